import { useSignal, type Signal } from '@preact/signals';
import { useRef } from 'preact/hooks';
import { replaceDraft, useUi } from '../context.ts';
import { Icon } from '../kit/controls.tsx';
import { Dialog } from '../kit/dialogs.tsx';
import { sameContent } from '../../app/state/draft.ts';
import { later } from '../kit/later.tsx';
import { Menu } from '../kit/menu.tsx';
import { ShareButton } from '../../features/share/share.tsx';
import { text } from '../words.ts';

const Gallery = later(async () => (await import('../../features/gallery/gallery.tsx')).Gallery);

export function TopBar({ keysOpen }: { keysOpen: Signal<boolean> }) {
  const ui = useUi();
  const { state, actions } = ui.app;
  const theme = state.theme.value;
  return (
    <header class="top">
      <h1 class="wordmark">{text.name}</h1>
      <CaseMenu />
      <span class="spring" />
      <OpenButton />
      {ui.app.samples.length > 0 && (
        <Menu
          label={text.top.samples}
          title={text.top.samplesTitle}
          testId="sample-menu"
          align="right"
          items={ui.app.samples.map((s) => ({
            id: s.id,
            title: s.title,
            testId: `sample-${s.id}`,
            choose: () => actions.openSample(s.id),
          }))}
        >
          <Icon name="sample" />
          <span class="word">{text.top.samples}</span>
        </Menu>
      )}
      <Menu
        label={text.top.exports}
        testId="export-menu"
        align="right"
        items={[
          {
            id: 'csv',
            title: text.top.csv,
            testId: 'export-csv',
            disabled: state.motion.value === null,
            choose: actions.exportCsv,
          },
          { id: 'scenario', title: text.top.scenario, testId: 'export-scenario', choose: actions.saveScenario },
          {
            id: 'more',
            title: text.top.exportMore,
            testId: 'export-more',
            choose: () => {
              state.exporting.value = true;
            },
          },
        ]}
      >
        <Icon name="export" />
        <span class="word">{text.top.exports}</span>
      </Menu>
      <ShareButton />
      <button
        type="button"
        class="quiet square"
        data-testid="theme"
        aria-label={text.top.theme(theme)}
        title={text.top.theme(theme)}
        onClick={() => {
          state.theme.value = theme === 'dark' ? 'light' : 'dark';
        }}
      >
        <Icon name={theme === 'dark' ? 'light' : 'dark'} />
      </button>
      <button
        type="button"
        class="quiet square help"
        data-testid="keys"
        aria-label={text.top.keys}
        title={`${text.top.keys} (?)`}
        onClick={() => {
          keysOpen.value = true;
        }}
      >
        ?
      </button>
    </header>
  );
}

/** The name of the case in the panel; it opens the gallery. */
function CaseMenu() {
  const ui = useUi();
  const open = useSignal(false);
  const origin = ui.origin.value;
  const edited = origin !== null && !sameContent(origin.scenario, ui.app.state.draft.value);
  const close = () => {
    open.value = false;
  };
  return (
    <>
      <button
        type="button"
        class="menu-button"
        aria-haspopup="dialog"
        aria-label={`${text.top.cases}: ${origin?.title ?? text.top.ownScenario}`}
        data-testid="case-menu"
        onClick={() => {
          open.value = true;
        }}
      >
        <span class="case-title">{origin?.title ?? text.top.ownScenario}</span>
        {edited && <span class="edited">{text.top.edited}</span>}
        <Icon name="down" />
      </button>
      {open.value && (
        <Dialog title={text.top.cases} testId="gallery" wide onClose={close}>
          <Gallery onClose={close} />
        </Dialog>
      )}
    </>
  );
}

function OpenButton() {
  const ui = useUi();
  const input = useRef<HTMLInputElement>(null);
  return (
    <>
      <button
        type="button"
        class="quiet"
        data-testid="open-button"
        aria-label={text.top.open}
        title={text.top.openTitle}
        onClick={() => input.current?.click()}
      >
        <Icon name="open" />
        <span class="word">{text.top.open}</span>
      </button>
      <input
        ref={input}
        class="hidden"
        type="file"
        multiple
        accept=".csv,.txt,.json,.mdl,.mat,text/csv,application/json"
        tabIndex={-1}
        aria-label={text.top.openTitle}
        data-testid="open-file"
        onChange={(event) => {
          const files = [...(event.currentTarget.files ?? [])];
          event.currentTarget.value = '';
          if (files.length > 0) replaceDraft(ui, () => ui.app.actions.openFiles(files));
        }}
      />
    </>
  );
}
