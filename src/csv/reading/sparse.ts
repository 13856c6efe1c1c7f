/** Columns that have their values at different times, as logs of several sensors do: each is interpolated for itself. */

/** Gaps so many of a column's own typical steps long are not bridged. */
const LONGEST_GAP = 10;

/**
 * Fills a column between its own values, linearly.
 * @param t times of n rows, s, rising
 * @param x its values, NaN where there are none; changed in place
 */
export function filled(t: Float64Array, x: Float64Array): void {
  const own: number[] = [];
  for (let i = 0; i < x.length; i++) if (x[i] === x[i]) own.push(i);
  if (own.length < 2) return;
  const steps = own.slice(1).map((row, k) => t[row]! - t[own[k]!]!);
  const typical = [...steps].sort((a, b) => a - b)[steps.length >> 1]!;
  for (const [k, step] of steps.entries()) {
    const [a, b] = [own[k]!, own[k + 1]!];
    if (!(step > 0) || step > LONGEST_GAP * typical) continue;
    for (let i = a + 1; i < b; i++) x[i] = x[a]! + ((x[b]! - x[a]!) * (t[i]! - t[a]!)) / step;
  }
}
