import { effect } from '@preact/signals';
import { useRef } from 'preact/hooks';
import type { Chart } from '../../charts/chart.ts';
import { ChartView } from '../../charts/chartView.tsx';
import { cells, scaleColour } from '../../charts/marks.ts';
import { words as plain } from '../../core/motion/symbols.ts';
import { labelOf, measuredValues, type SweepView } from './sweepCurve.tsx';
import { words } from './words.ts';

/** A measure over the two numbers that are varied. */
export function SweepMap(view: SweepView) {
  const { app, plan, label, title, onHover, onPick } = view;
  const [first, second] = [plan.axes[0]!, plan.axes[1]!];
  const [wide, tall] = [first.values.length, second.values.length];
  const chart = useRef<Chart | null>(null);
  const at = useRef<number | null>(null);
  const latest = useRef(view);
  latest.current = view;
  const draw = (): void => {
    const map = cells(wide, tall, measuredValues(latest.current, wide * tall), at.current);
    const names = (axis: typeof first): string[] => axis.values.map((v) => v.label);
    chart.current?.setPicture({
      x: { title: plain(labelOf(first)), kind: 'steps', names: names(first), air: 0 },
      y: { title: plain(labelOf(second)), kind: 'steps', names: names(second), air: 0 },
      marks: [map],
      bar: { low: map.range[0], high: map.range[1], colour: scaleColour },
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
      label={words.sweep.map(label, labelOf(first), labelOf(second))}
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
        const number = (axis: typeof first, i: number): number =>
          axis.angle ? (axis.values[i]!.value * 180) / Math.PI : axis.values[i]!.value;
        return [
          { title: plain(labelOf(first)), values: [...values.keys()].map((job) => number(first, job % wide)) },
          {
            title: plain(labelOf(second)),
            values: [...values.keys()].map((job) => number(second, Math.floor(job / wide))),
          },
          { title, values: [...values] },
        ];
      }}
      attach={(made) => {
        chart.current = made;
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
        };
      }}
    />
  );
}
