import { luFactor, luSolve } from '../linalg/lu.ts';
import { integral } from './integral.ts';
import { recipeOf } from './recipes.ts';
import type { SystemView } from '../model/system.ts';
import type { Measure } from '../cases/case.ts';

/** Recorded columns by name, or undefined where there is none. */
export type Columns = (name: string) => Float64Array | undefined;

/**
 * Columns of a run as plots and measures name them: recorded ones, and those that the catalogue computes of them.
 *
 * @param view of the system
 * @param parameters by name, SI
 * @param recorded columns of the run
 * @throws Error for a name that is neither
 */
export function caseColumns(
  view: SystemView,
  parameters: Readonly<Record<string, number>>,
  recorded: Columns,
): (name: string) => Float64Array {
  return (name) => {
    const column = recorded(name);
    if (column) return column;
    const recipe = recipeOf(view, parameters, (other) => recorded(other) !== undefined, name);
    if (!recipe) throw new Error(`there is no column "${name}", and what is recorded is not enough to compute it`);
    const from = recipe.from.map((other) => recorded(other)!);
    let before = 0;
    return recorded('t')!.map((_, row) => (before = recipe.value(from, row, before)));
  };
}

/**
 * The number that a measure names; `column` as made by `caseColumns`. NaN for a time without a row.
 *
 * @param measure which number of which column
 * @param column values by name, a row each
 */
export function measured(measure: Measure, column: (name: string) => Float64Array): number {
  const t = column('t');
  if (measure.kind === 'end') return column(measure.column)[t.length - 1]!;
  if (measure.kind === 'at')
    return column(measure.column)[t.findIndex((time) => Math.abs(time - measure.time) < 1e-9)] ?? NaN;
  const { from = -Infinity, to = Infinity } = measure;
  const within = (values: Float64Array): Float64Array => values.filter((_, row) => t[row]! >= from && t[row]! <= to);
  const distance = (along: { x: string; y: string }): number =>
    pathLength(within(column(along.x)), within(column(along.y)));
  const energy = (spent: 'net' | 'gross'): number =>
    integral(within(t), within(column(spent === 'net' ? 'power' : 'power.gross')));
  switch (measure.kind) {
    case 'diameter':
      return circleDiameter(within(column(measure.x)), within(column(measure.y)));
    case 'distance':
      return distance(measure);
    case 'speed':
      return distance(measure) / (within(t).at(-1)! - within(t)[0]!);
    case 'energy':
      return energy(measure.spent);
    case 'energyPerMetre':
      return energy(measure.spent) / distance(measure);
    case 'max':
      return Math.max(...within(column(measure.column)));
    case 'min':
      return Math.min(...within(column(measure.column)));
  }
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

function pathLength(x: Float64Array, y: Float64Array): number {
  let length = 0;
  for (let row = 1; row < x.length; row++) length += Math.hypot(x[row]! - x[row - 1]!, y[row]! - y[row - 1]!);
  return length;
}

const mean = (values: Float64Array): number => values.reduce((sum, value) => sum + value, 0) / values.length;
