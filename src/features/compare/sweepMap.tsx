import { effect } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { createHeatMap, type HeatMap } from '../../charts/heatMap.ts';
import type { SweepAxis } from '../../core/scenario/sweepAxes.ts';
import { words } from './words.ts';
import type { SweepView } from './sweepCurve.tsx';

const labelOf = ({ label, unit }: SweepAxis): string => (unit ? `${label} [${unit}]` : label);

/** A measure over the two numbers that are varied. */
export function SweepMap({ app, plan, measure, factor, label, onHover, onPick }: SweepView) {
  const host = useRef<HTMLDivElement>(null);
  const map = useRef<HeatMap | null>(null);
  const at = useRef<number | null>(null);
  const [first, second] = [plan.axes[0]!, plan.axes[1]!];
  const move = (cell: number | null) => {
    at.current = cell;
    map.current?.select(cell);
    onHover(cell);
  };
  useEffect(() => {
    const made = (map.current = createHeatMap(host.current!, { hover: move, pick: onPick }));
    const draw = (): void => {
      const total = first.values.length * second.values.length;
      made.setData({
        columns: first.values.map((v) => v.label),
        rows: second.values.map((v) => v.label),
        values: Float64Array.from(
          { length: total },
          (_, job) => (app.sweep.results[job]?.values[measure] ?? NaN) * factor,
        ),
        xLabel: labelOf(first),
        yLabel: labelOf(second),
        label: '',
      });
    };
    const stops = [
      effect(() => {
        void app.sweep.version.value;
        draw();
      }),
      app.state.theme.subscribe(() => requestAnimationFrame(() => made.redraw())),
    ];
    return () => {
      for (const stop of stops) stop();
      made.destroy();
    };
  }, [plan]);
  const wide = first.values.length;
  const total = wide * second.values.length;
  const steps: Record<string, number> = { ArrowRight: 1, ArrowLeft: -1, ArrowUp: wide, ArrowDown: -wide };
  return (
    <div
      ref={host}
      class="overlay-plot tall"
      role="application"
      tabIndex={0}
      aria-label={words.sweep.map(label, labelOf(first), labelOf(second))}
      data-testid="sweep-map"
      onKeyDown={(event) => {
        const step = steps[event.key];
        if (step !== undefined) {
          const here = at.current;
          const next = here === null ? 0 : here + step;
          const sameRow = Math.abs(step) > 1 || here === null || Math.floor(next / wide) === Math.floor(here / wide);
          if (next >= 0 && next < total && sameRow) move(next);
        } else if (event.key === 'Enter' && at.current !== null) onPick(at.current);
        else return;
        event.preventDefault();
      }}
    />
  );
}
