/** The sheet of keys, with what a feature offers beside them. */
import { text as storedText } from '../../app/words.ts';
import { sheetOf } from '../../app/commands.ts';
import { useUi } from '../context.ts';
import { Dialog } from '../kit/dialog.tsx';
import { text } from '../words.ts';

export function KeysDialog({ onForget }: { onForget?: (() => void) | undefined }) {
  const { app, features, commands } = useUi();
  const close = app.actions.closeDialog;
  if (app.state.dialog.value !== 'keys') return null;
  return (
    <Dialog title={text.top.keys} testId="keys-dialog" onClose={close}>
      <dl class="keys">
        {sheetOf(commands).map(([keys, what]) => (
          <div key={keys}>
            <dt>{keys.split(' ').map((key) => (/^[–a-z]/.test(key) ? ` ${key} ` : <kbd key={key}>{key}</kbd>))}</dt>
            <dd>{what}</dd>
          </div>
        ))}
      </dl>
      {features.map(({ id, help: Help }) =>
        Help ? (
          <div key={id} class="forget">
            <Help close={close} />
          </div>
        ) : null,
      )}
      {onForget && (
        <div class="forget">
          <p class="hint">{storedText.forgetHint}</p>
          <button
            type="button"
            data-testid="forget"
            onClick={() => {
              close();
              onForget();
            }}
          >
            {storedText.forget}
          </button>
        </div>
      )}
    </Dialog>
  );
}
