/** A second scene on a canvas of its own, at any size: for pictures and videos that leave the page. */
import type { SceneView } from './contract.ts';
import { createScene } from './scene.ts';

export interface CaptureOptions {
  width: number;
  height: number;
  theme: 'light' | 'dark';
  transparent: boolean;
  labels: boolean;
  supersample: number;
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
export function openCapture({ width, height, theme, transparent, labels, supersample }: CaptureOptions): Capture {
  const drawn = document.createElement('canvas');
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext('2d', { alpha: transparent });
  if (!context) throw new Error('The browser gives no 2-D canvas of that size.');
  const view = createScene(drawn, { theme, reducedMotion: true, still: { transparent, labels } });
  const gl = drawn.getContext('webgl2')!;
  const scale = Math.max(0.5, Math.min(width, height) / USUAL_HEIGHT);
  // Half a hundredth of a pixel more: the size in pixels is rounded down.
  const resize = (samples: number): void => view.resize((width + 0.005) / scale, (height + 0.005) / scale, scale * samples);
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
  context.imageSmoothingQuality = 'high';
  return {
    canvas,
    view,
    draw(caption) {
      view.draw();
      context.clearRect(0, 0, width, height);
      context.drawImage(drawn, 0, 0, width, height);
      if (caption !== null) writeCaption(context, caption, theme);
    },
    dispose: close,
  };
}

function writeCaption(context: CanvasRenderingContext2D, caption: string, theme: 'light' | 'dark'): void {
  const { width, height } = context.canvas;
  let size = Math.max(8, Math.round(Math.min(width, height) / 30));
  const font = (): string => `500 ${size}px system-ui, sans-serif`;
  context.font = font();
  const room = width - 2 * size;
  const wide = context.measureText(caption).width;
  if (wide > room) size = Math.max(6, Math.floor((size * room) / wide));
  context.font = font();
  context.textBaseline = 'alphabetic';
  context.lineJoin = 'round';
  context.lineWidth = size / 4;
  context.strokeStyle = theme === 'dark' ? 'rgb(18 21 26 / 85%)' : 'rgb(246 247 248 / 85%)';
  context.fillStyle = theme === 'dark' ? '#e4e8eb' : '#191e23';
  context.strokeText(caption, size, height - size);
  context.fillText(caption, size, height - size);
}
