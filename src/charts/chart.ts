/** A chart on the page: the frame and its marks on a canvas, a cursor and dots over it, hands and keys. */
import { interpolate } from '../core/motion/interpolation.ts';
import type { Text } from '../core/motion/symbols.ts';
import './chart.css';
import { firstAt, type CurveMark } from './curves.ts';
import { frameOf, paint, rangeOf, toX, toY, type Frame, type Picture, type Zoom } from './frame.ts';
import { attachGestures, chartKey, type GestureTarget } from './gestures.ts';
import { lineContext } from './pen.ts';
import type { Theme } from './surface.ts';
import { chartSheet } from './sheet.ts';
import { token } from './tokens.ts';

export interface ChartOptions {
  /** x rises in every curve, or is the one thing that is varied: zooming is along x, the cursor is a line. */
  alongX?: boolean;
  /** A click, or a drag of the cursor's line: where, in units of the axes. */
  onSeek?(x: number, y: number): void;
  /** The person looks at another part. */
  onZoom?(zoom: Zoom): void;
  /** The pointer stands at something of a mark; null when it leaves. */
  onHover?(index: number | null): void;
  onPick?(index: number): void;
  /** Arrow keys, one to the right or up being 1; both zero for Enter. False where there is nothing to do. */
  onStep?(by: number, across: number): boolean;
  /** The key of the table. */
  onTable?(): void;
  /** After every drawing: what stands over the canvas follows. */
  onLayout?(frame: Frame): void;
}

/** One column of a chart's table. */
export interface TableColumn {
  title: Text;
  values: number[];
}

const EMPTY: Picture = { x: { title: [], range: [0, 1] }, y: { title: [], range: [0, 1] }, marks: [] };
const TABLE_ROWS = 21;

export class Chart implements GestureTarget {
  frame: Frame;
  zoom: Zoom = { x: null, y: null };
  private picture: Picture = EMPTY;
  private readonly host: HTMLElement;
  private readonly options: ChartOptions;
  private readonly canvas = element('canvas', 'chart-canvas');
  private readonly over = element('div', 'chart-over');
  private readonly line = element('div', 'chart-cursor');
  private readonly box = element('div', 'chart-box');
  private readonly dots = element('div', 'chart-dots');
  private readonly observer: ResizeObserver;
  private readonly detach: () => void;
  private cursor: { x: number | null; dots: readonly Dot[] } = { x: null, dots: [] };
  private size = { width: 0, height: 0 };
  private queued = 0;
  private ended = false;

  constructor(host: HTMLElement, options: ChartOptions = {}) {
    this.host = host;
    this.options = options;
    this.over.append(this.line, this.dots, this.box);
    host.append(this.canvas, this.over);
    this.line.hidden = this.box.hidden = true;
    this.frame = frameOf(lineContext(this.canvas), EMPTY, { width: 320, height: 180 });
    this.detach = attachGestures(host, this);
    // Its size comes with the page's next layout: asking for it here would have the page laid out at once.
    this.observer = new ResizeObserver(([entry]) => {
      const { width, height } = entry!.contentRect;
      if (width === this.size.width && height === this.size.height) return;
      this.size = { width, height };
      this.draw();
    });
    this.observer.observe(host);
  }

  setPicture(picture: Picture): void {
    this.picture = picture;
    this.redraw();
  }

  setZoom(zoom: Zoom): void {
    const { x, y } = this.zoom;
    if (same(zoom.x, x) && same(zoom.y, y)) return;
    this.zoom = zoom;
    this.redraw();
    this.options.onZoom?.(zoom);
  }

  /** Marks the present: a line at x, and dots. Cheap: nothing is drawn anew. */
  setCursor(x: number | null, dots: readonly Dot[] = []): void {
    this.cursor = { x, dots };
    this.placeCursor();
  }

