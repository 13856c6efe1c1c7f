/**
 * Colours of the scene, as CSS strings in sRGB.
 *
 * Front and back take the vermilion/blue and orange/sky-blue pairs of Okabe and Ito's palette for colour-blind readers
 * (https://jfly.uni-koeln.de/color/): the darker pair on the light ground, the lighter pair on the dark one.
 */
import type { ColourRole } from '../core/model/system.ts';

export type Theme = 'light' | 'dark';

export interface Palette {
  /** Meaning: front, back, whole board. */
  role: Readonly<Record<ColourRole, string>>;
  background: string;
  /** Above the horizon, where the background ends. */
  zenith: string;
  /** Ground under the board and away from it; it fades into the background. */
  ground: string;
  groundRim: string;
  gridFine: string;
  gridStrong: string;
  label: string;
  /** What the person does: the page's one colour for action. */
  accent: string;
  /** Hemisphere light, from above and from below. */
  sky: string;
  bounce: string;
  key: string;
  /** Strengths: hemisphere, key, environment (0 to 1 of the room), and how dark a shadow is (0 to 1). */
  light: Readonly<{ hemisphere: number; key: number; environment: number; shadow: number; contact: number }>;
}

export const palettes: Readonly<Record<Theme, Palette>> = {
  light: {
    role: { neutral: '#4c545c', first: '#D55E00', second: '#0072B2' },
    background: '#dfe4e8',
    zenith: '#f4f6f8',
    ground: '#fbfbfa',
    groundRim: '#e4e8eb',
    gridFine: '#d6dbe0',
    gridStrong: '#b3bcc4',
    label: '#5b6670',
    accent: '#0b6e64',
    sky: '#ffffff',
    bounce: '#d6d2cb',
    key: '#fff6ea',
    light: { hemisphere: 1.65, key: 2.4, environment: 0.55, shadow: 0.24, contact: 0.34 },
  },
  dark: {
    role: { neutral: '#b4bcc4', first: '#E69F00', second: '#56B4E9' },
    background: '#0f1216',
    zenith: '#20262d',
    ground: '#30363e',
    groundRim: '#171b20',
    gridFine: '#373e46',
    gridStrong: '#4b545e',
    label: '#a3adb8',
    accent: '#4cc2b0',
    sky: '#d5e2f2',
    bounce: '#565b63',
    key: '#fff1e0',
    light: { hemisphere: 1.5, key: 2.6, environment: 0.5, shadow: 0.5, contact: 0.55 },
  },
};
