import { describe, expect, it } from 'vitest';
import {
  formatField,
  formatFixed,
  formatQuantity,
  formatScientific,
  formatSpeed,
  formatTime,
  formatCount,
  isExpression,
  naturalStep,
  nudge,
  parseField,
  plainText,
  storedFromShown,
} from '../../../src/ui/kit/format.ts';
import type { FieldRules } from '../../../src/ui/kit/format.ts';

const DEG = Math.PI / 180;
/** A stand-in that knows just what these tests type. */
const known: Record<string, number> = {
  'pi/8': Math.PI / 8,
  '45 deg': 45 * DEG,
  '(360/8) deg': 45 * DEG,
  '1/60': 1 / 60,
  '2*3': 6,
};
const evaluate = (text: string): number => {
  const value = known[text];
  if (value === undefined) throw new Error(`cannot read ${text}`);
  return value;
};
const parse = (text: string, rules: Partial<FieldRules> = {}) => parseField(text, { angle: false, ...rules }, evaluate);

describe('numbers as they are read', () => {
  it('use a minus sign, and none for zero', () => {
    expect(formatFixed(-1.234, 2)).toBe('−1.23');
    expect(formatFixed(-0.001, 2)).toBe('0.00');
    expect(formatFixed(NaN, 2)).toBe('–');
    expect(formatTime(5.8)).toBe('5.800');
  });

  it('stand in powers of ten where they are small', () => {
    expect(formatScientific(-2.1e-10)).toBe('−2.1e−10');
    expect(formatScientific(3e-15, 0)).toBe('3e−15');
    expect(formatScientific(12, 1)).toBe('1.2e1');
    expect(formatScientific(0)).toBe('0');
  });

  it('carry units after a thin space, degrees without', () => {
    expect(formatQuantity(0.081961, 'm')).toBe('0.08196\u202fm');
    expect(formatQuantity(Math.PI / 6, '°')).toBe('30°');
    expect(formatQuantity(-DEG, '°/s')).toBe('−1\u202f°/s');
  });

  it('name slow speeds by their fraction', () => {
    expect([1 / 64, 0.5, 1, 4, 0.62].map(formatSpeed)).toEqual(['1/64×', '1/2×', '1×', '4×', '0.62×']);
  });

  it('group thousands', () => {
    expect([7, 1204, 1234567].map(formatCount)).toEqual(['7', '1,204', '1,234,567']);
  });
});

describe('a field', () => {
  it('shows angles in degrees and expressions as typed', () => {
    expect(formatField(undefined, true)).toBe('');
    expect(formatField(30 * DEG, true)).toBe('30');
    expect(formatField('-45 deg', true)).toBe('−45');
    expect(formatField('pi/8', true)).toBe('pi/8');
    expect(formatField(1e-8, false)).toBe('1e−8');
  });

  it('reads a bare number in an angle field as degrees and says so in the draft', () => {
    expect(parse('45', { angle: true })).toEqual({ ok: true, stored: '45 deg', value: 45 * DEG });
    expect(parse('−45°', { angle: true, min: -DEG }).ok).toBe(false);
    expect(parse('360/8', { angle: true })).toMatchObject({ stored: '(360/8) deg' });
  });

  it('takes deg, rad and pi as written', () => {
    expect(parse('45°', { angle: true })).toMatchObject({ stored: '45 deg', value: 45 * DEG });
    expect(parse('45 deg/s', { angle: true })).toMatchObject({ stored: '45 deg' });
    expect(parse('π/8', { angle: true })).toMatchObject({ stored: 'pi/8', value: Math.PI / 8 });
    expect(parse('pi/8 rad', { angle: true })).toMatchObject({ stored: 'pi/8' });
    expect(parse('0.3 rad', { angle: true })).toEqual({ ok: true, stored: 0.3, value: 0.3 });
    expect(parse('0.3rad', { angle: true })).toMatchObject({ stored: 0.3 });
  });

  it('keeps plain numbers as numbers and expressions as text', () => {
    expect(parse('−0.04')).toEqual({ ok: true, stored: -0.04, value: -0.04 });
    expect(parse('0.04 m', { unit: 'm' })).toMatchObject({ stored: 0.04 });
    expect(parse('2×3')).toEqual({ ok: true, stored: '2*3', value: 6 });
    expect(parse('1/60', { numeric: true })).toEqual({ ok: true, stored: 1 / 60, value: 1 / 60 });
  });

  it('refuses what it cannot use and says why', () => {
    expect(parse('')).toMatchObject({ ok: false });
    expect(parse('', { optional: true })).toEqual({ ok: true, stored: undefined, value: undefined });
    expect(parse('0,5')).toEqual({ ok: false, error: 'write decimals with a point' });
    expect(parse('1e999')).toMatchObject({ error: 'is not a finite number' });
    expect(parse('0', { positive: true })).toMatchObject({ error: 'must be greater than 0' });
    expect(parse('-1', { min: 0 })).toMatchObject({ error: 'must be at least 0' });
    expect(parse('90', { angle: true, max: 45 * DEG })).toMatchObject({ error: 'must be at most 45°' });
    expect(parse('what')).toMatchObject({ error: 'cannot read what' });
  });

  it('returns to the same draft from what it shows', () => {
    for (const stored of ['12.5 deg', '-3e-7 deg'] as const) {
      expect(parse(formatField(stored, true), { angle: true })).toMatchObject({ stored });
    }
    for (const stored of [0.1, -1e-8, 9.81, 1234.5] as const)
      expect(parse(formatField(stored, false))).toMatchObject({ stored });
  });

  it('tells expressions from numbers with an exponent', () => {
    expect(['1e-3', '−2.5E4', '12'].map(isExpression)).toEqual([false, false, false]);
    expect(['pi/8', '45 deg', 'e'].map(isExpression)).toEqual([true, true, true]);
  });

  it('makes typographic signs plain', () => {
    expect(plainText(' −2 × 3\u202f·\u00a04° ')).toBe('-2 * 3 * 4 deg');
  });
});

describe('stepping', () => {
  it('moves by a tenth of the decade, without binary dust', () => {
    expect([0.25, 9.81, 40].map(naturalStep)).toEqual([0.01, 0.1, 1]);
    expect(naturalStep(0)).toBe(0.1);
    expect(nudge(0.1, 0.1, 2)).toBe(0.3);
    expect(nudge(9.81, 0.1, -10)).toBe(8.81);
  });

  it('stores steps of an angle in degrees', () => {
    expect(storedFromShown(46, { angle: true })).toBe('46 deg');
    expect(storedFromShown(46, { angle: false })).toBe(46);
  });
});
