import { effect } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import type { SweepPlan } from '../../app/runs/sweep.ts';
import type { App } from '../../app/app.ts';
import { createOverlayPlot } from '../../charts/overlayPlot.ts';
import { token } from '../../charts/tokens.ts';
import { words } from './words.ts';

/** One measure of every run of a sweep, and what pointing at a run and picking one leads to. */
export interface SweepView {
  app: App;
  plan: SweepPlan;
  measure: number;
  factor: number;
  label: string;
  onHover(job: number | null): void;
  onPick(job: number): void;
}

/** A measure against the one number that is varied. */
export function SweepCurve({ app, plan, measure, factor, label, onHover, onPick }: SweepView) {
  const host = useRef<HTMLDivElement>(null);
  const axis = plan.axes[0]!;
  const xLabel = axis.unit ? `${axis.label} [${axis.unit}]` : axis.label;
  const x = axis.values.map(({ value }) => (axis.angle ? (value * 180) / Math.PI : value));
  const ratio = x.length > 2 && x[0]! > 0 && Math.abs(x[1]! / x[0]! - x[2]! / x[1]!) < 1e-6 * (x[1]! / x[0]!);
  const at = useRef<number | null>(null);
  const move = (job: number | null) => {
    at.current = job;
    onHover(job);
  };
  useEffect(() => {
    const plot = createOverlayPlot(host.current!, {
      xLabel,
      yLabel: label,
      rising: false,
      logarithmicX: ratio,
      onHover: (_curve, index) => move(index),
      onPick: (_curve, index) => onPick(index),
    });
    const draw = (): void => {
      const y = x.map((_, job) => (app.sweep.results[job]?.values[measure] ?? NaN) * factor);
      plot.setCurves([{ label, color: token('--accent'), points: true, x, y, xFactor: 1, yFactor: 1 }]);
    };
    const stops = [
      effect(() => {
        void app.sweep.version.value;
        draw();
      }),
      app.state.theme.subscribe(() => requestAnimationFrame(() => host.current && draw())),
    ];
    return () => {
      for (const stop of stops) stop();
      plot.destroy();
    };
  }, [plan]);
  return (
    <div
      ref={host}
      class="overlay-plot"
      role="application"
      tabIndex={0}
      aria-label={words.sweep.curve(label, xLabel)}
      data-testid="sweep-curve"
      onKeyDown={(event) => {
        const step = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
        if (step !== 0) move(Math.min(x.length - 1, Math.max(0, (at.current ?? (step > 0 ? -1 : x.length)) + step)));
        else if (event.key === 'Enter' && at.current !== null) onPick(at.current);
        else return;
        event.preventDefault();
      }}
    />
  );
}
