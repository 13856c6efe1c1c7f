import { BernsteinFit } from './bernstein.ts';
import { leastBetween } from './dip.ts';

/**
 * The first time within an interval at which a function goes from above zero to zero or below, however often it crosses and
 * turns there: for a smooth function of a step's dense output, which a polynomial follows.
 *
 * The interval is halved, the earlier half first, until of each piece the polynomial through nine of its values tells that
 * it has one sign, or that it turns once at the most: then its ends, and its least value, tell all. Most steps are far from
 * any event, and known to be by six values.
 *
 * Not guaranteed: what is in no value, as a spike between two looks; of each piece that the caller names there are six. What does not become a polynomial in a piece of
 * `NARROWEST` (a kink) is known by its ends and one minimum there.
 */

/** For a first look, and for a piece. */
const glance = new BernsteinFit(5);
const piece = new BernsteinFit(8);

/** A polynomial is believed to lie this many of its last coefficients beside the function. */
const MARGIN = 4;
/** Rounding of a coefficient, beside the largest value. */
const ROUNDING = 1e-11;
/** Off the polynomial by less than this part of its range between nodes a function turns where it does. */
const FOLLOWED = 1e-4;
/** Where else a piece is looked at to see whether the polynomial follows: no simple parts of it. */
const CHECKS = [0.2183, 0.5569, 0.8741];
/** Of the whole interval: no piece is shorter. */
const NARROWEST = 1e-9;
/** Nor than this beside its times, which have to be told apart. */
const ULPS = 32 * Number.EPSILON;
/** Values of the function; then pieces are known by their ends alone. */
const MOST_LOOKS = 100_000;

/** Where the function crosses: above zero at the first, not at the second, and once between. */
export type Crossing = readonly [above: number, below: number];

const glanced = new Float64Array(glance.degree + 1);

/** How a function is looked at. */
export interface Looks {
  /** Evaluated within the interval; NaN counts as below zero. */
  readonly value: (t: number) => number;
  /** Pieces that are glanced at one after another; one where none are named. */
  readonly pieces?: number;
  /** The same at less cost, for a glance, and how far that may be off. */
  readonly nearly?: (t: number) => number;
  readonly off?: number;
}

/**
 * @param looks at the function
 * @param low first time, s
 * @param high last time, s
 * @returns null where it does not fall through zero
 */
export function firstCrossing(looks: Looks, low: number, high: number): Crossing | null {
  const { pieces = 1 } = looks;
  for (let k = 1, a = low; k <= pieces; k++) {
    const b = k === pieces ? high : low + ((high - low) * k) / pieces;
    const crossing = inPiece(looks, a, b);
    if (crossing) return crossing;
    a = b;
  }
  return null;
}

function inPiece({ value, nearly = value, off = 0 }: Looks, low: number, high: number): Crossing | null {
  const { nodes, degree } = glance;
  for (let j = 0; j <= degree; j++)
    glanced[j] = nearly(j === 0 ? low : j === degree ? high : low + nodes[j]! * (high - low));
  glance.fit(glanced);
  const slack = off + MARGIN * glance.tail + ROUNDING * sizeOf(glanced);
  if (glance.least > slack || glance.greatest < -slack) return null;
  return new Search(value, Math.max(NARROWEST * (high - low), ULPS * Math.max(Math.abs(low), Math.abs(high)))).in(
    low,
    value(low),
    high,
    value(high),
  );
}

class Search {
  private readonly value: (t: number) => number;
  private readonly narrowest: number;
  private readonly values = new Float64Array(piece.degree + 1);
  private looks = 0;

  constructor(value: (t: number) => number, narrowest: number) {
    this.value = value;
    this.narrowest = narrowest;
  }

  /** In [a, b], where the function is fa and fb. */
  in(a: number, fa: number, b: number, fb: number): Crossing | null {
    if (this.looks > MOST_LOOKS) return fa > 0 && !(fb > 0) ? [a, b] : null;
    const { values } = this;
    const off = this.follow(a, fa, b, fb);
    const slack = off + ROUNDING * sizeOf(values);
    const { least, greatest, turns, falls } = piece;
    if (off < Infinity && (least > slack || greatest < -slack)) return null;
    const followed = off <= FOLLOWED * (greatest - least);
    if ((followed && turns <= 1) || b - a <= this.narrowest || greatest - least <= ROUNDING * sizeOf(values))
      return this.once(a, fa, b, fb, !followed || (turns === 1 && falls));
    const middle = a + 0.5 * (b - a);
    const fm = values[piece.degree / 2]!;
    return this.in(a, fa, middle, fm) ?? this.in(middle, fm, b, fb);
  }

  /** Fits the polynomial of a piece: how far the function may be off it, Infinity where it is no number. */
  private follow(a: number, fa: number, b: number, fb: number): number {
    const { values, value } = this;
    const { nodes, degree } = piece;
    values[0] = fa;
    values[degree] = fb;
    for (let j = 1; j < degree; j++) values[j] = value(j === degree / 2 ? a + 0.5 * (b - a) : a + nodes[j]! * (b - a));
    piece.fit(values);
    let off = piece.tail;
    for (const x of CHECKS) off = Math.max(off, Math.abs(value(a + x * (b - a)) - piece.through(values, x)));
    this.looks += degree - 1 + CHECKS.length;
    return off < Infinity ? MARGIN * off : Infinity;
  }

  /** Where the function turns at most once: to rise again, or to fall. */
  private once(a: number, fa: number, b: number, fb: number, dips: boolean): Crossing | null {
    const { value } = this;
    if (fa > 0 && !(fb > 0)) return [a, b];
    if (fa > 0 && dips) {
      const dip = leastBetween(value, a, b);
      return dip === null ? null : [a, dip];
    }
    if (fa > 0 || fb > 0 || dips) return null;
    const top = leastBetween((t) => Number.MIN_VALUE - value(t), a, b);
    return top === null ? null : [top, b];
  }
}

function sizeOf(values: Float64Array): number {
  let most = 0;
  for (const x of values) most = Math.max(most, Math.abs(x));
  return most;
}

/**
 * First time in (low, high] at which a test holds that holds at `high`, to the last digits of t.
 *
 * @param test of a time
 * @param low s; the test fails there
 * @param high s
 */
export function firstTime(test: (t: number) => boolean, low: number, high: number): number {
  for (let middle = 0.5 * (low + high); middle > low && middle < high; middle = 0.5 * (low + high)) {
    if (test(middle)) high = middle;
    else low = middle;
  }
  return high;
}
