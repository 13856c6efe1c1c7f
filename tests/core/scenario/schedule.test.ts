import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compileExpression } from '../../../src/core/scenario/expressions.ts';
import { closuresOf, mark } from '../../../src/core/scenario/expressions/closures.ts';
import { Enclosure } from '../../../src/core/scenario/expressions/enclosure.ts';
import { REACH_OF_STAGES } from '../../../src/core/scenario/expressions/pace.ts';
import '../../../src/core/simulation/everyMotion.ts';
import { Schedule } from '../../../src/core/scenario/expressions/schedule.ts';

const of = (text: string) => compileExpression(text, { variables: ['t'] });
const scheduleOf = (text: string, until: number, withRate = false) =>
  new Schedule(of(text), { from: 0, until, quiet: 1e-12, reach: REACH_OF_STAGES, withRate });

/** Switches and the shortest bound on the way to the end. */
function walk(text: string, until: number, withRate = false): { switches: number[]; steps: number; shortest: number } {
  const schedule = scheduleOf(text, until, withRate);
  const switches: number[] = [];
  let shortest = Infinity;
  let steps = 0;
  for (let t = 0; t < until && steps < 1e5; steps++) {
    const bound = schedule.bound(t);
    shortest = Math.min(shortest, bound);
    t = Math.min(schedule.end, until, t + bound);
    if (t < schedule.end) continue;
    schedule.begin(t);
    if (schedule.jumps) switches.push(t);
  }
  return { switches, steps, shortest };
}

const formula = fc
  .letrec<{ node: string }>((tie) => ({
    node: fc.oneof(
      { maxDepth: 4, withCrossShrink: true },
      fc.constant('t'),
      fc.constantFrom('2', '0.3', '-1.5'),
      fc
        .tuple(
          fc.constantFrom(
            ...'sin cos tan tanh atan sinh cosh exp log log10 log2 sqrt cbrt asin acos abs sign floor ceil round -'.split(
              ' ',
            ),
          ),
          tie('node'),
        )
        .map(([f, a]) => `${f}(${a})`),
      fc
        .tuple(tie('node'), fc.constantFrom('+', '-', '*', '/', '<', '>='), tie('node'))
        .map(([a, op, b]) => `(${a} ${op} ${b})`),
      fc
        .tuple(fc.constantFrom('min', 'max', 'hypot', 'atan2'), tie('node'), tie('node'))
        .map(([f, a, b]) => `${f}(${a}, ${b})`),
      fc.tuple(tie('node'), fc.constantFrom('2', '3', '-2', '0.5', '1.7', '7')).map(([a, n]) => `(${a})^(${n})`),
      fc.tuple(tie('node'), fc.constantFrom('0.7', '2')).map(([a, n]) => `mod(9*tanh(${a}), ${n})`),
      fc.tuple(tie('node'), tie('node')).map(([a, b]) => `(2 + sin(${a}))^(${b})`),
      fc.tuple(tie('node'), tie('node'), tie('node')).map(([a, b, c]) => `(${a} > 0 ? ${b} : ${c})`),
    ),
  }))
  .node.filter((text) => text.length < 300);

describe('enclosures', () => {
  it('hold values and rates at every t of the interval', () => {
    fc.assert(
      fc.property(
        formula,
        fc.double({ min: -3, max: 3, noNaN: true }),
        fc.constantFrom(1e-6, 1e-3, 0.1, 1, 10),
        fc.double({ min: 0, max: 1, noNaN: true }),
        (text, a, width, share) => {
          let f: ReturnType<typeof of>;
          try {
            f = of(text);
          } catch {
            return;
          }
          const enclosure = new Enclosure(f.tree, 3);
          const { lo, hi } = enclosure.over({ a, b: a + width, open: [] });
          const t = Math.min(a + share * width, a + width);
          const plain = closuresOf(f.tree);
          mark.lost = false;
          const value = plain.dual(t);
          const { rate, lost } = mark;
          // Where the formula has no value of its own there is a limit, which an enclosure does not know of.
          if (lost || !Number.isFinite(value) || Math.abs(value) > 1e290) return;
          const slack = 1e-12 * Math.max(1, Math.abs(value));
          expect(value).toBeGreaterThanOrEqual(lo[0]! - slack);
          expect(value).toBeLessThanOrEqual(hi[0]! + slack);
          if (!enclosure.smooth) return;
          if (!Number.isFinite(rate) || Math.abs(rate) > 1e290) return;
          const most = 1e-11 * Math.max(1, Math.abs(rate), Math.abs(value));
          expect(rate).toBeGreaterThanOrEqual(lo[1]! - most);
          expect(rate).toBeLessThanOrEqual(hi[1]! + most);
        },
      ),
      { numRuns: 4000 },
    );
  });

  it('decide by bounds, not by a point where the formula has no value', () => {
    const { lo, hi } = new Enclosure(of('2 + sin(asin(t)) > 0 ? t : 7').tree, 1).over({ a: 0, b: 10, open: [] });
    expect(lo[0]!).toBeLessThanOrEqual(0);
    expect(hi[0]!).toBeGreaterThanOrEqual(1);
  });

  it('hold second and third derivatives', () => {
    for (const text of [
      'sin(3*t)*exp(-t)',
      '1/(1+t^2)',
      'tanh(t)^3',
      'log(2+cos(t))',
      'atan(5*t)',
      'sqrt(1+t^4)',
      't^1.5*cosh(t)',
    ]) {
      const f = of(text);
      for (let a = 0.1; a < 2; a += 0.23) {
        const { lo, hi } = new Enclosure(f.tree, 3).over({ a, b: a + 0.01, open: [] });
        const [t, h] = [a + 0.005, 1e-3];
        const d = (x: number): number => f.derivative(x);
        const second = (8 * (d(t + h) - d(t - h)) - (d(t + 2 * h) - d(t - 2 * h))) / (12 * h);
        const third = (-d(t + 2 * h) + 16 * d(t + h) - 30 * d(t) + 16 * d(t - h) - d(t - 2 * h)) / (12 * h * h);
        for (const [k, value, factor] of [
          [2, second, 2],
          [3, third, 6],
        ] as const) {
          expect(value, `${text} at ${a}`).toBeGreaterThan(factor * lo[k]! - 1e-5);
          expect(value, `${text} at ${a}`).toBeLessThan(factor * hi[k]! + 1e-5);
        }
      }
    }
  });
});

