/** What a sweep found: a curve or a map of one measure, and a table of all. */
import { useSignal } from '@preact/signals';
import type { App } from '../../app/app.ts';
import { scenarioAt, valuesAt, type SweepPlan } from '../../app/runs/sweep.ts';
import { words } from './words.ts';
import { text } from '../../ui/words.ts';
import { useUi } from '../../ui/context.ts';
import { THIN } from '../../ui/kit/format.ts';
import { measureInfo, measureText, titleOf } from './sweepChoices.ts';
import { SweepCurve } from './sweepCurve.tsx';
import { SweepMap } from './sweepMap.tsx';
import { SweepTable } from './sweepTable.tsx';

const own = words.sweep;

/** Puts a run of the sweep into the panel and runs it. */
export function pick(app: App, plan: SweepPlan, job: number): void {
  const values = valuesAt(plan, job).map(
    (value, a) => `${plan.axes[a]!.label} ${value.label}${plan.axes[a]!.unit && `${THIN}${plan.axes[a]!.unit}`}`,
  );
  app.actions.loadScenario(scenarioAt(plan, job), `${plan.title}, ${values.join(', ')}`);
}

/** A run in a sentence: where it stands and what was measured. */
export function describeRun(app: App, plan: SweepPlan, job: number): string {
  const result = app.sweep.results[job];
  const place = valuesAt(plan, job)
    .map((value, a) => `${plan.axes[a]!.label} = ${value.label}${plan.axes[a]!.unit && `${THIN}${plan.axes[a]!.unit}`}`)
    .join(', ');
  if (!result) return `${place}: –`;
  if (result.reason === 'refused') return `${place}: ${own.refused} (${result.message})`;
  const { meta } = app.systemOf(plan.file.system)!;
  const numbers = plan.measures.map((m, i) => {
    const { label, unit, factor } = measureInfo(m, meta, app.state.plots.value.degrees);
    return `${label} ${measureText(result.values[i]! * factor)}${unit && `${THIN}${unit}`}`;
  });
  return `${place}: ${numbers.join('; ')}; ${text.status.reasons[result.reason] ?? result.reason}`;
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
  const infos = plan.measures.map((m) => measureInfo(m, meta, app.state.plots.value.degrees));
  const info = infos[shown.value]!;
  const label = info.unit ? `${info.label}, ${info.unit}` : info.label;
  const axis = plan.axes[0]!;
  const view = {
    app,
    plan,
    measure: shown.value,
    factor: info.factor,
    title: titleOf(info),
    label,
    onHover: (job: number | null) => {
      hovered.value = job;
    },
    onPick: (job: number) => pick(app, plan, job),
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
      </div>
      {plan.axes.length === 2 ? (
        <SweepMap key={`${shown.value} ${info.factor}`} {...view} />
      ) : (
        axis.path !== 'method' && <SweepCurve key={`${shown.value} ${info.factor}`} {...view} />
      )}
      {(plan.axes.length === 2 || axis.path !== 'method') && (
        <p class="hint sweep-read" role="status" data-testid="sweep-read">
          {hovered.value === null ? own.hint : describeRun(app, plan, hovered.value)}
        </p>
      )}
      <SweepTable plan={plan} infos={infos} onPick={view.onPick} />
    </section>
  );
}
