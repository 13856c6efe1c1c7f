/** A log-log diagram as SVG text with a ground of its own, so that it reads in light and dark: curves labelled at their ends. */

export interface Curve {
  label: string;
  color: string;
  points: readonly { x: number; y: number }[];
}

export interface Diagram {
  title: string;
  xLabel: string;
  yLabel: string;
  curves: readonly Curve[];
}

const WIDTH = 780;
const HEIGHT = 520;
const FRAME = { left: 74, right: 130, top: 56, bottom: 58 };
/** Least distance of two labels, px. */
const LABEL_HEIGHT = 15;
const GROUND = '#fcfcfb';
const INK = '#1f2328';
const MUTED = '#59636e';
const GRID = '#e3e5e8';

interface Axis {
  from: number;
  to: number;
  /** Pixel of a value. */
  at(value: number): number;
}

/** x runs from large to small: errors become smaller, results better, to the right. */
export function diagram({ title, xLabel, yLabel, curves }: Diagram): string {
  const all = curves.flatMap((c) => c.points);
  const x = axis(
    all.map((p) => p.x),
    WIDTH - FRAME.right,
    FRAME.left,
  );
  const y = axis(
    all.map((p) => p.y),
    HEIGHT - FRAME.bottom,
    FRAME.top,
  );
  const text = (px: number, py: number, words: string, more = ''): string =>
    `<text x="${px}" y="${py}" ${more}>${words}</text>`;
  const middle = (FRAME.top + HEIGHT - FRAME.bottom) / 2;
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${HEIGHT}" width="${WIDTH}" height="${HEIGHT}" role="img" aria-label="${title}" font-family="system-ui, -apple-system, 'Segoe UI', sans-serif" font-size="12" fill="${MUTED}">
<rect width="${WIDTH}" height="${HEIGHT}" rx="6" fill="${GROUND}"/>
${text(FRAME.left, 30, title, `font-size="15" font-weight="600" fill="${INK}"`)}
${grid(x, y)}
${text((FRAME.left + WIDTH - FRAME.right) / 2, HEIGHT - 16, xLabel, 'text-anchor="middle" font-size="13"')}
${text(20, middle, yLabel, `text-anchor="middle" font-size="13" transform="rotate(-90 20 ${middle})"`)}
${curves.map((curve) => curveOf(curve, x, y)).join('\n')}
${labels(curves, x, y)}
</svg>
`;
}

/** A decade at a time, with whole decades at both ends; `low` and `high` are the pixels of its least and largest value. */
function axis(values: readonly number[], low: number, high: number): Axis {
  const from = Math.floor(Math.log10(Math.min(...values)));
  const to = Math.ceil(Math.log10(Math.max(...values)));
  return { from, to, at: (value) => low + ((high - low) * (Math.log10(value) - from)) / (to - from) };
}

function decades({ from, to }: Axis): number[] {
  return Array.from({ length: to - from + 1 }, (_, k) => from + k);
}

function grid(x: Axis, y: Axis): string {
  const [right, bottom] = [WIDTH - FRAME.right, HEIGHT - FRAME.bottom];
  const power = (k: number): string => `10<tspan dy="-5" font-size="9">${String(k).replace('-', '−')}</tspan>`;
  const vertical = decades(x).map((k) => {
    const px = round(x.at(10 ** k));
    return `<path d="M${px} ${FRAME.top}V${bottom}" stroke="${GRID}"/><text x="${px}" y="${bottom + 20}" text-anchor="middle">${power(k)}</text>`;
  });
  const horizontal = decades(y).map((k) => {
    const py = round(y.at(10 ** k));
    return `<path d="M${FRAME.left} ${py}H${right}" stroke="${GRID}"/><text x="${FRAME.left - 8}" y="${py + 4}" text-anchor="end">${power(k)}</text>`;
  });
  return [...vertical, ...horizontal].join('\n');
}

function curveOf({ points, color }: Curve, x: Axis, y: Axis): string {
  const at = points.map((p) => `${round(x.at(p.x))} ${round(y.at(p.y))}`);
  const dots = at.map((p) => `<circle cx="${p.split(' ')[0]}" cy="${p.split(' ')[1]}" r="2.6"/>`).join('');
  return `<path d="M${at.join('L')}" fill="none" stroke="${color}" stroke-width="1.8" stroke-linejoin="round"/><g fill="${color}">${dots}</g>`;
}

/** Names beside the last points; those of curves that end at the right stand in the margin, pushed apart, with a line. */
function labels(curves: readonly Curve[], x: Axis, y: Axis): string {
  const margin = WIDTH - FRAME.right;
  const placed = curves
    .filter((c) => c.points.length > 0)
    .map((c) => {
      const end = c.points.at(-1)!;
      const [px, py] = [x.at(end.x), y.at(end.y)];
      return { ...c, px, py, ly: py, lx: px > margin - 150 ? margin + 14 : px + 9 };
    })
    .sort((a, b) => a.py - b.py);
  spread(placed.filter((p) => p.lx > margin));
  return placed
    .map(({ label, color, px, py, lx, ly }) => {
      const line =
        lx > margin
          ? `<path d="M${round(px + 4)} ${round(py)}L${lx - 3} ${round(ly)}" stroke="${color}" stroke-width="0.7"/>`
          : '';
      const halo = `stroke="${GROUND}" stroke-width="4" paint-order="stroke"`;
      return `${line}<text x="${round(lx)}" y="${round(ly + 4)}" fill="${color}" font-weight="600" ${halo}>${label}</text>`;
    })
    .join('\n');
}

/** Pushes overlapping labels apart, again and again until none is left. */
function spread(placed: readonly { ly: number }[]): void {
  for (let pass = 0; pass < 200; pass++) {
    let moved = false;
    for (let k = 1; k < placed.length; k++) {
      const [above, below] = [placed[k - 1]!, placed[k]!];
      const lack = LABEL_HEIGHT - (below.ly - above.ly);
      if (lack <= 0.01) continue;
      above.ly -= lack / 2;
      below.ly += lack / 2;
      moved = true;
    }
    if (!moved) return;
  }
}

function round(value: number): number {
  return Math.round(10 * value) / 10;
}
