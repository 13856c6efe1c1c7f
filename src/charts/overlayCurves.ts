import { Pen } from './pen.ts';

/** One curve; what is shown is x times `xFactor` against y times `yFactor`. The arrays are read, never copied. */
export interface OverlayCurve {
  label: string;
  color: string;
  dash?: readonly number[];
  width?: number;
  x: ArrayLike<number>;
  y: ArrayLike<number>;
  xFactor: number;
  yFactor: number;
  /** Each value is marked. */
  points?: boolean;
}

/** Where curves are drawn: px, and the values at its edges (of the logarithm of x where that is drawn). */
export interface Frame {
  left: number;
  top: number;
  width: number;
  height: number;
  low: readonly [number, number];
  high: readonly [number, number];
  logarithmicX: boolean;
  /** Device pixels in one px; 1 if not said. */
  density?: number;
}

/** Smallest and largest finite x and y of all curves, in units shown; y over the part of x that is zoomed to. 0 .. 1 where there are none. */
export function limitsOf(
  curves: readonly OverlayCurve[],
  zoom: readonly [number, number] | null,
  rising: boolean,
): { x: [number, number]; y: [number, number] } {
  const x: [number, number] = [Infinity, -Infinity];
  const y: [number, number] = [Infinity, -Infinity];
  for (const curve of curves) {
    const { x: xs, y: ys, xFactor, yFactor } = curve;
    const [from, to] =
      zoom && rising ? [firstAt(xs, zoom[0] / xFactor), firstAt(xs, zoom[1] / xFactor) + 1] : [0, xs.length];
    let [lowX, highX, lowY, highY] = [Infinity, -Infinity, Infinity, -Infinity];
    for (let i = Math.max(0, from - 1); i < Math.min(to, xs.length); i++) {
      const [a, b] = [xs[i]!, ys[i]!];
      if (!Number.isFinite(a) || !Number.isFinite(b)) continue;
      if (a < lowX) lowX = a;
      if (a > highX) highX = a;
      if (b < lowY) lowY = b;
      if (b > highY) highY = b;
    }
    if (lowX > highX) continue;
    x[0] = Math.min(x[0], lowX * xFactor);
    x[1] = Math.max(x[1], highX * xFactor);
    y[0] = Math.min(y[0], lowY * yFactor);
    y[1] = Math.max(y[1], highY * yFactor);
  }
  return { x: orUnit(x), y: orUnit(y) };
}

const orUnit = ([low, high]: [number, number]): [number, number] =>
  low < high
    ? [low, high]
    : low === high
      ? [low - 0.5 * (Math.abs(low) || 1), high + 0.5 * (Math.abs(high) || 1)]
      : [0, 1];

/** Index of the first x that is not before a value, of rising ones. */
export function firstAt(xs: ArrayLike<number>, value: number): number {
  let low = 0;
  let high = xs.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (xs[middle]! < value) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Draws what is in the frame: of rising x only the extremes of each pixel column, else no point within the last one's pixel. */
export function drawCurve(context: CanvasRenderingContext2D, curve: OverlayCurve, frame: Frame, rising: boolean): void {
  context.strokeStyle = context.fillStyle = curve.color;
  context.lineJoin = 'round';
  const pen = new Pen(context, { width: curve.width ?? 1.5, dash: curve.dash, hair: 1 / (frame.density ?? 1) });
  if (rising && !frame.logarithmicX && curve.x.length > 4 * frame.width) tracedByColumn(pen, curve, frame);
  else tracedByPoint(pen, curve, frame);
  pen.end();
  context.setLineDash([]);
  if (curve.points) marks(context, curve, frame);
}

const scales = ({ xFactor, yFactor }: OverlayCurve, { left, top, width, height, low, high, logarithmicX }: Frame) => {
  const sx = width / (high[0] - low[0]);
  const sy = height / (high[1] - low[1]);
  return {
    px: (x: number): number => left + ((logarithmicX ? Math.log10(x * xFactor) : x * xFactor) - low[0]) * sx,
    py: (y: number): number => top + height - (y * yFactor - low[1]) * sy,
  };
};

function tracedByPoint(pen: Pen, curve: OverlayCurve, frame: Frame): void {
  const { px, py } = scales(curve, frame);
  const { x, y } = curve;
  let lastX = NaN;
  let lastY = NaN;
  for (let i = 0; i < x.length; i++) {
    const [a, b] = [px(x[i]!), py(y[i]!)];
    if (!Number.isFinite(a) || !Number.isFinite(b)) {
      lastX = NaN;
      continue;
    }
    if (Number.isNaN(lastX)) pen.moveTo(a, b);
    else if (Math.abs(a - lastX) < 0.7 && Math.abs(b - lastY) < 0.7 && i < x.length - 1) continue;
    else pen.lineTo(a, b);
    lastX = a;
    lastY = b;
  }
}

function tracedByColumn(pen: Pen, curve: OverlayCurve, frame: Frame): void {
  const { px, py } = scales(curve, frame);
  const { x, y, xFactor } = curve;
  let i = Math.max(0, firstAt(x, frame.low[0] / xFactor) - 1);
  const end = Math.min(x.length, firstAt(x, frame.high[0] / xFactor) + 1);
  let begun = false;
  while (i < end) {
    const column = Math.floor(px(x[i]!));
    const first = y[i]!;
    let [least, most, last] = [first, first, first];
    for (; i < end && Math.floor(px(x[i]!)) === column; i++) {
      last = y[i]!;
      if (!(last >= least)) least = last;
      if (!(last <= most)) most = last;
    }
    // A gap within a column is a gap of that column.
    if (!Number.isFinite(least) || !Number.isFinite(most)) {
      begun = false;
      continue;
    }
    if (begun) pen.lineTo(column, py(first));
    else pen.moveTo(column, py(first));
    begun = true;
    pen.lineTo(column, py(least));
    pen.lineTo(column, py(most));
    pen.lineTo(column, py(last));
  }
}

function marks(context: CanvasRenderingContext2D, curve: OverlayCurve, frame: Frame): void {
  const { px, py } = scales(curve, frame);
  const radius = curve.x.length > frame.width / 6 ? 2 : 3.5;
  for (let i = 0; i < curve.x.length; i++) {
    const [a, b] = [px(curve.x[i]!), py(curve.y[i]!)];
    if (!Number.isFinite(a) || !Number.isFinite(b)) continue;
    context.beginPath();
    context.arc(a, b, radius, 0, 2 * Math.PI);
    context.fill();
  }
}
