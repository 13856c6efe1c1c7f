/** The experiment: what is run. Everything in it edits the draft. */
import { replaceDraft, useUi } from '../../ui/context.ts';
import { formatTime } from '../../ui/kit/format.ts';
import { ControlSection, InputsSection } from './inputsSection.tsx';
import { MethodSection, TimeSection } from './methodSection.tsx';
import { ParametersSection } from './parametersSection.tsx';
import { StartSection } from './startSection.tsx';
import { SystemSection } from './systemSection.tsx';
import { text } from '../../ui/words.ts';
import { words } from './words.ts';

export function Experiment() {
  return (
    <div class="experiment" data-enter="run">
      <FileApart />
      <div class="scroll">
        <SystemSection />
        <StartSection />
        <TimeSection />
        <ParametersSection />
        <MethodSection />
        <InputsSection />
        <ControlSection />
      </div>
      <RunBar />
    </div>
  );
}

/** While a file is on the stage: it is not what stands below. */
function FileApart() {
  const motion = useUi().app.state.motion.value;
  if (motion?.source !== 'file') return null;
  return (
    <p class="apart" role="note" data-testid="file-apart">
      {words.onStage} <b>{motion.title}</b>. {words.apart}
    </p>
  );
}

function RunBar() {
  const ui = useUi();
  const { state, actions } = ui.app;
  const run = state.run.value;
  const computing = run?.kind === 'computing';
  const errors = [...state.draftErrors.value];
  const rejected = ui.rejected.value.size;
  return (
    <div class="run-bar">
      {errors.length > 0 && (
        <p class="error" role="alert">
          {errors[0]![0]}: {errors[0]![1]}
        </p>
      )}
      {errors.length === 0 && rejected > 0 && <p class="error">{words.notInForce(rejected)}</p>}
      {errors.length + rejected === 0 && run?.kind === 'ended' && run.reason !== 'end' && (
        <p class="outcome">
          {run.message || `${text.status.reasons[run.reason] ?? run.reason}, ${formatTime(run.time)} s`}
        </p>
      )}
      <div class="run-buttons">
        <button
          type="button"
          class="primary"
          data-testid="run"
          disabled={errors.length > 0}
          title={words.runKeys}
          onClick={() => actions.run()}
        >
          {words.run} <span aria-hidden="true">▸</span>
        </button>
        <button type="button" data-testid="cancel" disabled={!computing} onClick={() => actions.cancel()}>
          {text.panel.cancel}
        </button>
        <button type="button" data-testid="reset" onClick={() => replaceDraft(ui, () => actions.resetDraft())}>
          {words.reset}
        </button>
      </div>
    </div>
  );
}