describe('switches', () => {
  it.each([
    ['t > 5 ? (t < 5.5 ? 0.05 : 0) : 0', 8, [5, 5.5]],
    ['5*(sign(t-1)-sign(t-1.04))', 3, [1, 1.04]],
    ['mod(t, 0.25) < 0.125', 1, [0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875]],
    ['sign(sin(2*pi*t))', 2.2, [0.5, 1, 1.5, 2]],
    ['floor(3*t)', 1.1, [1 / 3, 2 / 3, 1]],
    ['ceil(t)+round(t)', 1.8, [0.5, 1, 1.5]],
    ['abs(t-0.3)', 1, [0.3]],
    ['max(0, sin(t))', 7, [Math.PI, 2 * Math.PI]],
    ['min(t, 2-t)', 2, [1]],
    ['(0.5 < t) * (t < 0.5001)', 9, [0.5, 0.5001]],
    ['t > 2 ? floor(2*t) : 0', 3, [2, 2.5, 3]],
    ['tan(t) > 1', 4, [Math.PI / 4, Math.PI / 2, (5 * Math.PI) / 4]],
    ['sin(t) == 0', 7, []],
    ['abs((t-1)^2)', 2, []],
    ['abs(t^2-2*t+1)', 2, []],
    ['min(t, t)', 2, []],
    ['floor(t) == 1', 3, [1, 2]],
    ['cos(t) ? 1 : 2', 9, []],
    ['(t-1)^2 < 1e-10', 2, [1 - 1e-5, 1 + 1e-5]],
    ['sin(t)', 9, []],
  ])('of %s up to %d', (text, until, expected) => {
    const { switches } = walk(text, until);
    const inside = switches.filter((t) => t < until);
    expect(inside.length, inside.join(', ')).toBe(expected.filter((t) => t < until).length);
    inside.forEach((t, i) => expect(Math.abs(t - expected[i]!)).toBeLessThanOrEqual(1e-11));
  });

  it('of trains are found one by one, however many there are to come', () => {
    const train = scheduleOf('mod(t, 1e-3) < 1e-4', 1e6);
    for (let k = 0; k < 200; k++) {
      expect(train.end).toBeCloseTo(k % 2 === 0 ? (k / 2) * 1e-3 + 1e-4 : ((k + 1) / 2) * 1e-3, 12);
      train.begin(train.end);
    }
  });

  it('each side is seen from within', () => {
    const f = of('t > 5 ? 1 : t < 5 ? 2 : 3');
    const schedule = new Schedule(f, { from: 0, until: 10, quiet: 1e-12, reach: REACH_OF_STAGES, withRate: false });
    expect([f.evaluate(4), f.evaluate(schedule.end), f.evaluate(6)]).toEqual([2, 2, 2]);
    schedule.begin(schedule.end);
    expect(f.evaluate(5)).toBe(1);
  });

  it('agree with a search by small steps', () => {
    fc.assert(
      fc.property(
        fc.constantFrom(
          'sin(7*t)',
          'cos(3*t+1)*t',
          'mod(t,0.37)-0.2',
          't^2-1.7',
          'exp(-t)-0.4',
          'sin(t^2*5)',
          '1/(t-2.77)',
        ),
        fc.constantFrom(
          'sign(X)',
          'floor(3*(X))',
          'abs(X)',
          'max(X, 0.1)',
          '(X) < 0.3',
          '(X) > 0 ? 1 : t',
          'mod(X, 0.5)',
          'round(X)*t',
        ),
        (inner, outer) => {
          const text = outer.replace('X', inner);
          const { switches } = walk(text, 2);
          const f = of(text);
          // A jump of the value, or of the rate, between two close points has a switch between them.
          const step = 1e-4;
          for (let t = 0.01; t < 1.99; t += step) {
            const [x, y] = [f.evaluate(t), f.evaluate(t + step)];
            const expected = (step * (f.derivative(t) + f.derivative(t + step))) / 2;
            if (Math.abs(y - x - expected) < 0.02 || Math.abs(x) + Math.abs(y) > 20) continue;
            expect(
              switches.some((s) => s >= t && s <= t + step),
              `${text} near ${t}`,
            ).toBe(true);
          }
        },
      ),
      { numRuns: 60 },
    );
  });
});

