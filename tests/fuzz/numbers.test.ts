import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { ControlError } from '../../src/core/control/linearization/matrices.ts';
import { feedbackOf } from '../../src/core/control/design/feedback.ts';
import { StartError } from '../../src/core/mechanics/consistentStart.ts';
import { FORMULATION_NAMES, METHOD_NAMES } from '../../src/core/scenario/defaults.ts';
import { ScenarioError, type ScenarioFile } from '../../src/core/scenario/types.ts';
import { Simulation } from '../../src/core/simulation/simulation.ts';
import { systems } from '../../src/core/systems/all.ts';
import { scenarioOf } from '../helpers.ts';
import { runs, SEED, tally } from './tally.ts';

/** The space of all scenarios, far beyond what is sensible: every run ends with a right answer or a named reason. */

const REASONS = new Set([
  'end',
  'touchdown',
  'constraint-singular',
  'step-too-small',
  'non-finite',
  'newton',
  'mass-matrix-singular',
]);
/** A run is watched for this many steps: longer ones are as good as endless in a test, and may be cancelled by a person. */
const MOST_STEPS = 400;

const magnitude = fc.oneof(
  fc.constantFrom(0, 1, -1, 1e-300, 1e300),
  fc.tuple(fc.double({ min: -8, max: 8, noNaN: true }), fc.boolean()).map(([e, minus]) => (minus ? -1 : 1) * 10 ** e),
);
const some = <T>(names: readonly string[], value: fc.Arbitrary<T>, most: number): fc.Arbitrary<Record<string, T>> =>
  fc
    .uniqueArray(fc.constantFrom(...names), { maxLength: most })
    .chain((keys) =>
      fc.tuple(...keys.map(() => value)).map((values) => Object.fromEntries(keys.map((k, i) => [k, values[i]!]))),
    );

const scenario = fc.constantFrom(...Object.values(systems)).chain(({ meta }): fc.Arbitrary<ScenarioFile> => {
  const coordinates = meta.coordinates.map((c) => c.name);
  const states = meta.order === 1 ? coordinates : [...coordinates, ...coordinates.map((n) => `${n}_dot`)];
  const method = fc
    .record({
      name: fc.constantFrom(...METHOD_NAMES),
      formulation: fc.constantFrom(...FORMULATION_NAMES),
      rtol: fc.double({ min: -13, max: -2, noNaN: true }).map((e) => 10 ** e),
      atol: fc.double({ min: -15, max: 0, noNaN: true }).map((e) => 10 ** e),
      step: fc.double({ min: -5, max: 2, noNaN: true }).map((e) => 10 ** e),
      projection: fc.boolean(),
    })
    .map(({ formulation, ...m }) => (m.name === 'ida' ? m : { ...m, formulation }));
  return fc.record(
    {
      version: fc.constant(1 as const),
      system: fc.constant(meta.id),
      parameters: some(
        meta.parameters.map((p) => p.name),
        magnitude,
        4,
      ),
      constraints: fc.constantFrom(...meta.constraintSets.map((c) => c.id)),
      hold: fc.uniqueArray(fc.constantFrom(...coordinates), { maxLength: 2 }),
      initial: some(states, fc.oneof(fc.double({ min: -4, max: 4, noNaN: true }), magnitude), 5),
      inputs:
        meta.inputs.length > 0
          ? some(
              meta.inputs.map((i) => i.name),
              fc.oneof(
                magnitude,
                fc.constantFrom('1/t', 'sqrt(t - 0.1)', '1e9*sin(1e6*t)', 'log(t)', 'exp(100*t)', 'tan(t)'),
              ),
              2,
            )
          : fc.constant({}),
      method,
      duration: fc.constantFrom(0.05, 0.5, 100),
      outputStep: fc.constantFrom(0.01, 0.3),
      events: fc.constantFrom<NonNullable<ScenarioFile['events']>[]>(
        {},
        { touchdown: 'ignore' },
        { touchdown: 'ignore', 'constraint-singular': 'ignore' },
      ),
    },
    { requiredKeys: ['version', 'system', 'method', 'duration', 'outputStep'] },
  );
});

/** Runs what can run. @returns why it ended, or was refused, and the time it reached, s */
function outcome(file: ScenarioFile): [how: string, reached: number] {
  let simulation: Simulation;
  try {
    const checked = scenarioOf(file);
    const system = systems[checked.system]!;
    simulation = new Simulation(checked, system, {
      extras: ['energy', 'residual'],
      feedback: feedbackOf(checked, system),
    });
  } catch (error) {
    if (error instanceof ScenarioError || error instanceof StartError || error instanceof ControlError) {
      expect(error.message.length).toBeGreaterThan(10);
      return ['refused by name', 0];
    }
    throw error;
  }
  let steps = 0;
  simulation.advance(() => ++steps >= MOST_STEPS);
  const { columns, rows } = simulation.takeChunk();
  for (const name of simulation.columns.filter((n) => n !== 'energy' && n !== 'residual')) {
    const column = columns[simulation.columns.indexOf(name)]!;
    for (let row = 0; row < rows; row++)
      if (!Number.isFinite(column[row]!))
        throw new Error(`${name} is ${column[row]} in row ${row} of ${rows}; ended ${JSON.stringify(simulation.end)}`);
  }
  const t = columns[0]!;
  for (let row = 1; row < rows; row++) expect(t[row]!).toBeGreaterThan(t[row - 1]!);
  const reached = rows > 0 ? t[rows - 1]! : 0;
  if (!simulation.end) return ['still running when no longer watched', reached];
  expect(REASONS).toContain(simulation.end.reason);
  expect(simulation.end.message.length).toBeGreaterThan(5);
  return [`ended: ${simulation.end.reason}`, reached];
}

describe('any numbers, any method', () => {
  const count = tally('numbers');
  test('no number that is not finite, no unnamed end, no endless step', { timeout: 600_000 }, () => {
    fc.assert(
      fc.property(scenario, (file) => count(...outcome(file))),
      { seed: SEED, numRuns: runs(400) },
    );
  });
});
