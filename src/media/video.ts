/** A canvas as a video file: by WebCodecs at exact frame times, else recorded as it plays. */
import { BufferTarget, CanvasSource, getFirstEncodableVideoCodec, Output } from 'mediabunny';
import { containerOf, pause, record } from './recording.ts';

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

/** What this browser can make of that size (px, even) and bits per second; null when nothing. */
export async function chooseEncoding(width: number, height: number, bitrate: number): Promise<Encoding | null> {
  if (typeof VideoEncoder === 'function') {
    const codec = await getFirstEncodableVideoCodec(['avc', 'vp9', 'vp8'], { width, height, bitrate });
    if (codec === 'avc') return { kind: 'exact', codec, extension: 'mp4', mime: 'video/mp4' };
    if (codec === 'vp9' || codec === 'vp8') return { kind: 'exact', codec, extension: 'webm', mime: 'video/webm' };
  }
  if (typeof MediaRecorder !== 'function' || !('captureStream' in HTMLCanvasElement.prototype)) return null;
  const mime = ['video/mp4', 'video/webm'].find((type) => MediaRecorder.isTypeSupported(type));
  return mime ? { kind: 'recorded', codec: 'browser', extension: mime === 'video/mp4' ? 'mp4' : 'webm', mime } : null;
}

/** The file. @throws DOMException `AbortError` when the signal says so; what the encoder throws. */
export const encodeVideo = (job: VideoJob): Promise<Blob> => (job.encoding.kind === 'exact' ? encodeExactly(job) : record(job));

async function encodeExactly({ canvas, encoding, frames, fps, bitrate, draw, onFrame, signal }: VideoJob): Promise<Blob> {
  const target = new BufferTarget();
  const output = new Output({ format: containerOf(encoding.extension), target });
  const source = new CanvasSource(canvas, { codec: encoding.codec as 'avc' | 'vp9' | 'vp8', bitrate, keyFrameInterval: 2 });
  output.addVideoTrack(source, { frameRate: fps });
  try {
    await output.start();
    for (let k = 0; k < frames; k++) {
      signal.throwIfAborted();
      draw(k);
      await source.add(k / fps, 1 / fps); // waits while the encoder is behind
      onFrame(k + 1);
      await pause(0);
    }
    signal.throwIfAborted();
    await output.finalize();
  } catch (error) {
    if (output.state !== 'finalized') await output.cancel().catch(() => undefined);
    throw error;
  }
  return new Blob([target.buffer!], { type: encoding.mime });
}
