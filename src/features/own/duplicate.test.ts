// Duplicate and change: of every built-in system the copy that one begins with runs to the same rows.
import { expect, test } from 'vitest';
import { feedbackOf } from '../../core/control/design/feedback.ts';
import { templates } from '../../core/description/templates.ts';
import { checkScenario } from '../../core/scenario/schema.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import '../../core/simulation/everyMotion.ts';
import { Simulation } from '../../core/simulation/simulation.ts';
import { cases, learnSystem, loadSystem, systemMetas } from '../../core/systems/registry.ts';
import { carriedOver } from './adopt.ts';

const METHOD = { name: 'dop853', rtol: 1e-12, atol: 1e-14 };
type Feedbacks = ReturnType<typeof feedbackOf>;

/** Rows and the regulator, which is the one that is given, where one is: a rider's gains are as large as their rounding is. */
async function rowsOf(file: ScenarioFile, given?: Feedbacks) {
  const scenario = checkScenario(file, systemMetas);
  const system = (await loadSystem(file.system))!;
  const feedback = given === undefined ? feedbackOf(scenario, system) : given;
  const simulation = new Simulation(scenario, system, { feedback, extras: [] });
  while (!simulation.end) simulation.advance(() => false);
  return { columns: simulation.columns, data: simulation.takeChunk().columns, feedback };
}

const builtIn = Object.keys(systemMetas).filter((id) => !id.startsWith('own-'));

test('every built-in system has its text', () => {
  expect(builtIn.filter((id) => !templates.some((template) => template.id === id))).toEqual([]);
});

test.each(builtIn)('%s', async (id) => {
  const { default: text } = await templates.find((template) => template.id === id)!.load();
  const { meta } = await learnSystem(text);
  const file: ScenarioFile = { ...cases.find(({ scenario }) => scenario.system === id)!.scenario };
  const draft: ScenarioFile = { ...file, method: METHOD, duration: 0.1, outputStep: 0.02 };
  const copy = carriedOver(draft, meta);
  expect(copy.initial).toEqual(draft.initial);
  expect(copy.control).toEqual(draft.control);
  expect(copy.at).toEqual(draft.at);
  const theirs = await rowsOf(draft);
  const ours = await rowsOf(copy, theirs.feedback);
  expect(ours.columns).toEqual(theirs.columns);
  for (const [k, values] of theirs.data.entries())
    values.forEach((x, row) => {
      const far = Math.abs(ours.data[k]![row]! - x) / Math.max(1, Math.abs(x));
      expect(far, `${theirs.columns[k]} in row ${row}`).toBeLessThan(1e-10);
    });
});
