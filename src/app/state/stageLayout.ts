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
  /** The scene leaves something out, to be in time. */
  coarse: ReadonlySignal<boolean>;
}

export interface StageLayoutActions {
  setInsetBox(box: StageBox | null): void;
  setPixelsPerMetre(pixels: number): void;
  setCoarse(coarse: boolean): void;
}

/** What the page and the scene measure of the stage for each other. */
export function createStageLayout(): { state: StageLayoutState; actions: StageLayoutActions } {
  const insetBox = signal<StageBox | null>(null);
  const pixelsPerMetre = signal(0);
  const coarse = signal(false);
  return {
    state: { insetBox: readonly(insetBox), pixelsPerMetre: readonly(pixelsPerMetre), coarse: readonly(coarse) },
    actions: {
      setInsetBox: (box) => void (insetBox.value = box),
      setPixelsPerMetre: (pixels) => void (pixelsPerMetre.value = pixels),
      setCoarse: (now) => void (coarse.value = now),
    },
  };
}
