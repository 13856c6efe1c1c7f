import type { CompiledExpression } from '../expressions.ts';
import { Enclosure, type Look, type Open } from './enclosure.ts';
import { switchesOf, type Node } from './tree.ts';

/**
 * What is known beforehand of a formula of t: where it switches, and how long a step may be that does not pass over
 * anything it does in between.
 *
 * Switches are enclosed by branch and bound: an interval over which every switch can decide one way only has none; one
 * over which what decides rises or falls has one, found by bisection to neighbouring doubles; any other is halved.
 * Between two switches (a stretch) the decisions are fixed as in its middle, so that both its ends are seen from within.
 *
 * A step is short enough (`bound`) where the formula is quiet, which is a parabola up to a small part of its largest
 * size, or where it changes no faster over the step than the step's own stages can see: h^2 |u'''| <= REACH (|u'| + h |u''|),
 * all three bounded over twice the step. For sin(wt) that is w h < 4.8, for the flank of a pulse about its e-fold time.
 * Where intervals tell nothing (beyond the range of doubles, say) steps grow from the shortest to where they tell something.
 * The size of the step is then the error estimate's to choose: it sees what there is.
 */

/** How much faster than a step a formula may change within it: less than a period, so that stages see it. */
const REACH = 4;
/** Switches closer than this beside the time, or 1 s, are one: a step between them could not advance the time. */
const TOGETHER = 64 * Number.EPSILON;
/** What switches back within this (beside the time, or 1 s) and is not monotone is not looked for. */
const RESOLUTION = 1e-9;
/** Enclosures for one search; then the search goes on from where it came. */
const MOST_LOOKS = 4000;
/** No step is made shorter than this beside the time, or 1 s: sqrt(t) changes without bound at 0. */
export const SHORTEST = 1e-9;
/** Enclosures to find a formula's largest size. */
const SIZE_LOOKS = 400;
/** So many shortest steps in a row without any bound on the formula: then steps grow again, blindly. */
const MOST_BLIND = 20;
/** Places within a blind step where it is tried whether something is known again. */
const BLIND_LOOKS = 64;
/** What the window shrinks by until the formula is quiet, or slow, in it. */
const NARROWER = 0.7;
/** Growth of the window from one bound to the next. */
const WIDER = 8;

const beside = (t: number): number => Math.max(1, Math.abs(t));

/** A sum's part, and the derivative of it that acts. */
interface Addend {
  readonly enclosure: Enclosure;
  readonly derivative: number;
  /** Of the derivative over all of the time, from below: what counts as nothing. */
  readonly nothing: number;
}

export interface ScheduleOptions {
  from: number;
  until: number;
  /** What part of its largest size a formula may change by unseen. */
  quiet: number;
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
  private readonly addends: Addend[] = [];
  private readonly look: Look = { a: 0, b: 0, open: [] };
  private looks = 0;
  /** Width of the window in which a switch is looked for, and whether `end` is one. */
  private width: number;
  private found = false;
  /** The bound that holds from `since` to `through`. */
  private step = Infinity;
  private since = 0;
  private through = -Infinity;
  /** Whether the last look found any bound, and how many windows in a row had none down to the shortest. */
  private known = true;
  private blind = 0;

  constructor(expression: CompiledExpression, options: ScheduleOptions) {
    this.expression = expression;
    this.options = options;
    this.switches = switchesOf(expression.tree);
    this.whole = new Enclosure(expression.tree, 1);
    this.width = options.until - options.from;
    for (const derivative of options.withRate ? [0, 1] : [0]) {
      for (const part of addendsOf(expression.tree)) {
        const enclosure = new Enclosure(part, 3 + derivative);
        const size = this.largest(new Enclosure(part, derivative), derivative);
        this.addends.push({ enclosure, derivative, nothing: options.quiet * size });
      }
    }
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
    this.through = -Infinity;
  }

  /** Bound for a step that begins at t in this stretch; Infinity where there is none. */
  bound(t: number): number {
    if (this.addends.length === 0) return Infinity;
    if (t >= this.since && t < this.through) return this.step;
    const end = Math.min(this.end, this.options.until);
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

  private sees(t: number, h: number, end: number): boolean {
    const { look } = this;
    look.a = t;
    look.b = Math.min(t + 2 * h, end);
    return this.addends.every(({ enclosure, derivative, nothing }) => {
      look.open.length = 0;
      const series = enclosure.over(look);
      const size = (k: number): number => Math.max(Math.abs(series.lo[k]!), Math.abs(series.hi[k]!));
      // Derivatives from coefficients: of u, or of its rate.
      const [first, second, third] =
        derivative === 0 ? [size(1), 2 * size(2), 6 * size(3)] : [2 * size(2), 6 * size(3), 24 * size(4)];
      this.known = third < Infinity;
      if (third * h * h * h <= 6 * nothing) return true;
      return third < Infinity && h * h * third <= REACH * (first + h * second);
    });
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

  /** Largest |u^(derivative)| from below, by branch and bound until within a factor of ten or out of patience. */
  private largest(enclosure: Enclosure, derivative: number): number {
    const { from, until } = this.options;
    const factor = derivative;
    const { look } = this;
    const queue: { a: number; b: number; most: number }[] = [];
    let least = 0;
    const push = (a: number, b: number): void => {
      look.a = a;
      look.b = b;
      look.open.length = 0;
      const { lo, hi } = enclosure.over(look);
      const most = Math.max(Math.abs(lo[factor]!), Math.abs(hi[factor]!));
      look.a = look.b = a + (b - a) / 2;
      const point = enclosure.over(look);
      const at = Math.min(Math.abs(point.lo[factor]!), Math.abs(point.hi[factor]!));
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

/** The parts of a sum that depend on t, each without its constant factors. */
function addendsOf(node: Node): Node[] {
  if (node.constant) return [];
  const [a, b] = node.args;
  if (node.op === '+' || node.op === '-') return [...addendsOf(a!), ...addendsOf(b!)];
  if (node.op === 'negative' || (node.op === '/' && b!.constant)) return addendsOf(a!);
  if (node.op === '*' && (a!.constant || b!.constant)) return addendsOf(a!.constant ? b! : a!);
  return node.op === 't' ? [] : [node];
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
