/** At the foot of the panel: whether the run follows, what was changed, and Run. */
import { useCommand, useUi } from '../../ui/context.ts';
import { Icon, Toggle } from '../../ui/kit/controls.tsx';
import { formatTime } from '../../ui/kit/format.ts';
import { later } from '../../ui/kit/later.tsx';
import { text } from '../../ui/words.ts';
import { words } from './words.ts';

const HistoryMenu = later(async () => (await import('./historyMenu.tsx')).HistoryMenu);

export function RunBar() {
  const { state, actions } = useUi().app;
  const computing = state.run.value?.kind === 'computing';
  return (
    <div class="run-bar">
      <Standing />
      <div class="follow-bar">
        <Toggle
          pressed={state.live.value}
          title={words.liveHint}
          testId="live"
          onClick={() => actions.set('live', !state.live.peek())}
        >
          {words.live}
        </Toggle>
        <span class="spring" />
        <StepButton id="undo" />
        <StepButton id="redo" />
        {state.history.value.length > 0 && <HistoryMenu />}
      </div>
      <div class="run-buttons">
        <button
          type="button"
          class={`primary${state.stale.value ? ' stale' : ''}`}
          data-testid="run"
          title={words.runKeys}
          onClick={() => actions.run()}
        >
          {words.run} <span aria-hidden="true">▸</span>
        </button>
        <button type="button" data-testid="cancel" disabled={!computing} onClick={() => actions.cancel()}>
          {text.panel.cancel}
        </button>
        <button type="button" data-testid="reset" onClick={() => actions.resetDraft()}>
          {words.reset}
        </button>
      </div>
    </div>
  );
}

function StepButton({ id }: { id: 'undo' | 'redo' }) {
  const { label, title, disabled, perform } = useCommand(id);
  return (
    <button
      type="button"
      class="quiet square"
      data-testid={id}
      aria-label={label}
      title={title}
      disabled={disabled}
      onClick={perform}
    >
      <Icon name={id} />
    </button>
  );
}

/** What keeps the stage from showing a run of what stands above, or how the run ended. */
function Standing() {
  const { state, actions } = useUi().app;
  const run = state.run.value;
  const wrong = new Map([...state.draftErrors.value, ...state.refusedFields.value]);
  const first = [...wrong][0];
  if (first)
    return (
      <p class="error" role="alert" data-testid="wrong">
        {wrong.size === 1 ? words.wrongField : words.wrongFields(wrong.size)}{' '}
        <button type="button" class="link" onClick={() => actions.goToField(first[0])}>
          {words.goThere}
        </button>
      </p>
    );
  const stale = state.stale.value;
  if (stale !== null)
    return (
      <p class="stale-mark" role="status" data-testid="stale">
        {words.stale[stale]}
      </p>
    );
  if (run?.kind === 'ended' && run.reason !== 'end')
    return (
      <p class="outcome">
        {run.message || `${text.status.reasons[run.reason] ?? run.reason}, ${formatTime(run.time)} s`}
      </p>
    );
  return null;
}
