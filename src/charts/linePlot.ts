import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';

/** One curve; `x` rises. Curves may have points of their own. */
export interface PlotSeries {
  label: string;
  color: string;
  dash?: readonly number[];
  x: Float64Array | readonly number[];
  y: Float64Array | readonly number[];
  /** Does not stretch the axis: a curve that ran away would flatten the others. */
  loose?: boolean;
}

export interface PlotOptions {
  xLabel: string;
  yLabel: string;
  /** Logarithmic y; values that are not positive are gaps. */
  logarithmic?: boolean;
  ink: string;
  line: string;
}

export interface LinePlot {
  setData(series: readonly PlotSeries[]): void;
  resize(width: number, height: number): void;
  /** The picture as it stands. */
  canvas(): HTMLCanvasElement | null;
  destroy(): void;
}

/** Several curves over one x axis, on a canvas. */
export function createLinePlot(place: HTMLElement, options: PlotOptions): LinePlot {
  // Let go when the plot ends: the last uPlot that was made stays in memory, with what its options' functions see.
  let host: HTMLElement | null = place;
  let plot: uPlot | null = null;
  let shape = '';
  const size = { width: 320, height: 180 };
  let limits: [number, number] | null = null;

  const build = (series: readonly PlotSeries[], data: uPlot.AlignedData): void => {
    plot?.destroy();
    const axis = {
      stroke: options.ink,
      grid: { stroke: options.line, width: 1 },
      ticks: { stroke: options.line, width: 1 },
      font: '11px system-ui, sans-serif',
      labelFont: '11px system-ui, sans-serif',
      labelSize: 16,
    };
    plot = new uPlot(
      {
        ...size,
        legend: { show: false },
        cursor: { drag: { x: true, y: false } },
        scales: {
          x: { time: false },
          y: {
            ...(options.logarithmic ? { distr: 3 as const } : {}),
            range: (_plot, low, high) => limits ?? [low, high],
          },
        },
        axes: [
          { ...axis, label: options.xLabel, size: 28 },
          {
            ...axis,
            label: options.yLabel,
            size: 60,
            ...(options.logarithmic
              ? {
                  splits: (_plot: uPlot, _axis: number, low: number, high: number) => decades(low, high),
                  values: (_plot: uPlot, at: number[]) => at.map(power),
                }
              : {}),
          },
        ],
        series: [
          {},
          ...series.map((s) => ({
            label: s.label,
            stroke: s.color,
            width: 1.5,
            ...(s.dash ? { dash: [...s.dash] } : {}),
            points: { show: false },
            spanGaps: true,
          })),
        ],
      },
      data,
      host!,
    );
  };

  return {
    setData(series) {
      const data = aligned(series, options.logarithmic ?? false);
      limits = limitsOf(series, options.logarithmic ?? false);
      const next = JSON.stringify(series.map((s) => [s.label, s.color, s.dash]));
      if (!plot || next !== shape) {
        shape = next;
        build(series, data);
      } else {
        plot.setData(data);
      }
    },
    resize(width, height) {
      size.width = width;
      size.height = height;
      plot?.setSize(size);
    },
    canvas: () => plot?.ctx.canvas ?? null,
    destroy() {
      plot?.destroy();
      plot = host = null;
    },
  };
}

/** At most this many labels stand on a logarithmic axis. */
const MOST_DECADES = 8;

/** Powers of ten from low to high, every one or as many apart as leaves them legible. */
function decades(low: number, high: number): number[] {
  const first = Math.ceil(Math.log10(low) - 1e-9);
  const last = Math.floor(Math.log10(high) + 1e-9);
  const apart = Math.max(1, Math.ceil((last - first + 1) / MOST_DECADES));
  const at: number[] = [];
  for (let k = Math.ceil(first / apart) * apart; k <= last; k += apart) at.push(10 ** k);
  return at;
}

const power = (x: number): string => `1e${String(Math.round(Math.log10(x))).replace('-', '\u2212')}`;

/** What the curves that may stretch the axis need, with a little air; null when there are none. */
function limitsOf(series: readonly PlotSeries[], logarithmic: boolean): [number, number] | null {
  let low = Infinity;
  let high = -Infinity;
  for (const { y, loose } of series) {
    if (loose) continue;
    for (const v of y) {
      if (!Number.isFinite(v) || (logarithmic && v <= 0)) continue;
      if (v < low) low = v;
      if (v > high) high = v;
    }
  }
  if (!(low <= high)) return null;
  if (logarithmic) return [low / 2, high * 2];
  const air = 0.05 * (high - low || Math.abs(high) || 1);
  return [low - air, high + air];
}

/** Columns on one x, as uPlot wants them. */
function aligned(series: readonly PlotSeries[], logarithmic: boolean): uPlot.AlignedData {
  if (series.length === 0) return [[0], []] as unknown as uPlot.AlignedData;
  const tables = series.map((s) => {
    const y = Array.from(s.y, (v) => (Number.isFinite(v) && (!logarithmic || v > 0) ? v : null));
    return [Array.from(s.x), y] as unknown as uPlot.AlignedData;
  });
  return tables.length === 1 ? tables[0]! : uPlot.join(tables);
}
