/** The kept work as text, and back: what was stored is read like a stranger's file. */
import { collectScenarioErrors } from '../../core/scenario/schema.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import { plotsFrom } from '../state/plotPanes.ts';
import type { AppState, CaseInfo, PlotsState, ViewName } from '../types.ts';

export const KEPT_VERSION = 1;
/** Characters; the drafts of all systems have a few thousand. */
const LONGEST = 2e6;
const VIEWS: Readonly<Record<ViewName, true>> = {
  orbit: true,
  front: true,
  side: true,
  top: true,
  caster: true,
  rider: true,
};

export const isView = (name: unknown): name is ViewName => typeof name === 'string' && Object.hasOwn(VIEWS, name);

/** What is being worked on. */
export interface Work {
  draft: ScenarioFile;
  origin: CaseInfo;
  drafts: ReadonlyMap<string, { draft: ScenarioFile; origin: CaseInfo }>;
  /** The file on the stage, by name. */
  file: string | null;
}

/** How it is looked at; what is left out stays as it is. */
export interface Settings {
  theme?: 'light' | 'dark';
  tool?: string | null;
  view?: ViewName;
  follow?: boolean;
  showTrails?: boolean;
  showForces?: boolean;
  loop?: boolean;
  speed?: number;
  plots?: PlotsState;
  look?: { [name in (typeof LOOKS)[number]]?: boolean } & { quality?: 'auto' | 'low' | 'high' };
}

/** What of the look is kept. */
export const LOOKS = ['names', 'frames', 'inset', 'level'] as const;

export interface Kept {
  work: Work;
  settings: Settings;
}

interface Known {
  systems: Readonly<Record<string, SystemMeta>>;
  cases: readonly CaseInfo[];
  toolIds: readonly string[];
}

export function workOf(state: AppState): Work {
  // A mode only stands in for the motion before it.
  const motion = (state.aside.peek() ?? { motion: state.motion.peek() }).motion;
  return {
    draft: state.draft.peek(),
    origin: state.origin.peek(),
    drafts: state.drafts.peek(),
    file: motion?.source === 'file' ? motion.title : null,
  };
}

export function toText({ work, settings }: Kept): string {
  const drafts = [...work.drafts.values()].map(({ draft, origin }) => ({
    draft: origin.scenario === draft ? null : draft,
    origin: origin.id || { title: origin.title, scenario: origin.scenario },
  }));
  return JSON.stringify({ version: KEPT_VERSION, system: work.draft.system, drafts, file: work.file, settings });
}

/** @throws Error that says what can't be used */
export function fromText(text: string, known: Known): Kept {
  if (text.length > LONGEST) throw new Error(`${text.length} characters are more than ever are kept`);
  const raw = recordOf(JSON.parse(text));
  if (raw['version'] !== KEPT_VERSION)
    throw new Error(`it is of version ${String(raw['version']).slice(0, 20)}, this page keeps version ${KEPT_VERSION}`);
  const drafts = new Map<string, { draft: ScenarioFile; origin: CaseInfo }>();
  for (const item of Array.isArray(raw['drafts']) ? raw['drafts'] : []) {
    const entry = draftOf(recordOf(item), known);
    drafts.set(entry.draft.system, entry);
  }
  const current = drafts.get(String(raw['system']));
  if (!current) throw new Error('it names no draft to go on with');
  const file = typeof raw['file'] === 'string' ? raw['file'].slice(0, 200) : null;
  return { work: { ...current, drafts, file }, settings: settingsOf(recordOf(raw['settings']), known) };
}

function draftOf(item: Record<string, unknown>, known: Known): { draft: ScenarioFile; origin: CaseInfo } {
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
  const { title, scenario } = recordOf(raw);
  return {
    id: '',
    title: typeof title === 'string' ? title.slice(0, 200) : '',
    summary: '',
    scenario: scenarioOf(scenario, known),
  };
}

function scenarioOf(raw: unknown, { systems }: Known): ScenarioFile {
  for (const [path, message] of collectScenarioErrors(raw, systems))
    throw new Error(path ? `${path}: ${message}` : message);
  return raw as ScenarioFile;
}

function settingsOf(raw: Record<string, unknown>, { toolIds }: Known): Settings {
  const { theme, tool, view, speed } = raw;
  const plots = plotsFrom(raw['plots']);
  const switches = (['follow', 'showTrails', 'showForces', 'loop'] as const).filter(
    (name) => typeof raw[name] === 'boolean',
  );
  return {
    ...(theme === 'light' || theme === 'dark' ? { theme } : {}),
    ...(tool === null || toolIds.includes(tool as string) ? { tool: tool as string | null } : {}),
    ...(isView(view) ? { view } : {}),
    ...Object.fromEntries(switches.map((name) => [name, raw[name]])),
    ...(typeof speed === 'number' && speed >= 1 / 256 && speed <= 64 ? { speed } : {}),
    ...(plots ? { plots } : {}),
    look: lookOf(raw['look']),
  };
}

function lookOf(raw: unknown): NonNullable<Settings['look']> {
  const look = raw === undefined ? {} : recordOf(raw);
  const { quality } = look;
  return {
    ...Object.fromEntries(LOOKS.filter((name) => typeof look[name] === 'boolean').map((name) => [name, look[name]])),
    ...(quality === 'auto' || quality === 'low' || quality === 'high' ? { quality } : {}),
  };
}

function recordOf(value: unknown): Record<string, unknown> {
  if (typeof value !== 'object' || value === null || Array.isArray(value))
    throw new Error('it is not what this page stores');
  return value as Record<string, unknown>;
}
