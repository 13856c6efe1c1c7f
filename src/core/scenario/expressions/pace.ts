import { Enclosure, type Look } from './enclosure.ts';
import type { Node } from './tree.ts';

/**
 * How long a step may be that does not pass over anything that a formula of t does.
 *
 * A step is short enough (`bound`) where the formula is quiet, which is a parabola up to a small part of its largest
 * size, or where it changes no faster over the step than the step's own stages can see: h^2 |u'''| <= reach (|u'| + h |u''|),
 * all three bounded over twice the step. For a reach of 4 that is w h < 4.8 for sin(wt), of 8 w h < 8.9; a step over the pulse
 * exp(-(t/w)^2) is at most 2.6 w or 4.9 w.
 * Where intervals tell nothing (beyond the range of doubles, say) steps grow from the shortest to where they tell something.
 * The size of the step is then the error estimate's to choose: it sees what there is.
 */

/**
 * How much faster than a step a formula may change within it. Several stages a step see what passes between two of them
 * (of a pulse that fits into the step the nearest sees a fifth at least); of one value a step it has to be less than a period.
 */
export const REACH_OF_STAGES = 8;
export const REACH_OF_ONE = 4;

/** No step is made shorter than this beside the time, or 1 s: sqrt(t) changes without bound at 0. */
const SHORTEST = 1e-9;

/** Enclosures to find a formula's largest size. */
const SIZE_LOOKS = 400;

/** So many shortest steps in a row without any bound on the formula: then steps grow again, blindly. */
const MOST_BLIND = 20;

/** Places within a blind step where it is tried whether something is known again. */
const BLIND_LOOKS = 64;

/** What the window shrinks by until the formula is quiet, or slow, in it. */
const NARROWER = 0.7;

/** A window that is too long by its own bounds is looked at in so many parts, where that can be expected to help. */
const PARTS = 16;
const WORTH_PARTS = 1e3;

const FACTORIAL = [1, 1, 2, 6, 24];

/** Growth of the window from one bound to the next. */
const WIDER = 8;

/** Times are told apart, and steps bounded, beside the time or 1 s. */
export const beside = (t: number): number => Math.max(1, Math.abs(t));

export interface PaceOptions {
  from: number;
  until: number;
  /** What part of its largest size a formula may change by unseen. */
  quiet: number;
  /** `REACH_OF_STAGES` or `REACH_OF_ONE`, by what takes the steps. */
  reach: number;
}

export class Pace {
  private readonly enclosure: Enclosure;
  private readonly derivative: number;
  private readonly reach: number;
  private readonly sizes = new Float64Array(4);
  private readonly piece = new Float64Array(4);
  private readonly look: Look = { a: 0, b: 0, open: [] };
  /** A part of the largest size over all of the time, from below: what counts as nothing. */
  private readonly nothing: number;
  /** The bound that holds from `since` to `through`. */
  private step = Infinity;
  private since = 0;
  private through = -Infinity;
  /** Whether the last look found any bound, and how many windows in a row had none down to the shortest. */
  private known = true;
  private blind = 0;

  /** @param derivative what acts: the formula (0) or its rate (1) */
  constructor(part: Node, derivative: number, options: PaceOptions) {
    this.enclosure = new Enclosure(part, 3 + derivative);
    this.derivative = derivative;
    this.reach = options.reach;
    this.nothing = options.quiet * this.largest(options);
  }

  /** A stretch begins: what was found of the last one is no more. */
  renew(): void {
    this.through = -Infinity;
  }

