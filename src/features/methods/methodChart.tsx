/** What the methods did: a column over time, a curve a method, or how precise each was for its time. */
import { effect } from '@preact/signals';
import { useRef } from 'preact/hooks';
import { CURVES } from '../../app/runs/curveStyles.ts';
import type { Comparison, Outcome } from '../../app/runs/comparison.ts';
import type { Chart } from '../../charts/chart.ts';
import { ChartView } from '../../charts/chartView.tsx';
import { curveMark, type Curve } from '../../charts/curves.ts';
import type { Picture } from '../../charts/frame.ts';
import { axisText, columnOf, shownFactor, shownUnit } from '../../core/motion/columns.ts';
import { Envelope } from '../../core/motion/envelope.ts';
import { words as plain } from '../../core/motion/symbols.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import { useUi } from '../../ui/context.ts';
import { words } from './words.ts';

/** In place of a column: the drift of energy against the computing time. */
export const PRECISION = 'work-precision';

/** Ends after which a curve's last values mean nothing. */
const ABANDONED: ReadonlySet<string> = new Set(['non-finite', 'newton', 'step-too-small']);

export function MethodChart({
  comparison,
  column,
  meta,
  onChart,
}: {
  comparison: Comparison;
  column: string;
  meta: SystemMeta;
  onChart(chart: Chart | null): void;
}) {
  const { app } = useUi();
  // Of each run's column, as long as it is drawn.
  const envelopes = useRef(new WeakMap<object, Envelope>());
  const precision = column === PRECISION;
  const label = precision ? words.precision : columnOf(meta, column).label;
  return (
    <ChartView
      key={column}
      class="methods-plot"
      testId="methods-plot"
      label={words.plot(label)}
      options={{
        alongX: !precision,
        ...(precision ? {} : { onSeek: (time: number) => app.actions.seek(time) }),
      }}
      attach={(chart) => {
        onChart(chart);
        const draw = (): void => {
          const outcomes = comparison.outcomes.peek();
          const { degrees } = app.state.plots.peek();
          chart.setPicture(
            precision ? precisionOf(outcomes) : overTime(outcomes, column, meta, degrees, envelopes.current),
          );
        };
        let frame = 0;
        const end = effect(() => {
          void comparison.version.value;
          void comparison.outcomes.value;
          void app.state.theme.value;
          void app.state.plots.value;
          // The theme's colours are in force after the page's own effect: draw in the next frame.
          if (frame === 0)
            frame = requestAnimationFrame(() => {
              frame = 0;
              draw();
            });
        });
        return () => {
          cancelAnimationFrame(frame);
          end();
          onChart(null);
        };
      }}
    />
  );
}

function overTime(
  outcomes: readonly Outcome[],
  name: string,
  meta: SystemMeta,
  degrees: boolean,
  envelopes: WeakMap<object, Envelope>,
): Picture {
  const column = columnOf(meta, name);
  const curves = outcomes.flatMap(({ contender, trajectory, state, reason }, i): Curve[] => {
    const y = trajectory?.column(name);
    if (!trajectory || !y) return [];
    let envelope = envelopes.get(trajectory);
    if (!envelope) envelopes.set(trajectory, (envelope = new Envelope()));
    return [
      {
        ...CURVES[i % CURVES.length]!,
        label: plain(contender.label),
        x: trajectory.column('t')!,
        y,
        yFactor: shownFactor(column, degrees),
        rising: true,
        envelope,
        settled: trajectory.settled,
        rate: trajectory.rateOf(name),
        loose: state === 'ended' && ABANDONED.has(reason),
      },
    ];
  });
  return {
    x: { title: axisText([columnOf(meta, 't')], degrees), air: 0 },
    y: {
      title: axisText([column], degrees),
      unit: shownUnit(column, degrees),
      kind: name === 'residual' ? 'logarithmic' : 'linear',
    },
    marks: curves.map(curveMark),
  };
}

/** Lower is more precise, further to the left is faster. */
function precisionOf(outcomes: readonly Outcome[]): Picture {
  const curves = outcomes.flatMap(({ contender, counts, seconds, state }, i): Curve[] => {
    const drift = Math.abs(counts?.energyDrift ?? NaN);
    if (state !== 'ended' || !(seconds > 0) || !(drift > 0)) return [];
    return [{ ...CURVES[i % CURVES.length]!, label: plain(contender.label), points: true, x: [seconds], y: [drift] }];
  });
  return {
    x: { title: plain(words.computing), kind: 'logarithmic' },
    y: { title: plain(words.drift), kind: 'logarithmic' },
    marks: curves.map(curveMark),
  };
}
