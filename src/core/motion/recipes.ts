/** How a column that is not recorded follows from those that are: its rows one after another. */
import { inputsOf } from '../model/inputs.ts';
import type { SystemView } from '../model/system.ts';
import { groundCoordinates } from './columns.ts';

export interface Recipe {
  /** Recorded columns that it is made of. */
  from: readonly string[];
  /**
   * @param columns values of `from`, in its order
   * @param row from 0, every row in turn
   * @param before the value of the row before; of the first row, 0
   */
  value(columns: readonly Float64Array[], row: number, before: number): number;
}

/**
 * The recipe of a computed column of the catalogue, or null where there is none or something that it needs is missing:
 * sums of coordinates (own rolls) and their rates; `power`, `power.gross` of the inputs, sum of u times its rate and of
 * its absolute values (W), and `work`, its integral (J); `speed` and `path` over the ground (m/s, m); `<body>.x`, `.y`,
 * `.z`, the place of a body's origin (m).
 *
 * @param view of the system
 * @param parameters by name, SI; those that are not named have their defaults
 * @param has whether a column is recorded
 * @param name of the column
 */
export function recipeOf(
  view: SystemView,
  parameters: Readonly<Record<string, number>>,
  has: (name: string) => boolean,
  name: string,
): Recipe | null {
  const made =
    sum(view, name) ??
    (name === 'power' || name === 'power.gross'
      ? power(view, has, name === 'power.gross')
      : name === 'work'
        ? work(view, has)
        : name === 'path'
          ? path(view)
          : name === 'speed'
            ? speed(view)
            : place(view, parameters, name));
  return made && made.from.every(has) ? made : null;
}

function sum({ meta }: SystemView, name: string): Recipe | null {
  const rate = name.endsWith('_dot') ? '_dot' : '';
  const found = meta.sums?.find((s) => `${s.name}${rate}` === name);
  if (!found) return null;
  return {
    from: found.of.map((coordinate) => coordinate + rate),
    value: (columns, row) => columns.reduce((total, values) => total + values[row]!, 0),
  };
}

/** Of the inputs that are recorded; none where one of the system's own is not. */
function power({ meta }: SystemView, has: (name: string) => boolean, gross: boolean): Recipe | null {
  const inputs = inputsOf(meta);
  const recorded = inputs.filter(({ name }) => has(name));
  if (recorded.length === 0 || meta.inputs.some(({ name }) => !has(name))) return null;
  const from: string[] = [];
  const terms = recorded.map(({ name, column }) => {
    const u = from.push(name) - 1;
    return { u, rates: Object.entries(column).map(([c, weight]) => ({ rate: from.push(`${c}_dot`) - 1, weight })) };
  });
  return {
    from,
    value(columns, row) {
      let total = 0;
      for (const { u, rates } of terms) {
        let rate = 0;
        for (const r of rates) rate += r.weight * columns[r.rate]![row]!;
        const part = columns[u]![row]! * rate;
        total += gross ? Math.abs(part) : part;
      }
      return total;
    },
  };
}

/** Trapezoidal rule over the rows of the power; what is not a number adds nothing. */
function work(view: SystemView, has: (name: string) => boolean): Recipe | null {
  const of = power(view, has, false);
  if (!of) return null;
  const t = of.from.length;
  return {
    from: [...of.from, 't'],
    value(columns, row, before) {
      if (row === 0) return 0;
      const span = columns[t]![row]! - columns[t]![row - 1]!;
      const share = 0.5 * span * (of.value(columns, row, 0) + of.value(columns, row - 1, 0));
      return share - share === 0 ? before + share : before;
    },
  };
}

function path({ meta }: SystemView): Recipe | null {
  const from = groundCoordinates(meta);
  if (from.length === 0) return null;
  return {
    from,
    value(columns, row, before) {
      if (row === 0) return 0;
      let square = 0;
      for (const c of columns) square += (c[row]! - c[row - 1]!) ** 2;
      const step = Math.sqrt(square);
      return step - step === 0 ? before + step : before;
    },
  };
}

function speed({ meta }: SystemView): Recipe | null {
  const from = groundCoordinates(meta).map((c) => `${c}_dot`);
  if (from.length === 0) return null;
  return { from, value: (columns, row) => Math.hypot(...columns.map((c) => c[row]!)) };
}

function place(view: SystemView, parameters: Readonly<Record<string, number>>, name: string): Recipe | null {
  const { bodies, coordinates, parameters: metas } = view.meta;
  const [id, axis = ''] = name.split('.');
  const body = bodies.findIndex((b) => b.id === id);
  if (body < 0 || !/^[xyz]$/.test(axis)) return null;
  const at = 12 * body + 'xyz'.indexOf(axis);
  const p = Float64Array.from(metas, (m) => parameters[m.name] ?? m.default);
  const poses = new Float64Array(12 * bodies.length);
  const q = new Float64Array(coordinates.length);
  return {
    from: coordinates.map((c) => c.name),
    value(columns, row) {
      for (let i = 0; i < q.length; i++) q[i] = columns[i]![row]!;
      view.poses(q, p, poses);
      return poses[at]!;
    },
  };
}
