/** From columns to curves: ranges, units, points. */
import type { Motion } from '../../app/types.ts';
import type { PaneCurve } from '../../charts/panePlot.ts';
import { compileExpression } from '../../core/scenario/expressions.ts';
import { decimated } from '../../core/motion/envelope.ts';
import { rowsWithin } from '../../core/motion/rowsWithin.ts';
import type { Trajectory } from '../../core/motion/trajectory.ts';
import type { ColumnInfo } from './columns.ts';
import type { PaneProps } from './paneView.tsx';
import type { CurveStyle } from './style.ts';

export const DEGREE = Math.PI / 180;
const EXACT_POINTS = 400;
/** Points of a path at the most. */
const PATH_POINTS = 20_000;

type Range = readonly [number, number];

export const shownUnit = (c: ColumnInfo, degrees: boolean): string =>
  c.angle && degrees ? c.unit.replace('rad', '°') : c.unit;

/** The unit that all of these have, or nothing. */
export function unitOf(columns: readonly ColumnInfo[], degrees: boolean): string {
  const units = [...new Set(columns.map((c) => shownUnit(c, degrees)))];
  return units.length === 1 ? units[0]! : units.filter(Boolean).join(', ');
}

/** The times that are shown. */
export function limits({ trajectory }: Motion, range: Range | null, to = Infinity): Range {
  const end = Math.min(to, trajectory.end);
  return range ?? [trajectory.start, end > trajectory.start ? end : trajectory.start + 1];
}

/** Value at a time, linear between rows; NaN where there is none. */
export function at(trajectory: Trajectory, values: Float64Array, time: number): number {
  const t = trajectory.column('t')!;
  if (values.length === 0) return NaN;
  const row = Math.min(trajectory.locate(time), values.length - 1);
  const next = Math.min(row + 1, values.length - 1);
  const span = t[next]! - t[row]!;
  const share = span > 0 ? Math.min(1, Math.max(0, (time - t[row]!) / span)) : 0;
  return share === 0 ? values[row]! : values[row]! + share * (values[next]! - values[row]!);
}

/** Work up to a time by the trapezoidal rule over the rows, J. */
export function energySpent(trajectory: Trajectory, power: Float64Array, time: number): number {
  const t = trajectory.column('t')!;
  let sum = 0;
  for (let i = 1; i < power.length && t[i]! <= time; i++) {
    const share = 0.5 * (t[i]! - t[i - 1]!) * (power[i]! + power[i - 1]!);
    if (share === share) sum += share;
  }
  return sum;
}

export function curvesOf(
  { pane, motion, values, range }: PaneProps,
  infoOf: (name: string) => ColumnInfo,
  degrees: boolean,
  styles: readonly CurveStyle[],
  width: number,
): { curves: PaneCurve[]; x: Range; y: Range } {
  const factor = (name: string): number => (infoOf(name).angle && degrees ? 1 / DEGREE : 1);
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
