import { closuresOf, type Closures } from './closures.ts';
import { add, bound, divide, multiply } from './intervals.ts';
import { logarithmAt } from './beyondRange.ts';
import { Magnitude } from './magnitude.ts';
import {
  constant,
  copy,
  difference,
  negated,
  newSeries,
  quotient,
  quotientBy,
  scaled,
  sum,
  times,
  type Series,
} from './series.ts';
import { angle, hypotenuse, power, powerOf, unarySeries } from './seriesFunctions.ts';
import { decide, type Node } from './tree.ts';

/** What brings numbers beyond doubles back. */
const extremes: ReadonlySet<string> = new Set(['*', '/', '^', 'pow', 'log', 'ln']);
const LARGE = 1e100;
/** So large, or so small without being 0, that the next product may leave doubles. */
const isExtreme = ({ lo, hi }: Series): boolean => {
  const size = Math.max(Math.abs(lo[0]!), Math.abs(hi[0]!));
  return size > LARGE || (size < 1 / LARGE && size > 0);
};

/** A switch that an interval leaves open. */
export interface Open {
  readonly part: Enclosure;
  /** What decides rises or falls all through the interval: the switch is crossed once, or whole number after whole number. */
  readonly monotone: boolean;
}

const binarySeries: Readonly<Record<string, (u: Series, v: Series, out: Series) => void>> = {
  '+': sum,
  '-': difference,
  '*': times,
  hypot: hypotenuse,
  atan2: angle,
};

/** Looking over an interval [a, b]. */
export interface Look {
  a: number;
  b: number;
  open: Open[];
}

/** Beside its parts, what the point value that an enclosure is narrowed with may be wrong by. */
const POINT = 2 ** -47;

/**
 * An expression over an interval of t: Taylor coefficients that hold everywhere in it. Switches are taken as decided where
 * the interval allows one decision only; else they are listed, and the series is the hull of both sides.
 */
export class Enclosure {
  readonly node: Node;
  readonly series: Series;
  /** No switch below is open, so that the coefficients of order 1 and up are those of a smooth function. */
  smooth = true;
  readonly parts: readonly Enclosure[];
  private readonly points: Closures;
  /** What decides a switch, and work space. */
  private readonly gap: Series;
  private readonly work: Series;
  private sizes?: Magnitude;

  /** @param order highest derivative */
  constructor(node: Node, order: number) {
    this.node = node;
    this.series = newSeries(order);
    this.gap = newSeries(order);
    this.work = newSeries(order);
    this.parts = node.constant ? [] : node.args.map((arg) => new Enclosure(arg, order));
    this.points = closuresOf(node);
    if (node.constant) constant(this.points.value(0), this.series);
  }

  over(look: Look): Series {
    const { node, series, parts } = this;
    if (node.constant) return series;
    if (node.op === 't') {
      constant(0, series);
      [series.lo[0], series.hi[0]] = [look.a, look.b];
      if (series.lo.length > 1) series.lo[1] = series.hi[1] = 1;
      return series;
    }
    if (decide(node.op)) return this.switched(look);
    const u = parts[0]!.over(look);
    const v = parts[1]?.over(look) ?? u;
    this.smooth = parts.every((p) => p.smooth);
    const one = unarySeries.get(node.op);
    if (one) one(u, series);
    else if (node.op === '^' || node.op === 'pow') {
      if (node.args[1]!.constant) power(u, v.lo[0]!, series);
      else powerOf(u, v, series);
    } else if (node.op === '*' && node.args[0]!.constant) scaled(v, u.lo[0]!, series);
    else if (node.op === '*' && node.args[0] === node.args[1]) power(u, 2, series);
    else if (node.op === '/') quotientBy(u, v, parts[1]!.magnitude().relative, series);
    else binarySeries[node.op]!(u, v, series);
    this.throughLogarithms(look);
    return series;
  }

  /** What the parts decide at t; of an open switch. */
  decisionAt(t: number): number {
    const [a, b] = this.parts;
    return decide(this.node.op)!(a!.points.value(t), b ? b.points.value(t) : 0);
  }

  /** After `over`: what is known of it in logarithms. */
  magnitude(): Magnitude {
    return (this.sizes ??= new Magnitude(this)).look();
  }

  /** Narrows what divides, and a product or logarithm of what is beyond doubles, or nearly. */
  private throughLogarithms({ a, b }: Look): void {
    const { node, parts, series } = this;
    const { op } = node;
    const divides = op === '/' || ((op === '^' || op === 'pow') && parts[1]!.series.hi[0]! < 0);
    const extreme = parts.some((p) => isExtreme(p.series)) && extremes.has(op);
    if (!divides && !extreme) return;
    if (op === 'log' || op === 'ln') return parts[0]!.magnitude().logarithm(series);
    const middle = extreme ? logarithmAt(node, a + (b - a) / 2) : NaN;
    this.magnitude().narrow(series, middle, (b - a) * 0.5000001);
  }

  private switched(look: Look): Series {
    const { node, parts } = this;
    const fixed = node.decided === node.decided;
    if (node.op === '?' && fixed) return this.chosen(node.decided, look);
    const u = parts[0]!.over(look);
    // Of a choice only the condition is looked at before it is decided.
    const v = node.op !== '?' && parts[1] ? parts[1].over(look) : u;
    this.smooth = parts[0]!.smooth && (node.op === '?' || (parts[1]?.smooth ?? true));
    const d = fixed ? node.decided : this.decision(u, v, look);
    if (d === d) return node.op === '?' ? this.chosen(d, look) : this.decided(d, u, v);
    this.smooth = false;
    return this.hull(u, v, look);
  }

