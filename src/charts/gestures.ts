/** What hands and keys do in every chart: click, drag to zoom, Shift to move along, pinch, wheel, plus, minus and zero. */
import { fromX, fromY, type Frame, type Zoom } from './frame.ts';
import type { Range } from './scales.ts';

export interface GestureTarget {
  readonly frame: Frame;
  readonly zoom: Zoom;
  /** What is shown without a zoom. */
  readonly whole: { x: Range; y: Range };
  /** Zooms and moves along x alone. */
  readonly alongX: boolean;
  /** The line of the cursor, px; null where there is none that can be drawn along. */
  readonly cursorX: number | null;
  setZoom(zoom: Zoom): void;
  seek(x: number, y: number): void;
  pick(index: number): void;
  hover(index: number | null, px: number, py: number): void;
  pointAt(px: number, py: number): number | null;
  /** The rectangle of a zoom being drawn, px in the frame; null for none. */
  showBox(box: readonly [left: number, top: number, width: number, height: number] | null): void;
  step(by: number, across: number): boolean;
  toggleTable(): void;
}

/** Pointer travel that makes a click a drag, px. */
const SLACK = 4;
/** How near to the cursor's line counts as on it, px. */
const REACH = 7;
const FACTOR = 1.25;
const NONE: Zoom = { x: null, y: null };

type Pair = readonly [number, number];

export function attachGestures(area: HTMLElement, target: GestureTarget): () => void {
  let press: { from: Pair; kind: 'zoom' | 'pan' | 'seek'; far: boolean; frame: Frame } | null = null;
  const touches = new Map<number, Pair>();
  let pinch: { apart: number; zoom: { x: Range; y: Range }; about: Pair } | null = null;
  const at = (event: MouseEvent): Pair => {
    const box = area.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const seek = ([x, y]: Pair): void => target.seek(fromX(target.frame, x), fromY(target.frame, y));

  const down = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    area.setPointerCapture(event.pointerId);
    const from = at(event);
    touches.set(event.pointerId, from);
    if (touches.size === 2) {
      const [a, b] = [...touches.values()] as [Pair, Pair];
      pinch = {
        apart: Math.max(10, Math.abs(a[0] - b[0])),
        zoom: shown(target),
        about: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2],
      };
      press = null;
      target.showBox(null);
      return;
    }
    const onLine = target.cursorX !== null && Math.abs(target.cursorX - from[0]) <= REACH;
    const touched = event.pointerType === 'touch' && target.alongX;
    press = {
      from,
      far: false,
      frame: target.frame,
      kind: event.shiftKey ? 'pan' : onLine || touched ? 'seek' : 'zoom',
    };
  };
  const move = (event: PointerEvent): void => {
    const to = at(event);
    if (touches.has(event.pointerId)) touches.set(event.pointerId, to);
    if (pinch && touches.size === 2) {
      const [a, b] = [...touches.values()] as [Pair, Pair];
      const factor = pinch.apart / Math.max(10, Math.abs(a[0] - b[0]));
      target.setZoom(limited(target, zoomed(target, pinch.zoom, factor, pinch.about)));
      return;
    }
    if (!press) {
      target.hover(target.pointAt(...to), ...to);
      return;
    }
    const { from, kind, frame } = press;
    press.far ||= Math.hypot(to[0] - from[0], to[1] - from[1]) > SLACK;
    if (!press.far) return;
    if (kind === 'seek') seek(to);
    else if (kind === 'pan') target.setZoom(limited(target, moved(target, frame, from, to)));
    else target.showBox(boxOf(target, from, to));
  };
  const up = (event: PointerEvent): void => {
    touches.delete(event.pointerId);
    if (pinch) {
      if (touches.size === 0) pinch = null;
      return;
    }
    if (!press) return;
    const { from, kind, far } = press;
    press = null;
    target.showBox(null);
    const to = at(event);
    if (!far) {
      const found = target.pointAt(...to);
      if (found !== null) target.pick(found);
      seek(to);
    } else if (kind === 'zoom') {
      const [left, top, width, height] = boxOf(target, from, to);
      // A sliver is a slip of the hand.
      if (width < SLACK || height < SLACK) return;
      const { frame } = target;
      const x: Range = [fromX(frame, left), fromX(frame, left + width)];
      target.setZoom({ x, y: target.alongX ? null : [fromY(frame, top + height), fromY(frame, top)] });
    }
  };
  const cancel = (event: PointerEvent): void => {
    touches.delete(event.pointerId);
    press = pinch = null;
    target.showBox(null);
  };
  const leave = (): void => target.hover(null, 0, 0);
  const wheel = (event: WheelEvent): void => {
    // A page that is scrolled goes on scrolling: a chart takes the wheel when it has the focus, or with a key held.
    if (!(event.ctrlKey || event.metaKey || event.altKey || area.contains(document.activeElement))) return;
    event.preventDefault();
    zoomAbout(target, event.deltaY > 0 ? FACTOR : 1 / FACTOR, at(event));
  };
  const whole = (): void => target.setZoom(NONE);
  const listeners: [string, (event: never) => void][] = [
    ['pointerdown', down],
    ['pointermove', move],
    ['pointerup', up],
    ['pointercancel', cancel],
    ['pointerleave', leave],
    ['dblclick', whole],
  ];
  for (const [name, listener] of listeners) area.addEventListener(name, listener as EventListener);
  area.addEventListener('wheel', wheel, { passive: false });
  return () => {
    for (const [name, listener] of listeners) area.removeEventListener(name, listener as EventListener);
    area.removeEventListener('wheel', wheel);
  };
}

