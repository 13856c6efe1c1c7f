/** One scenario, many methods: the report's Table 1, live. */
import { TableScroll } from '../../ui/kit/tableScroll.tsx';
import { useComputed, useSignal } from '@preact/signals';
import type { Signal } from '@preact/signals';
import { useMemo, useRef } from 'preact/hooks';
import { SaveMenu } from '../../ui/kit/saveMenu.tsx';
import type { Comparison, Outcome } from '../../app/runs/comparison.ts';
import { methodSets, type MethodChoice, type MethodSet } from '../../core/cases/methodSets.ts';
import type { MethodOptions } from '../../core/scenario/types.ts';
import { useUi } from '../../ui/context.ts';
import { Check } from '../../ui/kit/controls.tsx';
import { CURVES } from '../../app/runs/curveStyles.ts';
import { formatCount, formatDrift, formatPower, formatShort } from '../../ui/kit/format.ts';
import { text } from '../../ui/words.ts';
import type { Chart } from '../../charts/chart.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import { columnOf } from '../../core/motion/columns.ts';
import { partingOf } from '../../core/motion/parting.ts';
import { MethodChart, PRECISION } from './methodChart.tsx';
import { words } from './words.ts';

export interface MethodsProps {
  comparison: Comparison;
  saveTable(outcomes: readonly Outcome[]): void;
}

export function Methods(props: MethodsProps) {
  const chosen = useSignal(methodSets[0]!);
  const choose = (id: string) => {
    props.comparison.clear();
    chosen.value = methodSets.find((s) => s.id === id) ?? chosen.value;
  };
  return (
    <div class="scroll methods-tool">
      <p>
        <label>
          {words.set}{' '}
          <select data-testid="methods-set" value={chosen.value.id} onChange={(e) => choose(e.currentTarget.value)}>
            {methodSets.map((s) => (
              <option key={s.id} value={s.id}>
                {s.label}
              </option>
            ))}
          </select>
        </label>
      </p>
      <SetOfMethods key={chosen.value.id} {...props} set={chosen.value} />
    </div>
  );
}

/** To how many digits the methods that ended agree, and where they part. */
function Agreement({ comparison, meta, busy }: { comparison: Comparison; meta: SystemMeta; busy: boolean }) {
  const runs = comparison.outcomes.value.flatMap(({ state, trajectory }) =>
    state === 'ended' && trajectory ? [trajectory] : [],
  );
  const parting = useMemo(() => (busy ? null : partingOf(meta, runs)), [busy, comparison.outcomes.value]);
  if (!parting) return null;
  const { until, compared } = parting;
  // Cut, not rounded: they agree at least so long.
  const cut = (t: number): string => words.seconds(Math.floor(t * 100 + 1e-6) / 100);
  return (
    <p role="status" data-testid="methods-agree">
      {until[4] === compared
        ? words.agree(cut(compared))
        : until[1] === compared
          ? words.fade(cut(until[4]), cut(until[2]), cut(compared))
          : words.part(cut(until[4]), words.seconds(Math.ceil(until[1] * 100 - 1e-6) / 100))}
    </p>
  );
}

