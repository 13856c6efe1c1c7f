import { effect } from '@preact/signals';
import { useRef } from 'preact/hooks';
import type { SweepPlan } from '../../app/runs/sweep.ts';
import type { App } from '../../app/app.ts';
import type { Chart } from '../../charts/chart.ts';
import { ChartView } from '../../charts/chartView.tsx';
import { curveMark } from '../../charts/curves.ts';
import { token } from '../../charts/tokens.ts';
import type { Text } from '../../core/motion/symbols.ts';
import type { AxisInfo } from './sweepChoices.ts';
import { words } from './words.ts';

/** One measure of every run of a sweep, and what pointing at a run and picking one leads to. */
export interface SweepView {
  app: App;
  plan: SweepPlan;
  measure: number;
  factor: number;
  /** Of what is varied. */
  axes: readonly AxisInfo[];
  /** Of the measure, with its unit. */
  title: Text;
  label: string;
  onHover(job: number | null): void;
  onPick(job: number): void;
  /** For what saves it. */
  onChart(chart: Chart | null): void;
}

/** Values of a measure, run by run, in the unit shown; NaN while there is none. */
export const measuredValues = ({ app, measure, factor }: SweepView, count: number): Float64Array =>
  Float64Array.from({ length: count }, (_, job) => (app.sweep.results[job]?.values[measure] ?? NaN) * factor);

/** A measure against the one number that is varied. */
export function SweepCurve(view: SweepView) {
  const { app, plan, axes, label, title, onHover, onPick, onChart } = view;
  const axis = axes[0]!;
  const x = plan.axes[0]!.values.map((value) => axis.number(value));
  const ratio = x.length > 2 && x[0]! > 0 && Math.abs(x[1]! / x[0]! - x[2]! / x[1]!) < 1e-6 * (x[1]! / x[0]!);
  const at = useRef<number | null>(null);
  const latest = useRef(view);
  latest.current = view;
  const move = (job: number | null) => {
    at.current = job;
    onHover(job);
  };
  return (
    <ChartView
      key={`${plan.axes[0]!.path} ${view.measure}`}
      label={words.sweep.curve(label, axis.label)}
      testId="sweep-curve"
      options={{
        onHover: move,
        onPick,
        onStep: (by) => {
          if (by !== 0) move(Math.min(x.length - 1, Math.max(0, (at.current ?? (by > 0 ? -1 : x.length)) + by)));
          else if (at.current !== null) onPick(at.current);
          return true;
        },
      }}
      attach={(chart) => {
        onChart(chart);
        const draw = (): void =>
          chart.setPicture({
            x: { title: axis.title, kind: ratio ? 'logarithmic' : 'linear' },
            y: { title },
            marks: [
              curveMark({
                label: title,
                color: token('--accent'),
                points: true,
                x,
                y: measuredValues(latest.current, x.length),
              }),
            ],
          });
        const stops = [
          effect(() => {
            void app.sweep.version.value;
            draw();
          }),
          app.state.theme.subscribe(() => void requestAnimationFrame(draw)),
        ];
        return () => {
          for (const stop of stops) stop();
          onChart(null);
        };
      }}
    />
  );
}
