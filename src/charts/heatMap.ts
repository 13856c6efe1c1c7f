import { tickText } from './axisTicks.ts';
import { token } from './tokens.ts';

export interface HeatMapData {
  /** Labels of columns (from the left) and rows (from the bottom). */
  columns: readonly string[];
  rows: readonly string[];
  /** Values by row, from the bottom; NaN where there is none. */
  values: ArrayLike<number>;
  xLabel: string;
  yLabel: string;
  /** Of the values. */
  label: string;
}

export interface HeatMap {
  setData(data: HeatMapData): void;
  /** Marks a cell, or none. */
  select(index: number | null): void;
  redraw(): void;
  canvas(): HTMLCanvasElement;
  destroy(): void;
}

const LEFT = 78;
const RIGHT = 84;
const TOP = 8;
const BOTTOM = 40;

/** Stops of Matplotlib's viridis (S. van der Walt, N. Smith): even in lightness, told apart without red and green. */
const STOPS = [
  [68, 1, 84],
  [72, 40, 120],
  [62, 74, 137],
  [49, 104, 142],
  [38, 130, 142],
  [31, 158, 137],
  [53, 183, 121],
  [110, 206, 88],
  [181, 222, 43],
  [253, 231, 37],
] as const;

/** Colour of a share 0 .. 1 of the scale. */
export function scaleColour(share: number): string {
  const at = Math.min(1, Math.max(0, share)) * (STOPS.length - 1);
  const k = Math.min(STOPS.length - 2, Math.floor(at));
  const [a, b] = [STOPS[k]!, STOPS[k + 1]!];
  return `rgb(${a.map((c, i) => Math.round(c + (at - k) * (b[i]! - c))).join(' ')})`;
}

/** Numbers over two axes as coloured cells with a scale; the pointer names a cell and a click picks it. */
export function createHeatMap(
  host: HTMLElement,
  on: { hover(index: number | null): void; pick(index: number): void },
): HeatMap {
  const canvas = document.createElement('canvas');
  canvas.className = 'overlay-canvas';
  host.append(canvas);
  let data: HeatMapData | null = null;
  let selected: number | null = null;
  let queued = 0;
  const redraw = (): void => {
    if (queued === 0) queued = requestAnimationFrame(() => ((queued = 0), data && draw(host, canvas, data, selected)));
  };
  const cellAt = (event: PointerEvent | MouseEvent): number | null => {
    if (!data) return null;
    const { columns, rows } = data;
    const x = Math.floor(((event.offsetX - LEFT) / (host.clientWidth - LEFT - RIGHT)) * columns.length);
    const y = rows.length - 1 - Math.floor(((event.offsetY - TOP) / (host.clientHeight - TOP - BOTTOM)) * rows.length);
    return x >= 0 && x < columns.length && y >= 0 && y < rows.length ? y * columns.length + x : null;
  };
  canvas.addEventListener('pointermove', (event) => on.hover(cellAt(event)));
  canvas.addEventListener('pointerleave', () => on.hover(null));
  canvas.addEventListener('click', (event) => {
    const cell = cellAt(event);
    if (cell !== null) on.pick(cell);
  });
  const observer = new ResizeObserver(redraw);
  observer.observe(host);
  return {
    setData(next) {
      data = next;
      redraw();
    },
    select(index) {
      selected = index;
      redraw();
    },
    redraw,
    canvas: () => canvas,
    destroy() {
      cancelAnimationFrame(queued);
      queued = -1;
      observer.disconnect();
      canvas.remove();
    },
  };
}

function draw(host: HTMLElement, canvas: HTMLCanvasElement, data: HeatMapData, selected: number | null): void {
  const { clientWidth: width, clientHeight: height } = host;
  if (width < LEFT + RIGHT + 20 || height < TOP + BOTTOM + 20) return;
  const density = devicePixelRatio || 1;
  const [w, h] = [Math.round(width * density), Math.round(height * density)];
  // Setting a size takes a new picture's memory, even where it is the same.
  if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
  const context = canvas.getContext('2d')!;
  context.setTransform(density, 0, 0, density, 0, 0);
  context.clearRect(0, 0, width, height);
  const [low, high] = rangeOf(data.values);
  cells(
    context,
    data,
    { width: width - LEFT - RIGHT, height: height - TOP - BOTTOM },
    (v) => (high > low ? (v - low) / (high - low) : 0.5),
    token('--sunken'),
    selected,
    token('--text'),
    token('--surface'),
  );
  context.font = '11px system-ui, sans-serif';
  context.fillStyle = token('--muted');
  axes(context, data, width, height);
  scale(context, data.label, low, high, width, height, token('--muted'));
}

