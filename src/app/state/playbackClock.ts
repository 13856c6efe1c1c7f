/** Time that goes on with the display, at a chosen speed. */
import { effect, type ReadonlySignal, type Signal } from '@preact/signals';

export interface Playback {
  time: Signal<number>;
  playing: Signal<boolean>;
  speed: ReadonlySignal<number>;
  heldSpeed: Signal<number | null>;
  loop: ReadonlySignal<boolean>;
}

/** What the clock plays against. */
export interface PlaybackRange {
  start(): number;
  /** Last time that can be shown now. */
  end(): number;
  /** More rows are still coming: wait at the end instead of stopping there. */
  growing(): boolean;
}

/** What a person can choose, from slow motion to fast. */
export const speeds: readonly number[] = [1 / 64, 1 / 32, 1 / 16, 1 / 8, 1 / 4, 1 / 2, 1, 2, 4];

/** A tab that slept wakes with one long frame; it goes on from where it was instead of jumping ahead. */
const LONGEST_FRAME_S = 0.25;
/** A longer frame than any slow drawing takes: the tab was hidden, or the machine slept. */
const SLEPT_MS = 3000;
/** Over how long the speed that is really held is measured. */
const MEASURE_S = 1;

/** Advances `time` with the display while playing; asks for no frames otherwise. Returns a stop function. */
export function runPlaybackClock(playback: Playback, range: PlaybackRange): () => void {
  let frame = 0;
  let last = 0;
  let measuredFrom = { wall: 0, time: 0 };

  const tick = (now: number): void => {
    const elapsed = Math.min(Math.max(now - last, 0) / 1000, LONGEST_FRAME_S);
    // Of the time that was slept through nothing is said.
    if (now - last > SLEPT_MS) measuredFrom = { wall: now, time: playback.time.peek() };
    last = now;
    advance(playback, range, elapsed);
    const wall = (now - measuredFrom.wall) / 1000;
    if (wall >= MEASURE_S) {
      const moved = playback.time.peek() - measuredFrom.time;
      // A jump back is a loop or a seek, no speed.
      if (moved >= 0) playback.heldSpeed.value = moved / wall;
      measuredFrom = { wall: now, time: playback.time.peek() };
    }
    if (playback.playing.peek()) frame = requestAnimationFrame(tick);
  };

  const stop = effect(() => {
    cancelAnimationFrame(frame);
    // A new speed starts a new measurement.
    void playback.speed.value;
    if (!playback.playing.value) {
      playback.heldSpeed.value = null;
      return;
    }
    last = performance.now();
    measuredFrom = { wall: last, time: playback.time.peek() };
    frame = requestAnimationFrame(tick);
  });
  return () => {
    stop();
    cancelAnimationFrame(frame);
  };
}

function advance(playback: Playback, range: PlaybackRange, elapsed: number): void {
  const end = range.end();
  const next = playback.time.peek() + elapsed * playback.speed.peek();
  if (next < end) {
    playback.time.value = Math.max(next, range.start());
    return;
  }
  if (range.growing()) {
    playback.time.value = end;
    return;
  }
  if (playback.loop.peek() && end > range.start()) {
    playback.time.value = range.start();
    return;
  }
  playback.time.value = end;
  playback.playing.value = false;
}
