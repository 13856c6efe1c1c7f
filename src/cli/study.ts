import type { System } from '../core/model/system.ts';
import { settled } from '../core/scenario/own.ts';
import { ScenarioError } from '../core/scenario/types.ts';
import { checkStudy, type Study } from '../core/sweep/study.ts';
import { learnSystemOf, loadSystem, systemMetas } from '../core/systems/registry.ts';

/** A study, its JSON as it was written, and the system that all its runs are of. @param text JSON @throws ScenarioError */
export async function loadStudy(text: string): Promise<{ study: Study; written: unknown; system: System }> {
  let raw: unknown;
  try {
    raw = JSON.parse(text.replace(/^\ufeff/, ''));
  } catch (error) {
    throw new ScenarioError('', `the study is not valid JSON: ${(error as Error).message}`);
  }
  const scenario = (raw as { scenario?: unknown } | null)?.scenario;
  await learnSystemOf(scenario);
  const own = typeof scenario === 'object' && scenario !== null;
  const study = checkStudy(own ? { ...(raw as object), scenario: settled(scenario) } : raw, systemMetas);
  return { study, written: raw, system: await loadSystem(study.file.scenario.system)! };
}
