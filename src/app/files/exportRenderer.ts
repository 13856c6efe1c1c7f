/** What the export dialog asks of the scene, without knowing it. */
import type { ViewName } from '../state/settingsTable.ts';

export interface ShotPlan {
  /** Pixels of the result. */
  width: number;
  height: number;
  transparent: boolean;
  labels: boolean;
  /** Pixels drawn for each pixel kept, along one side: 1 or 2. */
  supersample: number;
  /** `page`: the camera as it is on the page. */
  view: ViewName | 'page';
  follow: boolean;
  /** Where the motion starts: the camera of a named view is placed there (s). */
  from: number;
  /** What stands over the close-up in the corner. */
  closeUpTitle: string;
}

/** A second scene beside the one on the page, drawn on demand, with all that is chosen to be seen there. */
export interface Shot {
  /** Holds the last picture, `width` by `height`. */
  canvas: HTMLCanvasElement;
  /** Puts the motion at a time (s), draws it, and writes the caption over its foot if there is one. */
  draw(time: number, caption: string | null): void;
  dispose(): void;
}

export interface GlbPlan {
  from: number;
  to: number;
  /** Keyframes per second; null takes the run's rows. */
  rate: number | null;
  generator: string;
}

/** Of long work: how to end it, and how far it is. */
export interface ExportProgress {
  signal: AbortSignal;
  /** Keyframes written so far. */
  onKey(done: number): void;
}

export interface ExportRenderer {
  /** @throws Error when the graphics processor can't draw at that size, or there is no motion. */
  open(plan: ShotPlan, signal?: AbortSignal): Promise<Shot>;
  /** A binary glTF 2.0 file, written in slices between which the page lives. @throws Error without a motion; what the signal says. */
  glb(plan: GlbPlan, progress: ExportProgress): Promise<Blob>;
}
