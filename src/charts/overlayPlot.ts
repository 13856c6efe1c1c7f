import { decadeTicks, linearTicks, tickText } from './axisTicks.ts';
import { drawCurve, limitsOf, type Frame, type OverlayCurve } from './overlayCurves.ts';
import { lineContext } from './pen.ts';
import { token } from './tokens.ts';

export type { OverlayCurve } from './overlayCurves.ts';

export interface OverlayOptions {
  xLabel: string;
  yLabel: string;
  /** x is rising in every curve: the cursor is a line, and a drag zooms along x alone. */
  rising: boolean;
  logarithmicX?: boolean;
  /** A metre is as long on both axes. */
  equal?: boolean;
  /** A click, or a drag of the cursor's line, in units shown. */
  onSeek?(x: number): void;
  /** A click next to a point of a curve with points. */
  onPick?(curve: number, index: number): void;
  /** The pointer stands next to that point, or next to none. */
  onHover?(curve: number, index: number | null): void;
  /** A drag chose this part of the x axis; null to see everything. */
  onZoom?(range: readonly [number, number] | null): void;
}

export interface OverlayPlot {
  setCurves(curves: readonly OverlayCurve[]): void;
  /** Line at x, and a point on each curve where one is given (x, y in units shown); none at null. */
  setCursor(x: number | null, points?: readonly (readonly [number, number] | null)[]): void;
  setZoom(range: readonly [number, number] | null): void;
  redraw(): void;
  canvas(): HTMLCanvasElement;
  destroy(): void;
}

const LEFT = 68;
const RIGHT = 12;
const TOP = 10;
const BOTTOM = 36;
/** Pointer travel that makes a click a drag, px. */
const SLACK = 4;
/** How near to a line or point counts as on it, px. */
const REACH = 7;

/** Curves with their own x in one frame, drawn on a canvas with no more lines than there are pixels. */
export function createOverlayPlot(host: HTMLElement, options: OverlayOptions): OverlayPlot {
  return new Overlay(host, options);
}

type Pair = readonly [number, number];

class Overlay implements OverlayPlot {
  private readonly host: HTMLElement;
  private readonly options: OverlayOptions;
  private readonly element = document.createElement('canvas');
  private readonly cover = document.createElement('canvas');
  private readonly observer: ResizeObserver;
  private curves: readonly OverlayCurve[] = [];
  private frame: Frame = { left: LEFT, top: TOP, width: 1, height: 1, low: [0, 0], high: [1, 1], logarithmicX: false };
  private zoom: Pair | null = null;
  /** Of a path against another column: the y part of its zoom. */
  private zoomY: Pair | null = null;
  private cursor: { x: number; points: readonly (Pair | null)[] } | null = null;
  private drag: { from: Pair; to: Pair; kind: 'zoom' | 'seek'; far: boolean } | null = null;
  private queued = 0;

  constructor(host: HTMLElement, options: OverlayOptions) {
    this.host = host;
    this.options = options;
    for (const canvas of [this.element, this.cover]) {
      canvas.className = 'overlay-canvas';
      host.append(canvas);
    }
    this.observer = new ResizeObserver(() => this.redraw());
    this.observer.observe(host);
    const { cover } = this;
    cover.addEventListener('pointerdown', (event) => this.press(event));
    cover.addEventListener('pointermove', (event) => this.move(event));
    cover.addEventListener('pointerup', (event) => this.release(event));
    cover.addEventListener('pointercancel', () => this.endDrag());
    cover.addEventListener('pointerleave', () => this.options.onHover?.(0, null));
    cover.addEventListener('dblclick', () => this.zoomTo(null, null));
  }

  setCurves(curves: readonly OverlayCurve[]): void {
    this.curves = curves;
    this.redraw();
  }

  setCursor(x: number | null, points: readonly (Pair | null)[] = []): void {
    this.cursor = x === null ? null : { x, points };
    this.drawCover();
  }

  setZoom(range: Pair | null): void {
    if (range === null) this.zoomY = null;
    this.zoom = range;
    this.redraw();
  }

  /** Once a picture, however often it is asked for. */
  redraw(): void {
    if (this.queued === 0) this.queued = requestAnimationFrame(() => this.draw());
  }

  canvas(): HTMLCanvasElement {
    return this.element;
  }

  destroy(): void {
    cancelAnimationFrame(this.queued);
    this.queued = -1;
    this.observer.disconnect();
    this.element.remove();
    this.cover.remove();
  }

  private draw(): void {
    this.queued = 0;
    const context = this.sized(this.element);
    if (!context) return;
    this.frame = this.fit();
    const { frame } = this;
    this.drawAxes(context);
    context.save();
    context.beginPath();
    context.rect(frame.left, frame.top, frame.width, frame.height);
    context.clip();
    for (const curve of this.curves) drawCurve(context, curve, frame, this.options.rising);
    context.restore();
    this.drawCover();
  }

