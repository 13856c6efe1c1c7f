/** While a mode is on the stage: with or without its growth, and the way back. */
import { Toggle } from '../../ui/kit/controls.tsx';
import { useUi } from '../../ui/context.ts';
import { modeWords as words } from './words.ts';

export function ModeActions() {
  const { state, actions } = useUi().app;
  const aside = state.aside.value;
  if (!aside || state.motion.value?.source !== 'mode') return null;
  const [re, im] = aside.mode.mode.eigenvalue;
  const choose = (growth: boolean) => actions.showMode(aside.mode, growth);
  return (
    <>
      <p>{words.modeHint('10°')}</p>
      <div class="caption-actions">
        {re !== 0 && im !== 0 && (
          <div class="segments" role="group" aria-label={words.growthLabel}>
            <Toggle pressed={aside.growth} testId="mode-growth" onClick={() => choose(true)}>
              {words.growth}
            </Toggle>
            <Toggle pressed={!aside.growth} testId="mode-shape" onClick={() => choose(false)}>
              {words.shapeOnly}
            </Toggle>
          </div>
        )}
        <button type="button" data-testid="mode-back" onClick={actions.leaveMode}>
          {words.back}
        </button>
      </div>
    </>
  );
}
