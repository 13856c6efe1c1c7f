/** States by name as the catalogue of columns has them, and the part of a draft that an analysis depends on. */
import type { ScenarioFile } from '../../core/scenario/types.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import { columnOf, type Column } from '../../core/motion/columns.ts';

/** Coordinates, then (unless the equations are of first order) their rates, as the catalogue has them. */
export function statesOf(meta: SystemMeta): ReadonlyMap<string, Column> {
  const names = meta.coordinates.map((c) => c.name);
  const rates = meta.order === 1 ? [] : names.map((name) => `${name}_dot`);
  return new Map([...names, ...rates].map((name) => [name, columnOf(meta, name)]));
}

/** What of a draft decides its operating point, its linearization and its gain: all else may be wrong or change. */
export function analysedPart({
  version,
  system,
  parameterSet,
  parameters,
  constraints,
  hold,
  release,
  control,
  at,
}: ScenarioFile): ScenarioFile {
  const lqr = control?.type === 'lqr' ? { control } : at === undefined ? {} : { at };
  const all = { parameterSet, parameters, constraints, hold, release, ...lqr };
  return {
    version,
    system,
    ...(Object.fromEntries(Object.entries(all).filter(([, value]) => value !== undefined)) as Partial<ScenarioFile>),
  };
}

type At = NonNullable<ScenarioFile['at']>;

/** The operating point as it is written: the controller's where there is one. */
export function pointOf({ control, at }: ScenarioFile): At {
  return (control?.type === 'lqr' ? control.at : at) ?? {};
}

/** Where a fault of the point is told. */
export const pointPath = ({ control }: ScenarioFile): string => (control?.type === 'lqr' ? 'control.at' : 'at');

/** A draft with one value of its operating point changed, or left open. */
export function withPoint(draft: ScenarioFile, name: string, value: At[string] | undefined): ScenarioFile {
  const { [name]: _, ...rest } = pointOf(draft);
  const next = value === undefined ? rest : { ...rest, [name]: value };
  const { at: __, ...plain } = draft;
  if (draft.control?.type === 'lqr') return { ...draft, control: { ...draft.control, at: next } };
  return Object.keys(next).length > 0 ? { ...plain, at: next } : plain;
}
