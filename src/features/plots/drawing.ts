/** From columns to curves: ranges, units, points. */
import type { Motion } from '../../app/runs/motion.ts';
import type { PaneCurve } from '../../charts/panePlot.ts';
import { compileExpression } from '../../core/scenario/expressions.ts';
import { shownFactor, type Column } from '../../core/motion/columns.ts';
import { decimated } from '../../core/motion/envelope.ts';
import { rowsWithin } from '../../core/motion/rowsWithin.ts';
import type { PaneProps } from './paneView.tsx';
import type { CurveStyle } from './style.ts';

const EXACT_POINTS = 400;
/** Points of a path at the most. */
const PATH_POINTS = 20_000;

type Range = readonly [number, number];

/** The times that are shown. */
export function limits({ trajectory }: Motion, range: Range | null, to = Infinity): Range {
  const end = Math.min(to, trajectory.end);
  return range ?? [trajectory.start, end > trajectory.start ? end : trajectory.start + 1];
}

export function curvesOf(
  { pane, motion, values, range }: PaneProps,
  infoOf: (name: string) => Column,
  degrees: boolean,
  styles: readonly CurveStyle[],
  width: number,
): { curves: PaneCurve[]; x: Range; y: Range } {
  const factor = (name: string): number => shownFactor(infoOf(name), degrees);
  const shown = pane.y
    .map((name, i) => ({ name, style: styles[i]! }))
    .filter(({ name }) => !pane.hidden?.includes(name));
  const [from, to] = limits(motion, range.peek(), pane.to);
  const overTime = pane.x === 't';
  const { trajectory } = motion;
  const t = trajectory.column('t')!;
  const curves: PaneCurve[] = shown.map(({ name, style }) => {
    const column = values(name);
    const y = column.get();
    const scale = factor(name);
    if (overTime) {
      const points = decimated(
        t.subarray(0, y.length),
        y,
        column.envelope,
        from,
        to,
        Math.max(100, width),
        trajectory.settled,
      );
      return { ...style, x: points.t, y: scale === 1 ? points.y : points.y.map((v) => scale * v) };
    }
    return { ...style, ...path(t, values(pane.x).get(), y, from, to, factor(pane.x), scale) };
  });
  if (pane.exact && overTime) {
    const { evaluate } = compileExpression(pane.exact.expression, { variables: ['t'] });
    const scale = factor(pane.y[0] ?? '');
    const x = Array.from({ length: EXACT_POINTS + 1 }, (_, i) => from + ((to - from) * i) / EXACT_POINTS);
    curves.push({ color: styles[0]?.color ?? '#888', dash: [2, 2], x, y: x.map((time) => scale * evaluate(time)) });
  }
  return {
    curves,
    x: overTime ? [from, to] : rangeOf(curves.map((c) => c.x)),
    y: rangeOf(
      curves.map((c) => c.y),
      overTime ? { x: curves.map((c) => c.x), from, to } : undefined,
    ),
  };
}

/** Rows of a path within the times that are shown; of too many, one in every few and the last. */
function path(
  t: Float64Array,
  xs: Float64Array,
  ys: Float64Array,
  from: number,
  to: number,
  xScale: number,
  yScale: number,
): { x: number[]; y: number[] } {
  const x: number[] = [];
  const y: number[] = [];
  const [first, end] = rowsWithin(t.subarray(0, Math.min(xs.length, ys.length)), from, to);
  const step = Math.max(1, Math.ceil((end - first) / PATH_POINTS));
  for (let i = first; i < end; i = i < end - 1 ? Math.min(i + step, end - 1) : end) {
    x.push(xScale * xs[i]!);
    y.push(yScale * ys[i]!);
  }
  return { x, y };
}

/** With a little air; a flat curve in the middle. */
function rangeOf(
  lists: readonly ArrayLike<number>[],
  within?: { x: readonly ArrayLike<number>[]; from: number; to: number },
): Range {
  let low = Infinity;
  let high = -Infinity;
  lists.forEach((list, k) => {
    for (let i = 0; i < list.length; i++) {
      const v = list[i]!;
      if (v - v !== 0 || (within && (within.x[k]![i]! < within.from || within.x[k]![i]! > within.to))) continue;
      if (v < low) low = v;
      if (v > high) high = v;
    }
  });
  if (!(low <= high)) return [-1, 1];
  // A curve that only rounding moves is flat.
  const air =
    high - low > 1e-12 * Math.max(Math.abs(low), Math.abs(high)) ? 0.06 * (high - low) : 0.1 * (Math.abs(high) || 1);
  return [low - air, high + air];
}