  /** Once a frame of the page, however often it is asked for; in the colours of the theme in force. */
  redraw(): void {
    if (this.queued === 0 && !this.ended) this.queued = requestAnimationFrame(() => this.draw());
  }

  /** Whether the key was one of the chart's. */
  key(key: string): boolean {
    return chartKey(key, this);
  }

  /** As it stands, on the page's surface. */
  async png(): Promise<Blob | null> {
    this.draw();
    const { width, height } = this.canvas;
    const sheet = Object.assign(document.createElement('canvas'), { width, height });
    const context = sheet.getContext('2d')!;
    context.fillStyle = token('--surface');
    context.fillRect(0, 0, width, height);
    context.drawImage(this.canvas, 0, 0);
    return new Promise((resolve) => sheet.toBlob(resolve));
  }

  /** Lines as lines, on white. */
  svg(title: string): string {
    const legend = curvesOf(this.picture).map(({ curve }) => curve);
    return chartSheet([{ title, picture: this.picture, zoom: this.zoom, legend }]);
  }

  /** What is shown in numbers: curves at even places, points each. */
  table(): TableColumn[] {
    return tableOf(this.picture, [this.frame.x.low, this.frame.x.high]);
  }

  destroy(): void {
    this.ended = true;
    cancelAnimationFrame(this.queued);
    this.observer.disconnect();
    this.detach();
    this.canvas.remove();
    this.over.remove();
    this.picture = EMPTY;
  }

  // --- what gestures ask for

  get alongX(): boolean {
    return this.options.alongX ?? false;
  }
  get whole(): GestureTarget['whole'] {
    return { x: rangeOf(this.picture, 'x', null, null), y: rangeOf(this.picture, 'y', null, null) };
  }
  get cursorX(): number | null {
    const { x } = this.cursor;
    return x !== null && this.alongX && this.options.onSeek ? toX(this.frame, x) : null;
  }
  seek(x: number, y: number): void {
    this.options.onSeek?.(x, y);
  }
  pick(index: number): void {
    this.options.onPick?.(index);
  }
  hover(index: number | null): void {
    this.host.style.cursor = index !== null && this.options.onPick ? 'pointer' : '';
    this.options.onHover?.(index);
  }
  pointAt(px: number, py: number): number | null {
    if (!this.options.onHover && !this.options.onPick) return null;
    for (const mark of [...this.picture.marks].reverse()) {
      const found = mark.pick?.(this.frame, px, py) ?? null;
      if (found !== null) return found;
    }
    return null;
  }
  showBox(box: readonly [number, number, number, number] | null): void {
    this.box.hidden = box === null;
    if (!box) return;
    const [left, top, width, height] = box;
    Object.assign(this.box.style, {
      left: `${left}px`,
      top: `${top}px`,
      width: `${width}px`,
      height: `${height}px`,
    });
  }
  step(by: number, across: number): boolean {
    return this.options.onStep?.(by, across) ?? false;
  }
  toggleTable(): void {
    this.options.onTable?.();
  }

  private draw(): void {
    cancelAnimationFrame(this.queued);
    this.queued = 0;
    const { width, height } = this.size;
    if (this.ended || width < 1 || height < 1) return;
    const density = devicePixelRatio || 1;
    const [w, h] = [Math.round(width * density), Math.round(height * density)];
    // Setting a size takes a new picture's memory, even where it is the same.
    if (this.canvas.width !== w || this.canvas.height !== h) [this.canvas.width, this.canvas.height] = [w, h];
    const context = lineContext(this.canvas);
    context.setTransform(density, 0, 0, density, 0, 0);
    context.clearRect(0, 0, width, height);
    this.frame = frameOf(context, this.picture, this.size, this.zoom, density);
    paint(context, this.frame, this.picture, themeNow());
    this.placeCursor();
    this.options.onLayout?.(this.frame);
  }

