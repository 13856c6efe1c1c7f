/** A scenario as the part of an address after `#`: what differs from a case, in plain text that a person can read before opening it. */
import { collectScenarioErrors } from './schema.ts';
import type { ScenarioFile } from './types.ts';
import type { SystemMeta } from '../model/system.ts';
import { settled, written } from './own.ts';
import { packText, unpackText } from './packed.ts';
import { decode, difference, encode, isRecord, LinkError, patched, readValue, short, type Entry } from './patch.ts';

export { LinkError } from './patch.ts';

export interface LinkContent {
  /** The built-in case that the scenario is a change of, or null: then the link holds all of it. */
  caseId: string | null;
  /** As its author calls it, where that is not the case's own title. */
  title?: string;
  scenario: ScenarioFile;
  /** Ids of the open tool and of the view, a playback time (s), and what is plotted: only names and shapes are checked here. */
  tool?: string;
  view?: string;
  time?: number;
  plots?: unknown;
}

export interface OpenedLink extends LinkContent {
  /** The check does not fit: changed by hand, or the case it names is not what it was. */
  altered: boolean;
}

/** What decoding needs to know of the program. */
export interface Known {
  systems: Readonly<Record<string, SystemMeta>>;
  cases: readonly { id: string; scenario: ScenarioFile }[];
}

const VERSION = '1';
/** Characters; longer addresses get lost in mails and chats. The longest built-in case needs a tenth. */
export const LONGEST_LINK = 16_000;
const MOST_ENTRIES = 500;
const LONGEST_TITLE = 80;
const LONGEST_TIME = 1e5;
const DEEPEST_PLOTS = 8;
const NAMES = ['v', 'case', 'title', 'tool', 'view', 'time', 'plots', 'sum'] as const;
type Name = (typeof NAMES)[number];

const NOTHING = { version: 1 } as const;

/** Where a description stands in a scenario, and in a link that packs it. */
const DESCRIPTION = 'system.description';
const PACKED = 'system.packed';
/** Bytes: somewhat more than a description may have, of which its own check then speaks. */
const LARGEST_UNPACKED = 200_000;

/**
 * The text after `#`, without it.
 *
 * @param content scenario, and what the page shows of it
 * @throws LinkError when it would be longer than `LONGEST_LINK`, or for what a link can't carry
 */
export function encodeLink(content: LinkContent, { cases, systems }: Known): string {
  const scenario = written(content.scenario, systems);
  const base = cases.find((c) => c.id === content.caseId && c.scenario.system === content.scenario.system);
  const changes = difference({ ...(base?.scenario ?? NOTHING) }, { ...scenario });
  const own = changes.find(([path]) => (NAMES as readonly string[]).includes(path));
  if (own) throw new LinkError(own[0], 'is no name of a scenario');
  const entries: Entry[] = [['v', VERSION]];
  if (base) entries.push(['case', base.id]);
  if (content.title) entries.push(['title', content.title.slice(0, LONGEST_TITLE).replace(/[\ud800-\udbff]$/, '')]);
  entries.push(...changes.map(shorter));
  for (const name of ['tool', 'view'] as const) if (content[name]) entries.push([name, content[name]]);
  if (content.time !== undefined && content.time > 0) entries.push(['time', String(content.time)]);
  if (content.plots !== undefined) entries.push(['plots', JSON.stringify(content.plots)]);
  entries.push(['sum', sumOf(scenario)]);
  const text = entries.map(([path, value]) => `${path}=${encode(value).replaceAll('%20', '+')}`).join('&');
  if (text.length > LONGEST_LINK || entries.length > MOST_ENTRIES)
    throw new LinkError(
      '',
      `a link of ${text.length} characters is more than the ${LONGEST_LINK} that addresses carry; save the scenario as a file instead`,
    );
  return text;
}

/** A description is packed where that is shorter. */
function shorter([path, value]: Entry): Entry {
  if (path !== DESCRIPTION) return [path, value];
  const packed = packText(value);
  return packed.length < encode(value).length ? [PACKED, packed] : [path, value];
}

