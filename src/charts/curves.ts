/** Curves and points in a frame. */
import { interpolate } from '../core/motion/interpolation.ts';
import { decimated } from '../core/motion/decimated.ts';
import { Envelope } from '../core/motion/envelope.ts';
import type { Text } from '../core/motion/symbols.ts';
import { toX, toY, type Extent, type Frame, type Mark } from './frame.ts';
import { Pen } from './pen.ts';
import type { Range } from './scales.ts';
import type { Surface } from './surface.ts';

/** What is shown is x times `xFactor` against y times `yFactor`. The arrays are read, never copied. A value that is not a number is a gap. */
export interface Curve {
  label: Text;
  color: string;
  dash?: readonly number[] | undefined;
  width?: number;
  x: ArrayLike<number>;
  y: ArrayLike<number>;
  xFactor?: number;
  yFactor?: number;
  /** x rises: no more lines are drawn than there are pixels. */
  rising?: boolean;
  /** Of y, kept from drawing to drawing while it grows. */
  envelope?: Envelope;
  /** Rows that will not change any more. */
  settled?: number;
  /** dy/dx at the rows: where they lie apart, the curve bends between them as it does in the motion. */
  rate?: ArrayLike<number> | undefined;
  /** Rows that are drawn, all without it. */
  rows?: readonly [first: number, end: number];
  /** Each value is marked. */
  points?: boolean;
  /** Does not stretch the axes: a curve that ran away would flatten the others. */
  loose?: boolean;
}

export interface CurveMark extends Mark {
  curve: Curve;
}

/** Points nearer than this to the last one drawn (px) add nothing to a picture. */
const FINE = 0.4;
/** Points of a path at the most. */
const PATH_POINTS = 20_000;
/** Between two rows a curve gets points so far apart, px, where it leaves the chord by more than this, px. */
const APART = 1.5;
const BENT = 0.15;
/** A point counts as pointed at within this, px. */
const REACH = 14;

export function curveMark(curve: Curve): CurveMark {
  const kept = { ...curve, envelope: curve.envelope ?? new Envelope() };
  return {
    curve,
    extent: (x) => (curve.loose ? null : extentOf(kept, x)),
    draw: (surface, frame) => draw(surface, frame, kept),
    ...(curve.points ? { pick: (frame, x, y) => nearest(kept, frame, x, y) } : {}),
  };
}

type Kept = Curve & { envelope: Envelope };

const rowsOf = ({ rows, x, y }: Curve): readonly [number, number] => rows ?? [0, Math.min(x.length, y.length)];
const stepOf = (curve: Curve): number => {
  const [first, end] = rowsOf(curve);
  return Math.max(1, Math.ceil((end - first) / PATH_POINTS));
};

function extentOf(curve: Kept, within: Range | null): Extent | null {
  const { x, y, xFactor = 1, yFactor = 1 } = curve;
  const scaled = ([low, high]: Range, factor: number): Range =>
    factor < 0 ? [factor * high, factor * low] : [factor * low, factor * high];
  if (curve.rising && y instanceof Float64Array) {
    let [from, to] = rowsOf(curve);
    if (to <= from) return null;
    if (within) {
      const inside = [firstAt(x, within[0] / xFactor), firstAt(x, within[1] / xFactor, true)] as const;
      // Between two rows, the line from one to the other.
      const none = inside[0] >= inside[1] ? 1 : 0;
      from = Math.max(from, inside[0] - none);
      to = Math.min(to, inside[1] + none);
    }
    const range = curve.envelope.range(y, from, Math.max(from, to), curve.settled);
    if (!(range[0] <= range[1])) return null;
    const [first, last] = rowsOf(curve);
    return { x: scaled([x[first]!, x[last - 1]!], xFactor), y: scaled(range, yFactor) };
  }
  const found = { x: [Infinity, -Infinity] as [number, number], y: [Infinity, -Infinity] as [number, number] };
  const [first, end] = rowsOf(curve);
  const step = stepOf(curve);
  for (let i = first; i < end; i += step) {
    const [a, b] = [x[i]! * xFactor, y[i]! * yFactor];
    if (a - a !== 0 || b - b !== 0 || (curve.rising && within && (a < within[0] || a > within[1]))) continue;
    if (a < found.x[0]) found.x[0] = a;
    if (a > found.x[1]) found.x[1] = a;
    if (b < found.y[0]) found.y[0] = b;
    if (b > found.y[1]) found.y[1] = b;
  }
  return found.x[0] <= found.x[1] ? found : null;
}

/** Index of the first x that is not before a value (or is after it), of rising ones. */
export function firstAt(xs: ArrayLike<number>, value: number, after = false): number {
  let low = 0;
  let high = xs.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (after ? xs[middle]! <= value : xs[middle]! < value) low = middle + 1;
    else high = middle;
  }
  return low;
}

