import { integral } from '../motion/integral.ts';
import { ExpressionError } from '../scenario/expressions.ts';
import { Formula } from '../scenario/formula.ts';

/**
 * A number of a run: a column, or an expression of columns, over its rows (`max(abs(alpha))`, `settle.alpha`), or a fact of
 * the run itself.
 */
export const KINDS = ['max', 'min', 'mean', 'final', 'rise', 'settle', 'overshoot'] as const;
export type Kind = (typeof KINDS)[number];

/**
 * Facts: `time` when the run ended, s; `distance` along the ground, m; `work` that the inputs put in, J, with nothing given
 * back (`power.gross`); `energyPerMetre`, J/m; `batteryHour`, what an hour of it takes, Wh.
 */
export const FACTS = ['time', 'distance', 'work', 'energyPerMetre', 'batteryHour'] as const;
export type Fact = (typeof FACTS)[number];

export type ParsedMeasure = { fact: Fact } | { kind: Kind; expression: string };

const SHAPE = new RegExp(`^\\s*(${KINDS.join('|')})\\s*(?:\\.\\s*([A-Za-z_]\\w*)|\\((.*)\\))\\s*$`, 's');

/**
 * @param text as written in the file
 * @throws Error with words of what would be right
 */
export function measureOf(text: string): ParsedMeasure {
  const plain = text.trim();
  if ((FACTS as readonly string[]).includes(plain)) return { fact: plain as Fact };
  const found = SHAPE.exec(plain);
  if (!found)
    throw new Error(
      `"${plain.slice(0, 60)}" is no measure; right would be ${KINDS.map((kind) => `${kind}(…)`).join(', ')} of an expression of columns, or ${FACTS.join(', ')}`,
    );
  return { kind: found[1] as Kind, expression: (found[2] ?? found[3])!.trim() };
}

/** A rise is from a tenth to nine tenths of the change; settled is within a fiftieth of it. */
const RISE = [0.1, 0.9] as const;
const SETTLED = 0.02;
/** A response must be settled before this part of its rows. */
const LATEST = 0.9;
/** The final value is the mean over this part of the rows. */
const FINAL = 0.02;

/**
 * @param expression of the columns
 * @param names of the columns that an expression may use
 * @param column by name; undefined where there is none
 * @param rows how many
 */
export function valuesOf(
  expression: string,
  names: readonly string[],
  column: (name: string) => Float64Array,
  rows: number,
): Float64Array {
  const used = names.filter((name) => new RegExp(`(?<![\\w.])${name}(?!\\w)`).test(expression));
  let formula: Formula;
  try {
    formula = new Formula(expression, used);
  } catch (error) {
    if (error instanceof ExpressionError && /unknown name/.test(error.message))
      throw new Error(`${error.message}; columns of the run: ${names.join(', ')}`);
    throw error;
  }
  const columns = used.map(column);
  const at = new Float64Array(used.length);
  return Float64Array.from({ length: rows }, (_, row) => {
    for (let i = 0; i < at.length; i++) at[i] = columns[i]![row]!;
    return formula.evaluate(at);
  });
}

/**
 * @param kind which number of the values
 * @param t times of the rows, s, ascending
 * @param values one for each time
 * @returns NaN where the run has no such number (no row, or a step that never rises)
 */
export function reduced(kind: Kind, t: Float64Array, values: Float64Array): number {
  const n = values.length;
  if (n === 0) return NaN;
  switch (kind) {
    case 'max':
      return values.reduce((a, b) => Math.max(a, b));
    case 'min':
      return values.reduce((a, b) => Math.min(a, b));
    case 'mean':
      return n > 1 && t[n - 1]! > t[0]! ? integral(t, values) / (t[n - 1]! - t[0]!) : values[0]!;
    default:
      return ofResponse(kind, t, values);
  }
}

/** What is read of a step response that goes from its first value to its final one. */
function ofResponse(kind: Kind, t: Float64Array, values: Float64Array): number {
  const n = values.length;
  const tail = values.subarray(n - Math.max(1, Math.round(FINAL * n)));
  const final = tail.reduce((a, b) => a + b, 0) / tail.length;
  if (kind === 'final') return final;
  const change = final - values[0]!;
  // A response that comes back to where it began is measured by how far it went.
  const size = Math.max(
    Math.abs(change),
    kind === 'settle' ? values.reduce((a, x) => Math.max(a, Math.abs(x - final)), 0) : 0,
  );
  if (!(size > 0)) return kind === 'settle' || kind === 'overshoot' ? 0 : NaN;
  if (kind === 'settle') {
    let row = n - 1;
    while (row >= 0 && Math.abs(values[row]! - final) <= SETTLED * size) row--;
    // What only its end is near has not settled.
    return row + 1 >= LATEST * n && row >= 0 ? NaN : t[row + 1]! - t[0]!;
  }
  const share = (row: number): number => (values[row]! - values[0]!) / change;
  if (kind === 'overshoot') {
    let most = 0;
    for (let row = 0; row < n; row++) most = Math.max(most, share(row) - 1);
    return most;
  }
  const first = (level: number): number => {
    let row = 0;
    while (row < n && !(share(row) >= level)) row++;
    return row < n ? t[row]! : NaN;
  };
  return first(RISE[1]) - first(RISE[0]);
}
