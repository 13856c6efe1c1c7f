/** Scales of the complex plane: linear, or logarithmic on both sides of zero. */

export interface PlaneScale {
  /** From a value to 0 … 1. */
  place(x: number): number;
  ticks: readonly number[];
}

/** Eigenvalues that lie further apart than this are seen better on logarithmic scales. */
const WIDE = 60;

/** Of a logarithmic scale, at most. */
const DECADES = 3;

/** Whether some sizes are so small beside the largest that a linear plane shows them as one point. */
export function isWide(sizes: readonly number[]): boolean {
  const some = sizes.filter((x) => x > 0);
  return some.length > 1 && Math.max(...some) > WIDE * Math.min(...some);
}

export function linearScale(low: number, high: number, count = 6): PlaneScale {
  const step = niceStep((high - low) / count);
  const first = Math.ceil(low / step);
  const ticks = Array.from({ length: Math.max(0, Math.floor(high / step + 1e-9) - first + 1) }, (_, i) =>
    Number(((first + i) * step).toPrecision(12)),
  );
  return { place: (x) => (x - low) / (high - low), ticks };
}

/** sign(x) log10(1 + |x| / small): linear up to about `small`, logarithmic beyond. */
export function logarithmicScale(low: number, high: number, small: number): PlaneScale {
  const value = (x: number): number => Math.sign(x) * Math.log10(1 + Math.abs(x) / small);
  const [from, to] = [value(low), value(high)];
  const decades: number[] = [];
  for (let x = small; x <= Math.max(-low, high) * (1 + 1e-9); x *= 10) decades.push(Number(x.toPrecision(1)));
  const ticks = [...decades.map((x) => -x).reverse(), 0, ...decades].filter((x) => x >= low && x <= high);
  return { place: (x) => (value(x) - from) / (to - from), ticks };
}

/** Where a logarithmic scale becomes linear: a power of ten, at the smallest size but not much below the largest. */
export function bendOf(sizes: readonly number[]): number {
  const some = sizes.filter((x) => x > 0);
  if (some.length === 0) return 1;
  const decade = (x: number): number => Math.floor(Math.log10(x) + 1e-9);
  return 10 ** Math.max(decade(Math.min(...some)), decade(Math.max(...some)) - DECADES);
}

/** Ends of an axis that hold all values and zero, with a little air. */
export function extent(values: readonly number[], air = 0.08): [number, number] {
  const finite = values.filter(Number.isFinite);
  const [low, high] = [Math.min(0, ...finite), Math.max(0, ...finite)];
  const width = high - low || 1;
  return [low - air * width, high + air * width];
}

/** 1, 2 or 5 times a power of ten, at least `x`. */
export function niceStep(x: number): number {
  const decade = 10 ** Math.floor(Math.log10(x));
  return decade * ([1, 2, 5, 10].find((m) => m * decade >= x * (1 - 1e-9)) ?? 10);
}