function unpacked(text: string): string {
  try {
    return unpackText(text, LARGEST_UNPACKED);
  } catch (error) {
    throw new LinkError(PACKED, error instanceof Error ? error.message : String(error));
  }
}

/**
 * What a link holds, its scenario checked like a stranger's file. What mail and chat programs do to addresses is undone
 * where the check then fits: `&amp;`, `%3D`, `%26` and `%23` in place of signs, a full stop or bracket after the end.
 *
 * @param text with or without `#`
 * @param known built-in cases and systems
 * @throws LinkError, and nothing else, for what can't be read
 */
export function decodeLink(text: string, known: Known): OpenedLink {
  const readings = readingsOf(text);
  let altered: OpenedLink | null = null;
  let refusal: LinkError | null = null;
  for (const reading of readings) {
    try {
      const opened = decodeReading(reading, known);
      if (!opened.altered) return opened;
      altered ??= opened;
    } catch (error) {
      if (!(error instanceof LinkError)) throw error;
      // What is wrong with the reading that has entries is what a person can mend.
      if (!refusal || !readings[0]!.includes('=')) refusal = error;
    }
  }
  if (altered) return altered;
  throw refusal!;
}

/**
 * The description of an own system that a link holds, so that it can be read before the link is decoded; null where there is none.
 * @param text with or without `#`
 */
