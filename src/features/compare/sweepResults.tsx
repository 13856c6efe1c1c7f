/** What a sweep found: a curve or a map of one measure, and a table of all. */
import { useSignal } from '@preact/signals';
import { useRef } from 'preact/hooks';
import type { Chart } from '../../charts/chart.ts';
import { TextView } from '../../charts/textView.tsx';
import { joined, plainText, words as plain, type Text } from '../../core/motion/symbols.ts';
import { SaveMenu } from '../../ui/kit/saveMenu.tsx';
import type { App } from '../../app/app.ts';
import { scenarioAt, valuesAt, type SweepPlan } from '../../app/runs/sweep.ts';
import { words } from './words.ts';
import { text } from '../../ui/words.ts';
import { useUi } from '../../ui/context.ts';
import { THIN } from '../../ui/kit/format.ts';
import { axisInfo, measureInfo, measureText, titleOf } from './sweepChoices.ts';
import { SweepCurve } from './sweepCurve.tsx';
import { SweepMap } from './sweepMap.tsx';
import { SweepTable } from './sweepTable.tsx';

const own = words.sweep;

/** Where a run of the sweep stands: `Ẋ = 2 m/s, …`. */
function placeOf(app: App, plan: SweepPlan, job: number, is: string): Text {
  const { meta } = app.systemOf(plan.file.system)!;
  const values = valuesAt(plan, job);
  return joined(
    plan.axes.map((axis, a) => {
      const { symbol, unit, text: shown } = axisInfo(axis, meta, app.state.plots.value.degrees);
      return [...symbol, ...plain(`${is}${shown(values[a]!)}${unit && `${THIN}${unit}`}`)];
    }),
  );
}

/** Puts a run of the sweep into the panel and runs it. */
export function pick(app: App, plan: SweepPlan, job: number): void {
  app.actions.loadScenario(scenarioAt(plan, job), `${plan.title}, ${plainText(placeOf(app, plan, job, ' '))}`);
}

/** A run in a sentence: where it stands and what was measured. */
export function describeRun(app: App, plan: SweepPlan, job: number): Text {
  const result = app.sweep.results[job];
  const place = placeOf(app, plan, job, ' = ');
  if (!result) return [...place, ...plain(': –')];
  if (result.reason === 'refused') return [...place, ...plain(`: ${own.refused} (${result.message})`)];
  const { meta } = app.systemOf(plan.file.system)!;
  const numbers = plan.measures.map((m, i) => {
    const { label, unit, factor } = measureInfo(m, meta, app.state.plots.value.degrees);
    return `${label} ${measureText(result.values[i]! * factor)}${unit && `${THIN}${unit}`}`;
  });
  return [...place, ...plain(`: ${numbers.join('; ')}; ${text.status.reasons[result.reason] ?? result.reason}`)];
}

export function SweepResults() {
  const { app } = useUi();
  const plan = app.sweep.plan.value;
  return (
    plan && (
      <Results key={JSON.stringify([plan.file.system, plan.axes.map((a) => a.path), plan.measures])} plan={plan} />
    )
  );
}

function Results({ plan }: { plan: SweepPlan }) {
  const { app } = useUi();
  const shown = useSignal(0);
  const hovered = useSignal<number | null>(null);
  const { meta } = app.systemOf(plan.file.system)!;
  const { degrees } = app.state.plots.value;
  const infos = plan.measures.map((m) => measureInfo(m, meta, degrees));
  const info = infos[shown.value]!;
  const label = info.unit ? `${info.label}, ${info.unit}` : info.label;
  const axis = plan.axes[0]!;
  const axes = plan.axes.map((a) => axisInfo(a, meta, degrees));
  const chart = useRef<Chart | null>(null);
  const drawn = plan.axes.length === 2 || axis.path !== 'method';
  const view = {
    app,
    plan,
    axes,
    measure: shown.value,
    factor: info.factor,
    title: titleOf(info),
    label,
    onHover: (job: number | null) => {
      hovered.value = job;
    },
    onPick: (job: number) => pick(app, plan, job),
    onChart: (made: Chart | null) => {
      chart.current = made;
    },
  };
  return (
    <section class="sweep-results" aria-label={own.table} data-testid="sweep-results">
      <div class="compare-row">
        <label>
          {own.show}{' '}
          <select
            value={String(shown.value)}
            data-testid="sweep-show"
            onChange={(e) => {
              shown.value = Number(e.currentTarget.value);
            }}
          >
            {infos.map((m, i) => (
              <option key={m.id} value={String(i)}>
                {m.label}
              </option>
            ))}
          </select>
        </label>
        <span class="spring" />
        {drawn && <SaveMenu title={`${plan.title}, ${info.label}`} picture={() => chart.current} testId="sweep" />}
      </div>
      {plan.axes.length === 2 ? (
        <SweepMap key={`${shown.value} ${info.factor} ${degrees}`} {...view} />
      ) : (
        axis.path !== 'method' && <SweepCurve key={`${shown.value} ${info.factor} ${degrees}`} {...view} />
      )}
      {drawn && (
        <p class="hint sweep-read" role="status" data-testid="sweep-read">
          {hovered.value === null ? own.hint : <TextView of={describeRun(app, plan, hovered.value)} />}
        </p>
      )}
      <SweepTable plan={plan} axes={axes} infos={infos} onPick={view.onPick} />
    </section>
  );
}
