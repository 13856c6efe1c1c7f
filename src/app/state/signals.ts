import { computed, type ReadonlySignal, type Signal } from '@preact/signals';

/** A signal as the outside has it: read and watched; assigning to it throws. */
export const readonly = <T>(signal: Signal<T>): ReadonlySignal<T> => computed(() => signal.value);

/** Something that happens, as opposed to something that is: who listens is called each time, who comes later missed it. */
export interface AppEvent<T> {
  /** Returns what ends the subscription. */
  subscribe(listener: (what: T) => void): () => void;
}

export interface EventSource<T> extends AppEvent<T> {
  emit(what: T): void;
}

export function createEvent<T>(): EventSource<T> {
  const listeners = new Set<(what: T) => void>();
  return {
    subscribe(listener) {
      listeners.add(listener);
      return () => void listeners.delete(listener);
    },
    emit(what) {
      for (const listener of [...listeners]) listener(what);
    },
  };
}

/** The part that the outside may have. */
export const listenable = <T>({ subscribe }: EventSource<T>): AppEvent<T> => ({ subscribe });