  private sized(canvas: HTMLCanvasElement): CanvasRenderingContext2D | null {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (width < LEFT + RIGHT + 20 || height < TOP + BOTTOM + 20) return null;
    const density = devicePixelRatio || 1;
    const [w, h] = [Math.round(width * density), Math.round(height * density)];
    if (canvas.width !== w || canvas.height !== h) {
      canvas.width = w;
      canvas.height = h;
    }
    const context = lineContext(canvas);
    context.setTransform(density, 0, 0, density, 0, 0);
    context.clearRect(0, 0, width, height);
    return context;
  }

  private fit(): Frame {
    const { rising, equal, logarithmicX = false } = this.options;
    const width = this.host.clientWidth - LEFT - RIGHT;
    const height = this.host.clientHeight - TOP - BOTTOM;
    const all = limitsOf(this.curves, this.zoom, rising);
    let [x0, x1] =
      this.zoom ??
      (rising && !this.curves.some((c) => c.points) ? all.x : logarithmicX ? airLogarithmic(all.x) : air(all.x));
    let [y0, y1] = this.zoomY ?? air(all.y);
    if (equal) {
      const scale = Math.max((x1 - x0) / width, (y1 - y0) / height);
      [x0, x1] = [(x0 + x1 - scale * width) / 2, (x0 + x1 + scale * width) / 2];
      [y0, y1] = [(y0 + y1 - scale * height) / 2, (y0 + y1 + scale * height) / 2];
    }
    return {
      left: LEFT,
      top: TOP,
      width,
      height,
      low: [logarithmicX ? Math.log10(x0) : x0, y0],
      high: [logarithmicX ? Math.log10(x1) : x1, y1],
      logarithmicX,
      density: devicePixelRatio || 1,
    };
  }

  private drawAxes(context: CanvasRenderingContext2D): void {
    const { left, top, width, height, low, high, logarithmicX } = this.frame;
    const [ink, line] = [token('--muted'), token('--line')];
    context.font = '11px system-ui, sans-serif';
    context.lineWidth = 1;
    context.strokeStyle = line;
    context.fillStyle = ink;
    context.textAlign = 'center';
    context.textBaseline = 'top';
    const bottom = top + height;
    const xs = logarithmicX
      ? decadeTicks(10 ** low[0], 10 ** high[0], width / 60)
      : linearTicks(low[0], high[0], width / 70);
    context.beginPath();
    for (const x of xs) {
      const at = Math.round(this.toX(x)) + 0.5;
      context.moveTo(at, top);
      context.lineTo(at, bottom + 3);
      context.fillText(tickText(x), at, bottom + 5);
    }
    context.textAlign = 'right';
    context.textBaseline = 'middle';
    for (const y of linearTicks(low[1], high[1], height / 34)) {
      const at = Math.round(this.toY(y)) + 0.5;
      context.moveTo(left - 3, at);
      context.lineTo(left + width, at);
      context.fillText(tickText(y), left - 6, at);
    }
    context.stroke();
    context.textAlign = 'center';
    context.textBaseline = 'bottom';
    context.fillText(this.options.xLabel, left + width / 2, bottom + BOTTOM - 2);
    context.save();
    context.translate(8, top + height / 2);
    context.rotate(-Math.PI / 2);
    context.textBaseline = 'middle';
    context.fillText(this.options.yLabel, 0, 0);
    context.restore();
  }

  /** What moves stands on a canvas of its own, so that the curves are not drawn anew with it. */
  private drawCover(): void {
    const context = this.sized(this.cover);
    if (!context) return;
    const { left, top, width, height } = this.frame;
    const ink = token('--text');
    context.save();
    context.beginPath();
    context.rect(left - 5, top - 5, width + 10, height + 10);
    context.clip();
    if (this.cursor) {
      const { x, points } = this.cursor;
      if (this.options.rising) {
        context.fillStyle = token('--accent');
        context.fillRect(Math.round(this.toX(x)) - 0.5, top, 1.5, height);
      }
      points.forEach((point, i) => {
        if (!point || !Number.isFinite(point[1])) return;
        context.beginPath();
        context.arc(this.toX(point[0]), this.toY(point[1]), 4, 0, 2 * Math.PI);
        context.fillStyle = this.curves[i]?.color ?? ink;
        context.fill();
        context.lineWidth = 1.5;
        context.strokeStyle = token('--surface');
        context.stroke();
      });
    }
    if (this.drag?.kind === 'zoom' && this.drag.far) {
      const [x0, y0, w, h] = this.box();
      context.globalAlpha = 0.16;
      context.fillStyle = token('--accent');
      context.fillRect(x0, y0, w, h);
    }
    context.restore();
  }

