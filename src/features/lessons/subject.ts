/** The scenario that a part of a lesson is about. */
import type { App } from '../../app/app.ts';
import type { Block, Lesson, Subject } from '../../core/lessons/lesson.ts';
import { columnsOf } from '../../core/motion/columns.ts';
import type { SystemView } from '../../core/model/system.ts';
import { settled } from '../../core/scenario/own.ts';
import { checkScenario } from '../../core/scenario/schema.ts';
import { ScenarioError, type Scenario, type ScenarioFile } from '../../core/scenario/types.ts';
import { learnSystemOf, systemMetas, systemViews } from '../../core/systems/registry.ts';
import { words } from './words.ts';

/**
 * As a draft, checked.
 *
 * @param app whose cases there are
 * @param subject of the part
 * @param change values that a slider sets, by group
 * @throws ScenarioError
 */
export async function scenarioOf(
  app: App,
  subject: Subject,
  change: { path: [string, string]; value: number } | null = null,
): Promise<{ draft: ScenarioFile; checked: Scenario }> {
  let raw: Record<string, unknown>;
  if ('case' in subject) {
    const found = app.cases.find(({ id }) => id === subject.case);
    if (!found) throw new ScenarioError('', words.noCase(subject.case));
    raw = found.scenario as unknown as Record<string, unknown>;
  } else raw = subject.scenario;
  await learnSystemOf(raw);
  if (change) {
    const [group, name] = change.path;
    raw = { ...raw, [group]: { ...(raw[group] as object | undefined), [name]: change.value } };
  }
  const draft = settled(raw) as unknown as ScenarioFile;
  return { draft, checked: checkScenario(draft, systemMetas) };
}

/** What a person can mend; anything else is thrown on. */
export function reasonOf(error: unknown): string {
  if (error instanceof ScenarioError) return error.message;
  throw error;
}

export interface Fault {
  /** Where the part begins in the file. */
  line: number;
  why: string;
}

/**
 * What of a lesson can't be used, one fault a part: its scenario, what its slider moves, the columns that it names.
 *
 * @param app whose cases there are
 * @param lesson that was read
 */
export async function faultsIn(app: App, lesson: Lesson): Promise<Fault[]> {
  const faults: Fault[] = [];
  for (const block of lesson.blocks) {
    if (block.kind === 'text') continue;
    try {
      await checkPart(app, block);
    } catch (error) {
      faults.push({ line: block.line, why: reasonOf(error) });
    }
  }
  return faults;
}

async function checkPart(app: App, block: Exclude<Block, { kind: 'text' }>): Promise<void> {
  const { checked } = await scenarioOf(app, block.subject);
  const vary = block.kind === 'live' ? block.vary : null;
  for (const value of vary ? [vary.from, vary.to] : [])
    await scenarioOf(app, block.subject, { path: vary!.path, value });
  const named = block.kind === 'question' ? [block.ask.column] : block.plot ? [block.plot.x, ...block.plot.y] : [];
  const known = columnsIn(systemViews[checked.system]!);
  const missing = named.find((name) => name !== '' && !/^lambda_\d+$/.test(name) && !known.includes(name));
  if (missing !== undefined) throw new ScenarioError('', words.unknownColumn(missing, known.join(', ')));
}

/** What runs of a system record, and what is computed of that; the constraints' forces, lambda_1 and on, besides. */
function columnsIn(view: SystemView): string[] {
  const names = view.meta.coordinates.map(({ name }) => name);
  const inputs = view.meta.inputs.map(({ name }) => name);
  const recorded = [
    't',
    ...names,
    ...names.map((name) => `${name}_dot`),
    ...inputs,
    'energy',
    'kinetic',
    'potential',
    'residual',
  ];
  return columnsOf(view, recorded).map(({ name }) => name);
}
