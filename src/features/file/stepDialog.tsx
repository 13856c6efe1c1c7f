/** Asks for the time step of a file that has neither header nor time column. */
import { MathSymbol } from '../../charts/textView.tsx';
import { useRef, useState } from 'preact/hooks';
import type { PendingFile } from '../../app/files/fileState.ts';
import type { NumberOrExpression } from '../../core/scenario/types.ts';
import { useUi } from '../../ui/context.ts';
import { Dialog } from '../../ui/kit/dialog.tsx';
import { formatShort } from '../../ui/kit/format.ts';
import { NumberField } from '../../ui/kit/numberField.tsx';
import { numberOf } from '../../ui/kit/useNumberField.ts';
import { words } from './words.ts';

export function StepDialog() {
  const pending = useUi().app.state.pendingFile.value;
  return pending ? <StepForm key={pending.name} pending={pending} /> : null;
}

function StepForm({ pending }: { pending: PendingFile }) {
  const ui = useUi();
  const { actions } = ui.app;
  const inverse = Math.round(1 / pending.offeredStep);
  const offered =
    Math.abs(inverse * pending.offeredStep - 1) < 1e-9 && inverse > 1 ? `1/${inverse}` : pending.offeredStep;
  const [step, setStep] = useState<NumberOrExpression>(offered);
  // Enter commits the field and submits the form before anything is drawn again
  const latest = useRef<NumberOrExpression>(offered);
  const commit = (value: NumberOrExpression = offered) => {
    latest.current = value;
    setStep(value);
  };
  const submit = (event: Event) => {
    event.preventDefault();
    if (!ui.rejected.peek().has('file.step')) actions.answerTimeStep(numberOf(latest.current, pending.offeredStep));
  };
  return (
    <Dialog title={words.stepTitle} testId="step-dialog" onClose={() => actions.answerTimeStep(null)}>
      <form onSubmit={submit}>
        <p>{words.stepAsk(pending.name)}</p>
        <NumberField
          testId="step-field"
          symbol={<MathSymbol of="Δt" />}
          spec={{
            path: 'file.step',
            label: words.step,
            unit: 's',
            angle: false,
            positive: true,
            value: step,
            base: offered,
            rest: pending.offeredStep,
            step: 0.001,
            commit,
          }}
        />
        <p class="hint">{words.rowsPerSecond(formatShort(1 / numberOf(step, pending.offeredStep), 5))}</p>
        <div class="dialog-buttons">
          <button type="submit" class="primary" data-testid="step-accept">
            {words.use}
          </button>
          <button type="button" data-testid="step-cancel" onClick={() => actions.answerTimeStep(null)}>
            {words.giveUp}
          </button>
        </div>
      </form>
    </Dialog>
  );
}
