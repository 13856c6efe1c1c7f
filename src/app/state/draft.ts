/** Edits of the draft: always a new object, and only keys that differ from their default stay. */
import type { MethodOptions, NumberOrExpression, ScenarioFile } from '../../core/scenario/types.ts';
import type { SystemMeta } from '../../core/model/system.ts';

export type Entries = 'initial' | 'parameters' | 'inputs' | 'events';

/** `undefined` takes the key out. */
export function withKey<K extends keyof ScenarioFile>(
  draft: ScenarioFile,
  key: K,
  value: ScenarioFile[K] | undefined,
): ScenarioFile {
  const next = { ...draft };
  if (value === undefined) delete next[key];
  else next[key] = value;
  return next;
}

export function withEntry(
  draft: ScenarioFile,
  section: Entries,
  name: string,
  value: NumberOrExpression | undefined,
): ScenarioFile {
  return withKey(draft, section, changed(draft[section], name, value) as never);
}

export function withMethod<K extends keyof MethodOptions>(
  draft: ScenarioFile,
  key: K,
  value: MethodOptions[K] | undefined,
): ScenarioFile {
  return withKey(draft, 'method', changed(draft.method as Record<string, unknown>, key, value) as never);
}

function changed(record: Readonly<Record<string, unknown>> | undefined, name: string, value: unknown) {
  const next: Record<string, unknown> = { ...record };
  if (value === undefined) delete next[name];
  else next[name] = value;
  return Object.keys(next).length > 0 ? next : undefined;
}

/** Another parameter set; values that it already holds need not be named any more. */
export function withParameterSet(draft: ScenarioFile, meta: SystemMeta, set: string | undefined): ScenarioFile {
  const named = Object.entries(draft.parameters ?? {}).filter(
    ([name, value]) => value !== parameterDefault(meta, set, name),
  );
  return withKey(
    withKey(draft, 'parameterSet', set),
    'parameters',
    named.length > 0 ? Object.fromEntries(named) : undefined,
  );
}

/** What a parameter is when the draft does not name it. */
export function parameterDefault(meta: SystemMeta, set: string | undefined, name: string): number {
  const inSet = set === undefined ? undefined : meta.parameterSets[set]?.[name];
  return inSet ?? meta.parameters.find((p) => p.name === name)?.default ?? 0;
}

/** Same content, whatever the order of keys. */
export function sameContent(a: unknown, b: unknown): boolean {
  if (Object.is(a, b)) return true;
  if (typeof a !== 'object' || typeof b !== 'object' || a === null || b === null) return false;
  if (Array.isArray(a) !== Array.isArray(b)) return false;
  const [left, right] = [a as Record<string, unknown>, b as Record<string, unknown>];
  const keys = Object.keys(left);
  return (
    keys.length === Object.keys(right).length && keys.every((key) => key in right && sameContent(left[key], right[key]))
  );
}