/** Whether the key was one of the chart's. */
export function chartKey(key: string, target: GestureTarget): boolean {
  const { frame } = target;
  const about: Pair = [target.cursorX ?? frame.left + frame.width / 2, frame.top + frame.height / 2];
  if (key === '+' || key === '=') zoomAbout(target, 1 / FACTOR, about);
  else if (key === '-' || key === '−') zoomAbout(target, FACTOR, about);
  else if (key === '0') target.setZoom(NONE);
  else if (key === 't' || key === 'T') target.toggleTable();
  else if (key === 'ArrowRight') return target.step(1, 0);
  else if (key === 'ArrowLeft') return target.step(-1, 0);
  else if (key === 'ArrowUp') return target.step(0, 1);
  else if (key === 'ArrowDown') return target.step(0, -1);
  else if (key === 'Enter') return target.step(0, 0);
  else return false;
  return true;
}

const shown = ({ frame: { x, y } }: GestureTarget): { x: Range; y: Range } => ({
  x: [x.low, x.high],
  y: [y.low, y.high],
});

function zoomAbout(target: GestureTarget, factor: number, about: Pair): void {
  target.setZoom(limited(target, zoomed(target, shown(target), factor, about)));
}

/** About a place that stays where it is; in shares of the axes, so that a logarithmic one does the same. */
function zoomed({ frame, alongX }: GestureTarget, from: { x: Range; y: Range }, factor: number, [px, py]: Pair): Zoom {
  const along = (scale: Frame['x'], range: Range, at: number): Range => {
    const [a, b] = [scale.share(range[0]), scale.share(range[1])];
    return [scale.value(at - (at - a) * factor), scale.value(at + (b - at) * factor)];
  };
  return {
    x: along(frame.x, from.x, (px - frame.left) / frame.width),
    y: alongX ? null : along(frame.y, from.y, 1 - (py - frame.top) / frame.height),
  };
}

function moved({ alongX }: GestureTarget, frame: Frame, from: Pair, to: Pair): Zoom {
  const [dx, dy] = [(from[0] - to[0]) / frame.width, (to[1] - from[1]) / frame.height];
  return {
    x: [frame.x.value(dx), frame.x.value(1 + dx)],
    y: alongX ? null : [frame.y.value(dy), frame.y.value(1 + dy)],
  };
}

/** Along x, never beyond the whole; nothing where that is all. What is too small to tell apart stays as it is. */
function limited({ whole, alongX, zoom, frame }: GestureTarget, next: Zoom): Zoom {
  const { x } = next;
  if (!x) return next;
  const span = (range: Range): number => frame.x.share(range[1]) - frame.x.share(range[0]);
  if (!(x[1] - x[0] > 1e-9 * Math.max(Math.abs(x[0]), Math.abs(x[1]), 1e-3))) return zoom;
  const all = x[0] <= whole.x[0] && x[1] >= whole.x[1];
  if (all && (alongX || (next.y && next.y[0] <= whole.y[0] && next.y[1] >= whole.y[1]))) return NONE;
  if (!alongX) return next;
  if (span(x) >= span(whole.x)) return NONE;
  const shift = (a: number): Range => [frame.x.value(frame.x.share(x[0]) + a), frame.x.value(frame.x.share(x[1]) + a)];
  const kept =
    x[0] < whole.x[0]
      ? shift(frame.x.share(whole.x[0]) - frame.x.share(x[0]))
      : x[1] > whole.x[1]
        ? shift(frame.x.share(whole.x[1]) - frame.x.share(x[1]))
        : x;
  return { x: kept, y: null };
}

/** What a drag covers, within the frame. */
function boxOf({ frame, alongX }: GestureTarget, from: Pair, to: Pair): [number, number, number, number] {
  const within = (v: number, low: number, size: number): number => Math.min(Math.max(v, low), low + size);
  const sorted = (a: number, b: number): [number, number] => (a < b ? [a, b] : [b, a]);
  const [x0, x1] = sorted(within(from[0], frame.left, frame.width), within(to[0], frame.left, frame.width));
  const [y0, y1] = alongX
    ? [frame.top, frame.top + frame.height]
    : sorted(within(from[1], frame.top, frame.height), within(to[1], frame.top, frame.height));
  return [x0, y0, x1 - x0, y1 - y0];
}
