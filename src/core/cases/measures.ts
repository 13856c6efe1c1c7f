import { luFactor, luSolve } from '../linalg/lu.ts';
import type { SystemView } from '../systems/types.ts';
import type { Measure } from './case.ts';

/** Recorded columns by name, or undefined where there is none. */
export type Columns = (name: string) => Float64Array | undefined;

/**
 * Columns of a run as plots and measures name them: recorded ones, and `<body>.x`, `.y`, `.z`, the place of a body's
 * origin (m).
 * @throws Error for a name that is neither
 */
export function caseColumns(view: SystemView, parameters: Readonly<Record<string, number>>, recorded: Columns): (name: string) => Float64Array {
  const { coordinates, bodies } = view.meta;
  const p = Float64Array.from(view.meta.parameters, (m) => parameters[m.name] ?? m.default);
  const poses = new Float64Array(12 * bodies.length);
  const q = new Float64Array(coordinates.length);
  return (name) => {
    const column = recorded(name);
    if (column) return column;
    const [body, axis] = name.split('.');
    const offset = 12 * bodies.findIndex((b) => b.id === body) + ['x', 'y', 'z'].indexOf(axis ?? '');
    if (offset < 0 || !axis || axis.length !== 1) throw new Error(`there is no column "${name}"`);
    const state = coordinates.map((c) => recorded(c.name)!);
    return recorded('t')!.map((_, row) => {
      for (let i = 0; i < q.length; i++) q[i] = state[i]![row]!;
      view.poses(q, p, poses);
      return poses[offset]!;
    });
  };
}

/** The number that a measure names; `column` as made by `caseColumns`. NaN for a time without a row. */
export function measured(measure: Measure, column: (name: string) => Float64Array): number {
  const t = column('t');
  if (measure.kind === 'end') return column(measure.column)[t.length - 1]!;
  if (measure.kind === 'at') return column(measure.column)[t.findIndex((time) => Math.abs(time - measure.time) < 1e-9)] ?? NaN;
  const { from = -Infinity, to = Infinity } = measure;
  const within = (values: Float64Array): Float64Array => values.filter((_, row) => t[row]! >= from && t[row]! <= to);
  if (measure.kind === 'diameter') return circleDiameter(within(column(measure.x)), within(column(measure.y)));
  const values = within(column(measure.column));
  return measure.kind === 'max' ? Math.max(...values) : Math.min(...values);
}

/** Least squares of x² + y² + a x + b y + c = 0 over the points, about their mean; the diameter of that circle. */
function circleDiameter(x: Float64Array, y: Float64Array): number {
  const [meanX, meanY] = [mean(x), mean(y)];
  const A = new Float64Array(9);
  const right = new Float64Array(3);
  for (let k = 0; k < x.length; k++) {
    const row = [x[k]! - meanX, y[k]! - meanY, 1];
    const square = row[0]! ** 2 + row[1]! ** 2;
    for (let i = 0; i < 3; i++) {
      right[i]! -= row[i]! * square;
      for (let j = 0; j < 3; j++) A[3 * i + j]! += row[i]! * row[j]!;
    }
  }
  const pivots = new Int32Array(3);
  if (!luFactor(A, 3, pivots)) return NaN;
  luSolve(A, 3, pivots, right);
  return Math.sqrt(right[0]! ** 2 + right[1]! ** 2 - 4 * right[2]!);
}

const mean = (values: Float64Array): number => values.reduce((sum, value) => sum + value, 0) / values.length;
