/** While a mode is on the stage: with or without its growth, and the way back. */
import { Toggle } from '../../ui/kit/controls.tsx';
import { useUi } from '../../ui/context.ts';
import { modeWords as words } from './modeWords.ts';

export function ModeActions() {
  const { state, actions } = useUi().app;
  const preview = state.modePreview.value;
  if (!preview || state.motion.value?.source !== 'mode') return null;
  const { request, growth } = preview;
  const [re, im] = request.mode.eigenvalue;
  const choose = (growing: boolean) => actions.showMode(request, growing);
  return (
    <>
      <p>{words.modeHint('10°')}</p>
      <div class="caption-actions">
        {re !== 0 && im !== 0 && (
          <div class="segments" role="group" aria-label={words.growthLabel}>
            <Toggle pressed={growth} testId="mode-growth" onClick={() => choose(true)}>
              {words.growth}
            </Toggle>
            <Toggle pressed={!growth} testId="mode-shape" onClick={() => choose(false)}>
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
