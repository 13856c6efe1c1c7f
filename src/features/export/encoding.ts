/** What a video is to be: its codec and container, and the work of making one. */
import { Mp4OutputFormat, WebMOutputFormat } from 'mediabunny';

export interface Encoding {
  /** `recorded` is taken down as it plays, in true time, and a frame that comes too late for the recorder is missing. */
  kind: 'exact' | 'recorded';
  codec: 'avc' | 'vp9' | 'vp8' | 'browser';
  extension: 'mp4' | 'webm';
  mime: string;
}

export interface VideoJob {
  canvas: HTMLCanvasElement;
  encoding: Encoding;
  frames: number;
  fps: number;
  /** Bits per second. */
  bitrate: number;
  /** Draws frame k on the canvas. */
  draw(k: number): void;
  /** After each frame that is in the file. */
  onFrame(done: number): void;
  signal: AbortSignal;
}

export const pause = (milliseconds: number): Promise<void> => new Promise((done) => setTimeout(done, milliseconds));

export const containerOf = (extension: Encoding['extension']): Mp4OutputFormat | WebMOutputFormat =>
  extension === 'mp4' ? new Mp4OutputFormat() : new WebMOutputFormat();
