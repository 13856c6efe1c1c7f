/** The help: the sheet of keys, with what a feature offers beside it, and the pages that features add. */
import { Fragment } from 'preact';
import { useState } from 'preact/hooks';
import { text as storedText } from '../../app/words.ts';
import { sheetOf } from '../../app/commands.ts';
import { useUi } from '../context.ts';
import { Dialog } from '../kit/dialog.tsx';
import { text } from '../words.ts';

const KEYS = 'keys';
/** The page of the help that shows `AppState.document`. */
const DOCUMENTS = 'documents';

export function HelpDialog({ onForget }: { onForget?: (() => void) | undefined }) {
  const { app, features } = useUi();
  const [page, setPage] = useState(app.state.document.peek() === null ? KEYS : DOCUMENTS);
  const close = app.actions.closeDialog;
  const pages = features.flatMap(({ helpPages = [] }) => helpPages);
  const Body = pages.find(({ id }) => id === page)?.Body;
  const tabs = [{ id: KEYS, title: text.top.keys }, ...pages];
  const onKeyDown = (event: KeyboardEvent) => {
    const step = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
    if (step === 0) return;
    event.preventDefault();
    const next = tabs[(tabs.findIndex(({ id }) => id === page) + step + tabs.length) % tabs.length]!;
    setPage(next.id);
    document.getElementById(`help-tab-${next.id}`)?.focus();
  };
  return (
    <Dialog title={text.top.help} testId="keys-dialog" onClose={close}>
      {pages.length > 0 && (
        <div class="help-tabs" role="tablist" aria-label={text.top.help} onKeyDown={onKeyDown}>
          {tabs.map(({ id, title }) => (
            <button
              key={id}
              type="button"
              role="tab"
              id={`help-tab-${id}`}
              aria-selected={page === id}
              aria-controls="help-page"
              tabIndex={page === id ? 0 : -1}
              data-testid={`help-${id}`}
              onClick={() => setPage(id)}
            >
              {title}
            </button>
          ))}
        </div>
      )}
      <div
        id="help-page"
        class="help-page"
        {...(pages.length > 0 ? { role: 'tabpanel', 'aria-labelledby': `help-tab-${page}` } : {})}
        tabIndex={0}
      >
        {Body ? <Body /> : <Keys close={close} onForget={onForget} />}
      </div>
    </Dialog>
  );
}

/** A word between keys as it is, a key as a key; a comma after it is none of its. */
function inKeys(word: string) {
  const key = word.length > 1 ? word.replace(/,$/, '') : word;
  const after = word.slice(key.length);
  return /^[–a-z]/.test(word) ? (
    ` ${word} `
  ) : (
    <Fragment key={word}>
      <kbd>{key}</kbd>
      {after && `${after} `}
    </Fragment>
  );
}

function Keys({ close, onForget }: { close(): void; onForget?: (() => void) | undefined }) {
  const { features, commands } = useUi();
  return (
    <>
      <dl class="keys">
        {sheetOf(commands).map(([keys, what]) => (
          <div key={keys}>
            <dt>{keys.split(' ').map(inKeys)}</dt>
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
    </>
  );
}
