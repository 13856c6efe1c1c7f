import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { compileExpression, formulaTree } from '../../../src/core/scenario/expressions.ts';
import '../../../src/core/simulation/everyMotion.ts';
import { withoutDifferences } from '../../../src/core/scenario/expressions/differences.ts';

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

describe('differences of large numbers that nearly cancel', () => {
  // Beside them what is left, without a difference, of x = (t - a)/w; exp(-|x|) at the most.
  const cases: [text: string, left: (x: number) => number, slope: (x: number) => number][] = [
    [
      'sqrt(exp(2*X)+1) - exp(X)',
      (x) => 1 / (Math.hypot(Math.exp(x), 1) + Math.exp(x)),
      (x) => -1 / Math.hypot(1, Math.exp(-x)) / (Math.hypot(Math.exp(x), 1) + Math.exp(x)),
    ],
    [
      '-exp(X) + sqrt(exp(X)^2+1)',
      (x) => 1 / (Math.hypot(Math.exp(x), 1) + Math.exp(x)),
      (x) => -1 / Math.hypot(1, Math.exp(-x)) / (Math.hypot(Math.exp(x), 1) + Math.exp(x)),
    ],
    ['log(exp(X)+1) - X', (x) => Math.log1p(Math.exp(-x)), (x) => -1 / (1 + Math.exp(x))],
    ['X - log(exp(X)+1)', (x) => -Math.log1p(Math.exp(-x)), (x) => 1 / (1 + Math.exp(x))],
    ['cosh(X) - sinh(X)', (x) => Math.exp(-x), (x) => -Math.exp(-x)],
    ['(exp(X) - exp(X-1))/exp(X)', () => 1 - Math.exp(-1), () => 0],
    [
      '(exp(X) - exp(X-1))/(1+exp(X))^2',
      (x) => (1 - Math.exp(-1)) / (Math.exp(x) + 2 + Math.exp(-x)),
      (x) => (-(1 - Math.exp(-1)) * Math.tanh(x / 2)) / (Math.exp(x) + 2 + Math.exp(-x)),
    ],
  ];
  it.each(cases)('%s', (text, left, slope) => {
    for (const [a, w] of [
      [0, 1],
      [3, 0.125],
      [0.7, 1e-4],
    ] as const) {
      const f = of(text.replaceAll('X', `((t-${a})/${w})`));
      for (const x of [-30, -2, 0, 0.3, 5, 17, 25, 40, 300, 700, 720, 5000, 1e6]) {
        const t = a + x * w;
        // x as the formula has it.
        const at = (t - a) / w;
        const [value, rate] = [left(at), slope(at) / w];
        const most = 1e-13 * Math.max(1, Math.abs(at));
        expect(Math.abs(f.evaluate(t) - value), `${x}`).toBeLessThanOrEqual(most * Math.abs(value) + 3e-16);
        expect(Math.abs(f.derivative(t) - rate), `${x}`).toBeLessThanOrEqual(most * Math.abs(rate) + 3e-16 / w);
      }
    }
  });

  it('leave what does not cancel as it is written', () => {
    for (const text of [
      'exp(t) - 1',
      'sinh(t) - t',
      'exp(t) + exp(-t)',
      'sqrt(t^2+1) - t',
      'log(t) - t',
      'exp(t) - exp(2*t)',
    ]) {
      const tree = formulaTree(text, ['t']);
      expect(withoutDifferences(tree), text).toBe(tree);
    }
  });
});
