/** A canvas as a video file: by WebCodecs at exact frame times, else recorded as it plays. */
import { BufferTarget, CanvasSource, getFirstEncodableVideoCodec, Output } from 'mediabunny';
import { containerOf, pause, type Encoding, type VideoJob } from './encoding.ts';

/** What plays in most places first: MP4 with H.264, WebM, MP4 with whatever the recorder puts into it. */
const RECORDED = ['video/mp4;codecs=avc1.42E01E', 'video/webm', 'video/mp4'];

/** What this browser can make of that size (px, even) and bits per second; null when nothing. */
export async function chooseEncoding(width: number, height: number, bitrate: number): Promise<Encoding | null> {
  if (typeof VideoEncoder === 'function') {
    const codec = await getFirstEncodableVideoCodec(['avc', 'vp9', 'vp8'], { width, height, bitrate });
    if (codec === 'avc') return { kind: 'exact', codec, extension: 'mp4', mime: 'video/mp4' };
    if (codec === 'vp9' || codec === 'vp8') return { kind: 'exact', codec, extension: 'webm', mime: 'video/webm' };
  }
  if (typeof MediaRecorder !== 'function' || !('captureStream' in HTMLCanvasElement.prototype)) return null;
  const mime = RECORDED.find((type) => MediaRecorder.isTypeSupported(type));
  return mime
    ? { kind: 'recorded', codec: 'browser', extension: mime.startsWith('video/mp4') ? 'mp4' : 'webm', mime }
    : null;
}

/** The file. @throws DOMException `AbortError` when the signal says so; what the encoder throws. */
export const encodeVideo = async (job: VideoJob): Promise<Blob> =>
  job.encoding.kind === 'exact' ? encodeExactly(job) : (await import('./recording.ts')).record(job);

async function encodeExactly({
  canvas,
  encoding,
  frames,
  fps,
  bitrate,
  draw,
  onFrame,
  signal,
}: VideoJob): Promise<Blob> {
  const target = new BufferTarget();
  const output = new Output({ format: containerOf(encoding.extension), target });
  const source = new CanvasSource(canvas, {
    codec: encoding.codec as 'avc' | 'vp9' | 'vp8',
    bitrate,
    keyFrameInterval: 2,
  });
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
