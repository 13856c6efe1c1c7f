/** Fields of the experiment whose text is not in force, and the one that the person is led to. */
import { batch, signal, type ReadonlySignal } from '@preact/signals';
import { readonly } from './signals.ts';

export interface FieldState {
  /** Why text that stands in a field is not in force, by the draft's path. */
  refusedFields: ReadonlySignal<ReadonlyMap<string, string>>;
  /** Rises when the draft is replaced as a whole: fields then forget refused text. */
  draftEpoch: ReadonlySignal<number>;
  /** The field to go to, a new object each time. */
  wantedField: ReadonlySignal<{ path: string } | null>;
}

export interface FieldActions {
  /** @param reason null: the text is in force */
  refuseField(path: string, reason: string | null): void;
  goToField(path: string): void;
}

export interface FieldSlice {
  state: FieldState;
  actions: FieldActions & { forgetRefused(): void };
}

export function createFields(): FieldSlice {
  const refused = signal<ReadonlyMap<string, string>>(new Map());
  const epoch = signal(0);
  const wanted = signal<{ path: string } | null>(null);
  return {
    state: { refusedFields: readonly(refused), draftEpoch: readonly(epoch), wantedField: readonly(wanted) },
    actions: {
      refuseField(path, reason) {
        const now = refused.peek();
        if ((now.get(path) ?? null) === reason) return;
        const next = new Map(now);
        if (reason === null) next.delete(path);
        else next.set(path, reason);
        refused.value = next;
      },
      goToField: (path) => void (wanted.value = { path }),
      forgetRefused: () =>
        batch(() => {
          refused.value = new Map();
          epoch.value++;
        }),
    },
  };
}
