import { batch, signal, type ReadonlySignal } from '@preact/signals';
import { readonly } from './signals.ts';

/** Dialogs that more than one place opens. */
export type DialogName = 'export' | 'keys';

export interface DialogState {
  dialog: ReadonlySignal<DialogName | null>;
  /** What the help opens at: a file under docs/, with a place in it. */
  document: ReadonlySignal<string | null>;
}

export interface DialogActions {
  openDialog(name: DialogName): void;
  closeDialog(): void;
  /** Opens the help at a document: `control.md#reachability`. */
  openDocument(place: string): void;
}

/** One modal dialog at a time. */
export function createDialogs(): { state: DialogState; actions: DialogActions } {
  const dialog = signal<DialogName | null>(null);
  const document = signal<string | null>(null);
  const show = (name: DialogName | null, place: string | null = null): void =>
    batch(() => {
      document.value = place;
      dialog.value = name;
    });
  return {
    state: { dialog: readonly(dialog), document: readonly(document) },
    actions: {
      openDialog: (name) => show(name),
      closeDialog: () => show(null),
      openDocument: (place) => show('keys', place),
    },
  };
}
