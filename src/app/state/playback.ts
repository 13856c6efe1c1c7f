/** Playback of what is on the stage: the same for a live run and a file. */
import { effect, signal, type ReadonlySignal } from '@preact/signals';
import type { StageState } from '../runs/stageState.ts';
import { runPlaybackClock } from './playbackClock.ts';
import type { SettingsState } from './settings.ts';
import { readonly } from './signals.ts';

export interface PlaybackState {
  time: ReadonlySignal<number>;
  /** The time for what is read: the same, but of a ride while it is ridden some five times a second. */
  readTime: ReadonlySignal<number>;
  playing: ReadonlySignal<boolean>;
  /** The speed really held over the last second, or null when not playing. */
  heldSpeed: ReadonlySignal<number | null>;
}

export interface PlaybackActions {
  play(): void;
  pause(): void;
  togglePlaying(): void;
  /** To a time, as far as there is motion (s). */
  seek(time: number): void;
  /** Moves by whole rows. */
  stepRows(rows: number): void;
}

export interface PlaybackSlice {
  state: PlaybackState;
  actions: PlaybackActions & {
    /** To the time (s) at which another motion begins, before it is there. */
    jump(time: number): void;
    setPlaying(playing: boolean): void;
  };
}

/** Between two read times of a ride, ms: what the page writes anew costs the pictures that the rider waits for. */
const READ_MS = 200;

export function createPlayback(stage: StageState, settings: Pick<SettingsState, 'speed' | 'loop'>): PlaybackSlice {
  const time = signal(0);
  const playing = signal(false);
  const heldSpeed = signal<number | null>(null);
  const readTime = calmed(time, stage);
  const trajectory = () => stage.motion.peek()?.trajectory;
  const growing = (): boolean => stage.run.peek()?.kind === 'computing';
  runPlaybackClock(
    { time, playing, heldSpeed, speed: settings.speed, loop: settings.loop },
    { start: () => trajectory()?.start ?? 0, end: () => trajectory()?.end ?? 0, growing },
  );

  const play = (): void => {
    const rows = trajectory();
    if (!rows) return;
    // Play at the end starts over, as every player does; while rows still come, it waits for them.
    if (time.peek() >= rows.end && !growing()) time.value = rows.start;
    playing.value = true;
  };
  const pause = (): void => void (playing.value = false);

  const stepRows = (by: number): void => {
    const rows = trajectory();
    if (!rows || rows.length === 0) return;
    playing.value = false;
    const t = rows.column('t')!;
    const here = rows.locate(time.peek());
    // From between two rows, a step back goes to the row before, a step forward to the one after.
    const nearest = time.peek() >= t[Math.min(here + 1, t.length - 1)]! ? here + 1 : here;
    const between = by < 0 && time.peek() > t[nearest]! ? 1 : 0;
    time.value = t[Math.min(Math.max(nearest + by + between, 0), t.length - 1)]!;
  };

  return {
    state: { time: readonly(time), readTime, playing: readonly(playing), heldSpeed: readonly(heldSpeed) },
    actions: {
      play,
      pause,
      togglePlaying: () => (playing.peek() ? pause() : play()),
      seek(to) {
        const rows = trajectory();
        time.value = rows ? Math.min(Math.max(to, rows.start), rows.end) : 0;
      },
      stepRows,
      jump: (to) => void (time.value = to),
      setPlaying: (now) => void (playing.value = now),
    },
  };
}

function calmed(time: ReadonlySignal<number>, { motion, run }: StageState): ReadonlySignal<number> {
  const read = signal(time.peek());
  let timer: ReturnType<typeof setTimeout> | undefined;
  effect(() => {
    const now = time.value;
    const ridden = run.value?.kind === 'computing' && motion.peek()?.written?.control?.type === 'ride';
    if (ridden) {
      timer ??= setTimeout(() => {
        timer = undefined;
        read.value = time.peek();
      }, READ_MS);
      return;
    }
    clearTimeout(timer);
    timer = undefined;
    read.value = now;
  });
  return readonly(read);
}
