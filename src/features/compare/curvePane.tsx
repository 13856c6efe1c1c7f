import { effect, type Signal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import type { App } from '../../app/app.ts';
import type { Chart, Dot } from '../../charts/chart.ts';
import { ChartView } from '../../charts/chartView.tsx';
import { curveMark, type Curve } from '../../charts/curves.ts';
import type { Picture } from '../../charts/frame.ts';
import { token } from '../../charts/tokens.ts';
import { axisText, shownFactor, shownUnit, type Column } from '../../core/motion/columns.ts';
import { valuesOf } from '../../core/motion/columnValues.ts';
import { words as plain } from '../../core/motion/symbols.ts';
import type { ShownRun } from './shownRuns.ts';

interface Shown {
  runs: readonly ShownRun[];
  x: Column;
  y: Column;
  equal: boolean;
}

/** One column of several runs against time or another column. */
export function CurvePane({
  app,
  zoom,
  label,
  testId,
  onChart,
  ...shown
}: Shown & {
  app: App;
  zoom: Signal<readonly [number, number] | null>;
  label: string;
  testId: string;
  /** For what saves it. */
  onChart(chart: Chart | null): void;
}) {
  const chart = useRef<Chart | null>(null);
  // No function below may hold the runs themselves: those of the first drawing would stay in memory as long as the plot.
  const latest = useRef(shown);
  latest.current = shown;
  const overTime = shown.x.name === 't';
  const degrees = (): boolean => app.state.plots.peek().degrees;
  const draw = (): void => chart.current?.setPicture(pictureOf(latest.current, degrees()));
  const mark = (): void => {
    const time = app.state.time.peek();
    chart.current?.setCursor(overTime ? time : null, dotsOf(latest.current, degrees(), time));
  };
  useEffect(() => {
    draw();
    mark();
  }, [shown.runs]);
  return (
    <ChartView
      class={shown.equal ? 'equal' : ''}
      label={label}
      testId={testId}
      options={{
        alongX: overTime,
        onZoom: ({ x }) => {
          zoom.value = x;
        },
        ...(overTime ? { onSeek: (time: number) => app.actions.seek(time) } : {}),
      }}
      attach={(made) => {
        chart.current = made;
        onChart(made);
        const stops = [
          effect(() => {
            void app.state.rowsVersion.value;
            void app.state.plots.value;
            draw();
            mark();
          }),
          app.state.time.subscribe(mark),
          effect(() => {
            if (overTime || zoom.value === null) made.setZoom({ x: zoom.value, y: null });
          }),
          // The theme's colours are in force after the page's own effect: draw in the next frame.
          app.state.theme.subscribe(() => void requestAnimationFrame(draw)),
        ];
        return () => {
          for (const stop of stops) stop();
          chart.current = null;
          onChart(null);
        };
      }}
    />
  );
}

function pictureOf({ runs, x, y, equal }: Shown, degrees: boolean): Picture {
  const curves = runs.map(({ name, motion, style }): Curve => {
    const [xs, ys] = [valuesOf(motion, x.name), valuesOf(motion, y.name)];
    return {
      label: plain(name),
      color: style?.color ?? token('--text'),
      ...(style ? { dash: style.dash } : { width: 2 }),
      x: xs.get(),
      y: ys.get(),
      xFactor: shownFactor(x, degrees),
      yFactor: shownFactor(y, degrees),
      ...(x.name === 't'
        ? { rising: true, envelope: ys.envelope, settled: motion.trajectory.settled, rate: ys.rate }
        : {}),
    };
  });
  return {
    x: { title: axisText([x], degrees), ...(x.name === 't' ? { air: 0 } : {}) },
    y: { title: axisText([y], degrees), unit: shownUnit(y, degrees) },
    equal,
    marks: curves.map(curveMark),
  };
}

/** Where each run is at a time; nowhere outside of its own. */
function dotsOf({ runs, x, y }: Shown, degrees: boolean, time: number): Dot[] {
  return runs.flatMap(({ motion, style }) => {
    const { trajectory } = motion;
    if (trajectory.length === 0 || time < trajectory.start || time > trajectory.end) return [];
    const [px, py] = [x, y].map((c) => valuesOf(motion, c.name).at(time) * shownFactor(c, degrees)) as [number, number];
    return px - px === 0 && py - py === 0 ? [{ x: px, y: py, color: style?.color ?? token('--text') }] : [];
  });
}
