import { signal, type ReadonlySignal } from '@preact/signals';
import { readonly } from './signals.ts';

/** In CSS pixels from the canvas's top left corner. */
export interface StageBox {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

export interface StageLayoutState {
  /** Where the close-up is drawn, or null. */
  insetBox: ReadonlySignal<StageBox | null>;
  /** CSS pixels per metre at what is looked at; 0 before the first picture. */
  pixelsPerMetre: ReadonlySignal<number>;
}

export interface StageLayoutActions {
  setInsetBox(box: StageBox | null): void;
  setPixelsPerMetre(pixels: number): void;
}

/** What the page and the scene measure of the stage for each other. */
export function createStageLayout(): { state: StageLayoutState; actions: StageLayoutActions } {
  const insetBox = signal<StageBox | null>(null);
  const pixelsPerMetre = signal(0);
  return {
    state: { insetBox: readonly(insetBox), pixelsPerMetre: readonly(pixelsPerMetre) },
    actions: {
      setInsetBox: (box) => void (insetBox.value = box),
      setPixelsPerMetre: (pixels) => void (pixelsPerMetre.value = pixels),
    },
  };
}
