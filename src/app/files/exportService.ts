import { signal, type ReadonlySignal } from '@preact/signals';
import type { ExportRenderer } from './exportRenderer.ts';
import { readonly } from '../state/signals.ts';

/** Who makes pictures and 3-D files of what is on the stage: the scene, once there is one and something to draw. */
export interface ExportService {
  /** Whether there is one now. */
  available: ReadonlySignal<boolean>;
  /** The one there is. @throws Error when there is none */
  renderer(): ExportRenderer;
  /** The scene offers its own, or takes it back. */
  offer(renderer: ExportRenderer | null): void;
}

export function createExportService(): ExportService {
  let current: ExportRenderer | null = null;
  const available = signal(false);
  return {
    available: readonly(available),
    renderer() {
      if (!current) throw new Error('There is no scene to draw with.');
      return current;
    },
    offer(renderer) {
      current = renderer;
      available.value = renderer !== null;
    },
  };
}
