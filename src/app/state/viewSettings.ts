/** How the stage is looked at, beyond the view and the first switches: what the View menu holds. */
import { signal, type Signal } from '@preact/signals';

/** In CSS pixels from the canvas's top left corner. */
export interface StageBox {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

export interface Look {
  /** Names and axes on the bodies. */
  names: Signal<boolean>;
  frames: Signal<boolean>;
  /** The close-up in a corner, where the system has one; and where on the stage it is drawn. */
  inset: Signal<boolean>;
  insetBox: Signal<StageBox | null>;
  /** From aboard, the horizon stays level. */
  level: Signal<boolean>;
  /** Metres of arrow per newton. */
  metresPerNewton: Signal<number>;
  quality: Signal<'auto' | 'low' | 'high'>;
  /** Pressing on a body pulls at it; with Shift it always does. */
  push: Signal<boolean>;
  /** CSS pixels per metre at what is looked at; 0 before the first picture. */
  pixelsPerMetre: Signal<number>;
}

export function initialLook(): Look {
  return {
    names: signal(false),
    frames: signal(false),
    inset: signal(false),
    insetBox: signal(null),
    level: signal(true),
    metresPerNewton: signal(0.01),
    quality: signal('auto'),
    push: signal(false),
    pixelsPerMetre: signal(0),
  };
}
