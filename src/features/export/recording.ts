/** A canvas taken down by the browser's own recorder as it plays, for browsers without WebCodecs. */
import {
  BlobSource,
  BufferTarget,
  EncodedPacketSink,
  EncodedVideoPacketSource,
  Input,
  MP4,
  Output,
  WEBM,
  type EncodedPacket,
  type InputVideoTrack,
} from 'mediabunny';
import { containerOf, pause, type VideoJob } from './encoding.ts';

const HIDDEN_MS = 250;

/** Until the picture just drawn has been composed, and with it recorded; a page that is not seen composes none. */
const composed = (): Promise<unknown> =>
  Promise.race([new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))), pause(HIDDEN_MS)]);

/** Plays all frames, each for its time on the clock on the wall or as long as the browser needs for it. @throws as `encodeVideo` */
export async function record(job: VideoJob): Promise<Blob> {
  const { canvas, encoding, frames, fps, bitrate, draw, onFrame, signal } = job;
  // A canvas that is not in the page is never composed, and a stream of it has no frames (Chromium).
  Object.assign(canvas.style, { position: 'fixed', top: '0', left: '-99999px' });
  canvas.ariaHidden = 'true';
  document.body.append(canvas);
  draw(0);
  const stream = canvas.captureStream(0);
  const track = stream.getVideoTracks()[0] as CanvasCaptureMediaStreamTrack;
  const recorder = new MediaRecorder(stream, { mimeType: encoding.mime, videoBitsPerSecond: bitrate });
  const parts: Blob[] = [];
  recorder.addEventListener('dataavailable', (event) => parts.push(event.data));
  const stopped = new Promise<void>((done, fail) => {
    recorder.addEventListener('stop', () => done());
    recorder.addEventListener('error', () => fail(new Error('The browser stopped recording.')));
  });
  recorder.start();
  const began = performance.now();
  try {
    for (let k = 0; k < frames; k++) {
      signal.throwIfAborted();
      draw(k);
      track.requestFrame();
      onFrame(k + 1);
      await composed();
      await pause(Math.max(0, began + (1000 * (k + 1)) / fps - performance.now()));
    }
  } finally {
    if (recorder.state !== 'inactive') recorder.stop();
    track.stop();
    canvas.remove();
  }
  await stopped;
  return timed(new Blob(parts, { type: encoding.mime }), job);
}

/**
 * The recording in a container that says how long it is, as recorders' own do not: every frame at its exact time where
 * none is missing, else when the recorder saw it.
 */
async function timed(recorded: Blob, { encoding, frames, fps }: VideoJob): Promise<Blob> {
  const input = new Input({ formats: [MP4, WEBM], source: new BlobSource(recorded) });
  const track = await input.getPrimaryVideoTrack();
  const codec = await track?.getCodec();
  const packets = track ? await packetsOf(track) : [];
  if (!track || !codec || packets.length === 0) throw new Error('The browser’s recorder gave no video.');
  const target = new BufferTarget();
  const output = new Output({ format: containerOf(encoding.extension), target });
  const source = new EncodedVideoPacketSource(codec);
  output.addVideoTrack(source, { frameRate: fps });
  await output.start();
  const first = packets[0]!.timestamp;
  const complete = packets.length === frames;
  const timeOf = (k: number): number =>
    complete
      ? k / fps
      : k < packets.length
        ? packets[k]!.timestamp - first
        : Math.max(frames / fps, packets.at(-1)!.timestamp - first + 1 / fps);
  const decoderConfig = (await track.getDecoderConfig()) ?? undefined;
  for (const [k, packet] of packets.entries()) {
    await source.add(
      packet.clone({ timestamp: timeOf(k), duration: timeOf(k + 1) - timeOf(k) }),
      k === 0 && decoderConfig ? { decoderConfig } : undefined,
    );
  }
  await output.finalize();
  return new Blob([target.buffer!], { type: encoding.mime });
}

/** In the order in which they are shown, which is a recorder's own. */
async function packetsOf(track: InputVideoTrack): Promise<EncodedPacket[]> {
  const packets: EncodedPacket[] = [];
  for await (const packet of new EncodedPacketSink(track).packets()) packets.push(packet);
  return packets;
}
