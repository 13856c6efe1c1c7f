import { describe, expect, test } from 'vitest';
import { cases } from '../../src/core/systems/registry.ts';
import type { Forcing } from '../../src/core/mechanics/forcing.ts';
import type { StateMap } from '../../src/core/mechanics/formulations/contract.ts';
import { formulations } from '../../src/core/mechanics/formulations/formulations.ts';
import type { Stepper } from '../../src/core/integrators/contract.ts';
import { methods } from '../../src/core/integrators/methods.ts';
import { motionOf } from '../../src/core/simulation/motion.ts';
import { systems } from '../../src/core/systems/all.ts';
import { distance, run } from '../core/integrators/problems.ts';
import { runOf, type FinishedRun } from '../helpers.ts';
import { mechanicsOf } from '../mechanics.ts';
import { pairs, settings, type Pair } from './pairs.ts';

const { coordinates } = systems['ripstik']!.meta;
const states = coordinates.flatMap((c) => [c.name, `${c.name}_dot`]);
const rolling = { version: 1, system: 'ripstik', initial: { X_dot: 1, alpha: '0.5 deg' }, duration: 0.5 };
const hanging = { ...cases.find((c) => c.id === 'hanging')!.scenario, duration: 2 };

interface Bench {
  stepper: Stepper;
  map: StateMap;
  q: Float64Array;
  v: Float64Array;
  /** y of the start. */
  y: Float64Array;
}

/** A pair on the rolling board, at its start. */
function benchOf({ method, sharp }: Pair, forcing?: Forcing): Bench {
  const { dynamics, q, v, scenario } = mechanicsOf(
    { ...rolling, method: { ...method, ...sharp(method.stages), ...(method.stages === 1 ? { rtol: 1e-6 } : {}) } },
    forcing,
  );
  const { map, stepper } = motionOf(scenario.method, dynamics);
  const y = new Float64Array(stepper.y.length);
  map.rebase(q, v);
  map.fromState(q, v, y);
  stepper.reset(0, y);
  return { stepper, map, q, v, y };
}

/** Times that no stepper has a reason to step to, and the state there by an independent sharp run. */
const looks = Array.from({ length: 8 }, (_, k) => 0.0061 * Math.sqrt(k + 0.5));
const truths = (() => {
  const { stepper, map, q, v } = benchOf({
    ...pairs.find((p) => p.id === 'dop853')!,
    sharp: () => ({ rtol: 1e-13, atol: 1e-14 }),
  });
  return looks.map((t) => {
    expect(run(stepper, t)).toBeNull();
    map.toState(stepper.y, q, v);
    return [...q, ...v];
  });
})();

test('every method and every formulation is in the suite', () => {
  expect(Object.keys(settings).sort()).toEqual(methods.map((m) => m.id).sort());
  for (const { id } of methods)
    for (const f of formulations)
      expect(pairs.some((p) => p.id === id && (p.formulation === f.id || id === 'ida'))).toBe(true);
});

