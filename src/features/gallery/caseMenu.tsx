import { useSignal } from '@preact/signals';
import { sameContent } from '../../app/state/draft.ts';
import { useUi } from '../../ui/context.ts';
import { Icon } from '../../ui/kit/controls.tsx';
import { Dialog } from '../../ui/kit/dialog.tsx';
import { later } from '../../ui/kit/later.tsx';
import { text as shared } from '../../ui/words.ts';
import { text } from './words.ts';

const Gallery = later(async () => (await import('./gallery.tsx')).Gallery);

/** The name of the case in the panel; it opens the gallery. */
export function CaseMenu() {
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
        aria-label={`${text.title}: ${origin?.title ?? shared.ownScenario}`}
        data-testid="case-menu"
        onClick={() => {
          open.value = true;
        }}
      >
        <span class="case-title">{origin?.title ?? shared.ownScenario}</span>
        {edited && <span class="edited">{text.edited}</span>}
        <Icon name="down" />
      </button>
      {open.value && (
        <Dialog title={text.title} testId="gallery" wide document="page.md#gallery" onClose={close}>
          <Gallery onClose={close} />
        </Dialog>
      )}
    </>
  );
}
