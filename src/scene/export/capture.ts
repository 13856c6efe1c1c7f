/** A second scene on a canvas of its own, at any size: for pictures and videos that leave the page. */
import { closeUpBox, writeCaption, writeCloseUp, writeLegend } from './captureNotes.ts';
import type { SceneView } from '../contract.ts';
import { loadStudio } from '../environment/room.ts';
import { createScene } from '../scene.ts';

export interface CaptureOptions {
  width: number;
  height: number;
  theme: 'light' | 'dark';
  transparent: boolean;
  labels: boolean;
  supersample: number;
  /** Title of the close-up in a corner, on a stage that has one; null without. */
  closeUp: string | null;
  /** The bar of the force arrows' scale at so many CSS pixels a metre; null without. */
  legend: ((pixelsPerMetre: number) => { pixels: number; label: string } | null) | null;
}

/** Lines and labels have their size on the page at this height (px), and grow with the picture. */
const USUAL_HEIGHT = 720;

export interface Capture {
  /** The finished picture. */
  canvas: HTMLCanvasElement;
  view: SceneView;
  draw(caption: string | null): void;
  dispose(): void;
}

/** @throws NoWebGlError, or Error when the graphics processor has no room for that size. */
export async function openCapture({
  width,
  height,
  theme,
  transparent,
  labels,
  supersample,
  closeUp,
  legend,
}: CaptureOptions): Promise<Capture> {
  await loadStudio();
  const drawn = document.createElement('canvas');
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext('2d', { alpha: transparent });
  if (!context) throw new Error('The browser gives no 2-D canvas of that size.');
  let pixelsPerMetre = 0;
  const view = createScene(drawn, {
    theme,
    reducedMotion: true,
    still: { transparent, labels },
    onScale: (pixels) => void (pixelsPerMetre = pixels),
  });
  const gl = drawn.getContext('webgl2')!;
  const scale = Math.max(0.5, Math.min(width, height) / USUAL_HEIGHT);
  const size = { width: width / scale, height: height / scale };
  // Half a hundredth of a pixel more: the size in pixels is rounded down.
  const resize = (samples: number): void =>
    view.resize((width + 0.005) / scale, (height + 0.005) / scale, scale * samples);
  const fits = (samples: number): boolean => {
    resize(samples);
    return gl.drawingBufferWidth === samples * width && gl.drawingBufferHeight === samples * height;
  };
  const close = (): void => {
    view.dispose();
    gl.getExtension('WEBGL_lose_context')?.loseContext(); // gives the memory back at once
    drawn.width = drawn.height = 1;
  };
  if (!(supersample > 1 && fits(supersample)) && !fits(1)) {
    close();
    throw new Error(`The graphics processor cannot draw ${width} × ${height} pixels; choose a smaller picture.`);
  }
  const box = closeUp === null ? null : closeUpBox(size);
  view.setInset(box);
  context.imageSmoothingQuality = 'high';
  return {
    canvas,
    view,
    draw(caption) {
      view.draw();
      context.setTransform(1, 0, 0, 1, 0, 0);
      context.clearRect(0, 0, width, height);
      context.drawImage(drawn, 0, 0, width, height);
      context.setTransform(scale, 0, 0, scale, 0, 0);
      if (box) writeCloseUp(context, box, closeUp!, theme);
      const bar = legend?.(pixelsPerMetre);
      if (bar) writeLegend(context, size, box, bar, theme);
      if (caption !== null) writeCaption(context, size, caption, theme);
    },
    dispose: close,
  };
}
