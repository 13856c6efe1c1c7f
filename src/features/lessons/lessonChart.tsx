/** Under a live part: the columns that the lesson names, of the motion on the stage. */
import { effect } from '@preact/signals';
import type { App } from '../../app/app.ts';
import type { Motion } from '../../app/runs/motion.ts';
import { ChartView } from '../../charts/chartView.tsx';
import type { Chart } from '../../charts/chart.ts';
import { stylesOf } from '../../charts/columnStyles.ts';
import { curveMark } from '../../charts/curves.ts';
import type { LessonPlot } from '../../core/lessons/lesson.ts';
import { axisText, columnOf, columnsOf, shownFactor, symbolOf, unitsOf } from '../../core/motion/columns.ts';
import { valuesOf } from '../../core/motion/columnValues.ts';
import { useUi } from '../../ui/context.ts';
import { words } from './words.ts';

/** A growing run is drawn again at most so often, ms. */
const REDRAW_MS = 100;

export function LessonChart({ plot, title }: { plot: LessonPlot; title: string }) {
  const { app } = useUi();
  const motion = app.state.motion.value;
  if (!motion || motion.trajectory.length === 0) return null;
  const names = columnsOf(motion.system, motion.trajectory.columns, motion.constraints !== null).map((c) => c.name);
  const missing = [plot.x, ...plot.y].find((name) => !names.includes(name));
  if (missing !== undefined) return <p role="alert">{words.noColumn(missing)}</p>;
  const overTime = plot.x === 't';
  return (
    <div class="lesson-plot">
      <ChartView
        key={motion.id}
        class={inOneScale(motion, plot) ? 'equal' : 'low'}
        testId="lesson-plot"
        label={words.plot(title)}
        options={{ alongX: overTime, ...(overTime ? { onSeek: (t) => app.actions.seek(t) } : {}) }}
        attach={(chart) => drawn(app, chart, motion, plot)}
      />
    </div>
  );
}

/** A path has one scale across and up; an angle against its rate has not. */
const inOneScale = ({ system: { meta } }: Motion, { x, y }: LessonPlot): boolean =>
  x !== 't' && y.every((name) => columnOf(meta, name).unit === columnOf(meta, x).unit);

/** Draws while the run grows, and marks the present. Returns how to end. */
function drawn({ state }: App, chart: Chart, motion: Motion, plot: LessonPlot): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const values = (name: string) => valuesOf(motion, name);
  const info = (name: string) => columnOf(motion.system.meta, name, motion.constraints ? motion.system.contacts : []);
  const factor = (name: string): number => shownFactor(info(name), state.plots.peek().degrees);
  const overTime = plot.x === 't';
  const equal = inOneScale(motion, plot);
  const mark = (): void => {
    const time = state.time.peek();
    if (overTime) return chart.setCursor(time);
    const x = values(plot.x).at(time) * factor(plot.x);
    const styles = stylesOf(plot.y.map(info));
    chart.setCursor(
      null,
      plot.y.map((name, k) => ({ x, y: values(name).at(time) * factor(name), color: styles[k]!.color })),
    );
  };
  const draw = (): void => {
    timer = undefined;
    const { degrees } = state.plots.peek();
    const { trajectory } = motion;
    const styles = stylesOf(plot.y.map(info));
    const x = overTime ? trajectory.column('t')! : values(plot.x).get();
    const curves = plot.y.map((name, k) => {
      const column = values(name);
      const y = column.get();
      return {
        ...styles[k]!,
        label: symbolOf(info(name)),
        x,
        y,
        xFactor: overTime ? 1 : factor(plot.x),
        yFactor: factor(name),
        rows: [0, Math.min(x.length, y.length)] as const,
        ...(overTime
          ? { rising: true, envelope: column.envelope, settled: trajectory.settled, rate: column.rate }
          : {}),
      };
    });
    const columns = plot.y.map(info);
    chart.setPicture({
      x: {
        title: axisText([info(plot.x)], degrees),
        ...(overTime ? { range: [trajectory.start, trajectory.end] } : {}),
      },
      y: { title: axisText(columns, degrees), unit: unitsOf(columns, degrees) },
      equal,
      marks: curves.map(curveMark),
    });
    mark();
    if ([plot.x, ...plot.y].some((name) => values(name).behind)) soon();
  };
  const soon = (): void => void (timer ??= setTimeout(draw, REDRAW_MS));
  const ends = [
    effect(() => {
      void state.rowsVersion.value;
      void state.plots.value;
      void state.theme.value;
      soon();
    }),
    state.time.subscribe(mark),
  ];
  return () => {
    clearTimeout(timer);
    for (const end of ends) end();
  };
}
