/** What was changed of the experiment, one step after another, and the way back and forth. */
import { batch, signal, type ReadonlySignal } from '@preact/signals';
import { sameContent } from './draft.ts';
import type { DraftAndOrigin, DraftEdit, ExperimentSlice } from './experiment.ts';
import { readonly } from './signals.ts';

export interface HistoryState {
  /** Oldest first, those that were undone included until something else is changed. */
  history: ReadonlySignal<readonly DraftEdit[]>;
  /** So many of them are in force. */
  historyAt: ReadonlySignal<number>;
}

export interface HistoryActions {
  undo(): void;
  redo(): void;
  /** To where so many of the changes are in force. */
  goToEdit(count: number): void;
}

/** Changes of one thing closer together than this (ms) are one: a drag, a number being typed. */
const GESTURE_MS = 600;
const MOST = 300;

export interface HistorySlice {
  state: HistoryState;
  actions: HistoryActions & { forget(): void };
}

/**
 * @param moved called after a step, with what it changed
 * @param now ms
 */
export function createHistory(
  { edited, actions: { replace } }: ExperimentSlice,
  moved: (edit: DraftEdit) => void,
  now = (): number => performance.now(),
): HistorySlice {
  const list = signal<readonly DraftEdit[]>([]);
  const at = signal(0);
  let last = -Infinity;
  let stepping = false;

  edited.subscribe((edit) => {
    if (stepping) return;
    const time = now();
    const before = list.peek().slice(0, at.peek());
    const previous = before.at(-1);
    const goesOn =
      previous?.label === edit.label && time - last < GESTURE_MS && edit.before.origin === edit.after.origin;
    last = time;
    const joined = goesOn ? { ...previous, after: edit.after } : edit;
    const kept = goesOn ? before.slice(0, -1) : before;
    const next = same(joined.before, joined.after) ? kept : [...kept, joined].slice(-MOST);
    batch(() => {
      list.value = next;
      at.value = next.length;
    });
  });

  const goTo = (count: number): void => {
    const [from, entries] = [at.peek(), list.peek()];
    const to = Math.min(Math.max(count, 0), entries.length);
    if (to === from) return;
    const target = to === 0 ? entries[0]!.before : entries[to - 1]!.after;
    const before = from === 0 ? entries[0]!.before : entries[from - 1]!.after;
    const { label } = entries[to < from ? to : to - 1]!;
    stepping = true;
    at.value = to;
    replace(label, target);
    stepping = false;
    last = -Infinity;
    moved({ label, before, after: target });
  };

  return {
    state: { history: readonly(list), historyAt: readonly(at) },
    actions: {
      undo: () => goTo(at.peek() - 1),
      redo: () => goTo(at.peek() + 1),
      goToEdit: goTo,
      forget: () =>
        batch(() => {
          list.value = [];
          at.value = 0;
        }),
    },
  };
}

const same = (a: DraftAndOrigin, b: DraftAndOrigin): boolean => a.origin === b.origin && sameContent(a.draft, b.draft);
