import { cosine, direction, sine } from '../../elementary/trigonometry.ts';
import { pointsOf, type PathOptions } from '../../scenario/path.ts';

/** A place on a path: where it is, which way it goes (rad), how it bends (1/m, to the left positive). */
export interface PathPlace {
  x: number;
  y: number;
  heading: number;
  curvature: number;
}

/** A path on the ground. */
export interface PathCurve {
  /** The place nearest to a vehicle, which heads a way: where a path crosses itself, the branch that goes that way. Into `out`. */
  nearest(x: number, y: number, heading: number, out: PathPlace): void;
  /** Its curvatures, from the least to the most: 0 or one value where they do not change. */
  readonly bends: readonly [number, number];
  /** Ways that it heads (rad): the one of a line, else two at a right angle, between which all lie. */
  readonly headings: readonly number[];
}

/** Of a path that turns. */
const ALL_WAYS = [0, Math.PI / 2] as const;

/**
 * The curve of a scenario's path.
 *
 * @param path as the scenario has it, m
 */
export function pathCurve(path: PathOptions): PathCurve {
  if ('line' in path) return line(path.line);
  if ('circle' in path) return circle(path.circle);
  return new Spline(pointsOf(path), path.closed);
}

function line({ x: x0, y: y0, heading: chi }: { x: number; y: number; heading: number }): PathCurve {
  const [c, s] = [cosine(chi), sine(chi)];
  return {
    bends: [0, 0],
    headings: [chi],
    nearest(x, y, _heading, out) {
      const along = (x - x0) * c + (y - y0) * s;
      out.x = x0 + along * c;
      out.y = y0 + along * s;
      out.heading = chi;
      out.curvature = 0;
    },
  };
}

function circle(of: { radius: number; x: number; y: number; heading: number }): PathCurve {
  const { radius } = of;
  const [cx, cy] = [of.x - radius * sine(of.heading), of.y + radius * cosine(of.heading)];
  const left = Math.sign(radius);
  return {
    bends: [1 / radius, 1 / radius],
    headings: ALL_WAYS,
    nearest(x, y, _heading, out) {
      const angle = direction(y - cy, x - cx);
      out.x = cx + Math.abs(radius) * cosine(angle);
      out.y = cy + Math.abs(radius) * sine(angle);
      out.heading = angle + (left * Math.PI) / 2;
      out.curvature = 1 / radius;
    },
  };
}

/** Places kept between two points. */
const BETWEEN = 24;
/** A heading that is off by one radian counts as much as this distance, m. */
const HEADING = 0.5;

/**
 * A cubic spline through points, over the lengths of its chords (C. de Boor, A Practical Guide to Splines, chapter 4; natural
 * at open ends), kept as places close together.
 */
class Spline implements PathCurve {
  readonly bends: readonly [number, number];
  readonly headings = ALL_WAYS;
  private readonly x: Float64Array;
  private readonly y: Float64Array;
  private readonly heading: Float64Array;
  private readonly curvature: Float64Array;
  private readonly closed: boolean;

  constructor(points: readonly (readonly [number, number])[], closed: boolean) {
    const [first, last] = [points[0]!, points.at(-1)!];
    const apart = distance(first[0] - last[0], first[1] - last[1]) > 1e-9;
    const through = closed && apart ? [...points, first] : points;
    this.closed = closed;
    const s = [0];
    for (let i = 1; i < through.length; i++)
      s.push(s[i - 1]! + distance(through[i]![0] - through[i - 1]![0], through[i]![1] - through[i - 1]![1]));
    const second = [0, 1].map((k) =>
      secondDerivatives(
        s,
        through.map((p) => p[k]!),
        closed,
      ),
    );
    const count = (through.length - 1) * BETWEEN + 1;
    const make = (): Float64Array => new Float64Array(count);
    [this.x, this.y, this.heading, this.curvature] = [make(), make(), make(), make()];
    for (let row = 0; row < count; row++) {
      const i = Math.min(through.length - 2, Math.floor(row / BETWEEN));
      const h = s[i + 1]! - s[i]!;
      const b = (row - i * BETWEEN) / BETWEEN;
      const a = 1 - b;
      const [value, rate, bend] = [0, 1, 2].map((order) =>
        [0, 1].map((k) => {
          const [p, q] = [through[i]![k]!, through[i + 1]![k]!];
          const [mp, mq] = [second[k]![i]!, second[k]![i + 1]!];
          if (order === 0) return a * p + b * q + (((a * a * a - a) * mp + (b * b * b - b) * mq) * h * h) / 6;
          if (order === 1) return (q - p) / h + (((3 * b * b - 1) * mq - (3 * a * a - 1) * mp) * h) / 6;
          return a * mp + b * mq;
        }),
      );
      [this.x[row], this.y[row]] = value as [number, number];
      this.heading[row] = direction(rate![1]!, rate![0]!);
      const speed = distance(rate![0]!, rate![1]!);
      this.curvature[row] = (rate![0]! * bend![1]! - rate![1]! * bend![0]!) / (speed * speed * speed);
    }
    this.bends = [Math.min(...this.curvature), Math.max(...this.curvature)];
  }

