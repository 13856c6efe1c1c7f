/** The scenario that a part of a lesson is about. */
import type { App } from '../../app/app.ts';
import type { Subject } from '../../core/lessons/lesson.ts';
import { settled } from '../../core/scenario/own.ts';
import { checkScenario } from '../../core/scenario/schema.ts';
import { ScenarioError, type Scenario, type ScenarioFile } from '../../core/scenario/types.ts';
import { learnSystemOf, systemMetas } from '../../core/systems/registry.ts';
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