export function descriptionInLink(text: string): string | null {
  const found = /(?:^|[&#]|&amp;)system\.(description|packed)(?:=|%3D)([^&]*)/.exec(text.slice(0, LONGEST_LINK + 1));
  if (!found) return null;
  const [, kind, value] = found as unknown as [string, string, string];
  try {
    const plain = decode('', value.replaceAll('+', ' '));
    return String(readValue('', kind === 'packed' ? unpacked(plain) : plain));
  } catch {
    // Decoding says what is broken.
    return null;
  }
}

/** The text as it is, then as it was before its signs were written in other ways; each once. */
function readingsOf(text: string): string[] {
  const signs = text
    .replace(/^(?:#|%23)+/i, '')
    .replace(/&(?:amp;)+|&#38;|&#x26;/gi, '&')
    .replace(/&(?:gt|quot|apos|nbsp|#34|#39);.*$/i, '');
  const readings = [signs, signs.replace(/(^|&)([^&=]*?)%3D/gi, '$1$2=')];
  try {
    readings.push(decodeURIComponent(signs).replace(/^#/, ''));
  } catch {
    // Cut within a % code: the others say what is missing.
  }
  return [...new Set(readings)];
}

function decodeReading(text: string, { systems, cases }: Known): OpenedLink {
  // The check stands last: without it nothing before it need be whole.
  if (/^v=1(&|$)/.test(text) && !/&sum=[0-9a-z]/.test(text))
    throw new LinkError('', 'the end is missing; the link was cut on its way');
  const { own, changes } = entriesOf(text);
  if (own.get('v') !== VERSION)
    throw new LinkError(
      'v',
      own.has('v')
        ? `version "${short(own.get('v')!)}" is not known here; this page reads version ${VERSION}`
        : 'is missing: this is no link of this page, or it was cut',
    );
  const sum = own.get('sum')?.match(/^[0-9a-z]+/)?.[0];
  if (sum === undefined) throw new LinkError('', 'the end is missing; the link was cut on its way');
  const caseId = own.get('case') ?? null;
  const base = cases.find((c) => c.id === caseId);
  if (caseId !== null && !base) throw new LinkError('case', `no case is called "${short(caseId)}"`);
  const scenario = patched({ ...(base?.scenario ?? NOTHING) }, changes);
  for (const [path, message] of collectScenarioErrors(scenario, systems)) throw new LinkError(path, message);
  const checked = settled(scenario) as unknown as ScenarioFile;
  const title = own.get('title');
  return {
    caseId,
    ...(title === undefined ? {} : { title: title.slice(0, LONGEST_TITLE) }),
    scenario: checked,
    ...nameIn(own, 'tool'),
    ...nameIn(own, 'view'),
    ...timeIn(own),
    ...plotsIn(own),
    altered: sum !== sumOf(scenario),
  };
}

function entriesOf(text: string): { own: Map<Name, string>; changes: Entry[] } {
  if (text.length > LONGEST_LINK)
    throw new LinkError('', `${text.length} characters are more than the ${LONGEST_LINK} of a link`);
  const parts = text.split('&').filter((part) => part !== '');
  if (parts.length > MOST_ENTRIES)
    throw new LinkError('', `${parts.length} entries are more than the ${MOST_ENTRIES} of a link`);
  const own = new Map<Name, string>();
  const changes: Entry[] = [];
  const seen = new Set<string>();
  for (const part of parts) {
    const equals = part.indexOf('=');
    if (equals < 1) throw new LinkError('', `"${short(part)}" is no entry; entries read name=value`);
    const path = part.slice(0, equals);
    const place = path === PACKED ? DESCRIPTION : path;
    if (seen.has(place)) throw new LinkError(path, 'stands twice');
    seen.add(place);
    const value = decode(path, part.slice(equals + 1).replaceAll('+', ' '));
    if ((NAMES as readonly string[]).includes(path)) own.set(path as Name, value);
    else if (path === PACKED) changes.push([DESCRIPTION, unpacked(value)]);
    else changes.push([path, value]);
  }
  return { own, changes };
}

function nameIn<K extends 'tool' | 'view'>(own: ReadonlyMap<Name, string>, key: K): { [key in K]?: string } {
  const name = own.get(key);
  if (name === undefined) return {};
  if (!/^[a-z][a-z0-9-]{0,39}$/.test(name)) throw new LinkError(key, `"${short(name)}" is no name`);
  return { [key]: name } as { [key in K]?: string };
}

function timeIn(own: ReadonlyMap<Name, string>): { time?: number } {
  const text = own.get('time');
  if (text === undefined) return {};
  const time = /^\d/.test(text) ? Number(text) : NaN;
  if (!(time >= 0 && time <= LONGEST_TIME))
    throw new LinkError('time', `must be seconds from 0 to ${LONGEST_TIME}, not "${short(text)}"`);
  return { time };
}

function plotsIn(own: ReadonlyMap<Name, string>): { plots?: unknown } {
  const text = own.get('plots');
  if (text === undefined) return {};
  let plots: unknown;
  try {
    plots = JSON.parse(text);
  } catch {
    throw new LinkError('plots', 'is not JSON; the link was cut or changed on its way');
  }
  checkPlain('plots', plots, DEEPEST_PLOTS);
  return { plots };
}

/** Refuses what is nested too deeply, and names that reach behind an object. @throws LinkError */
function checkPlain(place: string, value: unknown, deep: number): void {
  if (typeof value !== 'object' || value === null) return;
  if (deep === 0) throw new LinkError(place, `is nested more than ${DEEPEST_PLOTS} deep`);
  for (const key of Object.keys(value)) {
    if (key === '__proto__') throw new LinkError(place, 'holds a name that no object may have');
    checkPlain(place, (value as Record<string, unknown>)[key], deep - 1);
  }
}

/** 32 bits (FNV-1a) of the scenario, whatever the order of its names: tells cut and changed links, no more. */
function sumOf(scenario: object): string {
  let hash = 0x811c9dc5;
  for (const c of ordered(scenario)) hash = Math.imul(hash ^ c.charCodeAt(0), 0x01000193);
  return (hash >>> 0).toString(36);
}

function ordered(value: unknown): string {
  if (Array.isArray(value)) return `[${value.map(ordered).join()}]`;
  if (!isRecord(value)) return JSON.stringify(value) ?? '';
  const keys = Object.keys(value).filter((key) => value[key] !== undefined);
  return `{${keys
    .sort()
    .map((key) => `${JSON.stringify(key)}:${ordered(value[key])}`)
    .join()}}`;
}
