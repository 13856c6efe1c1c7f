import { effect } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import { useUi } from '../../ui/context.ts';

/** From the last change to what takes longer than a frame, ms. */
const REST_MS = 300;

/**
 * Asks something of a draft with a regulator once it has rested for a moment.
 *
 * @param ask of the draft that has rested
 * @param changed told at every change, before the rest
 * @param gone told when what asks is no more
 */
export function useRestedRegulator(ask: (draft: ScenarioFile) => void, changed?: () => void, gone?: () => void): void {
  const { app } = useUi();
  useEffect(() => {
    let timer = 0;
    const stop = effect(() => {
      const draft = app.state.draft.value;
      clearTimeout(timer);
      if (draft.control?.type !== 'lqr') return;
      changed?.();
      timer = window.setTimeout(() => ask(draft), REST_MS);
    });
    return () => {
      clearTimeout(timer);
      stop();
      gone?.();
    };
  }, []);
}
