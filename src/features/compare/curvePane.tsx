import { effect, type Signal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import type { App } from '../../app/app.ts';
import { createOverlayPlot, type OverlayCurve, type OverlayPlot } from '../../charts/overlayPlot.ts';
import { token } from '../../charts/tokens.ts';
import { shownFactor, spoken, type Column } from '../../core/motion/columns.ts';
import { valuesOf } from '../../core/motion/columnValues.ts';
import type { ShownRun } from './shownRuns.ts';

/** One column of several runs against time or another column. */
export function CurvePane({
  app,
  runs,
  x,
  y,
  zoom,
  equal,
  label,
  testId,
}: {
  app: App;
  runs: readonly ShownRun[];
  x: Column;
  y: Column;
  zoom: Signal<readonly [number, number] | null>;
  equal: boolean;
  label: string;
  testId: string;
}) {
  const host = useRef<HTMLDivElement>(null);
  const plot = useRef<OverlayPlot | null>(null);
  // No function below may hold `runs` itself: those of the first drawing would stay in memory as long as the plot.
  const latest = useRef(runs);
  latest.current = runs;
  useEffect(() => {
    const made = (plot.current = createOverlayPlot(host.current!, {
      xLabel: spoken(x, true),
      yLabel: spoken(y, true),
      rising: x.name === 't',
      equal,
      onZoom: (range) => {
        zoom.value = range;
      },
      ...(x.name === 't' ? { onSeek: (time: number) => app.actions.seek(time) } : {}),
    }));
    const stops = [
      effect(() => {
        void app.state.rowsVersion.value;
        made.setCurves(curvesOf(latest.current, x, y));
      }),
      effect(() => {
        const time = app.state.time.value;
        made.setCursor(
          x.name === 't' ? time : 0,
          latest.current.map((run) => pointAt(run, x, y, time)),
        );
      }),
      effect(() => made.setZoom(zoom.value)),
      // The theme's colours are in force after the page's own effect: draw in the next frame.
      app.state.theme.subscribe(() => requestAnimationFrame(() => made.redraw())),
    ];
    return () => {
      for (const stop of stops) stop();
      made.destroy();
    };
  }, []);
  useEffect(() => {
    plot.current?.setCurves(curvesOf(latest.current, x, y));
    plot.current?.setCursor(
      x.name === 't' ? app.state.time.peek() : 0,
      latest.current.map((run) => pointAt(run, x, y, app.state.time.peek())),
    );
  }, [runs]);
  return (
    <div
      ref={host}
      class={`overlay-plot${equal ? ' square-plot' : ''}`}
      role="img"
      aria-label={label}
      data-testid={testId}
    />
  );
}

const EMPTY = new Float64Array(0);

function curvesOf(runs: readonly ShownRun[], x: Column, y: Column): OverlayCurve[] {
  return runs.map(({ name, motion, style }) => {
    const [xs, ys] = [x, y].map((c) => valuesOf(motion, c.name).get());
    const there = xs !== undefined && ys !== undefined;
    return {
      label: name,
      color: style?.color ?? token('--text'),
      ...(style?.dash ? { dash: style.dash } : {}),
      ...(style ? {} : { width: 2 }),
      x: there ? xs : EMPTY,
      y: there ? ys : EMPTY,
      xFactor: shownFactor(x, true),
      yFactor: shownFactor(y, true),
    };
  });
}

/** Where a run is at a time; nowhere outside of its own. */
function pointAt({ motion }: ShownRun, x: Column, y: Column, time: number): readonly [number, number] | null {
  const { trajectory } = motion;
  if (trajectory.length === 0 || time < trajectory.start || time > trajectory.end) return null;
  const [px, py] = [x, y].map((c) => valuesOf(motion, c.name).at(time) * shownFactor(c, true)) as [number, number];
  return Number.isNaN(px) || Number.isNaN(py) ? null : [px, py];
}
