import { useComputed } from '@preact/signals';
import { useUi } from '../context.ts';
import { formatTime, THIN } from '../kit/format.ts';
import { Slot } from '../slot.tsx';
import { text } from '../words.ts';
import { fraction, timelineOf } from './timeline.ts';
import type { Timeline } from './timeline.ts';

/** Half the thumb, so that marks and buffer line up with the thumb's centre (see .scrub-line). */
const percent = (part: number): string => `${(100 * part).toFixed(3)}%`;

export function Scrubber() {
  const { state } = useUi().app;
  void state.rowsVersion.value;
  const motion = state.motion.value;
  const line = timelineOf(motion, state.run.value);
  return (
    <div class="scrub">
      <div class="scrub-line">
        <span class="scrub-track" />
        <span class="scrub-buffer" style={{ width: percent(fraction(line.available, line)) }} />
        <Played line={line} />
        <Slot name="timeLine" />
        {motion?.marks.map((mark) => (
          <Mark key={`${mark.time} ${mark.name}`} at={fraction(mark.time, line)} time={mark.time} name={mark.name} />
        ))}
      </div>
      <Range line={line} disabled={motion === null} />
      <span class="end" data-testid="end-time">
        {formatTime(line.end)}
        {THIN}s
      </span>
    </div>
  );
}

function Played({ line }: { line: Timeline }) {
  const { state } = useUi().app;
  return <span class="scrub-played" style={{ width: percent(fraction(state.readTime.value, line)) }} />;
}

function Range({ line, disabled }: { line: Timeline; disabled: boolean }) {
  const { state, actions } = useUi().app;
  const said = useComputed(() => `${formatTime(state.readTime.value)} ${text.transport.seconds}`);
  return (
    <input
      type="range"
      class="scrub-input"
      min={line.start}
      max={line.end}
      step="any"
      value={state.readTime.value}
      disabled={disabled}
      aria-label={text.transport.position}
      aria-valuetext={said}
      data-testid="scrubber"
      onInput={(event) => actions.seek(Math.min(event.currentTarget.valueAsNumber, line.available))}
    />
  );
}

function Mark({ at, time, name }: { at: number; time: number; name: string }) {
  const { actions } = useUi().app;
  const side = at > 0.85 ? 'right' : at < 0.1 ? 'left' : 'middle';
  return (
    <button
      type="button"
      class={`mark ${side}`}
      style={{ left: percent(at) }}
      title={`${name}, ${formatTime(time)}${THIN}s`}
      onClick={() => actions.seek(time)}
    >
      <span>{name}</span>
    </button>
  );
}
