/** What differs between two plain objects, as short lines of text: `initial.alpha` → `12 deg`. */

/** Why a link can't be written or read: what, and at which entry. */
export class LinkError extends Error {
  /** The entry, e.g. `initial.alpha`; empty when it concerns the whole link. */
  readonly place: string;
  constructor(place: string, message: string) {
    super(place ? `${short(place)}: ${message}` : message);
    this.name = 'LinkError';
    this.place = place;
  }
}

/** Path and value; the path's names are percent-encoded and joined by dots, the value is as `writeValue` has it, empty to leave the key out. */
export type Entry = readonly [path: string, value: string];

/** Deeper than any scenario. */
const DEEPEST = 6;

/** Strict percent-encoding (RFC 3986): what word processors and chats would take for punctuation or marks is encoded too. */
export const encode = (text: string): string =>
  encodeURIComponent(text).replace(/[!'()*]/g, (c) => `%${c.charCodeAt(0).toString(16).toUpperCase()}`);

/**
 * A text cut to 60 characters, for words.
 *
 * @param text as written
 */
export function short(text: string): string {
  return text.length > 60 ? `${text.slice(0, 59)}…` : text;
}

/**
 * What makes `to` out of `from`, keys in their order. Objects are gone into; anything else, also a list, is replaced whole.
 *
 * @param from record
 * @param to record
 * @throws LinkError for what JSON could not hold
 */
export function difference(from: Readonly<Record<string, unknown>>, to: Readonly<Record<string, unknown>>): Entry[] {
  const entries: Entry[] = [];
  collect('', from, to, entries);
  return entries;
}

function collect(path: string, from: unknown, to: unknown, entries: Entry[]): void {
  if (!isRecord(to)) {
    if (!sameLeaf(from, to)) entries.push([path, writeValue(path, to)]);
    return;
  }
  let before: Record<string, unknown> = isRecord(from) ? from : {};
  const inPlace = isRecord(from) && (path === '' || keepsOrder(from, to));
  // Another order of names is another object to what goes through them one by one: written anew.
  if (!inPlace) {
    before = {};
    if (from !== undefined || keysOf(to).length === 0) entries.push([path, '{}']);
  }
  const under = (key: string): string => (path ? `${path}.` : '') + encode(key).replaceAll('.', '%2E');
  for (const key of keysOf(before)) if (!has(to, key)) entries.push([under(key), '']);
  for (const key of keysOf(to)) {
    if (key === '__proto__') throw new LinkError(under(key), 'is no name that a link can carry');
    collect(under(key), has(before, key) ? before[key] : undefined, to[key], entries);
  }
}

/**
 * A copy of `from` with the entries in force, one after the other.
 *
 * @param from record, which stays as it is
 * @param entries path and value, in order
 * @throws LinkError with the place of an entry that can't be
 */
export function patched(from: Readonly<Record<string, unknown>>, entries: readonly Entry[]): Record<string, unknown> {
  const result = copy(from) as Record<string, unknown>;
  for (const [path, text] of entries) set(result, path, text);
  return result;
}

function set(root: Record<string, unknown>, path: string, text: string): void {
  const names = path.split('.').map((name) => decode(path, name));
  if (names.length > DEEPEST) throw new LinkError(path, `is nested more than ${DEEPEST} deep`);
  if (names.includes('') || names.includes('__proto__')) throw new LinkError(path, 'is no name of a scenario');
  const last = names.pop()!;
  let at = root;
  for (const name of names) {
    if (!Object.hasOwn(at, name)) at[name] = {};
    const next = at[name];
    if (!isRecord(next)) throw new LinkError(path, `"${short(name)}" has no entries of its own`);
    at = next;
  }
  if (text === '') delete at[last];
  else at[last] = readValue(path, text);
}

/**
 * @param place for the error
 * @param text percent-encoded
 * @throws LinkError for a broken percent code
 */
export function decode(place: string, text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    throw new LinkError(place, 'holds a broken % code; the link was cut or changed on its way');
  }
}

/** Text that is not JSON stands for itself, so that `12 deg` needs no quotes; everything else is JSON. */
function writeValue(path: string, value: unknown): string {
  if (typeof value === 'string') return isJson(value) || !isWellFormed(value) ? JSON.stringify(value) : value;
  if (isListed(value)) return writeListed(value);
  throw new LinkError(path, 'is nothing that a link can carry');
}

/**
 * A value of a link: JSON, or text that stands for itself.
 *
 * @param path for the error
 * @param text as written
 * @throws LinkError
 */
export function readValue(path: string, text: string): unknown {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return text;
  }
  if (isListed(value)) return value;
  if (isRecord(value) && keysOf(value).length === 0) return {};
  throw new LinkError(path, 'holds a nested value; its parts belong in entries of their own');
}

/** Minus zero is another number. */
const writeListed = (value: unknown): string =>
  Array.isArray(value) ? `[${value.map(writeListed).join(',')}]` : Object.is(value, -0) ? '-0' : JSON.stringify(value);

/** A word or number, a list of such (what is held), or of such lists (a ride's commands). */
const isListed = (value: unknown, depth = 2): boolean =>
  isScalar(value) || (depth > 0 && Array.isArray(value) && value.every((item) => isListed(item, depth - 1)));

function isScalar(value: unknown): boolean {
  return (
    value === null ||
    typeof value === 'string' ||
    typeof value === 'boolean' ||
    (typeof value === 'number' && Number.isFinite(value))
  );
}

function isJson(text: string): boolean {
  if (text === '') return true;
  try {
    JSON.parse(text);
    return true;
  } catch {
    return false;
  }
}

/** Half of a surrogate pair has no percent code. */
function isWellFormed(text: string): boolean {
  try {
    encodeURIComponent(text);
    return true;
  } catch {
    return false;
  }
}

/**
 * Whether a value is an object with keys, and not a list.
 *
 * @param value anything
 */
export function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

/** Keys that say something; undefined is as good as not there. */
const keysOf = (record: Readonly<Record<string, unknown>>): string[] =>
  Object.keys(record).filter((key) => record[key] !== undefined);
const has = (record: Readonly<Record<string, unknown>>, key: string): boolean =>
  Object.hasOwn(record, key) && record[key] !== undefined;

/** Whether taking out and adding at the end leads to these keys in this order. */
function keepsOrder(from: Readonly<Record<string, unknown>>, to: Readonly<Record<string, unknown>>): boolean {
  const reached = [...keysOf(from).filter((key) => has(to, key)), ...keysOf(to).filter((key) => !has(from, key))];
  return keysOf(to).every((key, i) => key === reached[i]);
}

function sameLeaf(a: unknown, b: unknown): boolean {
  if (Array.isArray(a) && Array.isArray(b)) return a.length === b.length && a.every((item, i) => sameLeaf(item, b[i]));
  return Object.is(a, b);
}

/**
 * A deep copy.
 *
 * @param value JSON as parsed
 */
export function copy(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(copy);
  return isRecord(value) ? Object.fromEntries(Object.entries(value).map(([key, entry]) => [key, copy(entry)])) : value;
}
