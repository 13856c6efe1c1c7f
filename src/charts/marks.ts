/** What stands in a frame beside curves: cells of a heat map, bands, lines across, places along x. */
import { fromX, fromY, toX, toY, type Frame, type Mark } from './frame.ts';
import type { Range } from './scales.ts';

/** A line across the whole frame. */
export function lineAcross(along: 'x' | 'y', value: number, color?: string, dash: readonly number[] = []): Mark {
  return {
    draw(surface, frame, theme) {
      const { left, top, width, height } = frame;
      surface.strokeStyle = color ?? theme.ink;
      surface.lineWidth = 1;
      surface.setLineDash(dash);
      surface.beginPath();
      if (along === 'x') {
        const at = Math.round(toX(frame, value)) + 0.5;
        surface.moveTo(at, top);
        surface.lineTo(at, top + height);
      } else {
        const at = Math.round(toY(frame, value)) + 0.5;
        surface.moveTo(left, at);
        surface.lineTo(left + width, at);
      }
      surface.stroke();
      surface.setLineDash([]);
    },
  };
}

/** Tints where one of the coordinates is positive: what grows. */
export function growingBand(along: 'x' | 'y'): Mark {
  return {
    under: true,
    draw(surface, frame, theme) {
      const { left, top, width, height } = frame;
      surface.fillStyle = theme.growing;
      if (along === 'x') {
        const zero = Math.min(left + width, Math.max(left, toX(frame, 0)));
        surface.fillRect(zero, top, left + width - zero, height);
      } else {
        const zero = Math.min(top + height, Math.max(top, toY(frame, 0)));
        surface.fillRect(left, top, width, zero - top);
      }
    },
  };
}

/** Needs room for points that something else draws. */
export function room(x: Range, y: Range): Mark {
  return { extent: () => ({ x, y }), draw: () => {} };
}

/** Rising places along x, of which the nearest to the pointer is picked. */
export function stops(values: ArrayLike<number>): Mark {
  return {
    draw: () => {},
    pick(frame, px) {
      const at = fromX(frame, px);
      let best = 0;
      for (let i = 1; i < values.length; i++) if (Math.abs(values[i]! - at) < Math.abs(values[best]! - at)) best = i;
      return values.length > 0 ? best : null;
    },
  };
}

/** Stops of Matplotlib's viridis (S. van der Walt, N. Smith): even in lightness, told apart without red and green. */
const STOPS = [
  [68, 1, 84],
  [72, 40, 120],
  [62, 74, 137],
  [49, 104, 142],
  [38, 130, 142],
  [31, 158, 137],
  [53, 183, 121],
  [110, 206, 88],
  [181, 222, 43],
  [253, 231, 37],
] as const;

/** Colour of a share 0 .. 1 of the scale. */
export function scaleColour(share: number): string {
  const at = Math.min(1, Math.max(0, share)) * (STOPS.length - 1);
  const k = Math.min(STOPS.length - 2, Math.floor(at));
  const [a, b] = [STOPS[k]!, STOPS[k + 1]!];
  return `rgb(${a.map((c, i) => Math.round(c + (at - k) * (b[i]! - c))).join(' ')})`;
}

/** Smallest and largest number of a list; [Infinity, -Infinity] where there is none. */
export function rangeOfValues(values: ArrayLike<number>): [number, number] {
  let low = Infinity;
  let high = -Infinity;
  for (let i = 0; i < values.length; i++) {
    const v = values[i]!;
    if (v < low) low = v;
    if (v > high) high = v;
  }
  return [low, high];
}

/**
 * A heat map over two axes of `steps`.
 * @param values by row, from the bottom; NaN where there is none
 * @param selected the cell that is marked
 * @param colour of a value, and of its share 0 .. 1 between the smallest and the largest
 */
export function cells(
  columns: number,
  rows: number,
  values: ArrayLike<number>,
  selected: number | null,
  colour: (share: number, value: number) => string = scaleColour,
): Mark & { range: Range } {
  const [low, high] = rangeOfValues(values);
  const edges = (frame: Frame, c: number, r: number): [number, number, number, number] => {
    const [x0, x1] = [Math.round(toX(frame, c - 0.5)), Math.round(toX(frame, c + 0.5))];
    const [y0, y1] = [Math.round(toY(frame, r + 0.5)), Math.round(toY(frame, r - 0.5))];
    return [x0, y0, x1 - x0, y1 - y0];
  };
  return {
    range: [low, high],
    extent: () => ({ x: [-0.5, columns - 0.5], y: [-0.5, rows - 0.5] }),
    draw(surface, frame, theme) {
      for (let r = 0; r < rows; r++)
        for (let c = 0; c < columns; c++) {
          const v = values[r * columns + c]!;
          surface.fillStyle = v - v === 0 ? colour(high > low ? (v - low) / (high - low) : 0.5, v) : theme.empty;
          surface.fillRect(...edges(frame, c, r));
        }
      if (selected === null) return;
      const cell = edges(frame, selected % columns, Math.floor(selected / columns));
      for (const [style, wide] of [
        [theme.surface, 4],
        [theme.text, 2],
      ] as const) {
        surface.strokeStyle = style;
        surface.lineWidth = wide;
        surface.strokeRect(...cell);
      }
    },
    pick(frame, px, py) {
      const [c, r] = [Math.round(fromX(frame, px)), Math.round(fromY(frame, py))];
      return c >= 0 && c < columns && r >= 0 && r < rows ? r * columns + c : null;
    },
  };
}

/** Of kinds that have no order, told apart with any colour vision and in both themes (M. Okabe, K. Ito). */
const KINDS = ['#0072b2', '#e69f00', '#009e73', '#cc79a7', '#56b4e9', '#d55e00', '#f0e442', '#999999'] as const;

/** Colour of a kind by its number from 0; the last one is that of all that follow. */
export const kindColour = (kind: number): string => KINDS[Math.min(kind, KINDS.length - 1)]!;
