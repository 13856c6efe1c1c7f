/** One scenario, many times: what is varied and measured, and how far it is. */
import { useSignal } from '@preact/signals';
import type { Signal } from '@preact/signals';
import { MOST_SWEEP_RUNS, type SweepAxis } from '../../core/scenario/sweepAxes.ts';
import type { SweepMeasure } from '../../core/motion/sweepMeasures.ts';
import { words } from './words.ts';
import { useUi } from '../../ui/context.ts';
import { AxisFields } from './axisFields.tsx';
import { MeasureFields } from './measureFields.tsx';
import { axisOf, formsFrom, measurableColumns, offeredAxis, pathsOf, type AxisForm } from './sweepChoices.ts';
import { SweepResults } from './sweepResults.tsx';

const own = words.sweep;

export function SweepPart() {
  const { app } = useUi();
  const system = app.systemOf(app.state.draft.value.system);
  // A scenario that cannot run offers nothing to vary: the form begins when it can.
  const sound = app.state.draftErrors.value.size === 0;
  return (
    <>
      {system &&
        (sound ? (
          <Form key={system.meta.id} />
        ) : (
          <p class="hint" role="status">
            {own.invalid}
          </p>
        ))}
      <Standing />
      <SweepResults />
    </>
  );
}

function Form() {
  const { app, origin } = useUi();
  const file = app.state.draft.value;
  const { meta } = app.systemOf(file.system)!;
  const paths = pathsOf(meta, file);
  const first = paths?.[0];
  // As it was asked for last, if that was of this system.
  const last = app.sweep.plan.peek();
  const forms = last?.file.system === file.system ? formsFrom(last.form) : null;
  const axes: readonly [Signal<AxisForm>, Signal<AxisForm>] = [
    useSignal(forms?.[0] ?? offeredAxis(first, first?.path ?? '', 11)),
    useSignal(forms?.[1] ?? { ...offeredAxis(undefined, '', 9), path: '' }),
  ];
  const columns = measurableColumns(app, meta);
  const measures = useSignal<readonly SweepMeasure[]>(
    forms
      ? last!.measures
      : [
          { kind: 'end', column: columns[0]! },
          { kind: 'time' },
          ...(meta.order === 1 ? [] : [{ kind: 'drift' } as const]),
        ],
  );
  const asked = paths
    ? plan(
        axes.map((a) => a.value),
        paths,
        measures.value,
      )
    : { problem: own.invalid };
  const start = (event: Event) => {
    event.preventDefault();
    if (asked.axes)
      app.sweep.start({
        title: origin.value?.title ?? meta.title,
        file,
        axes: asked.axes,
        measures: measures.value,
        form: axes.map((a) => a.value),
      });
  };
  const runs = asked.axes?.reduce((product, { values }) => product * values.length, 1) ?? 0;
  return (
    <form class="sweep-form" onSubmit={start}>
      <p class="hint">{own.about(origin.value?.title ?? meta.title, app.sweep.cores)}</p>
      {paths && axes.map((form, i) => <AxisFields key={i} index={i} form={form} paths={paths} />)}
      <MeasureFields measures={measures} columns={columns} meta={meta} />
      {asked.problem && (
        <p class="field-error" role="alert" data-testid="sweep-problem">
          {asked.problem}
        </p>
      )}
      <div class="compare-row">
        <button
          type="submit"
          class="primary"
          data-testid="sweep-run"
          disabled={!asked.axes || app.sweep.state.value === 'computing'}
        >
          {own.run(runs)}
        </button>
        <button
          type="button"
          data-testid="sweep-cancel"
          disabled={app.sweep.state.value !== 'computing'}
          onClick={() => app.sweep.cancel()}
        >
          {own.cancel}
        </button>
      </div>
    </form>
  );
}

function plan(
  forms: readonly AxisForm[],
  paths: Parameters<typeof axisOf>[1],
  measures: readonly SweepMeasure[],
): { axes?: SweepAxis[]; problem?: string } {
  const used = forms.filter(({ path }) => path === 'method' || paths.some((p) => p.path === path));
  if (new Set(used.map((f) => f.path)).size < used.length) return { problem: own.sameAxis };
  if (measures.length === 0) return { problem: own.needsMeasure };
  try {
    const axes = used.map((form) => axisOf(form, paths));
    const runs = axes.reduce((product, { values }) => product * values.length, 1);
    if (runs > MOST_SWEEP_RUNS) return { problem: own.tooMany(runs, MOST_SWEEP_RUNS) };
    return axes.length > 0 && runs > 0 ? { axes } : {};
  } catch (error) {
    return { problem: (error as Error).message };
  }
}

/** How far it is, said politely. */
function Standing() {
  const {
    app: { sweep },
  } = useUi();
  void sweep.version.value;
  const state = sweep.state.value;
  if (state === 'empty') return null;
  return (
    <div class="sweep-standing" data-testid="sweep-standing" data-state={state}>
      {state === 'computing' && <progress max={sweep.total} value={sweep.progress} aria-label={words.parts.sweep} />}
      <span role={state === 'computing' ? undefined : 'status'}>
        {state === 'computing'
          ? own.progress(sweep.done, sweep.total)
          : state === 'cancelled'
            ? own.cancelled(sweep.done, sweep.total)
            : own.finished(sweep.total)}
      </span>
    </div>
  );
}