function draw(surface: Surface, frame: Frame, curve: Kept): void {
  const { color, dash, width = 1.5, xFactor = 1, yFactor = 1 } = curve;
  surface.strokeStyle = surface.fillStyle = color;
  surface.lineJoin = 'round';
  const pen = new Pen(surface, { width, dash, hair: 1 / frame.density });
  const [first, end] = rowsOf(curve);
  if (curve.rising && curve.x instanceof Float64Array && curve.y instanceof Float64Array) {
    const { low, high } = frame.x;
    const few = decimated(
      curve.x.subarray(0, end),
      curve.y.subarray(0, end),
      curve.envelope,
      low / xFactor,
      high / xFactor,
      Math.max(100, Math.round(frame.width)),
      curve.settled ?? end,
    );
    const bent = between(few, frame, curve, end);
    trace(pen, frame, bent.t, bent.y, 0, bent.t.length, 1, xFactor, yFactor);
  } else trace(pen, frame, curve.x, curve.y, first, end, stepOf(curve), xFactor, yFactor);
  pen.end();
  surface.setLineDash([]);
  if (curve.points) points(surface, frame, curve);
}

/** What is drawn of the rows, with points between them where the curve bends; as it is where rows were left out. */
function between(
  few: { t: number[]; y: number[] },
  frame: Frame,
  { x, y, rate, xFactor = 1, yFactor = 1 }: Curve,
  end: number,
): { t: number[]; y: number[] } {
  const first = rate ? firstAt(x, few.t[0] ?? NaN) : 0;
  if (!rate || first + few.t.length > end || x[first + few.t.length - 1] !== few.t.at(-1)) return few;
  const out: { t: number[]; y: number[] } = { t: [], y: [] };
  for (let row = first; row < first + few.t.length; row++) {
    out.t.push(x[row]!);
    out.y.push(y[row]!);
    if (row + 1 >= first + few.t.length) break;
    const at = (share: number): number => x[row]! + share * (x[row + 1]! - x[row]!);
    const away = Math.abs(interpolate(x, y, rate, row, at(0.5)) - 0.5 * (y[row]! + y[row + 1]!));
    const turn = Math.abs(interpolate(x, y, rate, row, at(0.25)) - 0.75 * y[row]! - 0.25 * y[row + 1]!);
    const leaves = Math.abs(toY(frame, yFactor * Math.max(away, turn)) - toY(frame, 0));
    if (!(leaves > BENT)) continue;
    const wide = toX(frame, xFactor * x[row + 1]!) - toX(frame, xFactor * x[row]!);
    const pieces = Math.ceil(wide / APART);
    for (let k = 1; k < pieces; k++) {
      out.t.push(at(k / pieces));
      out.y.push(interpolate(x, y, rate, row, at(k / pieces)));
    }
  }
  return out;
}

function trace(
  pen: Pen,
  frame: Frame,
  xs: ArrayLike<number>,
  ys: ArrayLike<number>,
  first: number,
  end: number,
  step: number,
  xFactor: number,
  yFactor: number,
): void {
  const { left, top, width, height, x, y } = frame;
  let down = false;
  let [lastX, lastY] = [NaN, NaN];
  for (let i = first; i < end; i = i < end - 1 ? Math.min(i + step, end - 1) : end) {
    const px = left + width * x.share(xFactor * xs[i]!);
    const py = top + height * (1 - y.share(yFactor * ys[i]!));
    if (px - px !== 0 || py - py !== 0) {
      down = false;
      continue;
    }
    if (!down) pen.moveTo(px, py);
    else if (i === end - 1 || Math.abs(px - lastX) > FINE || Math.abs(py - lastY) > FINE) pen.lineTo(px, py);
    else continue;
    down = true;
    [lastX, lastY] = [px, py];
  }
}

function points(surface: Surface, frame: Frame, curve: Curve): void {
  const { x, y, xFactor = 1, yFactor = 1 } = curve;
  const radius = x.length > frame.width / 6 ? 2 : 3.5;
  for (let i = 0; i < x.length; i++) {
    const [px, py] = [toX(frame, x[i]! * xFactor), toY(frame, y[i]! * yFactor)];
    if (px - px !== 0 || py - py !== 0) continue;
    surface.beginPath();
    surface.arc(px, py, radius, 0, 2 * Math.PI);
    surface.fill();
  }
}

function nearest({ x, y, xFactor = 1, yFactor = 1 }: Curve, frame: Frame, px: number, py: number): number | null {
  let best = REACH;
  let found: number | null = null;
  for (let i = 0; i < x.length; i++) {
    const away = Math.hypot(toX(frame, x[i]! * xFactor) - px, toY(frame, y[i]! * yFactor) - py);
    if (away < best) [best, found] = [away, i];
  }
  return found;
}
