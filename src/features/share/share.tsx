/** Copies a link to what is in the panel; on a phone it is handed to the system's own sheet. */
import { useSignal } from '@preact/signals';
import { useUi } from '../../ui/context.ts';
import { Icon } from '../../ui/kit/controls.tsx';
import { later } from '../../ui/kit/later.tsx';
import { words } from './words.ts';

const LinkDialog = later(async () => (await import('./linkDialog.tsx')).LinkDialog);

const load = () => import('../../app/persistence/links.ts');
/** What fails here is told when it is pressed. */
const foresee = () => void load().catch(() => {});

export function ShareButton() {
  const { app } = useUi();
  const shown = useSignal<string | null>(null);
  const share = async () => {
    let fragment: string;
    try {
      fragment = (await load()).linkOf(app);
    } catch (error) {
      app.actions.report('warning', words.notShared, [(error as Error).message]);
      return;
    }
    const link = `${location.origin}${location.pathname}#${fragment}`;
    if (await handedOver(app.state.origin.peek().title, link)) return;
    try {
      await navigator.clipboard.writeText(link);
      app.actions.report('info', words.copied, [words.copiedHint(link.length)]);
    } catch {
      shown.value = link; // no clipboard, or not allowed: the person copies it
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

/** Whether the phone's own sheet took it; giving it up there is an answer too. */
async function handedOver(title: string, url: string): Promise<boolean> {
  if (!('share' in navigator) || !matchMedia('(pointer: coarse)').matches) return false;
  try {
    await navigator.share({ title, url });
    return true;
  } catch (error) {
    return (error as Error).name === 'AbortError';
  }
}
