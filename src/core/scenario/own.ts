/**
 * Systems that a person describes (docs/own-systems.md), as scenarios name them. Outside, in files, links and calls of a
 * worker, `system` is `{"description": "…"}`; inside, it is an id made of the text, under which the system is known once the
 * text has been read (`core/systems/own.ts`).
 */
import type { SystemMeta } from '../model/system.ts';

export const OWN = 'own-';

/**
 * The id of a text: 64 bits (FNV-1a from two starts).
 *
 * @param text of the description
 */
export function ownId(text: string): string {
  let [a, b] = [0x811c9dc5, 0x2c1b3c6d];
  for (let i = 0; i < text.length; i++) {
    const c = text.charCodeAt(i);
    a = Math.imul(a ^ c, 0x01000193);
    b = Math.imul(b ^ c, 0x01000193) ^ (b >>> 15);
  }
  return `${OWN}${(a >>> 0).toString(36)}${(b >>> 0).toString(36)}`;
}

export const isOwn = (id: string): boolean => id.startsWith(OWN);

/**
 * The text that a raw scenario holds; null where it names a system, or nothing.
 *
 * @param raw JSON as parsed
 */
export function descriptionIn(raw: unknown): string | null {
  const system = (raw as { system?: { description?: unknown } } | null | undefined)?.system;
  return typeof system === 'object' && typeof system?.description === 'string' ? system.description : null;
}

/**
 * Id of the system that a scenario names, or that it describes; null where it does neither.
 *
 * @param scenario as parsed
 */
export function systemNamed(scenario: unknown): string | null {
  const system = (scenario as { system?: unknown } | null)?.system;
  const text = descriptionIn(scenario);
  return text === null ? (typeof system === 'string' ? system : null) : ownId(text);
}

/**
 * A scenario as it is used: an own system by its id.
 *
 * @param raw as parsed
 */
export function settled<S extends object>(raw: S): S {
  const text = descriptionIn(raw);
  return text === null ? raw : { ...raw, system: ownId(text) };
}

/** Of a scenario. */
export type Written<S> = Omit<S, 'system' | 'description'> & { system: string | { description: string } };

/**
 * A scenario as it is written: an own system by its description.
 *
 * @param scenario as it is used
 * @param systems metas by id
 */
export function written<S extends { system: string; description?: string }>(
  scenario: S,
  systems: Readonly<Record<string, Pick<SystemMeta, 'description'>>>,
): Written<S> {
  const text = Object.hasOwn(systems, scenario.system) ? systems[scenario.system]!.description : undefined;
  if (text === undefined) return scenario;
  const { description: _, system: __, ...rest } = scenario;
  return { ...(rest as Omit<S, 'system' | 'description'>), system: { description: text } };
}
