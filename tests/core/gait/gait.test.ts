// Pumping: targets of the feet, what a metre costs, and the search for the cheapest gait.
import { expect, test } from 'vitest';
import { gaitScenario, plainGait, targetAt, targetsOf, type Gait } from '../../../src/core/gait/gait.ts';
import { GaitError, holdSpeed, measureGait, type GaitReport } from '../../../src/core/gait/measureGait.ts';
import { nelderMead } from '../../../src/core/gait/nelderMead.ts';
import { optimiseGait, SEARCH } from '../../../src/core/gait/optimiseGait.ts';
import { compileExpression } from '../../../src/core/scenario/expressions.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { scenarioOf, seeded } from '../../helpers.ts';

const board = systems['ripstik']!;
const DRAG = { parameters: { wheelDrag: 0.5 }, speed: 1 };

function last<T, R>(steps: Generator<T, R>): R {
  for (;;) {
    const next = steps.next();
    if (next.done) return next.value;
  }
}

test('the targets in the scenario are those that are drawn, at random gaits and times', () => {
  const random = seeded(20);
  for (let i = 0; i < 50; i++) {
    const gait: Gait = {
      amplitude: 0.4 * random(),
      frequency: 0.5 + 3 * random(),
      phase: 6 * random() - 3,
      bias: random() - 0.5,
      twist: random() - 0.5,
      harmonics: i % 3 === 0 ? [] : [{ order: 2 + (i % 3), cosine: random() - 0.5, sine: random() - 0.5 }],
    };
    const t = 5 * random();
    for (const [k, foot] of (['front', 'back'] as const).entries())
      expect(compileExpression(targetsOf(gait)[k]!, { variables: ['t'] }).evaluate(t)).toBeCloseTo(
        targetAt(gait, foot, t * gait.frequency),
        12,
      );
  }
});

test('a system without feet has no gait; with them its scenario is one that runs', () => {
  expect(() => gaitScenario(systems['bicycle']!.meta, plainGait)).toThrow('bicycle has no feet that pump');
  for (const id of ['ripstik', 'ripstik-rider'])
    expect(scenarioOf(gaitScenario(systems[id]!.meta, plainGait)).control?.type).toBe('track');
});

test('feet together by 14.1° once a second hold 1 m/s against wheels of 0.5 N·s/m; opposed feet cost more', () => {
  const together = last(holdSpeed(board, plainGait, DRAG));
  expect(together.settledSpeed).toBeCloseTo(1, 3);
  expect((together.gait.amplitude * 180) / Math.PI).toBeCloseTo(14.1, 1);
  expect(together.cost).toBeCloseTo(1.023, 2);
  // Nothing is cheaper than the drag of two wheels that roll straight on.
  expect(together.cost).toBeGreaterThan(1);
  expect(together.grossCost).toBeGreaterThan(together.cost);
  const opposed = last(holdSpeed(board, { ...plainGait, phase: Math.PI }, DRAG));
  expect(opposed.cost).toBeCloseTo(1.176, 2);
});

test('the search finds a cheaper gait that holds the speed, in ten tries', () => {
  const seen: number[] = [];
  const search = optimiseGait(board, plainGait, DRAG, { ...SEARCH, most: 10 });
  let best: GaitReport | null = null;
  for (let next = search.next(); ; next = search.next()) {
    if (next.done) {
      best = next.value;
      break;
    }
    seen.push(next.value.tried);
  }
  expect(seen.at(-1)).toBe(10);
  expect(best.cost).toBeLessThan(1.0227);
  expect(Math.abs(best.settledSpeed - 1)).toBeLessThan(1e-3);
  expect(best.gait.amplitude).toBeLessThan(SEARCH.mostAmplitude);
  // It is measured again from its own numbers.
  expect(measureGait(board, best.gait, DRAG).cost).toBeCloseTo(best.cost, 10);
});

test('a speed that no amplitude holds is refused in words', () => {
  expect(() => last(holdSpeed(board, { ...plainGait, frequency: 0.2 }, { ...DRAG, speed: 5 }))).toThrow(GaitError);
});

test('the simplex finds the minimum of a curved valley, and goes around where there is no value', () => {
  const valley = ([x, y]: readonly number[]): number =>
    x! < -1.4 ? Infinity : 100 * (y! - x! * x!) ** 2 + (1 - x!) ** 2;
  const search = nelderMead([-1.2, 1], [0.5, 0.5], 1e-16, 400);
  let next = search.next();
  while (!next.done) next = search.next(valley(next.value));
  expect(next.value.x[0]).toBeCloseTo(1, 6);
  expect(next.value.x[1]).toBeCloseTo(1, 6);
});
