import { signal, type ReadonlySignal } from '@preact/signals';
import { readonly } from './signals.ts';

/** Dialogs that more than one place opens. */
export type DialogName = 'export' | 'keys';

export interface DialogState {
  dialog: ReadonlySignal<DialogName | null>;
}

export interface DialogActions {
  openDialog(name: DialogName): void;
  closeDialog(): void;
}

/** One modal dialog at a time. */
export function createDialogs(): { state: DialogState; actions: DialogActions } {
  const dialog = signal<DialogName | null>(null);
  return {
    state: { dialog: readonly(dialog) },
    actions: {
      openDialog: (name) => void (dialog.value = name),
      closeDialog: () => void (dialog.value = null),
    },
  };
}
