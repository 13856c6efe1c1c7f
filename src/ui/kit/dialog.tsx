import type { ComponentChildren } from 'preact';
import { useEffect, useId, useRef } from 'preact/hooks';
import { HelpLink } from './helpLink.tsx';
import { Icon } from './controls.tsx';
import { words } from './words.ts';

/** A modal dialog: focus goes in, stays in and comes back; Escape closes. */
export function Dialog({
  title,
  testId,
  wide,
  document: about,
  onClose,
  children,
}: {
  title: string;
  testId: string;
  wide?: boolean;
  /** The document that it is explained in, under docs/. */
  document?: string;
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
          {about && <HelpLink document={about} title={title} />}
          <button type="button" class="quiet square" aria-label={words.close} onClick={onClose}>
            <Icon name="close" />
          </button>
        </div>
        {children}
      </div>
    </dialog>
  );
}
