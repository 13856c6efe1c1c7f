import { signal, type ReadonlySignal } from '@preact/signals';
import type { Push } from '../../core/simulation/push.ts';
import { readonly } from '../state/signals.ts';

export interface PushState {
  /** The push that acts on the run now, by pointer or keys, or null. */
  push: ReadonlySignal<Push | null>;
}

export interface PushActions {
  setPush(push: Push | null): void;
}

export function createPush(): { state: PushState; actions: PushActions } {
  const push = signal<Push | null>(null);
  return { state: { push: readonly(push) }, actions: { setPush: (next) => void (push.value = next) } };
}
