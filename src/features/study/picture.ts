/** What is drawn of a sweep's results: a map over two varied quantities, points where they form no grid, or how often a value comes. */
import { cells, kindColour, rangeOfValues, scaleColour } from '../../charts/marks.ts';
import { fromX, toX, toY, type Mark, type Picture } from '../../charts/frame.ts';
import { words as plain } from '../../core/motion/symbols.ts';
import { gridOf, type Grid } from '../../core/sweep/studyResults.ts';
import { kindName, written, type Quantity } from './quantities.ts';
import { words } from './words.ts';

export interface Drawing {
  kind: 'map' | 'points' | 'histogram';
  /** @param at what the pointer stands at, by the mark's number */
  picture(at: number | null): Picture;
  /** The row at a mark's number; null where there is none. */
  rowAt(at: number): number | null;
  /** The number of what lies beside it; for keys. */
  beside(at: number | null, by: number, across: number): number | null;
  /** What a mark that is no row says. */
  describe(at: number): string;
  /** Rows that another hides, and rows without a value. */
  hidden: number;
  left: number;
}

/** Side of a point, px, where they are few and where they are many. */
const POINT = [5, 2] as const;
const MANY = 5000;
/** Farther from the pointer than this nothing is picked, px. */
const NEAR = 12;
const MOST_BARS = 60;

/**
 * @param rows that are shown
 * @param y null for a histogram
 */
export function drawingOf(x: Quantity, y: Quantity | null, colour: Quantity, rows: readonly number[]): Drawing {
  if (!y) return histogram(x, rows);
  const grid = gridOf(x.values as Float64Array, y.values as Float64Array, rows);
  return grid ? map(x, y, colour, grid) : points(x, y, colour, rows);
}

/** As a number: of a kind its place in the list. */
function valueOf({ values, kinds, factor }: Quantity): (row: number) => number {
  if (!kinds) return (row) => (values as Float64Array)[row]! * factor;
  const place = new Map(kinds.map((kind, i) => [kind, i]));
  return (row) => place.get(values[row] as string)!;
}

const colourOf = ({ kinds }: Quantity): ((share: number, value: number) => string) =>
  kinds ? (_, value) => kindColour(value) : scaleColour;

function barOf(colour: Quantity, [low, high]: readonly [number, number]): NonNullable<Picture['bar']> {
  const { kinds, title } = colour;
  if (!kinds) return { title, low, high, colour: scaleColour };
  const last = kinds.length - 1;
  return {
    low: 0,
    high: last,
    colour: (share) => kindColour(Math.round(share * last)),
    names: kinds.map((kind) => kindName(colour, kind)),
  };
}

function map(x: Quantity, y: Quantity, colour: Quantity, grid: Grid): Drawing {
  const [wide, tall] = [grid.x.length, grid.y.length];
  const value = valueOf(colour);
  const values = Float64Array.from(grid.cells, (row) => (row < 0 ? NaN : value(row)));
  const names = (all: readonly number[], { factor }: Quantity): string[] => all.map((v) => short(v * factor));
  const axes = {
    x: { title: x.title, kind: 'steps' as const, names: names(grid.x, x), air: 0 },
    y: { title: y.title, kind: 'steps' as const, names: names(grid.y, y), air: 0 },
  };
  return {
    kind: 'map',
    picture: (at) => {
      const mark = cells(wide, tall, values, at, colourOf(colour));
      return { ...axes, marks: [mark], bar: barOf(colour, mark.range) };
    },
    rowAt: (at) => (grid.cells[at]! < 0 ? null : grid.cells[at]!),
    beside: (at, by, across) => {
      if (at === null) return 0;
      const [c, r] = [(at % wide) + by, Math.floor(at / wide) + across];
      return c >= 0 && c < wide && r >= 0 && r < tall ? r * wide + c : at;
    },
    describe: () => words.nothing,
    hidden: grid.hidden,
    left: values.reduce((count, v, cell) => count + (grid.cells[cell]! >= 0 && Number.isNaN(v) ? 1 : 0), 0),
  };
}

const short = (x: number): string => written(Number(x.toPrecision(3)));

