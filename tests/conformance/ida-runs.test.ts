import { describe, expect, test } from 'vitest';
import { cases } from '../../src/core/systems/registry.ts';
import { reportMethods } from '../../src/core/cases/methodSets.ts';
import { systems } from '../../src/core/systems/all.ts';
import { Simulation } from '../../src/core/simulation/simulation.ts';
import { runOf, scenarioOf, type FinishedRun } from '../helpers.ts';

const { coordinates } = systems['ripstik']!.meta;
const states = coordinates.flatMap((c) => [c.name, `${c.name}_dot`]);
const caseNamed = (id: string) => cases.find((c) => c.id === id)!.scenario;
const hanging = { ...caseNamed('hanging'), duration: 2 };
const rolling = { version: 1, system: 'ripstik', initial: { X_dot: 1, alpha: '0.5 deg' }, duration: 0.5 };
const falling = { ...caseNamed('falling-report'), duration: 2 };

/** Largest difference of any state in the first rows. */
function apart(a: FinishedRun, b: FinishedRun, rows: number): number {
  expect(a.rows).toBe(b.rows);
  return Math.max(
    ...states.map((name) =>
      a.columns
        .get(name)!
        .subarray(0, rows)
        .reduce((worst, x, k) => Math.max(worst, Math.abs(x - b.columns.get(name)![k]!)), 0),
    ),
  );
}

describe('a run by ida', () => {
  test.each([
    { name: 'hanging, 2 s', scenario: hanging, rows: 201, within: 1e-6 },
    { name: 'rolling, 0.5 s', scenario: rolling, rows: 51, within: 1e-6 },
    // Its motion magnifies a difference at 0.5 s five hundred times by 1 s, and a hundred thousand times by 2 s.
    { name: "the report's falling board, 2 s", scenario: falling, rows: 51, within: 2e-5 },
  ])('$name: rows as those of dopri5, on their constraints, energy kept', ({ scenario, rows, within }) => {
    const expected = runOf({ ...scenario, method: { rtol: 1e-11, atol: 1e-13 } });
    for (const projection of [true, false]) {
      const run = runOf({ ...scenario, method: { name: 'ida', rtol: 1e-9, atol: 1e-11, projection } });
      expect(run.end).toMatchObject({ reason: 'end', time: scenario.duration });
      expect(apart(run, expected, rows)).toBeLessThan(within);
      expect(run.counts.residual).toBeLessThan(projection ? 1e-12 : 1e-7);
      expect(Math.abs(run.counts.energyDrift!)).toBeLessThan(1e-6);
      const { steps, evaluations, jacobians, factorizations } = run.counts;
      expect(Math.min(steps, evaluations - steps, jacobians, factorizations)).toBeGreaterThan(0);
    }
  });

  test('stops at touchdown, at the moment that dopri5 finds', () => {
    const scenario = { ...rolling, duration: 10 };
    const expected = runOf(scenario).end;
    const run = runOf({ ...scenario, method: { name: 'ida' } });
    expect(run.end.reason).toBe('touchdown');
    expect(Math.abs(run.end.time - expected.time)).toBeLessThan(1e-6);
    expect(run.columns.get('t')!.at(-1)).toBe(run.end.time);
  });

  const thrown = {
    version: 1,
    system: 'ripstik',
    initial: { alpha_fp: '60 deg', alpha_fp_dot: 3 },
    duration: 3,
    events: { touchdown: 'ignore' },
  };

  test('a skate that comes to lie flat ends it by name, at the moment that dopri5 finds', () => {
    const expected = runOf({ ...thrown, method: { rtol: 1e-10 } }).end;
    // At 1e-10 rounding decides whether Newton's iteration gets there: of starts 1e-12 apart every fourth ends 0.4 ms before.
    for (const [rtol, within] of [
      [1e-8, 1e-5],
      [1e-9, 1e-6],
    ] as const) {
      const { end } = runOf({ ...thrown, method: { name: 'ida', rtol, atol: 0.01 * rtol } });
      expect(end.reason).toBe('constraint-singular');
      expect(Math.abs(end.time - expected.time)).toBeLessThan(within);
    }
  });

  test('passes near dependent constraints at a sharp tolerance, where rounding is all that Newton has left', () => {
    const run = runOf({
      ...thrown,
      initial: { alpha_fp: '45 deg', alpha_bp: '45 deg' },
      duration: 1.6,
      method: { name: 'ida', rtol: 1e-10, atol: 1e-12 },
    });
    expect(run.end.reason).toBe('end');
  });

  test('a formulation or a number of stages is refused by its path', () => {
    const scenario = scenarioOf({ ...rolling, method: { name: 'ida' } });
    for (const extra of [{ formulation: 'blt' }, { stages: 2 }]) {
      const path = `method.${Object.keys(extra)[0]!}`;
      expect(
        () => new Simulation({ ...scenario, method: { ...scenario.method, ...extra } }, systems['ripstik']!),
      ).toThrow(expect.objectContaining({ path }));
    }
  });
});

test.each(reportMethods)("the report's $label runs its falling board by name", ({ method, id }) => {
  const run = runOf({ ...caseNamed('falling-report'), duration: 1, method });
  expect(run.end, id).toMatchObject({ reason: 'end', time: 1 });
  expect(Math.abs(run.counts.energyDrift!)).toBeLessThan(1e-4);
  expect(run.counts.residual).toBeLessThan(1e-12);
});
