/** Plots beside an embedded stage, as the page around it asks for them. */
import { effect, signal, type ReadonlySignal } from '@preact/signals';
import { columnsOf } from '../../core/motion/columns.ts';
import type { App } from '../app.ts';
import { panesFrom, plotsKey } from '../state/namedPlots.ts';
import type { PlotPane } from '../state/plotPanes.ts';

const text = {
  panes: 'plots needs panes such as [{"y": ["alpha", "beta"]}], [{"x": "X", "y": ["Y"]}], [] for none, or nothing',
  column: (name: string, names: string) => `there is no column ${JSON.stringify(name)}; there are ${names}`,
};

export interface EmbeddedPlots {
  shown: ReadonlySignal<boolean>;
  /** @param panes as the message has them; absent: those that suit the motion @throws Error */
  ask(panes: unknown): void;
}

/**
 * What is asked for stays while motions come and go; what a person changes of it stays until then.
 *
 * @param app whose stage it is
 */
export function embeddedPlots({ state, actions }: App): EmbeddedPlots {
  const shown = signal(false);
  const wanted = signal<readonly PlotPane[] | null>(null);
  effect(() => {
    const [motion, origin, panes] = [state.motion.value, state.origin.value, wanted.value];
    if (!motion || !panes) return;
    actions.set('plots', { ...state.plots.peek(), own: { key: plotsKey(motion, origin.id), panes } });
  });
  return {
    shown,
    ask(asked) {
      const panes = asked === undefined ? null : panesFrom(asked);
      if (asked !== undefined && !panes) throw new Error(text.panes);
      const motion = state.motion.peek();
      // Of a motion still to come the columns are not known; what it lacks is then not drawn.
      if (motion && motion.system.meta.id === state.draft.peek().system && panes) {
        const names = columnsOf(motion.system, motion.trajectory.columns, motion.constraints !== null).map(
          (c) => c.name,
        );
        const missing = panes.flatMap(({ x, y }) => [x, ...y]).find((name) => !names.includes(name));
        if (missing !== undefined) throw new Error(text.column(missing, names.join(', ')));
      }
      wanted.value = panes;
      if (!panes) actions.set('plots', { ...state.plots.peek(), own: null });
      shown.value = panes?.length !== 0;
    },
  };
}
