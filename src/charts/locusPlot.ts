import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';

/** One curve over the common values; gaps are NaN. */
export interface LocusCurve {
  color: string;
  dash?: readonly number[];
  width?: number;
  y: readonly number[];
}

export interface LocusPlotOptions {
  xLabel: string;
  yLabel: string;
  values: readonly number[];
  curves: readonly LocusCurve[];
  /** Values that are marked by vertical lines. */
  marks: readonly number[];
  /** Linear up to about this size, logarithmic beyond; without it, linear. */
  bend?: number;
  /** Of the y axis; its own choice where they are not given. */
  ticks?: readonly number[];
  colors: { ink: string; line: string; mark: string; above: string };
  /** The value under the pointer, as an index; null when it leaves. */
  onPoint(index: number | null): void;
}

export interface LocusPlot {
  resize(width: number, height: number): void;
  destroy(): void;
}

/** Real parts against what is varied: the half above zero is tinted, critical values are marked. */
export function createLocusPlot(
  host: HTMLElement,
  { xLabel, yLabel, values, curves, marks, bend, ticks, colors, onPoint }: LocusPlotOptions,
): LocusPlot {
  const font = '11px system-ui, sans-serif';
  const axis = {
    stroke: colors.ink,
    grid: { stroke: colors.line, width: 1 },
    ticks: { stroke: colors.line, width: 1 },
    font,
    labelFont: font,
    labelSize: 16,
    values: (_plot: uPlot, splits: number[]) => splits.map(tickText),
  };
  const plot = new uPlot(
    {
      width: Math.max(100, host.clientWidth),
      height: Math.max(80, host.clientHeight),
      legend: { show: false },
      cursor: { drag: { x: true, y: false }, y: false, points: { show: false } },
      scales: {
        x: { time: false },
        y: {
          ...(bend === undefined ? {} : { distr: 4 as const, asinh: bend }),
          range: (_plot, low, high) => withZero(low, high),
        },
      },
      axes: [
        { ...axis, label: xLabel, size: 28 },
        { ...axis, label: yLabel, size: 52, ...(ticks ? { splits: () => [...ticks] } : {}) },
      ],
      series: [
        {},
        ...curves.map(({ color, dash, width }) => ({
          stroke: color,
          width: width ?? 1.5,
          ...(dash ? { dash: [...dash] } : {}),
          points: { show: false },
          spanGaps: false,
          pxAlign: 0,
        })),
      ],
      hooks: {
        drawClear: [(u) => fillAbove(u, colors.above)],
        draw: [(u) => drawMarks(u, marks, colors.mark, colors.ink)],
        setCursor: [(u) => onPoint(u.cursor.left !== undefined && u.cursor.left >= 0 ? (u.cursor.idx ?? null) : null)],
      },
    },
    [[...values], ...curves.map(({ y }) => y.map((v) => (Number.isFinite(v) ? v : null)))] as uPlot.AlignedData,
    host,
  );
  return {
    resize: (width, height) => plot.setSize({ width, height }),
    destroy: () => plot.destroy(),
  };
}

const tickText = (x: number | null): string =>
  x === null ? '' : String(Number(x.toPrecision(10))).replace('-', '\u2212');

function withZero(low: number, high: number): [number, number] {
  const [from, to] = [Math.min(0, low), Math.max(0, high)];
  const air = 0.06 * (to - from || 1);
  return [from - air, to + air];
}

function fillAbove(u: uPlot, color: string): void {
  const { left, top, width } = u.bbox;
  const zero = Math.min(top + u.bbox.height, Math.max(top, u.valToPos(0, 'y', true)));
  u.ctx.fillStyle = color;
  u.ctx.fillRect(left, top, width, zero - top);
}

function drawMarks(u: uPlot, marks: readonly number[], color: string, ink: string): void {
  const { left, top, width, height } = u.bbox;
  const line = (x0: number, y0: number, x1: number, y1: number, stroke: string, dash: number[]): void => {
    u.ctx.strokeStyle = stroke;
    u.ctx.lineWidth = devicePixelRatio;
    u.ctx.setLineDash(dash.map((d) => d * devicePixelRatio));
    u.ctx.beginPath();
    u.ctx.moveTo(x0, y0);
    u.ctx.lineTo(x1, y1);
    u.ctx.stroke();
  };
  u.ctx.save();
  const zero = Math.round(u.valToPos(0, 'y', true)) + 0.5;
  if (zero >= top && zero <= top + height) line(left, zero, left + width, zero, ink, []);
  for (const mark of marks) {
    const x = Math.round(u.valToPos(mark, 'x', true)) + 0.5;
    if (x >= left && x <= left + width) line(x, top, x, top + height, color, [4, 3]);
  }
  u.ctx.restore();
}
