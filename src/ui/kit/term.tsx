/** A word of the field; pressed, or pointed at for a while, it shows what the glossary says. */
import type { ComponentChildren } from 'preact';
import { useEffect, useId, useRef, useState } from 'preact/hooks';

/** Ids of the glossary that the page uses. */
export type TermId =
  | 'multiplier'
  | 'residual'
  | 'held-coordinate'
  | 'tracked'
  | 'reachable'
  | 'stage'
  | 'pole'
  | 'cost'
  | 'consistent-start';

/** So long the pointer rests on it, ms. */
const HOVER_MS = 500;
const GAP = 6;
const MARGIN = 8;

export function Term({ id, children }: { id: TermId; children: ComponentChildren }) {
  const [meaning, setMeaning] = useState('');
  const [open, setOpen] = useState(false);
  const button = useRef<HTMLButtonElement>(null);
  const note = useRef<HTMLSpanElement>(null);
  const timer = useRef(0);
  const noteId = useId();
  useEffect(() => () => clearTimeout(timer.current), []);
  const show = async (): Promise<void> => {
    const { glossary } = await import('../glossary.ts');
    setMeaning(glossary.find((entry) => entry.id === id)?.meaning ?? '');
    const [from, at] = [button.current, note.current];
    if (!from || !at || at.matches(':popover-open')) return;
    at.showPopover();
    requestAnimationFrame(() => place(from, at));
  };
  const hide = (): void => {
    clearTimeout(timer.current);
    if (note.current?.matches(':popover-open')) note.current.hidePopover();
  };
  return (
    <>
      <button
        ref={button}
        type="button"
        class="term"
        aria-expanded={open}
        aria-describedby={open ? noteId : undefined}
        onClick={(event) => {
          // In a summary or a label it is neither folded nor pressed.
          event.preventDefault();
          clearTimeout(timer.current);
          if (open) hide();
          else void show().catch(() => {});
        }}
        onPointerEnter={(event) => {
          if (event.pointerType === 'mouse')
            timer.current = window.setTimeout(() => void show().catch(() => {}), HOVER_MS);
        }}
        onPointerLeave={hide}
      >
        {children}
      </button>
      <span
        ref={note}
        id={noteId}
        class="term-note"
        role="tooltip"
        popover="auto"
        onToggle={(event) => setOpen(event.newState === 'open')}
      >
        {meaning}
      </span>
    </>
  );
}

/** Under the word, above it where there is no room below; within the window. */
function place(from: HTMLElement, note: HTMLElement): void {
  const word = from.getBoundingClientRect();
  const { width, height } = note.getBoundingClientRect();
  const below = word.bottom + GAP + height < innerHeight - MARGIN;
  note.style.left = `${Math.max(MARGIN, Math.min(word.left, innerWidth - width - MARGIN))}px`;
  note.style.top = `${below ? word.bottom + GAP : Math.max(MARGIN, word.top - GAP - height)}px`;
}