function rangeOf(values: ArrayLike<number>): [number, number] {
  let low = Infinity;
  let high = -Infinity;
  for (let i = 0; i < values.length; i++) {
    const v = values[i]!;
    if (v < low) low = v;
    if (v > high) high = v;
  }
  return [low, high];
}

function cells(
  context: CanvasRenderingContext2D,
  { columns, rows, values }: HeatMapData,
  { width, height }: { width: number; height: number },
  share: (v: number) => number,
  empty: string,
  selected: number | null,
  ink: string,
  paper: string,
): void {
  const left = (c: number): number => Math.round(LEFT + (c * width) / columns.length);
  const top = (r: number): number => Math.round(TOP + ((rows.length - r) * height) / rows.length);
  for (let r = 0; r < rows.length; r++) {
    for (let c = 0; c < columns.length; c++) {
      const v = values[r * columns.length + c]!;
      context.fillStyle = Number.isFinite(v) ? scaleColour(share(v)) : empty;
      context.fillRect(left(c), top(r + 1), left(c + 1) - left(c), top(r) - top(r + 1));
    }
  }
  if (selected === null) return;
  const c = selected % columns.length;
  const r = Math.floor(selected / columns.length);
  for (const [style, wide] of [
    [paper, 4],
    [ink, 2],
  ] as const) {
    context.strokeStyle = style;
    context.lineWidth = wide;
    context.strokeRect(left(c), top(r + 1), left(c + 1) - left(c), top(r) - top(r + 1));
  }
}

function axes(
  context: CanvasRenderingContext2D,
  { columns, rows, xLabel, yLabel }: HeatMapData,
  width: number,
  height: number,
): void {
  const inner = { width: width - LEFT - RIGHT, height: height - TOP - BOTTOM };
  const every = (n: number, room: number, each: number): number => Math.max(1, Math.ceil((n * each) / room));
  context.textAlign = 'center';
  context.textBaseline = 'top';
  const stepX = every(columns.length, inner.width, 46);
  for (let c = 0; c < columns.length; c += stepX)
    context.fillText(short(columns[c]!, 12), LEFT + ((c + 0.5) * inner.width) / columns.length, TOP + inner.height + 5);
  context.textAlign = 'right';
  context.textBaseline = 'middle';
  const stepY = every(rows.length, inner.height, 16);
  for (let r = 0; r < rows.length; r += stepY)
    context.fillText(short(rows[r]!, 10), LEFT - 6, TOP + ((rows.length - r - 0.5) * inner.height) / rows.length);
  context.textAlign = 'center';
  context.textBaseline = 'bottom';
  context.fillText(xLabel, LEFT + inner.width / 2, height - 2);
  context.save();
  context.translate(9, TOP + inner.height / 2);
  context.rotate(-Math.PI / 2);
  context.textBaseline = 'middle';
  context.fillText(yLabel, 0, 0);
  context.restore();
}

function scale(
  context: CanvasRenderingContext2D,
  label: string,
  low: number,
  high: number,
  width: number,
  height: number,
  ink: string,
): void {
  if (!(low <= high)) return;
  const left = width - RIGHT + 14;
  const tall = height - TOP - BOTTOM;
  for (let i = 0; i < tall; i++) {
    context.fillStyle = scaleColour(high > low ? 1 - i / (tall - 1) : 0.5);
    context.fillRect(left, TOP + i, 12, 1.5);
  }
  context.fillStyle = ink;
  context.textAlign = 'left';
  const steps = high > low ? 4 : 0;
  for (let k = 0; k <= steps; k++) {
    const share = steps === 0 ? 0.5 : k / steps;
    context.textBaseline = k === 0 && steps > 0 ? 'bottom' : k === steps && steps > 0 ? 'top' : 'middle';
    context.fillText(
      tickText(Number((low + share * (high - low)).toPrecision(3))),
      left + 16,
      TOP + (1 - share) * tall,
    );
  }
  context.textAlign = 'right';
  context.textBaseline = 'bottom';
  context.fillText(label, width - 2, height - 2);
}

const short = (text: string, most: number): string => (text.length > most ? `${text.slice(0, most - 1)}…` : text);
