import { settled } from '../../core/scenario/own.ts';
import { parseScenario } from '../../core/scenario/schema.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import { learnSystemIn } from '../../core/systems/registry.ts';

/**
 * A scenario's text as the page has it: its own system learned, everything checked, the system named by its id.
 *
 * @param text JSON, as in a file
 * @param metas of the systems that there are
 * @throws ScenarioError
 */
export async function scenarioIn(text: string, metas: Readonly<Record<string, SystemMeta>>): Promise<ScenarioFile> {
  await learnSystemIn(text);
  parseScenario(text, metas);
  return settled(JSON.parse(text.replace(/^\ufeff/, '')) as ScenarioFile);
}
