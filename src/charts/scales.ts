/** Scales of axes: from values to shares 0 … 1 of an axis and back, with their ticks and one way to write numbers. */

/** Neighbouring numbers of a bent axis are at least so far apart, in shares of an even spacing. */
const APART = 0.75;

export type Range = readonly [number, number];

/**
 * - `linear`
 * - `logarithmic`: positive values
 * - `bent`: sign(x) log10(1 + |x| / bend), linear up to about `bend` and logarithmic beyond, on both sides of zero
 * - `steps`: names side by side, at 0, 1, 2 …
 */
export type ScaleKind = 'linear' | 'logarithmic' | 'bent' | 'steps';

export interface ScaleSpec {
  kind?: ScaleKind | undefined;
  bend?: number | undefined;
  /** Of `steps`. */
  names?: readonly string[] | undefined;
}

export interface Scale {
  readonly low: number;
  readonly high: number;
  share(value: number): number;
  value(share: number): number;
  /** At most about so many. */
  ticks(most: number): number[];
  text(tick: number): string;
}

export function scaleOf({ kind = 'linear', bend = 1, names = [] }: ScaleSpec, [low, high]: Range): Scale {
  const logarithmic = kind === 'logarithmic' && low > 0;
  const bent = (x: number): number => Math.sign(x) * Math.log10(1 + Math.abs(x) / bend);
  const unbent = (y: number): number => Math.sign(y) * bend * (10 ** Math.abs(y) - 1);
  const to = logarithmic ? Math.log10 : kind === 'bent' ? bent : (x: number): number => x;
  const from = logarithmic ? (y: number): number => 10 ** y : kind === 'bent' ? unbent : (y: number): number => y;
  const [a, b] = [to(low), to(high)];
  return {
    low,
    high,
    share: (value) => (to(value) - a) / (b - a),
    value: (share) => from(a + share * (b - a)),
    ticks: (most) =>
      kind === 'steps'
        ? stepTicks(low, high, names.length, most)
        : logarithmic
          ? decadeTicks(low, high, most)
          : kind === 'bent'
            ? bentTicks(low, high, bend, most, (x) => (to(x) - a) / (b - a))
            : linearTicks(low, high, most),
    text: (tick) => (kind === 'steps' ? (names[tick] ?? '') : tickText(tick)),
  };
}

/** Round numbers for an axis: about `most` of them within low .. high, 1, 2 or 5 times a power of ten apart. */
export function linearTicks(low: number, high: number, most: number): number[] {
  const span = high - low;
  if (!(span > 0) || !Number.isFinite(span)) return [low];
  const step = niceStep(span / Math.max(1, most));
  const ticks: number[] = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * span; k++)
    ticks.push(Number((k * step).toPrecision(12)) + 0);
  return ticks;
}

/** 1, 2 or 5 times a power of ten, at least `x`. */
export function niceStep(x: number): number {
  const decade = 10 ** Math.floor(Math.log10(x));
  return decade * ([1, 2, 5].find((m) => m * decade >= x * (1 - 1e-9)) ?? 10);
}

/** Powers of ten within low .. high, both positive, as far apart as leaves at most `most`; round numbers where there are fewer than two. */
export function decadeTicks(low: number, high: number, most: number): number[] {
  const first = Math.ceil(Math.log10(low) - 1e-9);
  const last = Math.floor(Math.log10(high) + 1e-9);
  const apart = Math.max(1, Math.ceil((last - first + 1) / Math.max(1, most)));
  const ticks: number[] = [];
  for (let k = Math.ceil(first / apart) * apart; k <= last; k += apart) ticks.push(power(k));
  return ticks.length > 1 ? ticks : linearTicks(low, high, most).filter((x) => x > 0);
}

const power = (k: number): number => Number(`1e${k}`);

/** Zero and decades on both of its sides, from `bend` on, the outermost first, as far apart as leaves room for their numbers. */
function bentTicks(low: number, high: number, bend: number, most: number, share: (x: number) => number): number[] {
  const decades: number[] = [];
  for (let x = bend; x <= Math.max(-low, high) * (1 + 1e-9); x *= 10) decades.push(Number(x.toPrecision(12)));
  const ticks: number[] = [];
  for (const x of [0, ...decades.reverse().flatMap((x) => [-x, x])])
    if (x >= low && x <= high && ticks.every((other) => Math.abs(share(x) - share(other)) * most >= APART))
      ticks.push(x);
  return ticks.length > 1 ? ticks.sort((a, b) => a - b) : linearTicks(low, high, most);
}

function stepTicks(low: number, high: number, count: number, most: number): number[] {
  const every = Math.max(1, Math.ceil(count / Math.max(1, most)));
  return Array.from({ length: count }, (_, i) => i).filter((i) => i % every === 0 && i >= low && i <= high);
}

/** A tick's number, short, with a true minus sign; powers of ten where plain digits were long. */
export function tickText(x: number): string {
  const size = Math.abs(x);
  const rounded = Number(x.toPrecision(12)) + 0;
  const plain =
    size !== 0 && (size < 1e-3 || size >= 1e5) ? rounded.toExponential().replace('e+', 'e') : String(rounded);
  return plain.replaceAll('-', '\u2212');
}

/** A range so small beside its values, or beside anything that is measured, that stretched to a whole chart it would mislead. */
export const isTiny = ([low, high]: Range): boolean => {
  const largest = Math.max(Math.abs(low), Math.abs(high));
  return high > low && high - low < (largest > 1e-9 ? 1e-3 * largest : Infinity) && high - low > 1e-12 * largest;
};

/** Room beyond the values: a share of their span, a factor where it is logarithmic; a flat range in the middle. */
export function withAir([low, high]: Range, share: number, kind: ScaleKind = 'linear'): [number, number] {
  if (!(low <= high)) return kind === 'logarithmic' ? [0.1, 1] : [-1, 1];
  if (kind === 'logarithmic' && low > 0) {
    const room = high > low ? (high / low) ** share : 2;
    return [low / room, high * room];
  }
  // What only rounding moves is flat.
  const flat = !(high - low > 1e-12 * Math.max(Math.abs(low), Math.abs(high)));
  const room = flat ? 0.1 * (Math.abs(high) || 1) : share * (high - low);
  return [low - room, high + room];
}