  private chosen(d: number, look: Look): Series {
    const part = this.parts[d ? 1 : 2]!;
    const { lo, hi } = part.over(look);
    copy({ lo, hi }, this.series);
    this.smooth = part.smooth;
    return this.series;
  }

  /** The one decision that the interval allows, or NaN; then the switch is listed as open. */
  private decision(u: Series, v: Series, look: Look): number {
    const { node, gap } = this;
    const { op } = node;
    const levels = op === 'floor' || op === 'ceil' || op === 'round' || op === 'mod';
    const one = levels || op === 'sign' || op === 'abs' || op === '?';
    if (op === 'mod') quotient(u, v, gap);
    else if (one) copy(u, gap);
    else difference(u, v, gap);
    const { a, b } = look;
    const middle = a + (b - a) / 2;
    if (this.smooth) this.narrow(look, middle, one);
    const [low, high] = [gap.lo[0]!, gap.hi[0]!];
    if (levels) {
      const y = op === 'mod' ? 1 : 0;
      const [from, to] = [decide(op)!(low, y), decide(op)!(high, y)];
      if (from === to) return from;
    } else if (low > 0 || high < 0 || (low === 0 && high === 0)) return decide(op)!(low, 0);
    // Without bounds it may have a pole, and rise on both sides of it.
    const monotone =
      this.smooth &&
      high - low < Infinity &&
      (gap.lo[1]! > 0 || gap.hi[1]! < 0 || (gap.lo[1] === 0 && gap.hi[1] === 0));
    if (monotone) {
      const first = this.decisionAt(a);
      if (first === this.decisionAt(b)) return first;
    }
    look.open.push({ part: this, monotone });
    return NaN;
  }

  /** The mean value form: the value in the middle and the slope bound what decides closer where the interval is short. */
  private narrow({ a, b }: Look, middle: number, one: boolean): void {
    const { gap, parts, node } = this;
    if (gap.lo.length < 2) return;
    const x = parts[0]!.points.value(middle);
    const y = parts[1] && node.op !== '?' ? parts[1].points.value(middle) : 0;
    const at = node.op === 'mod' ? x / y : one ? x : x - y;
    if (!Number.isFinite(at)) return;
    const slack = POINT * (node.op === 'mod' ? Math.abs(at) : one ? Math.abs(x) : Math.abs(x) + Math.abs(y));
    const half = (b - a) * 0.5000001;
    multiply(gap.lo[1]!, gap.hi[1]!, -half, half);
    add(bound.lo, bound.hi, at - slack, at + slack);
    if (bound.lo > gap.lo[0]!) gap.lo[0] = Math.min(bound.lo, gap.hi[0]!);
    if (bound.hi < gap.hi[0]!) gap.hi[0] = Math.max(bound.hi, gap.lo[0]!);
  }

  /** The series with a decision. */
  private decided(d: number, u: Series, v: Series): Series {
    const { series, work, node } = this;
    if (node.op === 'abs') scaled(u, d, series);
    else if (node.op === 'min' || node.op === 'max') {
      copy(d ? v : u, series);
    } else if (node.op === 'mod') {
      scaled(v, d, work);
      difference(u, work, series);
    } else constant(d, series);
    return series;
  }

  /** All that the series can be on either side of an open switch. */
  private hull(u: Series, v: Series, look: Look): Series {
    const { series, work, node, parts } = this;
    const join = (a: Series, b: Series): void => {
      for (let k = 0; k < series.lo.length; k++) {
        [series.lo[k], series.hi[k]] = [Math.min(a.lo[k]!, b.lo[k]!), Math.max(a.hi[k]!, b.hi[k]!)];
      }
    };
    switch (node.op) {
      case '?':
        join(parts[1]!.over(look), parts[2]!.over(look));
        break;
      case 'abs':
        negated(u, work);
        join(u, work);
        series.lo[0] = Math.max(0, Math.min(u.lo[0]!, u.hi[0]!));
        break;
      case 'min':
      case 'max':
        join(u, v);
        if (node.op === 'min') series.hi[0] = Math.min(u.hi[0]!, v.hi[0]!);
        else series.lo[0] = Math.max(u.lo[0]!, v.lo[0]!);
        break;
      case 'mod': {
        divide(u.lo[0]!, u.hi[0]!, v.lo[0]!, v.hi[0]!);
        const [from, to] = [Math.floor(bound.lo), Math.floor(bound.hi)];
        for (let k = 0; k < series.lo.length; k++) {
          multiply(v.lo[k]!, v.hi[k]!, -to, -from);
          add(bound.lo, bound.hi, u.lo[k]!, u.hi[k]!);
          [series.lo[k], series.hi[k]] = [bound.lo, bound.hi];
        }
        // The remainder lies between 0 and the divisor.
        series.lo[0] = Math.max(series.lo[0]!, Math.min(0, v.lo[0]!));
        series.hi[0] = Math.min(series.hi[0]!, Math.max(0, v.hi[0]!));
        break;
      }
      case 'sign':
        constant(0, series);
        [series.lo[0], series.hi[0]] = [-1, 1];
        break;
      case 'floor':
      case 'ceil':
      case 'round':
        constant(0, series);
        [series.lo[0], series.hi[0]] = [decide(node.op)!(u.lo[0]!, 0), decide(node.op)!(u.hi[0]!, 0)];
        break;
      default:
        constant(0, series);
        series.hi[0] = 1;
    }
    return series;
  }
}
