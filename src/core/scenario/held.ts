import type { SystemMeta } from '../model/system.ts';

/** What a scenario says of held coordinates. */
export interface Holding {
  hold?: readonly string[] | undefined;
  release?: readonly string[] | undefined;
}

type Meta = Pick<SystemMeta, 'held' | 'coordinates'>;

/**
 * The coordinates that stay where they start. What a system holds by default stays held, except what `release` names; a `hold`
 * that is empty or names one of those says it all and is taken as it stands.
 *
 * @param meta of the system
 * @param file names of its coordinates
 * @returns names, those of `hold` first
 */
export function heldOf({ held = [] }: Meta, { hold, release = [] }: Holding): string[] {
  if (hold && (hold.length === 0 || hold.some((name) => held.includes(name)))) return [...hold];
  return [...(hold ?? []), ...held.filter((name) => !release.includes(name))];
}

/**
 * How a scenario says what is held, in the fewest words: the inverse of `heldOf`.
 *
 * @param meta of the system
 * @param names of coordinates that are to be held
 */
export function holdingOf(
  { held = [], coordinates }: Meta,
  names: readonly string[],
): { hold?: string[]; release?: string[] } {
  const order = coordinates.map(({ name }) => name);
  const hold = order.filter((name) => names.includes(name) && !held.includes(name));
  const release = held.filter((name) => !names.includes(name));
  return { ...(hold.length > 0 ? { hold } : {}), ...(release.length > 0 ? { release } : {}) };
}
