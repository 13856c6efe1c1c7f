import { useEffect, useState } from 'preact/hooks';
import { bitrateFor, frameCount, MOST_FRAMES, sizeInWords, videoDuration } from '../../app/files/exportPlan.ts';
import type { ExportRenderer } from '../../app/files/exportRenderer.ts';
import type { Motion } from '../../app/runs/motion.ts';
import type { Encoding } from './encoding.ts';
import { chooseEncoding } from './video.ts';
import { words as text } from './words.ts';
import { useUi } from '../../ui/context.ts';
import { Check, Choice } from '../../ui/kit/controls.tsx';
import { formatSpeed } from '../../ui/kit/format.ts';
import { RangeFields, SizeFields, ViewField } from './fields.tsx';
import { captionOf, choices, rangeOf, saveVideo, videoPlan } from './jobs.ts';
import { SaveButton } from './picturePage.tsx';
import { Preview } from './preview.tsx';

const RATES = [24, 25, 30, 50, 60];
const SPEEDS = [4, 2, 1, 1 / 2, 1 / 4, 1 / 8, 1 / 16, 1 / 32, 1 / 64];
const speedInWords = (speed: number): string =>
  speed === 1 ? text.real : speed < 1 ? text.slow(formatSpeed(speed)) : text.fast(formatSpeed(speed));

/** What the browser can encode at this size: undefined while it is asked, null for nothing. */
function useEncoding(width: number, height: number, bitrate: number): Encoding | null | undefined {
  const [encoding, setEncoding] = useState<Encoding | null | undefined>(undefined);
  useEffect(() => {
    let asked = true;
    setEncoding(undefined);
    chooseEncoding(width, height, bitrate).then(
      (found) => {
        if (asked) setEncoding(found);
      },
      () => {
        if (asked) setEncoding(null);
      },
    );
    return () => {
      asked = false;
    };
  }, [width, height, bitrate]);
  return encoding;
}

export function VideoPage({ motion, renderer }: { motion: Motion; renderer: ExportRenderer }) {
  const { app } = useUi();
  const now = choices.video.value;
  const { from, to } = rangeOf(motion);
  const range = { from, to, fps: now.fps, speed: now.speed };
  const bitrate = bitrateFor(now.width, now.height, now.fps);
  const encoding = useEncoding(now.width, now.height, bitrate);
  const set = (change: Partial<typeof now>): void =>
    void (choices.video.value = { ...choices.video.peek(), ...change });
  const frames = frameCount(range);
  const reason =
    to <= from
      ? text.empty
      : frames > MOST_FRAMES
        ? text.tooLong(String(MOST_FRAMES))
        : encoding === null
          ? text.noCodec
          : null;
  const how =
    encoding === undefined
      ? text.checking
      : encoding === null
        ? ''
        : encoding.kind === 'exact'
          ? text.exact(text.codec[encoding.codec])
          : text.recorded;
  const save = (event: Event): void => {
    event.preventDefault();
    if (!reason && encoding) void saveVideo(app, renderer, motion, encoding);
  };
  return (
    <form onSubmit={save}>
      <Preview renderer={renderer} plan={videoPlan(app, from)} time={from} caption={captionOf(motion, from)} />
      <SizeFields even prefix="video" width={now.width} height={now.height} onChange={set} />
      <RangeFields motion={motion} />
      <Choice
        label={text.fps}
        value={String(now.fps)}
        testId="video-fps"
        options={RATES.map((n) => ({ id: String(n), label: String(n) }))}
        onChange={(id) => set({ fps: Number(id) })}
      />
      <Choice
        label={text.speed}
        value={String(now.speed)}
        testId="video-speed"
        options={SPEEDS.map((speed) => ({ id: String(speed), label: speedInWords(speed) }))}
        onChange={(id) => set({ speed: Number(id) })}
      />
      <ViewField view={now.view} motion={motion} testId="video-view" onChange={(view) => set({ view })} />
      <Check
        label={text.follow}
        checked={now.follow ?? app.state.follow.value}
        testId="video-follow"
        onChange={(follow) => set({ follow })}
      />
      <Check
        label={text.caption}
        checked={now.caption}
        testId="video-caption"
        onChange={(caption) => set({ caption })}
      />
      <Check label={text.labels} checked={now.labels} testId="video-labels" onChange={(labels) => set({ labels })} />
      <Check label={text.fine} checked={now.fine} testId="video-fine" onChange={(fine) => set({ fine })} />
      <p class="hint" data-testid="video-facts">
        {text.videoFacts(
          String(frames),
          videoDuration(range).toFixed(2),
          sizeInWords((bitrate * videoDuration(range)) / 8),
        )}
      </p>
      <p class="hint" data-testid="video-codec">
        {how}
      </p>
      <SaveButton testId="save-video" reason={reason} />
    </form>
  );
}
