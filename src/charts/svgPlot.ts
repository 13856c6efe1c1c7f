/** Plain line plots as SVG text, for pictures in the documentation. */

export interface Line {
  label: string;
  x: ArrayLike<number>;
  y: ArrayLike<number>;
}

export interface LinePlotSpec {
  title: string;
  xLabel: string;
  yLabel: string;
  lines: readonly Line[];
  /** Where the horizontal axis ends, if before the data. */
  to?: number | undefined;
  /** A metre is as long on both axes. */
  equal?: boolean | undefined;
}

const WIDTH = 420;
const HEIGHT = 280;
const LEFT = 58;
const RIGHT = 14;
const TOP = 30;
const BOTTOM = 42;
/** Told apart by colour-blind people too (Okabe and Ito). */
const COLORS = ['#d55e00', '#0072b2', '#009e73', '#cc79a7', '#56b4e9', '#e69f00'];
/** Half a pixel: what a curve may be simplified by. */
const FINE = 0.5;

/** Several plots side by side, two in a row, as one picture with a background of its own. */
export function plotSheet(plots: readonly LinePlotSpec[]): string {
  const columns = Math.min(2, plots.length);
  const rows = Math.ceil(plots.length / columns);
  const body = plots.map(
    (plot, i) =>
      `<g transform="translate(${(i % columns) * WIDTH} ${Math.floor(i / columns) * HEIGHT})">${onePlot(plot)}</g>`,
  );
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${columns * WIDTH} ${rows * HEIGHT}" width="${columns * WIDTH}" height="${rows * HEIGHT}" font-family="system-ui, sans-serif" font-size="11">`,
    `<rect width="100%" height="100%" fill="#ffffff"/>`,
    ...body,
    '</svg>',
    '',
  ].join('\n');
}

function onePlot({ title, xLabel, yLabel, lines, to = Infinity, equal = false }: LinePlotSpec): string {
  const shown = lines.map((line) => ({
    ...line,
    points: Array.from(line.x, (x, i): [number, number] => [x, line.y[i]!]).filter(
      ([x, y]) => x <= to && Number.isFinite(y),
    ),
  }));
  const all = shown.flatMap((line) => line.points);
  let [x0, x1] = extent(
    all.map(([x]) => x),
    0,
  );
  let [y0, y1] = extent(
    all.map(([, y]) => y),
    0.05,
  );
  const [w, h] = [WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM];
  if (equal) {
    const perPixel = Math.max((x1 - x0) / w, (y1 - y0) / h);
    [x0, x1] = around((x0 + x1) / 2, (perPixel * w) / 2);
    [y0, y1] = around((y0 + y1) / 2, (perPixel * h) / 2);
  }
  const X = (x: number): number => LEFT + ((x - x0) / (x1 - x0)) * w;
  const Y = (y: number): number => TOP + h - ((y - y0) / (y1 - y0)) * h;
  const grid = [
    ...ticks(x0, x1).map(
      (x) =>
        `<path d="M${px(X(x))} ${TOP}v${h}" stroke="#e3e5e8"/><text x="${px(X(x))}" y="${TOP + h + 14}" text-anchor="middle" fill="#555b63">${number(x)}</text>`,
    ),
    ...ticks(y0, y1).map(
      (y) =>
        `<path d="M${LEFT} ${px(Y(y))}h${w}" stroke="#e3e5e8"/><text x="${LEFT - 6}" y="${px(Y(y) + 4)}" text-anchor="end" fill="#555b63">${number(y)}</text>`,
    ),
  ];
  const curves = shown.map(
    (line, i) =>
      `<path d="${path(line.points.map(([x, y]) => [X(x), Y(y)]))}" fill="none" stroke="${COLORS[i % COLORS.length]}" stroke-width="1.5"${i >= COLORS.length ? ' stroke-dasharray="5 3"' : ''}/>`,
  );
  const legend =
    shown.length < 2
      ? []
      : shown.map(
          (line, i) =>
            `<text x="${WIDTH - RIGHT - 4}" y="${TOP + 13 + 13 * i}" text-anchor="end" fill="${COLORS[i % COLORS.length]}" stroke="#ffffff" stroke-width="3" paint-order="stroke">${escaped(line.label)}</text>`,
        );
  return [
    `<text x="${LEFT}" y="18" font-size="13" font-weight="600" fill="#1b1e22">${escaped(title)}</text>`,
    ...grid,
    `<rect x="${LEFT}" y="${TOP}" width="${w}" height="${h}" fill="none" stroke="#9aa0a6"/>`,
    ...curves,
    ...legend,
    `<text x="${LEFT + w / 2}" y="${HEIGHT - 10}" text-anchor="middle" fill="#1b1e22">${escaped(xLabel)}</text>`,
    `<text transform="translate(14 ${TOP + h / 2}) rotate(-90)" text-anchor="middle" fill="#1b1e22">${escaped(yLabel)}</text>`,
  ].join('\n');
}

/** Only points that move the pen by more than can be seen. */
function path(points: readonly (readonly [number, number])[]): string {
  let text = '';
  let last: readonly [number, number] = [NaN, NaN];
  points.forEach((point, i) => {
    if (i > 0 && i < points.length - 1 && Math.hypot(point[0] - last[0], point[1] - last[1]) < FINE) return;
    text += `${i === 0 ? 'M' : 'L'}${px(point[0])} ${px(point[1])}`;
    last = point;
  });
  return text;
}

function extent(values: readonly number[], air: number): [number, number] {
  const low = values.reduce((a, b) => Math.min(a, b), Infinity);
  const high = values.reduce((a, b) => Math.max(a, b), -Infinity);
  const margin = high > low ? air * (high - low) : Math.max(1, Math.abs(low)) * 0.1;
  return [low - margin, high + margin];
}

const around = (middle: number, half: number): [number, number] => [middle - half, middle + half];

function ticks(low: number, high: number): number[] {
  const rough = (high - low) / 5;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= rough)!;
  const first = Math.ceil(low / step);
  return Array.from({ length: Math.floor(high / step) - first + 1 }, (_, i) => (first + i) * step);
}

const px = (x: number): string => String(Math.round(10 * x) / 10);
const number = (x: number): string => String(Number(x.toPrecision(6))).replace('-', '\u2212');
const escaped = (text: string): string => text.replace(/&/g, '&amp;').replace(/</g, '&lt;');
