import { add, bound, multiply } from './intervals.ts';
import {
  constant,
  copy,
  integrateOver,
  newSeries,
  quotientBy,
  relativePower,
  relativeTo,
  sum,
  times,
  type Series,
} from './series.ts';
import { relativeExp, relativeHyperbolic } from './seriesFunctions.ts';
import type { Node } from './tree.ts';

/**
 * What is known of a part of a formula over an interval in logarithms: its sign, log |u|, and its Taylor coefficients
 * beside the first one. So a quotient of exponentials is bounded where each of them is beyond the range of doubles, and
 * exp(-x) / (1 + exp(-x))^2 is as narrow a thousand widths before its pulse as beside it.
 */

/** Its coefficients beside the first one are 1, 0, 0 … */
const ONE = constant(1, newSeries(0));

/** Rounding of a logarithm, beside itself or 1: it is the error beside the number. */
const ROUNDING = 2 ** -45;

/** What a size is below when doubles end: of less, a coefficient beside it could be anything. */
const LEAST = 1e-300;

/** A part of a formula, looked over an interval. */
interface Looked {
  readonly node: Node;
  readonly parts: readonly Looked[];
  readonly series: Series;
  magnitude(): Magnitude;
}

export class Magnitude {
  /** 1 or -1; 0 where it is not known, and nothing else is then. */
  sign = 0;
  /** Bounds of log |u|. */
  lo = -Infinity;
  hi = Infinity;
  /** Coefficients beside the first one, which is 1 here. */
  readonly relative: Series;
  private readonly of: Looked;
  private readonly share: Series;

  constructor(of: Looked) {
    this.of = of;
    const order = of.series.lo.length - 1;
    this.relative = newSeries(order);
    this.share = newSeries(order);
  }

  /** Looks over the interval that the enclosure and its parts were last looked over. */
  look(): this {
    const { node, parts } = this.of;
    const [a, b] = parts;
    if (!a || !this.structured(node.op, a, b ?? a)) this.plain();
    return this;
  }

  /**
   * Narrows the coefficients of u, which hold already.
   *
   * @param middle log |u| in the middle of the interval, or NaN: with the slope of the logarithm it bounds it closer
   * @param half of the interval, s
   */
  narrow(out: Series, middle: number, half: number): void {
    const { sign, relative, share } = this;
    if (sign === 0) return;
    let { lo, hi } = this;
    if (Number.isFinite(middle)) {
      multiply(relative.lo[1]!, relative.hi[1]!, -half, half);
      lo = Math.max(lo, middle + bound.lo - slackOf(middle));
      hi = Math.min(hi, middle + bound.hi + slackOf(middle));
    }
    const [least, most] = [Math.min(Math.exp(lo), Number.MAX_VALUE), Math.max(LEAST, Math.exp(hi))];
    if (!(least <= most)) return;
    weighted(relative, sign * least, sign * most, share);
    intersect(share, out);
  }

  /** log u into `out`, which holds already. */
  logarithm(out: Series): void {
    const { relative, share } = this;
    if (this.sign <= 0) return;
    integrateOver(relative, relative, share);
    [share.lo[0], share.hi[0]] = [this.lo, this.hi];
    intersect(share, out);
  }

  /** From its own coefficients. */
  private plain(): void {
    const { series } = this.of;
    const [lo, hi] = [series.lo[0]!, series.hi[0]!];
    this.sign = lo > 0 ? 1 : hi < 0 ? -1 : 0;
    relativeTo(series, this.relative);
    if (this.sign === 0) this.limits(-Infinity, Infinity);
    else this.limits(Math.log(Math.min(Math.abs(lo), Math.abs(hi))), Math.log(Math.max(Math.abs(lo), Math.abs(hi))));
  }

  private limits(lo: number, hi: number): void {
    this.lo = lo === Infinity ? Number.MAX_VALUE : lo - slackOf(lo);
    this.hi = hi + slackOf(hi);
    if (!(this.lo <= this.hi)) this.sign = 0;
  }

