/** Curves of the motion on the stage: any column over time or over another, one time for scene and plots. */
import { useSignal } from '@preact/signals';
import { useLayoutEffect, useMemo } from 'preact/hooks';
import type { Motion } from '../../app/runs/motion.ts';
import { plotsKey } from '../../app/state/namedPlots.ts';
import type { PlotPane } from '../../app/state/plotPanes.ts';
import { text } from './words.ts';
import { useUi } from '../../ui/context.ts';
import { Check } from '../../ui/kit/controls.tsx';
import { useDeferred, useLagging } from '../../ui/kit/deferred.ts';
import { columnsOf, type Column } from '../../core/motion/columns.ts';
import { valuesOf } from '../../core/motion/columnValues.ts';
import { PaneView } from './paneView.tsx';
import { panesOf, presetsOf, suggested } from './panes.ts';
import './plots.css';

export function PlotsTool() {
  const { state } = useUi().app;
  const motion = useDeferred(state.motion);
  if (!motion || motion.trajectory.length === 0) return <p class="hint pad">{text.empty}</p>;
  return <Plots motion={motion} />;
}

function Plots({ motion }: { motion: Motion }) {
  const { state, actions } = useUi().app;
  const caseId = state.origin.value.id;
  const plots = state.plots.value;
  const panes = panesOf(motion, caseId, plots);
  const range = useSignal<readonly [number, number] | null>(null);
  const values = (name: string) => valuesOf(motion, name, state.plots.peek().wrapped);
  useLayoutEffect(() => void (range.value = null), [motion.id]);
  const listed = JSON.stringify(columnsOf(motion.system, motion.trajectory.columns, motion.constraints !== null));
  const columns = useMemo(() => JSON.parse(listed) as Column[], [listed]);
  const choices = useLagging(columns);
  const own = plots.own?.key === plotsKey(motion, caseId);
  const change = (next: readonly PlotPane[]) => {
    actions.set('plots', { ...plots, own: { key: plotsKey(motion, caseId), panes: next } });
  };
  const edit = (i: number, pane: PlotPane | null) =>
    change(pane ? panes.map((p, k) => (k === i ? pane : p)) : panes.filter((_, k) => k !== i));
  const add = () => change([...panes, { title: text.newPane, x: 't', y: [columns[1]?.name ?? 't'] }]);
  return (
    <div class="scroll plots" data-testid="plots">
      <div class="plots-bar">
        <button type="button" data-testid="plots-add" onClick={add}>
          {text.add}
        </button>
        <Presets motion={motion} onAdd={(pane) => change([...panes, pane])} />
        <button
          type="button"
          data-testid="plots-case"
          disabled={!own}
          onClick={() => actions.set('plots', { ...plots, own: null })}
        >
          {text.ofCase}
        </button>
        <button
          type="button"
          data-testid="plots-whole"
          disabled={range.value === null}
          onClick={() => {
            range.value = null;
          }}
        >
          {text.whole}
        </button>
        <span class="spring" />
        <Check
          label={text.degrees}
          testId="plots-degrees"
          checked={plots.degrees}
          onChange={(degrees) => actions.set('plots', { ...state.plots.peek(), degrees })}
        />
        <Check
          label={text.wrapped}
          testId="plots-wrapped"
          checked={plots.wrapped}
          onChange={(wrapped) => actions.set('plots', { ...state.plots.peek(), wrapped })}
        />
      </div>
      {panes.map((pane, i) => (
        <PaneView
          key={i}
          pane={pane}
          motion={motion}
          choices={choices}
          values={values}
          range={range}
          first={i === 0}
          onChange={(next) => edit(i, next)}
          onUp={() => change([...panes.slice(0, i - 1), pane, panes[i - 1]!, ...panes.slice(i + 1)])}
        />
      ))}
      {own && panes.length === 0 && (
        <p class="hint">{suggested(motion, caseId).length > 0 ? text.ofCase : text.empty}</p>
      )}
    </div>
  );
}

/** Plots that are asked for often. */
function Presets({ motion, onAdd }: { motion: Motion; onAdd(pane: PlotPane): void }) {
  const { ready, phases } = presetsOf(motion);
  return (
    <select
      value=""
      class="plots-preset"
      aria-label={text.presets}
      data-testid="plots-preset"
      onChange={(e) => {
        const chosen = [...ready, ...phases].find(({ id }) => id === e.currentTarget.value);
        e.currentTarget.value = '';
        if (chosen) onAdd(chosen.pane);
      }}
    >
      <option value="">{text.preset}</option>
      {[[text.presets, ready] as const, [text.phases, phases] as const].map(([label, presets]) => (
        <optgroup key={label} label={label}>
          {presets.map(({ id, pane }) => (
            <option key={id} value={id}>
              {pane.title}
            </option>
          ))}
        </optgroup>
      ))}
    </select>
  );
}
