import { effect } from '@preact/signals';
import { useRef } from 'preact/hooks';
import type { Chart } from '../../charts/chart.ts';
import { ChartView } from '../../charts/chartView.tsx';
import { cells, scaleColour } from '../../charts/marks.ts';
import { measuredValues, type SweepView } from './sweepCurve.tsx';
import { words } from './words.ts';

/** A measure over the two numbers that are varied. */
export function SweepMap(view: SweepView) {
  const { app, plan, label, title, onHover, onPick, onChart } = view;
  const [first, second] = [plan.axes[0]!, plan.axes[1]!];
  const [along, up] = [view.axes[0]!, view.axes[1]!];
  const [wide, tall] = [first.values.length, second.values.length];
  const chart = useRef<Chart | null>(null);
  const at = useRef<number | null>(null);
  const latest = useRef(view);
  latest.current = view;
  const draw = (): void => {
    const map = cells(wide, tall, measuredValues(latest.current, wide * tall), at.current);
    chart.current?.setPicture({
      x: { title: along.title, kind: 'steps', names: first.values.map(along.tick), air: 0 },
      y: { title: up.title, kind: 'steps', names: second.values.map(up.tick), air: 0 },
      marks: [map],
      bar: { title, low: map.range[0], high: map.range[1], colour: scaleColour },
    });
  };
  const move = (cell: number | null) => {
    at.current = cell;
    draw();
    onHover(cell);
  };
  return (
    <ChartView
      key={`${first.path} ${second.path} ${view.measure}`}
      class="tall"
      label={words.sweep.map(label, along.label, up.label)}
      testId="sweep-map"
      options={{
        onHover: move,
        onPick,
        onStep: (by, across) => {
          const here = at.current;
          if (by === 0 && across === 0) {
            if (here !== null) onPick(here);
            return true;
          }
          const [c, r] = here === null ? [-1, 0] : [here % wide, Math.floor(here / wide)];
          const [nextC, nextR] = here === null ? [0, 0] : [c + by, r + across];
          if (nextC >= 0 && nextC < wide && nextR >= 0 && nextR < tall) move(nextR * wide + nextC);
          return true;
        },
      }}
      values={() => {
        const values = measuredValues(latest.current, wide * tall);
        return [
          { title: along.title, values: [...values.keys()].map((job) => along.number(first.values[job % wide]!)) },
          {
            title: up.title,
            values: [...values.keys()].map((job) => up.number(second.values[Math.floor(job / wide)]!)),
          },
          { title, values: [...values] },
        ];
      }}
      attach={(made) => {
        chart.current = made;
        onChart(made);
        const stops = [
          effect(() => {
            void app.sweep.version.value;
            draw();
          }),
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