describe.each(pairs)('contract: $name', (pair) => {
  test('the limit is hit to the last bit and never passed', () => {
    const { stepper } = benchOf(pair);
    for (const limit of [0.01, 0.01 + 1e-9, 0.0123456789, Math.PI / 100]) {
      expect(run(stepper, limit, () => expect(stepper.t).toBeLessThanOrEqual(limit))).toBeNull();
      expect(stepper.t).toBe(limit);
    }
  });

  test('after a reset the same input gives the same bits, and the counters move', () => {
    const { stepper, y } = benchOf(pair);
    const other = y.map((x, i) => x + 0.01 * Math.sin(i));
    const [a, b] = [0, 1].map(() => {
      stepper.reset(0, y);
      expect(run(stepper, 0.02)).toBeNull();
      const between = new Float64Array(y.length);
      stepper.interpolate((stepper.previousT + stepper.t) / 2, between);
      const found = { y: [...stepper.y], between: [...between], counters: { ...stepper.counters } };
      stepper.reset(0.3, other);
      run(stepper, 0.31);
      return found;
    });
    expect(b).toEqual(a);
    const { steps, evaluations, jacobians, factorizations, rejected } = a!.counters;
    expect(steps).toBeGreaterThan(0);
    expect(evaluations).toBeGreaterThanOrEqual(steps);
    expect(rejected).toBeGreaterThanOrEqual(0);
    if (pair.implicit) expect(Math.min(jacobians, factorizations)).toBeGreaterThan(0);
    else expect(jacobians + factorizations).toBe(0);
  });

  test('between the ends of its steps it knows the state, whatever happens to y afterwards', () => {
    const { stepper, map, q, v, y } = benchOf(pair);
    const between = new Float64Array(y.length);
    const within = pair.order ? 0.05 ** pair.order : 1e-6;
    let next = 0;
    expect(
      run(stepper, 0.02, () => {
        const kept = stepper.y.slice();
        stepper.y.fill(7);
        for (; next < looks.length && looks[next]! <= stepper.t; next++) {
          stepper.interpolate(looks[next]!, between);
          map.toState(between, q, v);
          expect(distance([...q, ...v], truths[next]!), `t = ${looks[next]!}`).toBeLessThan(within);
        }
        stepper.y.set(kept);
        stepper.stateChanged();
      }),
    ).toBeNull();
    expect(next).toBe(looks.length);
  });

  test('a force that is not a number fails by name, and moves nothing', () => {
    const wall = 0.013;
    const { stepper } = benchOf(pair, (t, _q, _v, force) => void (t > wall && force.fill(NaN)));
    let last = { t: 0, previousT: 0, y: [...stepper.y] };
    expect(run(stepper, 0.05, () => (last = { t: stepper.t, previousT: stepper.previousT, y: [...stepper.y] }))).toBe(
      'non-finite',
    );
    expect({ t: stepper.t, previousT: stepper.previousT, y: [...stepper.y] }).toEqual(last);
    expect(last.y.every(Number.isFinite)).toBe(true);
    expect(Math.abs(stepper.t - wall)).toBeLessThan(0.005);
  });

  test('dependent constraints at the start fail by name, and move nothing', () => {
    const { stepper, map, q, v, y } = benchOf(pair);
    // Its front skate lies flat: what keeps it from slipping and what keeps it on the ground are one row.
    q.fill(0);
    v.fill(0);
    q[coordinates.findIndex((c) => c.name === 'alpha_fp')] = Math.PI / 2;
    map.fromState(q, v, y);
    stepper.reset(0, y);
    expect(stepper.step(0.1)).toBe('constraint-singular');
    expect(stepper.t).toBe(0);
    expect([...stepper.y]).toEqual([...y]);
  });
});

describe.each([
  { what: 'the hanging board over 2 s', scenario: hanging },
  { what: 'the board rolling at 1 m/s with half a degree of lean, over 0.5 s', scenario: rolling },
])('$what', ({ scenario }) => {
  const truth = runOf({ ...scenario, method: { name: 'dop853', rtol: 1e-13, atol: 1e-14 } });

  /** Largest error of any state in any row. */
  function errorOf(run: FinishedRun): number {
    expect(run.end).toMatchObject({ reason: 'end', time: scenario.duration });
    expect(run.rows).toBe(truth.rows);
    return Math.max(...states.map((name) => distance(run.columns.get(name)!, truth.columns.get(name)!)));
  }

  test('the truth is the same by another method on another formulation', () => {
    expect(
      errorOf(
        runOf({
          ...scenario,
          method: { name: 'radau', stages: 3, formulation: 'nullspace-qr', rtol: 1e-11, atol: 1e-12 },
        }),
      ),
    ).toBeLessThan(1e-8);
  });

  test.each(pairs.filter((p) => !p.order))('$name is within 1e-6 of it', ({ method, sharp }) => {
    expect(errorOf(runOf({ ...scenario, method: { ...method, ...sharp(method.stages) } }))).toBeLessThan(1e-6);
  });

  test.each(pairs.filter((p) => p.order))('$name comes nearer at order $order', ({ method, order, coarse }) => {
    const [wide, narrow] = [1, 2].map((k) => errorOf(runOf({ ...scenario, method: { ...method, step: coarse! / k } })));
    expect(Math.abs(Math.log2(wide! / narrow!) - order!), `${wide} ${narrow}`).toBeLessThan(0.2);
  });
});