  nearest(x: number, y: number, heading: number, out: PathPlace): void {
    const count = this.x.length;
    let [best, least] = [0, Infinity];
    for (let i = 0; i < count; i++) {
      const off = HEADING * turned(heading - this.heading[i]!);
      const [dx, dy] = [x - this.x[i]!, y - this.y[i]!];
      const away = dx * dx + dy * dy + off * off;
      if (away < least) [best, least] = [i, away];
    }
    // On the neighbouring chord that is nearer; beyond an open end straight on.
    const from = Math.min(count - 2, this.along(best, x, y) < 0 ? Math.max(0, best - 1) : best);
    const chord = distance(this.x[from + 1]! - this.x[from]!, this.y[from + 1]! - this.y[from]!);
    const share = this.along(from, x, y) / chord;
    const within = this.closed ? Math.max(0, Math.min(1, share)) : share;
    const inside = Math.max(0, Math.min(1, share));
    out.x = this.x[from]! + within * (this.x[from + 1]! - this.x[from]!);
    out.y = this.y[from]! + within * (this.y[from + 1]! - this.y[from]!);
    out.heading = this.heading[from]! + inside * turned(this.heading[from + 1]! - this.heading[from]!);
    out.curvature =
      share === inside ? this.curvature[from]! + inside * (this.curvature[from + 1]! - this.curvature[from]!) : 0;
  }

  /** How far along the chord that begins at a place, m. */
  private along(i: number, x: number, y: number): number {
    const k = Math.min(i, this.x.length - 2);
    const [dx, dy] = [this.x[k + 1]! - this.x[k]!, this.y[k + 1]! - this.y[k]!];
    return ((x - this.x[i]!) * dx + (y - this.y[i]!) * dy) / distance(dx, dy);
  }
}

/** The length of (x, y); Math.hypot differs between engines in its last digit. */
const distance = (x: number, y: number): number => Math.sqrt(x * x + y * y);

/** An angle within half a turn of 0. */
export const turned = (angle: number): number => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));

/** Second derivatives at the knots: the tridiagonal equations by elimination, or by sweeps where they are cyclic. */
function secondDerivatives(s: readonly number[], f: readonly number[], closed: boolean): Float64Array {
  const n = s.length;
  const h = (i: number): number => s[i + 1]! - s[i]!;
  const slope = (i: number): number => (f[i + 1]! - f[i]!) / h(i);
  const M = new Float64Array(n);
  if (!closed) {
    // Natural: 0 at the ends.
    const [c, d] = [new Float64Array(n), new Float64Array(n)];
    for (let i = 1; i < n - 1; i++) {
      const pivot = 2 * (h(i - 1) + h(i)) - h(i - 1) * c[i - 1]!;
      c[i] = h(i) / pivot;
      d[i] = (6 * (slope(i) - slope(i - 1)) - h(i - 1) * d[i - 1]!) / pivot;
    }
    for (let i = n - 2; i > 0; i--) M[i] = d[i]! - c[i]! * M[i + 1]!;
    return M;
  }
  // Diagonally dominant: sweeps converge by a factor of four and more each.
  const m = n - 1;
  for (let sweep = 0; sweep < 60; sweep++) {
    for (let i = 0; i < m; i++) {
      const before = (i + m - 1) % m;
      const right = 6 * (slope(i) - slope(before)) - h(before) * M[before]! - h(i) * M[(i + 1) % m]!;
      M[i] = right / (2 * (h(before) + h(i)));
    }
  }
  M[m] = M[0]!;
  return M;
}