  private placeCursor(): void {
    const { frame, line, dots } = this;
    const { left, top, width, height } = frame;
    const x = this.cursor.x === null ? NaN : toX(frame, this.cursor.x);
    line.hidden = !(x >= left - 0.5 && x <= left + width + 0.5);
    line.style.top = `${top}px`;
    line.style.height = `${height}px`;
    if (!line.hidden) line.style.transform = `translateX(${x}px)`;
    while (dots.children.length > this.cursor.dots.length) dots.lastChild!.remove();
    while (dots.children.length < this.cursor.dots.length) dots.append(element('div', 'chart-dot'));
    this.cursor.dots.forEach((dot, i) => {
      const child = dots.children[i] as HTMLElement;
      const [px, py] = [toX(frame, dot.x), toY(frame, dot.y)];
      child.hidden = !(px >= left && py >= top && px <= left + width && py <= top + height);
      child.style.transform = `translate(${px}px, ${py}px)`;
      child.style.background = dot.color;
    });
  }
}

export interface Dot {
  x: number;
  y: number;
  color: string;
}

function element<K extends 'div' | 'canvas'>(kind: K, className: string): HTMLElementTagNameMap[K] {
  return Object.assign(document.createElement(kind), { className });
}

const same = (a: Zoom['x'], b: Zoom['x']): boolean => a === b || (!!a && !!b && a[0] === b[0] && a[1] === b[1]);

export const themeNow = (): Theme => ({
  text: token('--text'),
  ink: token('--muted'),
  line: token('--line'),
  surface: token('--surface'),
  accent: token('--accent'),
  growing: token('--growing'),
  empty: token('--sunken'),
});

const curvesOf = (picture: Picture): CurveMark[] => picture.marks.filter((m): m is CurveMark => 'curve' in m);

/** Points as they are; curves over rising x at so many even places, straight between their rows; paths row by row. */
export function tableOf(picture: Picture, [from, to]: readonly [number, number]): TableColumn[] {
  const curves = curvesOf(picture).map(({ curve }) => curve);
  const [first] = curves;
  if (!first) return [];
  const scaled = (values: ArrayLike<number>, factor = 1): number[] => Array.from(values, (v) => v * factor);
  if (first.points)
    return [
      { title: picture.x.title, values: scaled(first.x, first.xFactor) },
      ...curves.map((c) => ({ title: c.label, values: scaled(c.y, c.yFactor) })),
    ];
  if (!first.rising) return curves.flatMap((curve) => pathColumns(picture, curve));
  const places = Array.from({ length: TABLE_ROWS }, (_, i) => from + ((to - from) * i) / (TABLE_ROWS - 1));
  return [
    { title: picture.x.title, values: places },
    ...curves.map((c) => ({ title: c.label, values: places.map((x) => valueOf(c, x)) })),
  ];
}

/** Rows of a path at even distances in the record. */
function pathColumns(
  { x: axis }: Picture,
  { label, x, y, xFactor = 1, yFactor = 1 }: CurveMark['curve'],
): TableColumn[] {
  const rows = Math.min(TABLE_ROWS, x.length);
  const at = (i: number): number => Math.round((i * (x.length - 1)) / Math.max(1, rows - 1));
  const list = (values: ArrayLike<number>, factor: number): number[] =>
    Array.from({ length: rows }, (_, i) => values[at(i)]! * factor);
  return [
    { title: axis.title, values: list(x, xFactor) },
    { title: label, values: list(y, yFactor) },
  ];
}

function valueOf({ x, y, xFactor = 1, yFactor = 1 }: CurveMark['curve'], place: number): number {
  const at = place / xFactor;
  const row = firstAt(x, at, true) - 1;
  const slack = 1e-9 * Math.abs(x[x.length - 1]! - x[0]!);
  if (x.length === 0 || at < x[0]! - slack || at > x[x.length - 1]! + slack) return NaN;
  return yFactor * interpolate(x, y, undefined, Math.max(0, row), at);
}
