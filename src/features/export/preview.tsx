/** What a picture or the first frame of a video will be, small: drawn as the export draws it, anew when a choice changes. */
import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import type { ExportRenderer, ShotPlan } from '../../app/files/exportRenderer.ts';
import { job } from './jobs.ts';
import { words as text } from './words.ts';

/** Neither wider nor higher than this (px). */
const MOST = { width: 384, height: 216 };
/** Choices that follow each other faster than this (ms) are drawn once. */
const SETTLE_MS = 200;

export function Preview({
  renderer,
  plan,
  time,
  caption = null,
}: {
  renderer: ExportRenderer;
  plan: ShotPlan;
  time: number;
  caption?: string | null;
}) {
  const picture = useRef<HTMLCanvasElement>(null);
  const drawn = useSignal(false);
  const scale = Math.min(MOST.width / plan.width, MOST.height / plan.height, 1);
  const [width, height] = [plan.width, plan.height].map((x) => Math.max(1, Math.round(x * scale))) as [number, number];
  const key = JSON.stringify([plan, time, caption]);
  const busy = job.value !== null;
  useEffect(() => {
    // The graphics processor belongs to the export while one is under way.
    if (busy || !(plan.width > 0 && plan.height > 0)) return;
    const control = new AbortController();
    const draw = async () => {
      try {
        const shot = await renderer.open({ ...plan, width, height, supersample: 1 }, control.signal);
        try {
          const pen = control.signal.aborted ? null : picture.current?.getContext('2d');
          if (!pen) return;
          shot.draw(time, caption);
          pen.clearRect(0, 0, width, height);
          pen.drawImage(shot.canvas, 0, 0, width, height);
          drawn.value = true;
        } finally {
          shot.dispose();
        }
      } catch (_) {
        // Saving says what is wrong; a preview that can't be drawn is left as it was.
      }
    };
    const soon = setTimeout(() => void draw(), SETTLE_MS);
    return () => {
      clearTimeout(soon);
      control.abort();
    };
  }, [key, busy]);
  return (
    <canvas
      ref={picture}
      class="export-preview"
      width={width}
      height={height}
      role="img"
      aria-label={text.preview}
      data-testid="export-preview"
      data-state={drawn.value ? 'drawn' : 'waiting'}
    />
  );
}
