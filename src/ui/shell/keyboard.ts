/** The page's keys, which ask for its commands. Fields, menus and dialogs keep theirs. */
import { useEffect } from 'preact/hooks';
import { commandFor } from '../../app/commands.ts';
import type { Ui } from '../context.ts';

export function useKeyboard(ui: Ui): void {
  useEffect(() => {
    const onKeyDown = (event: KeyboardEvent) => press(ui, event);
    window.addEventListener('keydown', onKeyDown);
    return () => window.removeEventListener('keydown', onKeyDown);
  }, []);
}

type Press = Pick<
  KeyboardEvent,
  'key' | 'shiftKey' | 'ctrlKey' | 'metaKey' | 'altKey' | 'target' | 'defaultPrevented' | 'preventDefault'
>;

export function press({ app, commands }: Pick<Ui, 'app' | 'commands'>, event: Press): void {
  if (event.defaultPrevented || document.querySelector('dialog[open]')) return;
  const { target } = event;
  if (event.ctrlKey || event.metaKey || runsOnEnter(target)) {
    const command = commandFor(commands, event, app, runsOnEnter(target) ? 'field' : undefined);
    if (!command?.perform) return;
    if (command.keys?.some(({ textual }) => textual)) {
      if (keepsText(target)) return;
      event.preventDefault();
      command.perform(app);
    }
    // after the field has taken the key and what it led to has been drawn
    else setTimeout(() => command.perform!(app));
    return;
  }
  if (typing(target) || (event.key === ' ' && pressing(target))) return;
  const command = commandFor(commands, event, app);
  if (!command?.perform) return;
  command.perform(app);
  event.preventDefault();
}

/** Enter in a field runs the experiment where its part of the page says so; elsewhere a field only takes its value. */
function runsOnEnter(target: EventTarget | null): boolean {
  return (
    target instanceof HTMLInputElement &&
    target.type === 'text' &&
    target.closest<HTMLElement>('[data-enter]')?.dataset['enter'] === 'run'
  );
}

/** Text that is no part of the experiment: a name, a search. */
const keepsText = (target: EventTarget | null): boolean =>
  (target instanceof HTMLTextAreaElement ||
    (target instanceof HTMLInputElement && /^(text|search|number|url)$/.test(target.type))) &&
  target.dataset['path'] === undefined;

function typing(target: EventTarget | null): boolean {
  // The transport's slider is the time line itself; every other one keeps its arrows, Home and End.
  if (target instanceof HTMLInputElement && target.type === 'range') return target.closest('.transport') === null;
  if (target instanceof HTMLInputElement) return target.type !== 'checkbox';
  return target instanceof HTMLElement && (target.isContentEditable || /^(TEXTAREA|SELECT)$/.test(target.tagName));
}

/** Space presses what has the focus. */
function pressing(target: EventTarget | null): boolean {
  return (
    target instanceof HTMLElement &&
    (/^(BUTTON|SUMMARY|A)$/.test(target.tagName) || (target instanceof HTMLInputElement && target.type === 'checkbox'))
  );
}
