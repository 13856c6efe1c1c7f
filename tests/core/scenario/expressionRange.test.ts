import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { compileExpression } from '../../../src/core/scenario/expressions.ts';

const { entries } = JSON.parse(readFileSync('tests/reference/expression-derivatives.json', 'utf8')) as {
  entries: [text: string, t: number, value: number, valueTolerance: number, rate: number, tolerance: number][];
};

const of = (text: string) => compileExpression(text, { variables: ['t'] });

/** Numbers that doubles round to 0, or nearly. */
const NOTHING = 1e-290;

describe('values and rates over the range of doubles, against mpmath', () => {
  it.each(entries)('%s at %d', (text, t, value, valueTolerance, rate, tolerance) => {
    const f = of(text);
    expect(Math.abs(f.evaluate(t) - value)).toBeLessThanOrEqual(
      50 * valueTolerance + 1e-15 * Math.abs(value) + NOTHING,
    );
    expect(Math.abs(f.derivative(t) - rate)).toBeLessThanOrEqual(50 * tolerance + 1e-15 * Math.abs(rate) + NOTHING);
  });
});
