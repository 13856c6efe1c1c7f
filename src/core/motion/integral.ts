/**
 * Trapezoidal rule.
 *
 * @param t s, ascending
 * @param values one for each time
 * @param from first row
 * @param to row after the last
 */
export function integral(t: Float64Array, values: Float64Array, from = 0, to = t.length): number {
  let sum = 0;
  for (let i = from + 1; i < to; i++) sum += 0.5 * (values[i]! + values[i - 1]!) * (t[i]! - t[i - 1]!);
  return sum;
}
