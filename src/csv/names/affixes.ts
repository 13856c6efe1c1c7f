/** Names that a program made longer, all in one way: `board_x` … `board_theta`, `x_est` … `theta_est`. */
import type { Source } from '../source.ts';
import { isOtherQuantity } from './plainName.ts';

/** Groups looked at: more of them would be no bodies. */
const MOST_GROUPS = 40;

/**
 * The columns with the common part as a group's name before them (`board.x`), where by it a group is one body; null where
 * there is none.
 * @param isBody whether columns by these names (null: not of the group) hold all coordinates of a system
 */
export function withoutAffixes(
  sources: readonly Source[],
  isBody: (names: readonly (string | null)[]) => boolean,
): Source[] | null {
  const groups = new Map<string, (string | null)[]>();
  for (const [i, { plain }] of sources.entries()) {
    if (plain.length > 80) continue;
    const parts = plain.split('_');
    for (let k = 1; k < parts.length; k++)
      for (const [key, rest] of [
        [`${parts.slice(0, k).join('_')}_`, parts.slice(k).join('_')],
        [`_${parts.slice(k).join('_')}`, parts.slice(0, k).join('_')],
      ] as const) {
        const group = groups.get(key) ?? sources.map(() => null);
        groups.set(key, group);
        group[i] = rest;
      }
  }
  const bodies = [...groups]
    .filter(([key, names]) => !isOtherQuantity(key) && names.filter((name) => name !== null).length > 1)
    .slice(0, MOST_GROUPS)
    .filter(([, names]) => isBody(names));
  if (bodies.length === 0) return null;
  return sources.map((source, i) => {
    const of = bodies.find(([, names]) => names[i] !== null);
    return of ? { ...source, plain: `${of[0].replace(/^_|_$/g, '')}.${of[1][i]!}` } : source;
  });
}
