/**
 * Whether every component is a finite number.
 * @param x any length
 */
export function allFinite(x: Float64Array): boolean {
  let sum = 0;
  // 0 * x is NaN for what is infinite or NaN already, and 0 for everything else.
  for (let i = 0; i < x.length; i++) sum += 0 * x[i]!;
  return sum === 0;
}