function SetOfMethods({ comparison, saveTable, set }: MethodsProps & { set: MethodSet }) {
  const ui = useUi();
  const all = set.choices.filter(
    ({ method }) =>
      ui.methods.some((m) => m.id === method.name) &&
      (method.formulation === undefined || ui.formulations.some((f) => f.id === method.formulation)),
  );
  const chosen = useSignal<ReadonlySet<string>>(new Set(set.chosen));
  const settings = useSignal<ReadonlyMap<string, Partial<MethodOptions>>>(new Map());
  const { meta } = ui.app.systemOf(set.scenario?.system ?? ui.app.state.draft.value.system)!;
  const { order, coordinates } = meta;
  const columns = [...(order === 1 ? [] : ['energy', 'residual', PRECISION]), ...coordinates.map((c) => c.name)];
  const chosenColumn = useSignal(set.column);
  /** Of this system: another may have come on the stage since it was chosen. */
  const column = columns.includes(chosenColumn.value) ? chosenColumn.value : coordinates[0]!.name;
  const projection = useSignal(true);
  const problem = useSignal('');
  /** Once they run, those that do not are out of the way. */
  const folded = useSignal(false);
  const label = (name: string): string => (name === PRECISION ? words.precision : columnOf(meta, name).label);
  const busy = useComputed(() => comparison.busy);
  const chart = useRef<Chart | null>(null);
  const start = () => {
    problem.value = '';
    try {
      const contenders = all
        .filter((c) => chosen.value.has(c.id))
        .map((c) => ({
          ...c,
          method: { ...c.method, ...settings.value.get(c.id), ...(projection.value ? {} : { projection: false }) },
        }));
      ui.app.actions.compare(contenders, set.scenario);
      folded.value = true;
    } catch (error) {
      problem.value = (error as Error).message;
    }
  };
  const change = (id: string, key: keyof MethodOptions, value: number) => {
    settings.value = new Map(settings.value).set(id, { ...settings.value.get(id), [key]: value });
  };
  return (
    <div class="methods">
      <p>{set.scenario ? words.aboutSet(set.label) : words.about(ui.origin.value?.title ?? text.ownScenario)}</p>
      <div class="dialog-buttons">
        <button
          type="button"
          class="primary"
          data-testid="methods-run"
          disabled={busy.value || chosen.value.size === 0}
          onClick={start}
        >
          {words.run}
        </button>
        <button type="button" data-testid="methods-cancel" disabled={!busy.value} onClick={() => comparison.stop()}>
          {text.panel.cancel}
        </button>
        <Check
          label={words.projection}
          checked={projection.value}
          testId="methods-projection"
          onChange={(on) => {
            projection.value = on;
          }}
        />
        <span class="spring" />
        <button
          type="button"
          data-testid="methods-csv"
          disabled={comparison.outcomes.value.length === 0}
          onClick={() => saveTable(comparison.outcomes.value)}
        >
          {words.csv}
        </button>
      </div>
      {problem.value && (
        <p class="field-error" role="alert">
          {problem.value}
        </p>
      )}
      <TableScroll label={words.title}>
        <table data-testid="methods-table">
          <thead>
            <tr>
              {words.columns.map((c) => (
                <th key={c} scope="col">
                  {c}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {(folded.value ? all.filter(({ id }) => chosen.value.has(id)) : all).map((choice) => (
              <Row
                key={choice.id}
                choice={choice}
                outcome={comparison.outcomes.value.find((o) => o.contender.id === choice.id)}
                index={comparison.outcomes.value.findIndex((o) => o.contender.id === choice.id)}
                settings={{ ...choice.method, ...settings.value.get(choice.id) }}
                chosen={chosen}
                onChange={change}
              />
            ))}
          </tbody>
        </table>
      </TableScroll>
      <Agreement comparison={comparison} meta={meta} busy={busy.value} />
      {all.length > chosen.value.size && (
        <button
          type="button"
          class="link"
          data-testid="methods-all"
          aria-pressed={!folded.value}
          onClick={() => {
            folded.value = !folded.value;
          }}
        >
          {folded.value ? words.showAll(all.length) : words.showChosen}
        </button>
      )}
      {comparison.outcomes.value.length === 0 && <p class="hint">{words.noCurves}</p>}
      <div class="methods-row">
        <label>
          {words.curve}{' '}
          <select
            data-testid="methods-column"
            value={column}
            onChange={(e) => {
              chosenColumn.value = e.currentTarget.value;
            }}
          >
            {columns.map((c) => (
              <option key={c} value={c}>
                {label(c)}
              </option>
            ))}
          </select>
        </label>
        <span class="spring" />
        <SaveMenu
          title={words.plot(label(column))}
          picture={() => chart.current}
          testId="methods"
          disabled={comparison.outcomes.value.length === 0}
        />
      </div>
      {comparison.outcomes.value.length > 0 && (
        <MethodChart
          comparison={comparison}
          column={column}
          meta={meta}
          onChart={(made) => {
            chart.current = made;
          }}
        />
      )}
    </div>
  );
}

function Row({
  choice,
  outcome,
  index,
  settings,
  chosen,
  onChange,
}: {
  choice: MethodChoice;
  outcome: Outcome | undefined;
  index: number;
  settings: Partial<MethodOptions>;
  chosen: Signal<ReadonlySet<string>>;
  onChange(id: string, key: keyof MethodOptions, value: number): void;
}) {
  const toggle = () => {
    const next = new Set(chosen.value);
    if (!next.delete(choice.id)) next.add(choice.id);
    chosen.value = next;
  };
  const counts = outcome?.counts;
  const curve = index >= 0 ? CURVES[index % CURVES.length]! : null;
  const settingsShown = chosen.value.has(choice.id);
  const keys = (['step', 'rtol', 'atol', 'stages'] as const).filter((key) => settings[key] !== undefined);
  return (
    <tr data-testid={`method-row-${choice.id}`}>
      <th scope="row">
        <label>
          <input type="checkbox" checked={chosen.value.has(choice.id)} onChange={toggle} /> {choice.label}
        </label>
        {curve && (
          <svg class="swatch" width="22" height="8" aria-hidden="true">
            <line
              x1="0"
              y1="4"
              x2="22"
              y2="4"
              stroke={curve.color}
              stroke-width="2.5"
              stroke-dasharray={curve.dash?.join(' ')}
            />
          </svg>
        )}
        {settingsShown && (
          <span class="settings">
            {keys.map((key) => (
              <label key={key}>
                {key}{' '}
                <input
                  type="text"
                  inputMode="decimal"
                  value={short(settings[key]!)}
                  aria-label={`${choice.label}, ${key}`}
                  onChange={(event) => {
                    const value = Number(event.currentTarget.value);
                    if (value > 0 && value < Infinity) onChange(choice.id, key, value);
                    else event.currentTarget.value = short(settings[key]!);
                  }}
                />
              </label>
            ))}
          </span>
        )}
      </th>
      <td>{outcome && outcome.seconds > 0 ? formatShort(outcome.seconds, 3) : '–'}</td>
      <td>{counts ? formatDrift(counts) : '–'}</td>
      <td>{counts ? formatPower(counts.residual) : '–'}</td>
      <td>{counts ? <Pair of={counts.steps} besides={counts.rejected} /> : '–'}</td>
      <td>{counts ? <Pair of={counts.evaluations} besides={counts.jacobians} /> : '–'}</td>
      <td class="reached">{outcome ? formatShort(outcome.reached, 4) : '–'}</td>
      <td class="why" title={outcome?.message}>
        {outcome && <span>{standing(outcome)}</span>}
        {choice.report && <small>{words.report(choice.report.seconds, choice.report.reached)}</small>}
      </td>
    </tr>
  );
}

/** A count and, in brackets, what belongs to it. */
function Pair({ of, besides }: { of: number; besides: number }) {
  return (
    <>
      {formatCount(of)} <small>({formatCount(besides)})</small>
    </>
  );
}

/** `1e-6` rather than `0.000001`. */
const short = (x: number): string => (x < 1e-3 ? x.toExponential().replace('.0e', 'e') : String(x));

function standing(outcome: Outcome): string {
  if (outcome.state === 'ended') return text.status.reasons[outcome.reason] ?? outcome.reason;
  return outcome.state === 'refused' ? outcome.message : words.states[outcome.state];
}
