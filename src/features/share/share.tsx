/** Copies a link to what is in the panel; on a phone it is handed to the system's own sheet. */
import { useSignal } from '@preact/signals';
import { useUi } from '../../ui/context.ts';
import { Icon } from '../../ui/kit/controls.tsx';
import { later } from '../../ui/kit/later.tsx';
import { firstWords as words } from './firstWords.ts';

const LinkDialog = later(async () => (await import('./linkDialog.tsx')).LinkDialog);

const load = () => import('./shareLink.ts');
/** What fails here is told when it is pressed. */
const foresee = () => void load().catch(() => {});

export function ShareButton() {
  const { app } = useUi();
  const shown = useSignal<string | null>(null);
  const share = async () => {
    try {
      shown.value = await (await load()).shareLink(app);
    } catch (error) {
      app.actions.report('warning', words.notShared, [(error as Error).message]);
    }
  };
  return (
    <>
      {/* the code is there before the press, so that the browser still sees the copy as the person's doing */}
      <button
        type="button"
        class="quiet"
        data-testid="share"
        aria-label={words.share}
        title={words.shareTitle}
        onPointerEnter={foresee}
        onFocus={foresee}
        onClick={() => void share()}
      >
        <Icon name="share" />
        <span class="word">{words.share}</span>
      </button>
      {shown.value !== null && (
        <LinkDialog
          link={shown.value}
          onClose={() => {
            shown.value = null;
          }}
        />
      )}
    </>
  );
}
