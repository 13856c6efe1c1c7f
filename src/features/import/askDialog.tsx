/** Asks what a file leaves open before it is read: the time step of one without times. */
import { useRef, useState } from 'preact/hooks';
import type { PendingFile } from '../../app/files/fileState.ts';
import type { NumberOrExpression } from '../../core/scenario/types.ts';
import { MathSymbol } from '../../charts/textView.tsx';
import { useUi } from '../../ui/context.ts';
import { Dialog } from '../../ui/kit/dialog.tsx';
import { formatShort } from '../../ui/kit/format.ts';
import { NumberField } from '../../ui/kit/numberField.tsx';
import { numberOf } from '../../ui/kit/useNumberField.ts';
import { words } from './words.ts';

export function AskDialog() {
  const pending = useUi().app.state.pendingFile.value;
  if (!pending) return null;
  return pending.question.id === 'time-step' ? (
    <StepForm key={pending.name} pending={pending} />
  ) : (
    <AnswersForm key={pending.name} pending={pending} />
  );
}

/** The first of a file's questions that has answers to choose from. */
function AnswersForm({ pending: { name, question } }: { pending: PendingFile }) {
  const { actions } = useUi().app;
  return (
    <Dialog title={words.askTitle} testId="ask-dialog" onClose={() => actions.answerPending(null)}>
      <p>
        {name}: {question.text}
      </p>
      <div class="dialog-buttons">
        {question.answers.map(({ label, choices }, i) => (
          <button
            key={label}
            type="button"
            class={i === question.safest ? 'primary' : undefined}
            data-testid={`ask-${i}`}
            onClick={() => actions.answerPending(choices)}
          >
            {label}
          </button>
        ))}
        <button type="button" data-testid="ask-cancel" onClick={() => actions.answerPending(null)}>
          {words.giveUp}
        </button>
      </div>
    </Dialog>
  );
}

/** What is offered where the question names no step, s. */
const USUAL_STEP = 1 / 60;

function StepForm({ pending: { name, question } }: { pending: PendingFile }) {
  const { actions } = useUi().app;
  const refused = useRef(false);
  const rest = question.answers[question.safest]?.choices.step ?? USUAL_STEP;
  const inverse = Math.round(1 / rest);
  const offered = Math.abs(inverse * rest - 1) < 1e-9 && inverse > 1 ? `1/${inverse}` : rest;
  const [step, setStep] = useState<NumberOrExpression>(offered);
  // Enter commits the field and submits the form before anything is drawn again
  const latest = useRef<NumberOrExpression>(offered);
  const commit = (value: NumberOrExpression = offered) => {
    latest.current = value;
    setStep(value);
  };
  const submit = (event: Event) => {
    event.preventDefault();
    if (!refused.current) actions.answerPending({ step: numberOf(latest.current, rest) });
  };
  return (
    <Dialog title={words.stepTitle} testId="step-dialog" onClose={() => actions.answerPending(null)}>
      <form onSubmit={submit}>
        <p>
          {name}: {question.text}
        </p>
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
            rest,
            step: 0.001,
            commit,
            aside: (reason) => void (refused.current = reason !== null),
          }}
        />
        <p class="hint">{words.rowsPerSecond(formatShort(1 / numberOf(step, rest), 5))}</p>
        <div class="dialog-buttons">
          <button type="submit" class="primary" data-testid="step-accept">
            {words.use}
          </button>
          <button type="button" data-testid="step-cancel" onClick={() => actions.answerPending(null)}>
            {words.giveUp}
          </button>
        </div>
      </form>
    </Dialog>
  );
}
