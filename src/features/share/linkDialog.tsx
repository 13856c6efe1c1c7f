/** The link in a field, for the person to copy where the page may not. */
import { useEffect, useRef } from 'preact/hooks';
import { Dialog } from '../../ui/kit/dialog.tsx';
import { words } from './words.ts';

export function LinkDialog({ link, onClose }: { link: string; onClose(): void }) {
  const field = useRef<HTMLInputElement>(null);
  useEffect(() => {
    field.current?.focus();
    field.current?.select();
  }, []);
  return (
    <Dialog title={words.dialog} testId="share-dialog" onClose={onClose}>
      <p class="hint">{words.copyHint}</p>
      <input
        ref={field}
        class="link-field"
        readOnly
        value={link}
        aria-label={words.field}
        data-testid="share-link"
        onFocus={(event) => event.currentTarget.select()}
      />
    </Dialog>
  );
}
