/** In the bar at the top: a file of the person's own, and the samples. */
import { useRef } from 'preact/hooks';
import { useUi } from '../../ui/context.ts';
import { Icon } from '../../ui/kit/controls.tsx';
import { Menu } from '../../ui/kit/menu.tsx';
import { words } from './words.ts';

export function OpenButtons() {
  const { samples, actions } = useUi().app;
  return (
    <>
      <OpenButton />
      {samples.length > 0 && (
        <Menu
          label={words.samples}
          title={words.samplesTitle}
          testId="sample-menu"
          align="right"
          items={samples.map((s) => ({
            id: s.id,
            title: s.title,
            testId: `sample-${s.id}`,
            choose: () => actions.openSample(s.id),
          }))}
        >
          <Icon name="sample" />
          <span class="word">{words.samples}</span>
        </Menu>
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
        aria-label={words.open}
        title={words.openTitle}
        onClick={() => input.current?.click()}
      >
        <Icon name="open" />
        <span class="word">{words.open}</span>
      </button>
      <input
        ref={input}
        class="hidden"
        type="file"
        multiple
        accept=".csv,.tsv,.txt,.dat,.trc,.mot,.sto,.json,.jsonl,.gz,.xlsx,.parquet,.mdl,.mat,text/*,application/json"
        tabIndex={-1}
        aria-label={words.openTitle}
        data-testid="open-file"
        onChange={(event) => {
          const files = [...(event.currentTarget.files ?? [])];
          event.currentTarget.value = '';
          if (files.length > 0) ui.app.actions.openFiles(files);
        }}
      />
    </>
  );
}
