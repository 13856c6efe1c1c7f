/** Round numbers for an axis: about `most` of them within low .. high, 1, 2 or 5 times a power of ten apart. */
export function linearTicks(low: number, high: number, most: number): number[] {
  const span = high - low;
  if (!(span > 0) || !Number.isFinite(span)) return [low];
  const rough = span / Math.max(1, most);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5].find((m) => m * power >= rough) ?? 10);
  const ticks: number[] = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * span; k++)
    ticks.push(Number((k * step).toPrecision(12)));
  return ticks;
}

/** Powers of ten within low .. high, both positive, as far apart as leaves at most `most`; round numbers where there are fewer than two. */
export function decadeTicks(low: number, high: number, most: number): number[] {
  const first = Math.ceil(Math.log10(low) - 1e-9);
  const last = Math.floor(Math.log10(high) + 1e-9);
  const apart = Math.max(1, Math.ceil((last - first + 1) / Math.max(1, most)));
  const ticks: number[] = [];
  for (let k = Math.ceil(first / apart) * apart; k <= last; k += apart) ticks.push(10 ** k);
  return ticks.length > 1 ? ticks : linearTicks(low, high, most).filter((x) => x > 0);
}

/** A tick's number, short, with a real minus sign. */
export function tickText(x: number): string {
  const size = Math.abs(x);
  const plain =
    size !== 0 && (size < 1e-3 || size >= 1e5)
      ? x
          .toExponential(2)
          .replace(/\.?0+e/, 'e')
          .replace('e+', 'e')
      : String(Number(x.toPrecision(6)));
  return plain.replaceAll('-', '\u2212');
}
