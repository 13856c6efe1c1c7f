/** What the export dialog remembers while the page lives, and the work it starts. */
import { signal } from '@preact/signals';
import { download } from '../../app/files/download.ts';
import { bitrateFor, fileName, frameCount, frameTime, keyCount, type VideoRange } from '../../app/files/exportPlan.ts';
import type { ShotPlan, ExportRenderer } from '../../app/files/exportRenderer.ts';
import type { App } from '../../app/app.ts';
import type { Motion } from '../../app/runs/motion.ts';
import type { Encoding } from './encoding.ts';
import { words as text } from './words.ts';
import { text as page } from '../../ui/words.ts';

export type Tab = keyof typeof text.tabs;

interface Size {
  width: number;
  height: number;
}

export const choices = {
  tab: signal<Tab>('picture'),
  picture: signal<Size & { transparent: boolean; labels: boolean; fine: boolean; view: ShotPlan['view'] }>({
    width: 1920,
    height: 1080,
    transparent: false,
    labels: true,
    fine: true,
    view: 'page',
  }),
  video: signal<
    Size & {
      fps: number;
      speed: number;
      labels: boolean;
      fine: boolean;
      view: ShotPlan['view'];
      follow: boolean | null;
      caption: boolean;
    }
  >({
    width: 1280,
    height: 720,
    fps: 30,
    speed: 1,
    labels: true,
    fine: false,
    view: 'page',
    follow: null,
    caption: true,
  }),
  /** Of which motion, and null for its start and end. */
  range: signal<{ motion: number; from: number | null; to: number | null }>({ motion: -1, from: null, to: null }),
  rate: signal<number | null>(null),
};

/** The work under way, or null: of so many frames or keyframes. */
export const job = signal<{ done: number; all: number; of: 'frames' | 'keys'; cancel(): void } | null>(null);

export function rangeOf({ id, trajectory }: Motion): { from: number; to: number } {
  const { motion, from, to } = choices.range.value;
  return { from: (motion === id ? from : null) ?? trajectory.start, to: (motion === id ? to : null) ?? trajectory.end };
}

/** Keyframes of the part that is chosen, at the rate that is chosen or another. */
export function keysOf(motion: Motion, rate = choices.rate.value): number {
  return keyCount(motion.trajectory.column('t')!, { ...rangeOf(motion), rate });
}

/** Runs one export at a time; says how it ended unless it was cancelled. */
async function work(
  app: App,
  all: number,
  of: 'frames' | 'keys',
  make: (signal: AbortSignal) => Promise<{ name: string; part: BlobPart; type: string }>,
): Promise<void> {
  if (job.peek()) return;
  const control = new AbortController();
  job.value = { done: 0, all, of, cancel: () => control.abort() };
  try {
    const { name, part, type } = await make(control.signal);
    if (control.signal.aborted) return;
    download(name, [part], type);
    app.actions.report('info', text.done(name), [], undefined, 'export');
  } catch (error) {
    if (!control.signal.aborted)
      app.actions.report('error', text.failed, [error instanceof Error ? error.message : String(error)]);
  } finally {
    job.value = null;
  }
}

/** A picture says in its name from where it was taken. */
const titleOf = ({ title }: Motion, view: ShotPlan['view']): string =>
  view === 'page' ? title : text.seen(title.replace(/\.csv$/i, ''), text.views[view]);

const progress = (done: number): void => void (job.value = { ...job.peek()!, done });

/** What is drawn of the picture that is chosen, at a time (s). */
export function picturePlan(time: number): ShotPlan {
  const { width, height, transparent, labels, fine, view } = choices.picture.value;
  return {
    width,
    height,
    transparent,
    labels: labels && !transparent,
    supersample: fine ? 2 : 1,
    view,
    follow: true,
    from: time,
    closeUpTitle: page.viewMenu.insetTitle,
  };
}

/** The same of the video, whose motion begins at a time (s). */
export function videoPlan(app: App, from: number): ShotPlan {
  const { width, height, labels, fine, view, follow } = choices.video.value;
  return {
    width,
    height,
    transparent: false,
    labels,
    supersample: fine ? 2 : 1,
    view,
    follow: follow ?? app.state.follow.value,
    from,
    closeUpTitle: page.viewMenu.insetTitle,
  };
}

/** What is written into a frame of the video, at a time (s). */
export const captionOf = ({ title }: Motion, t: number): string | null =>
  choices.video.value.caption ? text.burnt(title, t.toFixed(2)) : null;

export function savePicture(app: App, renderer: ExportRenderer, motion: Motion): Promise<void> {
  const { width, height, view } = choices.picture.peek();
  const time = app.state.time.peek();
  return work(app, 1, 'frames', async (signal) => {
    const shot = await renderer.open(picturePlan(time), signal);
    try {
      shot.draw(time, null);
      const blob = await new Promise<Blob | null>((done) => shot.canvas.toBlob(done, 'image/png'));
      if (!blob) throw new Error(`The browser could not write a picture of ${width} × ${height} pixels.`);
      return { name: fileName(titleOf(motion, view), 'png'), part: blob, type: 'image/png' };
    } finally {
      shot.dispose();
    }
  });
}

export function saveVideo(app: App, renderer: ExportRenderer, motion: Motion, encoding: Encoding): Promise<void> {
  const { width, height, fps, speed, view } = choices.video.peek();
  const range: VideoRange = { ...rangeOf(motion), fps, speed };
  const frames = frameCount(range);
  return work(app, frames, 'frames', async (signal) => {
    const shot = await renderer.open(videoPlan(app, range.from), signal);
    const { encodeVideo } = await import('./video.ts');
    const draw = (k: number): void => {
      const t = frameTime(range, k);
      shot.draw(t, captionOf(motion, t));
    };
    try {
      const blob = await encodeVideo({
        canvas: shot.canvas,
        encoding,
        frames,
        fps,
        bitrate: bitrateFor(width, height, fps),
        draw,
        onFrame: progress,
        signal,
      });
      return { name: fileName(titleOf(motion, view), encoding.extension), part: blob, type: encoding.mime };
    } finally {
      shot.dispose();
    }
  });
}

export function saveGlb(app: App, renderer: ExportRenderer, motion: Motion): Promise<void> {
  const plan = { ...rangeOf(motion), rate: choices.rate.peek(), generator: page.name };
  return work(app, keysOf(motion), 'keys', async (signal) => ({
    name: fileName(motion.title, 'glb'),
    part: await renderer.glb(plan, { signal, onKey: progress }),
    type: 'model/gltf-binary',
  }));
}