  /** Bound for a step that begins at t in a stretch without switches up to `end`; Infinity where there is none. */
  bound(t: number, end: number): number {
    if (t >= this.since && t < this.through) return this.step;
    const rest = end - t;
    const shortest = SHORTEST * beside(t);
    if (!(rest > shortest)) return Infinity;
    const wanted = this.step < Infinity ? this.step * WIDER : rest;
    let h = Math.min(rest, wanted);
    while (h > shortest && !this.sees(t, h, end)) h *= NARROWER;
    this.blind = h > shortest || this.known ? 0 : this.blind + 1;
    h = Math.max(h, shortest);
    if (this.blind > MOST_BLIND) h = this.blindStep(t, Math.min(rest, shortest * 2 ** (this.blind - MOST_BLIND)));
    this.since = t;
    this.through = t + h;
    this.step = h >= rest ? Infinity : h;
    return this.step;
  }

  /** A step where nothing is known, at most to where something is again. */
  private blindStep(t: number, h: number): number {
    for (let k = 1; k <= BLIND_LOOKS; k++) {
      const shortest = SHORTEST * beside(t);
      this.sees(t + (h * k) / BLIND_LOOKS, shortest, Infinity);
      if (this.known) return Math.max(shortest, (h * (k - 1)) / BLIND_LOOKS);
    }
    return h;
  }

  /** Whether a step of h is short enough from t on to its end. */
  private sees(t: number, h: number, end: number): boolean {
    const { look, enclosure, derivative, nothing, reach, sizes, piece } = this;
    const [from, to] = [t, Math.min(t + 2 * h, end)];
    const enclose = (a: number, b: number, out: Float64Array): void => {
      look.a = a;
      look.b = b;
      look.open.length = 0;
      const { lo, hi } = enclosure.over(look);
      for (let k = 1; k <= 3; k++) {
        // Derivatives from coefficients: of u, or of its rate.
        const factor = derivative === 0 ? FACTORIAL[k]! : FACTORIAL[k + 1]!;
        const size = factor * Math.max(Math.abs(lo[k + derivative]!), Math.abs(hi[k + derivative]!));
        out[k] = Math.max(out[k]!, size);
      }
    };
    const isShort = (third: number, first: number, second: number): boolean =>
      third * h * h * h <= 6 * nothing || h * h * third <= reach * (first + h * second);
    sizes.fill(0);
    enclose(from, to, sizes);
    const [, first, second, third] = sizes as unknown as [number, number, number, number];
    this.known = third < Infinity;
    if (!this.known) return false;
    if (isShort(third, first, second)) return true;
    // Over a wide window bounds are wide: those over its parts are closer, and no larger.
    if (!isShort(third / WORTH_PARTS, first, second)) return false;
    piece.fill(0);
    for (let k = 0; k < PARTS; k++) {
      enclose(from + ((to - from) * k) / PARTS, from + ((to - from) * (k + 1)) / PARTS, piece);
      if (!isShort(piece[3]!, first, second)) return false;
    }
    return isShort(piece[3]!, piece[1]!, piece[2]!);
  }

  /** Largest |u^(derivative)| from below, by branch and bound until within a factor of ten or out of patience. */
  private largest({ from, until }: PaceOptions): number {
    const { look, enclosure, derivative } = this;
    const queue: { a: number; b: number; most: number }[] = [];
    let least = 0;
    const push = (a: number, b: number): void => {
      look.a = a;
      look.b = b;
      look.open.length = 0;
      const { lo, hi } = enclosure.over(look);
      const most = Math.max(Math.abs(lo[derivative]!), Math.abs(hi[derivative]!));
      look.a = look.b = a + (b - a) / 2;
      const point = enclosure.over(look);
      const at = Math.min(Math.abs(point.lo[derivative]!), Math.abs(point.hi[derivative]!));
      if (at < Infinity) least = Math.max(least, at);
      queue.push({ a, b, most });
    };
    push(from, until);
    for (let k = 0; k < SIZE_LOOKS; k += 2) {
      let top = 0;
      for (let i = 1; i < queue.length; i++) if (queue[i]!.most > queue[top]!.most) top = i;
      const { a, b, most } = queue[top]!;
      if (most <= 10 * least) break;
      queue.splice(top, 1);
      push(a, a + (b - a) / 2);
      push(a + (b - a) / 2, b);
    }
    return least;
  }
}
