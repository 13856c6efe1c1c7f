import type { Signal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useEffect, useId, useRef, useState } from 'preact/hooks';
import type { PendingFile } from '../../app/types.ts';
import type { NumberOrExpression } from '../../core/scenario/types.ts';
import { useUi } from '../context.ts';
import { Icon } from './controls.tsx';
import { formatShort } from './format.ts';
import { NumberField } from './numberField.tsx';
import { text as keepText } from '../../app/words.ts';
import { text } from '../words.ts';
import { numberOf } from './useNumberField.ts';

/** A modal dialog: focus goes in, stays in and comes back; Escape closes. */
export function Dialog({
  title,
  testId,
  wide,
  onClose,
  children,
}: {
  title: string;
  testId: string;
  wide?: boolean;
  onClose(): void;
  children: ComponentChildren;
}) {
  const dialog = useRef<HTMLDialogElement>(null);
  const id = useId();
  useEffect(() => {
    const element = dialog.current!;
    const before = document.activeElement as HTMLElement | null;
    element.showModal();
    const field = element.querySelector<HTMLInputElement>('form input, input[type=search]');
    field?.focus();
    field?.select();
    return () => {
      element.close();
      before?.focus?.();
    };
  }, []);
  return (
    <dialog
      ref={dialog}
      class={wide ? 'wide' : undefined}
      aria-labelledby={id}
      data-testid={testId}
      onCancel={(event) => {
        event.preventDefault();
        onClose();
      }}
      onClick={(event) => {
        if (event.target === dialog.current) onClose();
      }}
    >
      <div class="dialog-body">
        <div class="dialog-head">
          <h2 id={id}>{title}</h2>
          <button type="button" class="quiet square" aria-label={text.close} onClick={onClose}>
            <Icon name="close" />
          </button>
        </div>
        {children}
      </div>
    </dialog>
  );
}

export function KeysDialog({
  open,
  onTour,
  onForget,
}: {
  open: Signal<boolean>;
  onTour(): void;
  onForget?: (() => void) | undefined;
}) {
  if (!open.value) return null;
  return (
    <Dialog
      title={text.top.keys}
      testId="keys-dialog"
      onClose={() => {
        open.value = false;
      }}
    >
      <dl class="keys">
        {text.keys.map(([keys, what]) => (
          <div key={keys}>
            <dt>{keys.split(' ').map((key) => (/^[–a-z]/.test(key) ? ` ${key} ` : <kbd key={key}>{key}</kbd>))}</dt>
            <dd>{what}</dd>
          </div>
        ))}
      </dl>
      <div class="forget">
        <button
          type="button"
          data-testid="take-tour"
          onClick={() => {
            open.value = false;
            onTour();
          }}
        >
          {text.takeTour}
        </button>
      </div>
      {onForget && (
        <div class="forget">
          <p class="hint">{keepText.forgetHint}</p>
          <button
            type="button"
            data-testid="forget"
            onClick={() => {
              open.value = false;
              onForget();
            }}
          >
            {keepText.forget}
          </button>
        </div>
      )}
    </Dialog>
  );
}

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
    <Dialog title={text.file.stepTitle} testId="step-dialog" onClose={() => actions.answerTimeStep(null)}>
      <form onSubmit={submit}>
        <p>{text.file.stepAsk(pending.name)}</p>
        <NumberField
          testId="step-field"
          symbol="Δt"
          spec={{
            path: 'file.step',
            label: text.file.step,
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
        <p class="hint">{text.file.rowsPerSecond(formatShort(1 / numberOf(step, pending.offeredStep), 5))}</p>
        <div class="dialog-buttons">
          <button type="submit" class="primary" data-testid="step-accept">
            {text.file.use}
          </button>
          <button type="button" data-testid="step-cancel" onClick={() => actions.answerTimeStep(null)}>
            {text.file.giveUp}
          </button>
        </div>
      </form>
    </Dialog>
  );
}
