import type { SystemMeta } from './system.ts';

/**
 * Coordinates, parameters or inputs, those that the system shows first in front; a coordinate also by its rate.
 *
 * @param list in the order of the system
 * @param meta of the system
 */
export function shownFirst<T extends { name: string }>(list: readonly T[], { shown = [] }: SystemMeta): readonly T[] {
  if (shown.length === 0) return list;
  const names = shown.map((name) => name.replace(/(_dot|')$/, ''));
  const place = ({ name }: T): number => (names.includes(name) ? names.indexOf(name) : names.length);
  return [...list].sort((a, b) => place(a) - place(b));
}

/**
 * Whether the system shows any of these first.
 *
 * @param list of the system
 * @param meta of the system
 */
export const showsAny = (list: readonly { name: string }[], { shown = [] }: SystemMeta): boolean =>
  list.some(({ name }) => shown.includes(name));
