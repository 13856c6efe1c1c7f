import type { SystemMeta } from '../model/system.ts';

/**
 * Columns of a motion with those of coordinates that its system holds by default: where they are left out they stood still at 0.
 * Files and runs from before a system had such a coordinate are read so.
 *
 * @param meta of the system
 * @param names of the columns, `t` first
 * @param data as many columns, of one length
 * @returns names and columns, what was left out behind the coordinates or rates that there are; and which coordinates these are
 */
export function withHeld(
  { coordinates, held = [] }: Pick<SystemMeta, 'coordinates' | 'held'>,
  names: readonly string[],
  data: readonly Float64Array[],
): { names: string[]; data: Float64Array[]; added: string[] } {
  const there = new Set(names);
  const added = held.filter((name) => !there.has(name));
  const order = coordinates.map(({ name }) => name);
  const rated = order.some((name) => there.has(`${name}_dot`));
  const [all, columns] = [[...names], [...data]];
  for (const [own, wanted] of [
    [order, added],
    [order.map((name) => `${name}_dot`), rated ? added.map((name) => `${name}_dot`) : []],
  ] as const) {
    const at = all.reduce((last, name, i) => (own.includes(name) ? i + 1 : last), all.length);
    const missing = wanted.filter((name) => !there.has(name));
    all.splice(at, 0, ...missing);
    columns.splice(at, 0, ...missing.map(() => new Float64Array(data[0]?.length ?? 0)));
  }
  return { names: all, data: columns, added };
}
