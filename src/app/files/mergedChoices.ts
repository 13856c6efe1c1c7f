import type { ImportChoices } from '../../csv/plan.ts';
import { rememberedFrom, type RememberedChoices } from './importChoices.ts';

/** With the choices for one shape; none at all forgets it. */
export function remembering(
  known: RememberedChoices | null,
  shape: string,
  choices: ImportChoices,
): RememberedChoices | null {
  const { [shape]: _, ...others } = known ?? {};
  return rememberedFrom({ ...others, [shape]: choices }) ?? null;
}

/** Later choices over earlier ones; columns and units are chosen one by one. */
export function mergedChoices(before: ImportChoices, change: ImportChoices): ImportChoices {
  return {
    ...before,
    ...change,
    ...(change.map ? { map: { ...before.map, ...change.map } } : {}),
    ...(change.units ? { units: { ...before.units, ...change.units } } : {}),
  };
}