  /** By the signs and logarithms of its parts; false where those tell nothing. */
  private structured(op: string, a: Looked, b: Looked): boolean {
    const { relative } = this;
    const [from, to] = [a.series.lo[0]!, a.series.hi[0]!];
    switch (op) {
      case 'exp':
        relativeExp(a.series, relative);
        return this.known(1, from, to);
      case 'cosh':
      case 'sinh': {
        const [near, far] = [from > 0 ? from : to < 0 ? -to : 0, Math.max(Math.abs(from), Math.abs(to))];
        if (op === 'sinh' && near === 0) return false;
        relativeHyperbolic(op, a.series, relative);
        return this.known(op === 'cosh' || from > 0 ? 1 : -1, logHyperbolic(op, near), logHyperbolic(op, far));
      }
      case 'negative': {
        const u = a.magnitude();
        copy(u.relative, relative);
        return this.known(-u.sign, u.lo, u.hi);
      }
      case 'sqrt':
        return this.power(a.magnitude(), 0.5);
      case '^':
      case 'pow':
        return b.node.constant && this.power(a.magnitude(), b.series.lo[0]!);
      case '*':
        return a.node === b.node ? this.power(a.magnitude(), 2) : this.product(a.magnitude(), b.magnitude());
      case '/':
        return this.quotient(a.magnitude(), b.magnitude());
      case '+':
        return this.total(a.magnitude(), b.magnitude(), 1);
      case '-':
        return this.total(a.magnitude(), b.magnitude(), -1);
      default:
        return false;
    }
  }

  private known(sign: number, lo: number, hi: number): boolean {
    this.sign = sign;
    this.limits(lo, hi);
    return this.sign !== 0;
  }

  private power(u: Magnitude, p: number): boolean {
    if (u.sign === 0 || (u.sign < 0 && !Number.isInteger(p))) return false;
    relativePower(u.relative, p, this.relative);
    return this.known(u.sign > 0 || p % 2 === 0 ? 1 : -1, p * (p > 0 ? u.lo : u.hi), p * (p > 0 ? u.hi : u.lo));
  }

  private product(u: Magnitude, v: Magnitude): boolean {
    times(u.relative, v.relative, this.relative);
    return this.known(u.sign * v.sign, u.lo + v.lo, u.hi + v.hi);
  }

  private quotient(u: Magnitude, v: Magnitude): boolean {
    quotientBy(u.relative, ONE, v.relative, this.relative);
    return this.known(u.sign * v.sign, u.lo - v.hi, u.hi - v.lo);
  }

  /** u + sign v = u (1 + r): each adds its coefficients by the share that it has, 1 / (1 + r) and r / (1 + r). */
  private total(u: Magnitude, v: Magnitude, sign: number): boolean {
    if (u.sign === 0 || v.sign === 0) return false;
    const same = u.sign === sign * v.sign;
    if (!same && !(u.lo > v.hi)) return v.lo > u.hi && this.sumOf(v, u, false, sign * v.sign);
    return this.sumOf(u, v, same, u.sign);
  }

  /** Of two signs |u| > |v|. */
  private sumOf(u: Magnitude, v: Magnitude, same: boolean, sign: number): boolean {
    const { relative, share } = this;
    const s = same ? 1 : -1;
    const [least, most] = [Math.exp(v.lo - u.hi) * (1 - ROUNDING), Math.exp(v.hi - u.lo) * (1 + ROUNDING)];
    if (!(same ? least <= most : most < 1)) return false;
    weighted(u.relative, 1 / (1 + s * least), 1 / (1 + s * most), relative);
    weighted(v.relative, s / (1 / least + s), s / (1 / most + s), share);
    sum(relative, share, relative);
    relative.lo[0] = relative.hi[0] = 1;
    return same
      ? this.known(sign, logSum(u.lo, v.lo), logSum(u.hi, v.hi))
      : this.known(sign, u.lo + Math.log1p(-most), u.hi + Math.log1p(-least));
  }
}

const logSum = (x: number, y: number): number => Math.max(x, y) + Math.log1p(Math.exp(-Math.abs(x - y)));

const slackOf = (log: number): number => (Math.abs(log) < Infinity ? ROUNDING * Math.max(1, Math.abs(log)) : 0);

/** log cosh x or log sinh x, x >= 0. */
const logHyperbolic = (op: string, x: number): number =>
  x + Math.log1p((op === 'cosh' ? 1 : -1) * Math.exp(-2 * x)) - Math.LN2;

/** Both hold. */
function intersect(u: Series, out: Series): void {
  for (let k = 0; k < out.lo.length; k++) {
    if (u.lo[k]! > out.lo[k]!) out.lo[k] = Math.min(u.lo[k]!, out.hi[k]!);
    if (u.hi[k]! < out.hi[k]!) out.hi[k] = Math.max(u.hi[k]!, out.lo[k]!);
  }
}

/** Times what lies between these two. */
function weighted(u: Series, x: number, y: number, out: Series): void {
  add(Math.min(x, y), Math.max(x, y), 0, 0);
  const { lo, hi } = bound;
  for (let k = 0; k < out.lo.length; k++) {
    multiply(u.lo[k]!, u.hi[k]!, lo, hi);
    [out.lo[k], out.hi[k]] = [bound.lo, bound.hi];
  }
}
