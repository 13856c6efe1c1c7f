/** From columns to a picture: ranges, units, curves. */
import type { Motion } from '../../app/runs/motion.ts';
import { curveMark, type Curve } from '../../charts/curves.ts';
import type { Picture } from '../../charts/frame.ts';
import type { Range } from '../../charts/scales.ts';
import { axisText, columnOf, shownFactor, symbolOf, unitsOf, type Column } from '../../core/motion/columns.ts';
import type { ColumnValues } from '../../core/motion/columnValues.ts';
import { rowsWithin } from '../../core/motion/rowsWithin.ts';
import { words } from '../../core/motion/symbols.ts';
import { compileExpression } from '../../core/scenario/expressions.ts';
import type { PaneProps } from './paneProps.ts';
import { stylesOf } from '../../charts/columnStyles.ts';

const EXACT_POINTS = 400;

/** Columns of a motion by name. */
export const infoIn =
  ({ system, constraints }: Motion) =>
  (name: string): Column =>
    columnOf(system.meta, name, constraints === null ? [] : system.contacts);

/** The times that are shown. */
export function limits({ trajectory }: Motion, range: Range | null, to = Infinity): Range {
  const end = Math.min(to, trajectory.end);
  return range ?? [trajectory.start, end > trajectory.start ? end : trajectory.start + 1];
}

export function pictureOf({ pane, motion, values, range }: PaneProps, degrees: boolean): Picture {
  const infoOf = infoIn(motion);
  const styles = stylesOf(pane.y.map(infoOf));
  const overTime = pane.x === 't';
  const { trajectory } = motion;
  const t = trajectory.column('t')!;
  const shown = pane.y.map((name, i) => ({ name, style: styles[i]! })).filter(({ name }) => !hides(pane, name));
  const xs = overTime ? t : values(pane.x).get();
  const whole = limits(motion, null, pane.to);
  const curves = shown.map(({ name, style }): Curve => {
    const column = values(name);
    const y = column.get();
    return {
      ...style,
      label: symbolOf(infoOf(name)),
      x: xs,
      y,
      xFactor: overTime ? 1 : shownFactor(infoOf(pane.x), degrees),
      yFactor: shownFactor(infoOf(name), degrees),
      ...(overTime
        ? {
            rising: true,
            envelope: column.envelope,
            settled: trajectory.settled,
            rows: [0, y.length],
            rate: column.rate,
          }
        : { rows: rowsWithin(t.subarray(0, Math.min(xs.length, y.length)), ...limits(motion, range.peek(), pane.to)) }),
    };
  });
  if (pane.exact && overTime) curves.push(exactCurve(pane.exact, whole, shownFactor(infoOf(pane.y[0] ?? ''), degrees)));
  const y = shown.map(({ name }) => infoOf(name));
  return {
    x: { title: axisText([infoOf(pane.x)], degrees), ...(overTime ? { range: whole } : {}) },
    y: { title: axisText(y, degrees), unit: unitsOf(y, degrees) },
    equal: pane.equal,
    marks: curves.map(curveMark),
  };
}

const hides = (pane: PaneProps['pane'], name: string): boolean => pane.hidden?.includes(name) ?? false;

function exactCurve(
  { label, expression }: { label: string; expression: string },
  [from, to]: Range,
  yFactor: number,
): Curve {
  const { evaluate } = compileExpression(expression, { variables: ['t'] });
  const x = Float64Array.from({ length: EXACT_POINTS + 1 }, (_, i) => from + ((to - from) * i) / EXACT_POINTS);
  return {
    label: words(label),
    color: '#8a8f98',
    dash: [2, 2],
    x,
    y: x.map((time) => evaluate(time)),
    yFactor,
    rising: true,
  };
}

/** Where the motion is, on every curve of a plot over something else than time. */
export function dotsOf({ pane, motion, values }: PaneProps, degrees: boolean, time: number) {
  const infoOf = infoIn(motion);
  const styles = stylesOf(pane.y.map(infoOf));
  const value = (name: string): number => values(name).at(time) * shownFactor(infoOf(name), degrees);
  return pane.y.flatMap((name, i) =>
    hides(pane, name) ? [] : [{ x: value(pane.x), y: value(name), color: styles[i]!.color }],
  );
}

/** The time of the row nearest to a place in a plot over something else than time; in units shown. */
export function nearestTime({ pane, motion, values }: PaneProps, degrees: boolean, x: number, y: number): number {
  const infoOf = infoIn(motion);
  const t = motion.trajectory.column('t')!;
  const place = (name: string, at: number): { list: Float64Array; at: number; spread: number } => {
    const column: ColumnValues = values(name);
    const list = column.get();
    const [low, high] = column.envelope.range(list, 0, list.length, motion.trajectory.settled);
    return { list, at: at / shownFactor(infoOf(name), degrees), spread: high - low || 1 };
  };
  const across = place(pane.x, x);
  const curves = pane.y.filter((name) => !hides(pane, name)).map((name) => place(name, y));
  const spread = Math.max(...curves.map((c) => c.spread));
  let best = Infinity;
  let found = t[0] ?? 0;
  for (let i = 0; i < across.list.length; i++) {
    for (const { list, at } of curves) {
      const d = ((across.list[i]! - across.at) / across.spread) ** 2 + ((list[i]! - at) / spread) ** 2;
      if (d < best) [best, found] = [d, t[i]!];
    }
  }
  return found;
}
