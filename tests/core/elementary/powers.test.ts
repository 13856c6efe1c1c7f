/**
 * Exponential, logarithm and power against 40 digits (mpmath 1.3, `tests/reference/powers.json` by
 * `powers.py` beside it), and against what must hold of them.
 */
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { exponential, logarithm, power } from '../../../src/core/elementary/powers.ts';

const reference = JSON.parse(readFileSync(new URL('../../reference/powers.json', import.meta.url), 'utf8')) as Record<
  'exp' | 'log' | 'pow',
  Row[]
>;

/** Each row: arguments, and the value as a sum of two doubles. */
type Row = readonly number[];

/** Distance of x from the value high + low, in units of the last place of high. */
function ulps(x: number, high: number, low: number): number {
  const unit = Math.max(2 ** (Math.floor(Math.log2(Math.abs(high))) - 52), 5e-324);
  return Math.abs((x - high - low) / unit);
}

describe('within 1 ulp of the value to 40 digits', () => {
  const functions: readonly [string, (x: number, y: number) => number, readonly Row[]][] = [
    ['exponential', exponential, reference.exp],
    ['logarithm', logarithm, reference.log],
    ['power', power, reference.pow],
  ];
  for (const [name, f, rows] of functions)
    it(`${name}, ${rows.length} arguments over the whole range`, () => {
      let worst = 0;
      for (const row of rows) {
        const [high, low] = row.slice(-2) as [number, number];
        const x = f(row[0]!, row[1]!);
        const away = ulps(x, high, low);
        worst = Math.max(worst, away);
        expect(away, `${name}(${row.slice(0, -2).join(', ')}) = ${x}`).toBeLessThan(1);
      }
      expect(worst).toBeLessThan(0.85);
    });
});

const ODD = [0, -0, 1, -1, 2, -2, 0.5, -0.5, 3, -3, Infinity, -Infinity, NaN, 5e-324, 1e-310, 1.7e308, 2 ** 53, 1e17];

it('at the ends of the range it is what ECMAScript says', () => {
  const near = (a: number, b: number): boolean => Object.is(a, b) || Math.abs(a - b) <= 2.3e-16 * Math.abs(b) + 5e-324;
  for (const x of ODD) {
    expect(near(exponential(x), Math.exp(x)), `exp(${x}) = ${exponential(x)}`).toBe(true);
    expect(near(logarithm(x), Math.log(x)), `log(${x}) = ${logarithm(x)}`).toBe(true);
    for (const y of ODD)
      for (const base of [x, -x])
        expect(near(power(base, y), Math.pow(base, y)), `${base} ^ ${y} = ${power(base, y)}`).toBe(true);
  }
});

it('what is exact is exact: powers of two, whole powers of small numbers', () => {
  for (let k = -1074; k <= 1023; k++) expect(power(2, k)).toBe(k < -1022 ? 2 ** -1022 * 2 ** (k + 1022) : 2 ** k);
  for (let n = 1; n <= 9; n++)
    for (let k = 0, exact = 1; exact < 2 ** 53; k++, exact *= n) {
      expect(power(n, k)).toBe(exact);
      expect(power(-n, k)).toBe(k % 2 ? -exact : exact);
      if (n === 1 && k > 60) break;
    }
  expect(exponential(0)).toBe(1);
  expect(logarithm(1)).toBe(0);
});

it('rises with its argument, from one double to the next', () => {
  const next = new Float64Array(1);
  const bits = new BigUint64Array(next.buffer);
  for (const from of [0.5, 0.70710678, 0.999999999, 1, 1.4142135, 3, 1e-300, 1e300]) {
    next[0] = from;
    for (let i = 0; i < 2000; i++) {
      const x = next[0];
      bits[0]! += 1n;
      expect(logarithm(next[0]) >= logarithm(x), `log after ${x}`).toBe(true);
      expect(exponential(next[0]) >= exponential(x), `exp after ${x}`).toBe(true);
    }
  }
});