describe('bounds', () => {
  it.each([
    ['5', 10, Infinity],
    ['3*t+2', 10, Infinity],
    ['t^2', 10, Infinity],
    ['t > 3 ? 4 : 0', 10, Infinity],
  ])('none for %s', (text, until, bound) => expect(walk(text, until).shortest).toBe(bound));

  it('a pulse is never passed over, wherever it is and however narrow', () => {
    fc.assert(
      fc.property(
        fc.double({ min: 0, max: 10, noNaN: true }),
        fc.double({ min: -6, max: 0, noNaN: true }),
        fc.constantFrom(
          'exp(-((t-A)/W)^2)',
          '1/cosh((t-A)/W)',
          'cosh((t-A)/W)^-2',
          '1/(1+((t-A)/W)^2)',
          'sin(t)+exp(-((t-A)/W)^2)',
          '0.001*exp(-((t-A)/W)^2)*cos((t-A)/W)',
          'tanh((t-A)/W)',
          // Quotients of exponentials that leave doubles on one side of the pulse, or on both.
          '2/(exp((t-A)/W)+exp(-(t-A)/W))',
          '2*exp((t-A)/W)/(exp(2*(t-A)/W)+1)',
          'exp(-(t-A)/W)/(1+exp(-(t-A)/W))^2',
          'exp((t-A)/W)*(1+exp((t-A)/W))^(-2)',
          '1/(1+exp(-(t-A)/W)) - 1/(1+exp(-(t-A)/W-2))',
          'exp(-(t-A)/W)/(1+exp(-(t-A)/W)) - exp(-(t-A)/W-2)/(1+exp(-(t-A)/W-2))',
          '4/(exp((t-A)/W)+exp(-(t-A)/W))^2',
          '(exp((t-A)/W)-exp(-(t-A)/W))/(exp((t-A)/W)+exp(-(t-A)/W))^2',
          'sinh((t-A)/W)/cosh((t-A)/W)^2',
          'exp(-(t-A)/W-2*log(1+exp(-(t-A)/W)))',
          '(exp((t-A)/W)-exp(-(t-A)/W))/(exp((t-A)/W)+exp(-(t-A)/W))',
          // Differences of what is beyond doubles.
          '(exp((t-A)/W)-exp((t-A)/W-1))/(1+exp((t-A)/W))^2',
          '(sqrt(exp(2*(t-A)/W)+1)-exp((t-A)/W))/(1+exp(-(t-A)/W))',
          '(cosh((t-A)/W)-sinh((t-A)/W))/(1+exp(-(t-A)/W))^2',
          '(log(exp((t-A)/W)+1)-(t-A)/W)/(1+exp(-2*(t-A)/W))',
        ),
        (at, exponent, shape) => {
          const width = 10 ** exponent;
          const schedule = scheduleOf(shape.replaceAll('A', `${at}`).replaceAll('W', `${width}`), 10);
          for (let t = 0; t < 10;) {
            const bound = Math.min(schedule.bound(t), 10 - t);
            if (t <= at && t + bound > at) expect(bound).toBeLessThan(6 * width);
            t += bound;
          }
        },
      ),
      { numRuns: 300 },
    );
  });

  it('quiet stretches cost little', () => {
    expect(walk('exp(-((t-5)/1e-4)^2)', 10).steps).toBeLessThan(80);
    expect(walk('10 deg/(1+exp(100*(t-1)))', 10, true).steps).toBeLessThan(150);
    for (const share of ['exp(X)/(1+exp(X))', '(exp(X)-exp(-X))/(exp(X)+exp(-X))', '2*(3+exp(X))/(4+2*exp(X))'])
      expect(walk(share.replaceAll('X', '((t-5)/1e-5)'), 10).steps, share).toBeLessThan(200);
    expect(walk('(t+exp(t))/(1+exp(t))', 10).steps).toBeLessThan(60);
    expect(walk('sqrt(t)', 10).steps).toBeLessThan(60);
  });
});
