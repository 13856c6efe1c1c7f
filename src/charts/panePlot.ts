import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { lineContext, Pen } from './pen.ts';
import { token } from './tokens.ts';

/** A curve as points in the axes' units; a point that is not a number is a gap. Of any number of motions. */
export interface PaneCurve {
  color: string;
  dash?: readonly number[] | undefined;
  x: ArrayLike<number>;
  y: ArrayLike<number>;
}

type Range = readonly [number, number];

/** Everything that is drawn. */
export interface PanePicture {
  curves: readonly PaneCurve[];
  x: Range;
  y: Range;
  xLabel: string;
  yLabel: string;
  /** A unit is as long on both axes. */
  equal: boolean;
}

export interface PanePlot {
  /** In the colours of the theme in force. */
  draw(picture: PanePicture): void;
  /** Marks the present: a line at x, and dots. Cheap: nothing is drawn anew. */
  mark(x: number | null, dots: readonly { x: number; y: number; color: string }[]): void;
  /** Values of the axes under a place on the screen. */
  at(clientX: number, clientY: number): { x: number; y: number };
  /** The area of the curves, for pointers. */
  readonly over: HTMLElement;
  /** Width of the area of the curves, CSS pixels. */
  readonly width: number;
  resize(width: number, height: number): void;
  destroy(): void;
}

/** Points nearer than this to the last one drawn (CSS pixels) add nothing to a picture. */
const FINE = 0.4;
/** Smaller than this nothing can be read, CSS pixels. */
const SMALLEST = { width: 80, height: 60 };
const FONT = '11px system-ui, sans-serif';

/** Axes by uPlot, curves drawn over them on a canvas of their own: also those that turn back on themselves. */
export function createPanePlot(host: HTMLElement): PanePlot {
  let shown: PanePicture = { curves: [], x: [0, 1], y: [0, 1], xLabel: '', yLabel: '', equal: false };
  const cursor = document.createElement('div');
  cursor.className = 'pane-cursor';
  const dotsBox = document.createElement('div');
  const sheet = Object.assign(document.createElement('canvas'), { className: 'pane-curves' });
  const ruled = { stroke: () => token('--line'), width: 1 };
  const axis = {
    stroke: () => token('--muted'),
    grid: ruled,
    ticks: ruled,
    font: FONT,
    labelFont: FONT,
    labelSize: 15,
  };
  const typeset = (_: uPlot, at: number[]): string[] =>
    at.map((v) => String(Number(v.toPrecision(8))).replace('-', '\u2212'));
  const plot = new uPlot(
    {
      // Its size comes with the page's next layout: asking for it here would have the page laid out at once.
      ...SMALLEST,
      legend: { show: false },
      cursor: { show: false },
      scales: {
        x: { time: false, range: () => [...shown.x] as [number, number] },
        y: { range: () => [...shown.y] as [number, number] },
      },
      axes: [
        { ...axis, label: () => shown.xLabel, size: 26, values: typeset },
        { ...axis, label: () => shown.yLabel, size: 46, values: typeset },
      ],
      series: [{}, { show: true, stroke: 'transparent', points: { show: false } }],
      hooks: { draw: [(u) => strokeAll(u, sheet, shown.curves)] },
    },
    [
      [0, 1],
      [0, 0],
    ],
    host,
  );
  plot.over.before(sheet);
  plot.over.append(cursor, dotsBox);
  /** Of the curves, CSS pixels. */
  const area = (): [number, number] => [plot.bbox.width / devicePixelRatio, plot.bbox.height / devicePixelRatio];
  const fitted = ({ x, y }: PanePicture): { x: Range; y: Range } => {
    const [w, h] = area();
    if (w === 0 || h === 0) return { x, y };
    const perPixel = Math.max((x[1] - x[0]) / w, (y[1] - y[0]) / h);
    return { x: around(x, (perPixel * w) / 2), y: around(y, (perPixel * h) / 2) };
  };

  return {
    draw(picture) {
      shown = picture.equal ? { ...picture, ...fitted(picture) } : picture;
      plot.setData([[...shown.x], [null, null]]);
    },
    mark(x, dots) {
      const [width, height] = area();
      const left = x === null ? NaN : plot.valToPos(x, 'x');
      const inside = left >= -0.5 && left <= width + 0.5;
      cursor.hidden = !inside;
      if (inside) cursor.style.transform = `translateX(${left}px)`;
      while (dotsBox.children.length > dots.length) dotsBox.lastChild!.remove();
      while (dotsBox.children.length < dots.length)
        dotsBox.append(Object.assign(document.createElement('div'), { className: 'pane-dot' }));
      dots.forEach((dot, i) => {
        const element = dotsBox.children[i] as HTMLElement;
        const [px, py] = [plot.valToPos(dot.x, 'x'), plot.valToPos(dot.y, 'y')];
        element.hidden = !(px >= 0 && py >= 0 && px <= width && py <= height);
        element.style.transform = `translate(${px}px, ${py}px)`;
        element.style.background = dot.color;
      });
    },
    at(clientX, clientY) {
      const box = plot.over.getBoundingClientRect();
      return { x: plot.posToVal(clientX - box.left, 'x'), y: plot.posToVal(clientY - box.top, 'y') };
    },
    over: plot.over,
    get width() {
      return area()[0];
    },
    resize: (width, height) =>
      plot.setSize({ width: Math.max(SMALLEST.width, width), height: Math.max(SMALLEST.height, height) }),
    destroy: () => plot.destroy(),
  };
}

const around = ([low, high]: Range, half: number): Range => [(low + high) / 2 - half, (low + high) / 2 + half];

function strokeAll(u: uPlot, sheet: HTMLCanvasElement, curves: readonly PaneCurve[]): void {
  const { bbox } = u;
  // Setting a size clears.
  sheet.width = u.ctx.canvas.width;
  sheet.height = u.ctx.canvas.height;
  const ctx = lineContext(sheet);
  const scale = devicePixelRatio || 1;
  // Linear axes: two numbers each.
  const [x0, y0] = [u.valToPos(0, 'x', true), u.valToPos(0, 'y', true)];
  const [xs, ys] = [u.valToPos(1, 'x', true) - x0, u.valToPos(1, 'y', true) - y0];
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  ctx.lineJoin = 'round';
  for (const { color, dash, x, y } of curves) {
    ctx.strokeStyle = color;
    const pen = new Pen(ctx, { width: 1.5 * scale, dash: dash?.map((d) => d * scale), hair: 1 });
    let down = false;
    let [lastX, lastY] = [NaN, NaN];
    for (let i = 0; i < x.length; i++) {
      const [px, py] = [x0 + xs * x[i]!, y0 + ys * y[i]!];
      if (px - px !== 0 || py - py !== 0) {
        down = false;
        continue;
      }
      if (!down) pen.moveTo(px, py);
      else if (i === x.length - 1 || Math.abs(px - lastX) > FINE || Math.abs(py - lastY) > FINE) pen.lineTo(px, py);
      else continue;
      down = true;
      lastX = px;
      lastY = py;
    }
    pen.end();
  }
  ctx.restore();
}
