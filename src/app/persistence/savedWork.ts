/** The work in progress as the text that the browser stores, and back: what was stored is read like a stranger's file. */
import { descriptionIn, settled, written } from '../../core/scenario/own.ts';
import { collectScenarioErrors } from '../../core/scenario/schema.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import { systemMetas } from '../../core/systems/registry.ts';
import type { AppState } from '../app.ts';
import { builtInCases, type CaseInfo } from '../state/cases.ts';
import type { DraftAndOrigin } from '../state/experiment.ts';
import type { SettingValues } from '../state/settingsTable.ts';
import { fromStored, recordOf, toStored } from './settingsCodec.ts';

export const SAVED_VERSION = 1;
/** Characters; the drafts of all systems have a few thousand. */
const LONGEST = 2e6;

/** What is being worked on. */
export interface Work extends DraftAndOrigin {
  drafts: ReadonlyMap<string, DraftAndOrigin>;
  /** The file on the stage, by name. */
  file: string | null;
}

export interface SavedState {
  work: Work;
  /** What is left out stays as it is. */
  settings: Partial<SettingValues>;
}

interface Known {
  systems: Readonly<Record<string, SystemMeta>>;
  cases: readonly CaseInfo[];
  toolIds: readonly string[];
}

export function workOf(state: AppState): Work {
  // A mode only stands in for the motion before it.
  const { motion } = state.modePreview.peek()?.suspended ?? { motion: state.motion.peek() };
  return {
    draft: state.draft.peek(),
    origin: state.origin.peek(),
    drafts: state.drafts.peek(),
    file: motion?.source === 'file' ? motion.title : null,
  };
}

export function toText({ work, settings }: SavedState): string {
  const drafts = [...work.drafts.values()].map(({ draft, origin }) => ({
    draft: origin.scenario === draft ? null : written(draft, systemMetas),
    origin: storedOrigin(origin),
  }));
  return JSON.stringify({
    version: SAVED_VERSION,
    system: work.draft.system,
    drafts,
    file: work.file,
    settings: toStored(settings),
  });
}

/** The descriptions of own systems in a stored text, which have to be read before it is. */
export function descriptionsIn(text: string): string[] {
  if (text.length > LONGEST || !text.includes('"description"')) return [];
  try {
    const { drafts } = JSON.parse(text) as { drafts?: { draft?: unknown; origin?: { scenario?: unknown } }[] };
    const scenarios = (drafts ?? []).flatMap(({ draft, origin }) => [draft, origin?.scenario]);
    return [...new Set(scenarios.map(descriptionIn).filter((found) => found !== null))];
  } catch {
    // What is wrong is told when it is read.
    return [];
  }
}

/** A built-in case by its id; one with a title of its own by both. */
function storedOrigin({ id, title, scenario }: CaseInfo): unknown {
  if (id === '') return { title, scenario: written(scenario, systemMetas) };
  return builtInCases.find((one) => one.id === id)?.title === title ? id : { case: id, title };
}

/** @throws Error that says what can't be used */
export function fromText(text: string, known: Known): SavedState {
  if (text.length > LONGEST) throw new Error(`${text.length} characters are more than are ever stored`);
  const raw = recordOf(JSON.parse(text));
  if (raw['version'] !== SAVED_VERSION)
    throw new Error(
      `it is of version ${String(raw['version']).slice(0, 20)}, this page stores version ${SAVED_VERSION}`,
    );
  const drafts = new Map<string, DraftAndOrigin>();
  for (const item of Array.isArray(raw['drafts']) ? raw['drafts'] : []) {
    const entry = draftOf(recordOf(item), known);
    drafts.set(entry.draft.system, entry);
  }
  const current = drafts.get(String(raw['system']));
  if (!current) throw new Error('it names no draft to go on with');
  const file = typeof raw['file'] === 'string' ? raw['file'].slice(0, 200) : null;
  return { work: { ...current, drafts, file }, settings: fromStored(recordOf(raw['settings']), known) };
}

function draftOf(item: Record<string, unknown>, known: Known): DraftAndOrigin {
  const origin = originOf(item['origin'], known);
  if (item['draft'] === null) return { draft: origin.scenario, origin };
  const draft = scenarioOf(item['draft'], known);
  if (draft.system !== origin.scenario.system) throw new Error('a draft is of another system than its case');
  return { draft, origin };
}

function originOf(raw: unknown, known: Known): CaseInfo {
  if (typeof raw === 'string') {
    const found = known.cases.find((c) => c.id === raw);
    if (!found) throw new Error(`no case is called "${raw.slice(0, 60)}"`);
    return found;
  }
  const { case: id, title, scenario } = recordOf(raw);
  const own = typeof title === 'string' ? title.slice(0, 200) : '';
  if (typeof id === 'string') return { ...originOf(id, known), title: own };
  return {
    id: '',
    title: own,
    summary: '',
    scenario: scenarioOf(scenario, known),
  };
}

function scenarioOf(raw: unknown, { systems }: Known): ScenarioFile {
  for (const [path, message] of collectScenarioErrors(raw, systems))
    throw new Error(path ? `${path}: ${message}` : message);
  return settled(raw as ScenarioFile);
}