  private press(event: PointerEvent): void {
    if (event.button !== 0) return;
    const from: Pair = [event.offsetX, event.offsetY];
    const onCursor =
      this.options.rising &&
      this.options.onSeek !== undefined &&
      this.cursor !== null &&
      Math.abs(this.toX(this.cursor.x) - from[0]) <= REACH;
    this.drag = { from, to: from, kind: onCursor ? 'seek' : 'zoom', far: false };
    this.cover.setPointerCapture(event.pointerId);
  }

  private move(event: PointerEvent): void {
    const at: Pair = [event.offsetX, event.offsetY];
    const { drag } = this;
    if (!drag) {
      const found = this.options.onHover || this.options.onPick ? this.pointAt(at) : null;
      this.cover.style.cursor = found && this.options.onPick ? 'pointer' : '';
      this.options.onHover?.(found?.curve ?? 0, found?.index ?? null);
      return;
    }
    drag.to = at;
    drag.far ||= Math.hypot(at[0] - drag.from[0], at[1] - drag.from[1]) > SLACK;
    if (drag.kind === 'seek') this.options.onSeek!(this.fromX(at[0]));
    else this.drawCover();
  }

  private release(event: PointerEvent): void {
    const { drag } = this;
    if (!drag) return;
    drag.to = [event.offsetX, event.offsetY];
    const { options } = this;
    if (drag.far && drag.kind === 'zoom') {
      const [x0, y0, w, h] = this.box();
      // A sliver is a slip of the hand.
      if (w > SLACK)
        this.zoomTo([this.fromX(x0), this.fromX(x0 + w)], options.rising ? null : [this.fromY(y0 + h), this.fromY(y0)]);
    } else if (!drag.far) {
      const found = options.onPick ? this.pointAt(drag.to) : null;
      if (found) options.onPick!(found.curve, found.index);
      else if (options.rising) options.onSeek?.(this.fromX(drag.to[0]));
    }
    this.endDrag();
  }

  private endDrag(): void {
    this.drag = null;
    this.drawCover();
  }

  private zoomTo(x: Pair | null, y: Pair | null): void {
    this.zoom = x;
    this.zoomY = y;
    this.options.onZoom?.(x);
    this.redraw();
  }

  /** What the drag covers, within the frame: left, top, width, height. */
  private box(): [number, number, number, number] {
    const { left, top, width, height } = this.frame;
    const { from, to } = this.drag!;
    const within = (v: number, low: number, size: number): number => Math.min(Math.max(v, low), low + size);
    const [x0, x1] = [from[0], to[0]].map((x) => within(x, left, width)).sort((a, b) => a - b) as [number, number];
    const [y0, y1] = this.options.rising
      ? [top, top + height]
      : ([from[1], to[1]].map((y) => within(y, top, height)).sort((a, b) => a - b) as [number, number]);
    return [x0, y0, x1 - x0, y1 - y0];
  }

  private pointAt([x, y]: Pair): { curve: number; index: number } | null {
    let best: { curve: number; index: number } | null = null;
    let nearest = 2 * REACH;
    this.curves.forEach((curve, c) => {
      if (!curve.points) return;
      for (let i = 0; i < curve.x.length; i++) {
        const distance = Math.hypot(
          this.toX(curve.x[i]! * curve.xFactor) - x,
          this.toY(curve.y[i]! * curve.yFactor) - y,
        );
        if (distance < nearest) {
          nearest = distance;
          best = { curve: c, index: i };
        }
      }
    });
    return best;
  }

  private toX(x: number): number {
    const { left, width, low, high, logarithmicX } = this.frame;
    return left + (width * ((logarithmicX ? Math.log10(x) : x) - low[0])) / (high[0] - low[0]);
  }

  private toY(y: number): number {
    const { top, height, low, high } = this.frame;
    return top + height - (height * (y - low[1])) / (high[1] - low[1]);
  }

  private fromX(px: number): number {
    const { left, width, low, high, logarithmicX } = this.frame;
    const x = low[0] + ((px - left) / width) * (high[0] - low[0]);
    return logarithmicX ? 10 ** x : x;
  }

  private fromY(px: number): number {
    const { top, height, low, high } = this.frame;
    return high[1] - ((px - top) / height) * (high[1] - low[1]);
  }
}

/** A little room beyond the curves. */
function air([low, high]: Pair): Pair {
  const room = 0.05 * (high - low || Math.abs(high) || 1);
  return [low - room, high + room];
}

function airLogarithmic([low, high]: Pair): Pair {
  const room = (high / low) ** 0.05;
  return low > 0 ? [low / room, high * room] : [low, high];
}
