/** Names of states and inputs as a person reads them, and the part of a draft that an analysis depends on. */
import type { ScenarioFile } from '../../core/scenario/types.ts';
import type { ColourRole, SystemMeta } from '../../core/model/system.ts';

export interface StateName {
  name: string;
  /** Of a rate, that of its coordinate. */
  symbol: string;
  label: string;
  /** SI, e.g. `rad/s`. */
  unit: string;
  angle: boolean;
  rate: boolean;
  role: ColourRole;
}

/** Coordinates, then (unless the equations are of first order) their rates. */
export function stateNames(
  { coordinates, order }: Pick<SystemMeta, 'coordinates' | 'order'>,
  rateWord: string,
): Map<string, StateName> {
  const names = new Map<string, StateName>();
  for (const { name, symbol, label, kind, role } of coordinates) {
    const [angle, unit] = [kind === 'angle', kind === 'angle' ? 'rad' : 'm'];
    names.set(name, { name, symbol, label, unit, angle, rate: false, role });
    if (order !== 1)
      names.set(`${name}_dot`, {
        name: `${name}_dot`,
        symbol,
        label: `${label}, ${rateWord}`,
        unit: `${unit}/s`,
        angle,
        rate: true,
        role,
      });
  }
  return names;
}

/** What of a draft decides its operating point, its linearization and its gain: all else may be wrong or change. */
export function analysedPart({
  version,
  system,
  parameterSet,
  parameters,
  constraints,
  hold,
  control,
  at,
}: ScenarioFile): ScenarioFile {
  const lqr = control?.type === 'lqr' ? { control } : at === undefined ? {} : { at };
  const all = { parameterSet, parameters, constraints, hold, ...lqr };
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
