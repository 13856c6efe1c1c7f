/** What a tool puts on the stage beside the motion: gates to go through, and another motion that goes along as a ghost. */
import { signal, type ReadonlySignal } from '@preact/signals';
import { readonly } from '../state/signals.ts';
import type { Motion } from './motion.ts';

/** On the floor: its middle (m), the direction of going through it (rad), half of its width (m). */
export interface StageGate {
  x: number;
  y: number;
  heading: number;
  half: number;
  state: 'done' | 'next' | 'ahead';
}

export interface CompanyState {
  gates: ReadonlySignal<readonly StageGate[]>;
  /** Its title is the word over it. */
  companion: ReadonlySignal<Motion | null>;
}

export interface CompanyActions {
  setGates(gates: readonly StageGate[]): void;
  setCompanion(motion: Motion | null): void;
}

export function createCompany(): { state: CompanyState; actions: CompanyActions } {
  const gates = signal<readonly StageGate[]>([]);
  const companion = signal<Motion | null>(null);
  return {
    state: { gates: readonly(gates), companion: readonly(companion) },
    actions: {
      setGates: (next) => void (gates.value = next),
      setCompanion: (next) => void (companion.value = next),
    },
  };
}
