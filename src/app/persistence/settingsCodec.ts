/** The settings as stored text and links have them, by the table: what is not a value of its setting is passed over. */
import { sameContent } from '../state/draft.ts';
import { SETTINGS, settingIds, type PageFacts, type SettingId, type SettingValues } from '../state/settingsTable.ts';

type Plain = Record<string, unknown>;

/** As a plain object in the order of the table; `group.name` becomes an object of its own. */
export function toStored(values: Partial<SettingValues>): Plain {
  const plain: Plain = {};
  for (const id of settingIds) {
    const { stored, sparse, initial } = SETTINGS[id];
    if (stored === undefined || !(id in values) || (sparse && values[id] === initial)) continue;
    const [group, name] = placeOf(stored);
    if (group === null) plain[name] = values[id];
    else ((plain[group] ??= {}) as Plain)[name] = values[id];
  }
  return plain;
}

/** @throws Error when a group is no object */
export function fromStored(raw: Plain, page: PageFacts): Partial<SettingValues> {
  return collected((id) => {
    const { stored } = SETTINGS[id];
    if (stored === undefined) return undefined;
    const [group, name] = placeOf(stored);
    const holder = group === null ? raw : raw[group] === undefined ? {} : recordOf(raw[group]);
    return Object.hasOwn(holder, name) ? check(id, holder[name], page) : undefined;
  });
}

/** What a link says of them: only what is not at its initial value. */
export function toLink(values: SettingValues): { tool?: string; view?: string; plots?: unknown } {
  return Object.fromEntries(
    settingIds.flatMap((id) => {
      const { linked, initial } = SETTINGS[id];
      return linked === undefined || sameContent(values[id], initial) ? [] : [[linked, values[id]]];
    }),
  );
}

/** What a link sets; what it leaves out is as the table says. */
export function fromLink(
  link: { tool?: string; view?: string; plots?: unknown },
  page: PageFacts,
): Partial<SettingValues> {
  return collected((id) => {
    const { linked, initial, reset } = SETTINGS[id];
    if (linked === undefined) return undefined;
    const named = link[linked];
    return (named === undefined ? undefined : check(id, named, page)) ?? (reset ? initial : undefined);
  });
}

function collected(valueOf: (id: SettingId) => unknown): Partial<SettingValues> {
  return Object.fromEntries(
    settingIds.flatMap((id) => {
      const value = valueOf(id);
      return value === undefined ? [] : [[id, value]];
    }),
  );
}

const check = (id: SettingId, value: unknown, page: PageFacts): unknown => SETTINGS[id].check(value, page);

function placeOf(stored: string): [group: string | null, name: string] {
  const at = stored.indexOf('.');
  return at < 0 ? [null, stored] : [stored.slice(0, at), stored.slice(at + 1)];
}

export function recordOf(value: unknown): Record<string, unknown> {
  if (typeof value !== 'object' || value === null || Array.isArray(value))
    throw new Error('it is not what this page stores');
  return value as Record<string, unknown>;
}
