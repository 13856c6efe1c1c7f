/** Arithmetic of exports: which frames a video has, when they are, how large things get, how files are called. */
import { rowsWithin } from '../../core/motion/rowsWithin.ts';

/** Sides of a picture (px). */
export const SMALLEST = 16;
export const LARGEST = 7680;
/** A video longer than this is refused: nobody waits for it. */
export const MOST_FRAMES = 36_000;

/** Keyframes of a 3-D file: some 170 bytes each for the board, more than any viewer takes. */
export const MOST_KEYS = 2_000_000;

/** Times of keyframes, s: the run's rows within [from, to], each moment once, or `rate` a second. */
export function keyTimes(
  t: Float64Array,
  { from, to, rate }: { from: number; to: number; rate: number | null },
): Float64Array {
  if (rate !== null) return Float64Array.from({ length: keyCount(t, { from, to, rate }) }, (_, k) => from + k / rate);
  return t.slice(...rowsWithin(t, from, to)).filter((time, k, rows) => k === 0 || time > rows[k - 1]!);
}

/** How many they are; rows at one moment each for itself. */
export function keyCount(
  t: Float64Array,
  { from, to, rate }: { from: number; to: number; rate: number | null },
): number {
  if (rate !== null) return Math.max(1, Math.floor((to - from) * rate + 1e-9) + 1);
  const [first, end] = rowsWithin(t, from, to);
  return end - first;
}

export interface VideoRange {
  /** Times of the motion (s). */
  from: number;
  to: number;
  fps: number;
  /** Seconds of motion per second of video. */
  speed: number;
}

/** Frames that fill the range, each shown for 1/fps s; at least one. */
export function frameCount({ from, to, fps, speed }: VideoRange): number {
  return Math.max(1, Math.round(((to - from) * fps) / speed));
}

/** Time of the motion in frame k: from + k speed/fps, without adding up roundings. */
export function frameTime({ from, fps, speed }: VideoRange, k: number): number {
  return from + (k * speed) / fps;
}

/** Length of the video (s). */
export const videoDuration = (range: VideoRange): number => frameCount(range) / range.fps;

/** A whole number of pixels within the limits; even for video, whose colours have half as many samples. */
export function sideOf(pixels: number, even = false): number {
  const whole = Math.min(LARGEST, Math.max(SMALLEST, Math.round(Number.isFinite(pixels) ? pixels : SMALLEST)));
  return even ? whole - (whole % 2) : whole;
}

/** Bits per second that keep thin lines clean: 0.12 bits a pixel, between 0.5 and 60 Mbit/s. */
export function bitrateFor(width: number, height: number, fps: number): number {
  return Math.round(Math.min(60e6, Math.max(0.5e6, 0.12 * width * height * fps)));
}

/** `1.2 MB`, by thousands. */
export function sizeInWords(bytes: number): string {
  if (bytes < 1000) return `${Math.round(bytes)} B`;
  if (bytes < 1e6) return `${Math.round(bytes / 1000)} kB`;
  return bytes < 1e9 ? `${(bytes / 1e6).toFixed(bytes < 1e7 ? 1 : 0)} MB` : `${(bytes / 1e9).toFixed(1)} GB`;
}

/** A file name from a title: small letters, digits and hyphens. */
export function fileName(title: string, extension: string): string {
  const stem = title
    .replace(/\.csv$/i, '')
    .normalize('NFKD')
    .replace(/\p{M}/gu, '')
    .replace(/[^\w]+/g, '-')
    .replace(/^-+|-+$/g, '')
    .toLowerCase();
  return `${stem || 'run'}.${extension}`;
}
