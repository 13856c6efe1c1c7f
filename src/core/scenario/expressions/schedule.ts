import type { CompiledExpression } from '../expressions.ts';
import { addendsOf } from './addends.ts';
import { Enclosure, type Look, type Open } from './enclosure.ts';
import { beside, Pace, type PaceOptions } from './pace.ts';
import { switchesOf, type Node } from './tree.ts';

/**
 * What is known beforehand of a formula of t: where it switches, and how long a step may be that does not pass over
 * anything it does in between.
 *
 * Switches are enclosed by branch and bound: an interval over which every switch can decide one way only has none; one
 * over which what decides rises or falls has one, found by bisection to neighbouring doubles; any other is halved.
 * Between two switches (a stretch) the decisions are fixed as in its middle, so that both its ends are seen from within.
 *
 * How long a step may be in between: `pace.ts`, for each part of a sum.
 */

/** Switches closer than this beside the time, or 1 s, are one: a step between them could not advance the time. */
const TOGETHER = 64 * Number.EPSILON;
/** What switches back within this (beside the time, or 1 s) and is not monotone is not looked for. */
const RESOLUTION = 1e-9;
/** Enclosures for one search; then the search goes on from where it came. */
const MOST_LOOKS = 4000;

export interface ScheduleOptions extends PaceOptions {
  /** Whether its rate acts as well (the reference of a controller). */
  withRate: boolean;
}

export class Schedule {
  /** The next switch, or where the search for it will go on; Infinity where there is none. */
  end = Infinity;
  /** The formula jumps (in value or rate) at the beginning of this stretch. */
  jumps = false;

  private readonly expression: CompiledExpression;
  private readonly options: ScheduleOptions;
  private readonly switches: readonly Node[];
  private readonly whole: Enclosure;
  private readonly paces: readonly Pace[];
  private readonly look: Look = { a: 0, b: 0, open: [] };
  private looks = 0;
  /** Width of the window in which a switch is looked for, and whether `end` is one. */
  private width: number;
  private found = false;
  /** The double before `end`. */
  private last = -Infinity;

  constructor(expression: CompiledExpression, options: ScheduleOptions) {
    this.expression = expression;
    this.options = options;
    this.switches = switchesOf(expression.tree);
    this.whole = new Enclosure(expression.tree, 1);
    this.width = options.until - options.from;
    this.paces = addendsOf(expression.tree).flatMap((part) =>
      (options.withRate ? [0, 1] : [0]).map((derivative) => new Pace(part, derivative, options)),
    );
    this.begin(options.from);
  }

  /** A stretch begins at t: finds its end and fixes what switches decide in it. */
  begin(t: number): void {
    const { switches, options, expression } = this;
    if (switches.length === 0) return;
    const before = [expression.evaluate(t), expression.derivative(t)] as const;
    const wasFound = this.found;
    for (const s of switches) s.decided = NaN;
    // What switches here, or next to here, has switched.
    const from = wasFound || t === options.from ? t + TOGETHER * beside(t) : t;
    this.search(from);
    const middle = from + (Math.min(this.end, options.until) - from) / 2;
    // Parts stand before what they are parts of.
    for (const s of switches) s.decided = this.decisionOf(s, middle);
    const size = options.quiet * (Math.abs(before[0]) + Math.abs(expression.evaluate(t)));
    this.jumps =
      wasFound &&
      !(
        Math.abs(expression.evaluate(t) - before[0]) <= size &&
        Math.abs(expression.derivative(t) - before[1]) * (options.until - options.from) <= size
      );
    for (const pace of this.paces) pace.renew();
  }

  /**
   * The last double before the switch that ends the stretch, for the switch itself or a time beyond it: what a choice keeps away
   * from its parts (a root, a quotient) may have no value there.
   */
  inside(t: number): number {
    return t < this.end || !this.found ? t : this.last;
  }

  /** Bound for a step that begins at t in this stretch; Infinity where there is none. */
  bound(t: number): number {
    const end = Math.min(this.end, this.options.until);
    let bound = Infinity;
    for (const pace of this.paces) bound = Math.min(bound, pace.bound(t, end));
    return bound;
  }

  /** Sets `end` to the first switch from t on. */
  private search(t: number): void {
    const { until } = this.options;
    this.looks = 0;
    let from = t;
    let width = this.width;
    this.found = false;
    this.end = Infinity;
    while (from < until) {
      const to = Math.min(until, from + width);
      const at = this.first(from, to);
      if (at < Infinity) {
        this.end = at;
        this.found = this.looks < MOST_LOOKS;
        this.last = previous(at);
        this.width = 2 * Math.max(at - t, RESOLUTION * beside(t));
        return;
      }
      from = to;
      width *= 2;
    }
  }

  /** The first switch in (a, b], or where the search was given up; Infinity for none. */
  private first(a: number, b: number): number {
    const open = this.openOver(a, b);
    if (open.length === 0) return Infinity;
    if (this.looks >= MOST_LOOKS) return b;
    if (open.every((o) => o.monotone)) {
      const at = Math.min(...open.map(({ part }) => bisect((t) => part.decisionAt(t), a, b)));
      // What depends on these may have switched before them.
      const before = previous(at);
      return before > a ? Math.min(this.first(a, before), at) : at;
    }
    if (b - a <= RESOLUTION * beside(a)) {
      const at = Math.min(...this.switches.map((s) => bisect((t) => this.decisionOf(s, t), a, b)));
      return at;
    }
    const middle = a + (b - a) / 2;
    const left = this.first(a, middle);
    return left < Infinity ? left : this.first(middle, b);
  }

  private openOver(a: number, b: number): readonly Open[] {
    const { look } = this;
    this.looks++;
    look.a = a;
    look.b = b;
    look.open.length = 0;
    this.whole.over(look);
    return [...look.open];
  }

  private decisionOf(s: Node, t: number): number {
    return (this.points.get(s) ?? this.pointOf(s)).decisionAt(t);
  }

  private readonly points = new Map<Node, Enclosure>();
  private pointOf(s: Node): Enclosure {
    const point = new Enclosure(s, 0);
    this.points.set(s, point);
    return point;
  }
}

/** The first double in (a, b] whose decision is not that at a; Infinity where b decides as a does. */
function bisect(decision: (t: number) => number, a: number, b: number): number {
  const first = decision(a);
  if (decision(b) === first) return Infinity;
  let [low, high] = [a, b];
  for (let middle = low + (high - low) / 2; middle > low && middle < high; middle = low + (high - low) / 2) {
    if (decision(middle) === first) low = middle;
    else high = middle;
  }
  return high;
}

const words = new DataView(new ArrayBuffer(8));
/** The double before x > 0; before other numbers a little less. */
function previous(x: number): number {
  if (!(x > 0)) return x - Number.MIN_VALUE - Math.abs(x) * Number.EPSILON;
  words.setFloat64(0, x);
  words.setBigInt64(0, words.getBigInt64(0) - 1n);
  return words.getFloat64(0);
}