function points(x: Quantity, y: Quantity, colour: Quantity, rows: readonly number[]): Drawing {
  const [ofX, ofY, ofColour] = [x, y, colour].map(valueOf) as [Of, Of, Of];
  const seen = rows.filter((row) => !Number.isNaN(ofX(row)) && !Number.isNaN(ofY(row)));
  const [xs, ys, colours] = [ofX, ofY, ofColour].map((of) => Float64Array.from(seen, of)) as [Of3, Of3, Of3];
  const range = rangeOfValues(colours);
  const paint = colourOf(colour);
  const size = seen.length > MANY ? POINT[1] : POINT[0];
  const mark = (at: number | null): Mark => ({
    extent: () => ({ x: rangeOfValues(xs), y: rangeOfValues(ys) }),
    draw(surface, frame, theme) {
      for (let i = 0; i < xs.length; i++) {
        const v = colours[i]!;
        const share = range[1] > range[0] ? (v - range[0]) / (range[1] - range[0]) : 0.5;
        surface.fillStyle = Number.isNaN(v) ? theme.line : paint(share, v);
        surface.fillRect(toX(frame, xs[i]!) - size / 2, toY(frame, ys[i]!) - size / 2, size, size);
      }
      if (at === null) return;
      surface.strokeStyle = theme.text;
      surface.lineWidth = 2;
      surface.strokeRect(toX(frame, xs[at]!) - 5, toY(frame, ys[at]!) - 5, 10, 10);
    },
    pick(frame, px, py) {
      let [best, nearest] = [NEAR ** 2, null as number | null];
      for (let i = 0; i < xs.length; i++) {
        const apart = (toX(frame, xs[i]!) - px) ** 2 + (toY(frame, ys[i]!) - py) ** 2;
        if (apart < best) [best, nearest] = [apart, i];
      }
      return nearest;
    },
  });
  return {
    kind: 'points',
    picture: (at) => ({ x: { title: x.title }, y: { title: y.title }, marks: [mark(at)], bar: barOf(colour, range) }),
    rowAt: (at) => seen[at] ?? null,
    beside: (at, by, across) =>
      seen.length === 0 ? null : Math.min(seen.length - 1, Math.max(0, (at ?? -1) + (by || across))),
    describe: () => words.nothing,
    hidden: 0,
    left: rows.length - seen.length,
  };
}

type Of = (row: number) => number;
type Of3 = Float64Array;

function histogram(x: Quantity, rows: readonly number[]): Drawing {
  const of = valueOf(x);
  const values = rows.map(of).filter((v) => v - v === 0);
  const kinds = x.kinds;
  const [low, high] = kinds ? [-0.5, kinds.length - 0.5] : padded(rangeOfValues(values));
  const count = kinds ? kinds.length : Math.min(MOST_BARS, Math.max(5, Math.ceil(Math.sqrt(values.length))));
  const counts = new Float64Array(count);
  for (const v of values) {
    const bin = Math.min(count - 1, Math.floor(((v - low) / (high - low)) * count));
    counts[bin] = counts[bin]! + 1;
  }
  const edge = (bin: number): number => low + (bin / count) * (high - low);
  const most = rangeOfValues(counts)[1];
  const mark = (at: number | null): Mark => ({
    extent: () => ({ x: [low, high], y: [0, Math.max(1, most)] }),
    draw(surface, frame, theme) {
      counts.forEach((n, bin) => {
        surface.fillStyle = bin === at ? theme.text : kinds ? kindColour(bin) : theme.accent;
        const [left, right, top] = [toX(frame, edge(bin)), toX(frame, edge(bin + 1)), toY(frame, n)];
        surface.fillRect(left + 0.5, top, Math.max(1, right - left - 1), toY(frame, 0) - top);
      });
    },
    pick(frame, px) {
      const bin = Math.floor(((fromX(frame, px) - low) / (high - low)) * count);
      return bin >= 0 && bin < count ? bin : null;
    },
  });
  const axis = kinds ? { kind: 'steps' as const, names: kinds.map((kind) => kindName(x, kind)) } : {};
  return {
    kind: 'histogram',
    picture: (at) => ({
      x: { title: x.title, ...axis, air: 0 },
      y: { title: plain(words.count), zero: true },
      marks: [mark(at)],
    }),
    rowAt: () => null,
    beside: (at, by) => Math.min(count - 1, Math.max(0, (at ?? -1) + by)),
    describe: (bin) =>
      kinds
        ? `${kindName(x, kinds[bin]!)}: ${counts[bin]!}`
        : words.bin(String(counts[bin]!), written(edge(bin)), written(edge(bin + 1))),
    hidden: 0,
    left: rows.length - values.length,
  };
}

/** One value alone stands in the middle of a range. */
function padded([low, high]: readonly [number, number]): [number, number] {
  if (!(low <= high)) return [0, 1];
  return low < high
    ? [low, high]
    : [low - Math.max(1e-9, Math.abs(low) / 10), high + Math.max(1e-9, Math.abs(high) / 10)];
}
