/** The page's keys. Fields, menus and dialogs keep theirs. */
import { useEffect } from 'preact/hooks';
import { speeds } from '../../app/state/playbackClock.ts';
import type { App } from '../../app/app.ts';
import type { Ui } from '../context.ts';
import { viewsOf } from '../../app/runs/views.ts';
import { timelineOf } from '../stage/timeline.ts';

const JUMP = 0.1;

export function useKeyboard(ui: Ui): void {
  useEffect(() => {
    const onKeyDown = (event: KeyboardEvent) => {
      if (event.defaultPrevented || document.querySelector('dialog[open]')) return;
      if (event.key === 'Enter' && (event.ctrlKey || event.metaKey || runsOnEnter(event.target))) {
        // after the field has taken the key and what it led to has been drawn
        setTimeout(() => {
          if (!refused(event.target)) ui.app.actions.run();
        });
        return;
      }
      if (
        event.ctrlKey ||
        event.metaKey ||
        event.altKey ||
        typing(event.target) ||
        (event.key === ' ' && pressing(event.target))
      )
        return;
      if (act(ui, event.key, event.shiftKey)) event.preventDefault();
    };
    window.addEventListener('keydown', onKeyDown);
    return () => window.removeEventListener('keydown', onKeyDown);
  }, []);
}

/** Enter in a field runs the experiment where its part of the page says so; elsewhere a field only takes its value. */
function runsOnEnter(target: EventTarget | null): boolean {
  return (
    target instanceof HTMLInputElement &&
    target.type === 'text' &&
    target.closest<HTMLElement>('[data-enter]')?.dataset['enter'] === 'run'
  );
}

const refused = (target: EventTarget | null): boolean =>
  target instanceof HTMLInputElement && target.ariaInvalid === 'true';

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

/** Returns whether the key meant something. */
export function act({ app, features }: Ui, key: string, shift: boolean): boolean {
  const { state, actions } = app;
  const line = timelineOf(state.motion.peek(), state.run.peek());
  const seek = (time: number) => actions.seek(Math.min(line.available, Math.max(line.start, time)));
  const along = (sign: 1 | -1) => (shift ? seek(state.time.peek() + sign * JUMP) : actions.stepRows(sign));
  const does: Record<string, () => void> = {
    ' ': actions.togglePlaying,
    ArrowLeft: () => along(-1),
    ArrowRight: () => along(1),
    ',': () => actions.stepRows(-1),
    '.': () => actions.stepRows(1),
    Home: () => seek(line.start),
    End: () => seek(line.available),
    j: () => slowerOrFaster(app, -1),
    k: actions.pause,
    l: () => slowerOrFaster(app, 1),
    f: () => {
      actions.toggle('follow');
    },
    p: () => {
      actions.toggle('showInset');
    },
    n: () => {
      actions.toggle('showNames');
    },
    a: () => {
      actions.toggle('showFrames');
    },
    '?': () => {
      actions.openDialog('keys');
    },
  };
  const view = viewsOf((state.motion.peek()?.system ?? app.systemOf(state.draft.peek().system))?.meta.views).get(key);
  const name = key.length === 1 ? key.toLowerCase() : key;
  const command = features.flatMap(({ commands }) => commands ?? []).find((one) => one.key === name);
  const run =
    does[name] ??
    (command && (() => command.run(app))) ??
    (view &&
      (() => {
        actions.set('view', view);
      }));
  run?.();
  return run !== undefined;
}

/** L plays, then speeds up; J plays or goes on, one speed slower. */
function slowerOrFaster({ state, actions }: App, way: 1 | -1): void {
  if (state.playing.peek()) {
    const now = state.speed.peek();
    const next = way > 0 ? speeds.find((s) => s > now) : [...speeds].reverse().find((s) => s < now);
    if (next !== undefined) actions.set('speed', next);
  } else if (way < 0) {
    const slower = [...speeds].reverse().find((s) => s < state.speed.peek());
    if (slower !== undefined) actions.set('speed', slower);
    actions.play();
  } else {
    actions.play();
  }
}
