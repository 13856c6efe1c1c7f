import type { InputMeta, SystemMeta } from './system.ts';

/**
 * The named inputs of a system and a raw generalized force `f_<coordinate>` on each coordinate; none on one of first order.
 *
 * @param meta of the system
 */
export function inputsOf(meta: SystemMeta): InputMeta[] {
  if (meta.order === 1) return [];
  const raw = meta.coordinates
    .filter((c) => !meta.inputs.some((i) => i.name === `f_${c.name}`))
    .map((c) => ({
      name: `f_${c.name}`,
      symbol: `f_${c.name}`,
      label: `generalized force on ${c.name}`,
      unit: c.kind === 'angle' ? 'N·m' : 'N',
      column: { [c.name]: 1 },
    }));
  return [...meta.inputs, ...raw];
}
