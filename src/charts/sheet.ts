/** Charts as SVG files: for saving, and for pictures in the documentation. */
import type { Text } from '../core/motion/symbols.ts';
import { curveMark, type Curve } from './curves.ts';
import { frameOf, paint, type Picture, type Zoom } from './frame.ts';
import { PRINT } from './surface.ts';
import { SvgSurface } from './svgSurface.ts';
import { drawText, widthOf } from './typeset.ts';

export interface SheetChart {
  title: string;
  picture: Picture;
  zoom?: Zoom;
  /** What the colours mean. */
  legend?: readonly { label: Text; color: string; dash?: readonly number[] | undefined }[];
}

export interface Line {
  label: Text;
  x: ArrayLike<number>;
  y: ArrayLike<number>;
}

export interface LinePlotSpec {
  title: string;
  xLabel: Text;
  yLabel: Text;
  lines: readonly Line[];
  /** Where the horizontal axis ends, if before the data. */
  to?: number | undefined;
  equal?: boolean | undefined;
}

const WIDTH = 420;
const HEIGHT = 280;
const HEAD = 26;
const LEGEND = 14;
/** Told apart by colour-blind people too (Okabe and Ito). */
const COLORS = ['#d55e00', '#0072b2', '#009e73', '#cc79a7', '#56b4e9', '#e69f00'];

/** Several charts side by side, two in a row, as one picture on white. */
export function chartSheet(charts: readonly SheetChart[]): string {
  const columns = Math.min(2, charts.length);
  const rows = Math.ceil(charts.length / columns);
  const [width, height] = [columns * WIDTH, rows * HEIGHT];
  const body = charts.map(
    (chart, i) =>
      `<g transform="translate(${(i % columns) * WIDTH} ${Math.floor(i / columns) * HEIGHT})">${one(chart, `chart-${i}`)}</g>`,
  );
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}">`,
    `<rect width="100%" height="100%" fill="#ffffff"/>`,
    ...body,
    '</svg>',
    '',
  ].join('\n');
}

function one({ title, picture, zoom, legend = [] }: SheetChart, id: string): string {
  const surface = new SvgSurface(id);
  const frame = frameOf(surface, picture, { width: WIDTH, height: HEIGHT - HEAD }, zoom);
  surface.fillStyle = PRINT.text;
  surface.font = '600 13px system-ui, sans-serif';
  surface.textBaseline = 'middle';
  surface.fillText(title, frame.left, 14);
  surface.save();
  surface.translate(0, HEAD);
  paint(surface, frame, picture, PRINT);
  surface.strokeStyle = '#9aa0a6';
  surface.lineWidth = 1;
  surface.strokeRect(frame.left, frame.top, frame.width, frame.height);
  if (legend.length > 1) {
    // Read over the curves that run behind it.
    const wide = 38 + Math.max(...legend.map(({ label }) => widthOf(surface, label)));
    surface.globalAlpha = 0.65;
    surface.fillStyle = PRINT.surface;
    surface.fillRect(frame.left + frame.width - wide, frame.top + 1, wide - 1, LEGEND * legend.length + 5);
    surface.globalAlpha = 1;
    legend.forEach(({ label, color, dash }, i) => {
      const y = frame.top + 10 + LEGEND * i;
      const right = frame.left + frame.width - 6;
      surface.strokeStyle = color;
      surface.lineWidth = 2;
      surface.setLineDash(dash ?? []);
      surface.beginPath();
      surface.moveTo(right - 20, y);
      surface.lineTo(right, y);
      surface.stroke();
      surface.setLineDash([]);
      surface.fillStyle = PRINT.text;
      drawText(surface, label, right - 26, y, 'right');
    });
  }
  surface.restore();
  return surface.toString();
}

/** Plain line plots. */
export function plotSheet(plots: readonly LinePlotSpec[]): string {
  return chartSheet(
    plots.map(({ title, xLabel, yLabel, lines, to, equal }) => {
      const curves = lines.map((line, i): Curve => {
        const end = to === undefined ? line.x.length : Array.from(line.x).findIndex((x) => x > to);
        return {
          ...line,
          color: COLORS[i % COLORS.length]!,
          ...(i >= COLORS.length ? { dash: [5, 3] } : {}),
          rows: [0, end < 0 ? line.x.length : end],
        };
      });
      return {
        title,
        legend: curves,
        picture: {
          x: { title: xLabel, air: equal ? undefined : 0 },
          y: { title: yLabel },
          equal,
          marks: curves.map(curveMark),
        },
      };
    }),
  );
}
