/** Playback: the same for a live run and a file. */
import { useComputed } from '@preact/signals';
import { speeds } from '../../app/state/playbackClock.ts';
import { useUi } from '../context.ts';
import { Icon, Toggle } from '../kit/controls.tsx';
import { formatSpeed, formatTime, THIN } from '../kit/format.ts';
import { Scrubber } from './scrubber.tsx';
import { text } from '../words.ts';

export function Transport() {
  const { state, actions } = useUi().app;
  const playing = state.playing.value;
  const empty = state.motion.value === null;
  const words = text.transport;
  return (
    <section id="playback" class="transport" tabIndex={-1} aria-label={words.label}>
      <div class="transport-keys">
        <button
          type="button"
          class="quiet square"
          data-testid="step-back"
          aria-label={words.back}
          title={`${words.back} (←)`}
          disabled={empty}
          onClick={() => actions.stepRows(-1)}
        >
          <Icon name="back" />
        </button>
        <button
          type="button"
          class="quiet square play"
          data-testid="play"
          aria-label={playing ? words.pause : words.play}
          title={`${playing ? words.pause : words.play} (Space)`}
          disabled={empty}
          onClick={() => actions.togglePlaying()}
        >
          <Icon name={playing ? 'pause' : 'play'} />
        </button>
        <button
          type="button"
          class="quiet square"
          data-testid="step-forward"
          aria-label={words.forward}
          title={`${words.forward} (→)`}
          disabled={empty}
          onClick={() => actions.stepRows(1)}
        >
          <Icon name="forward" />
        </button>
      </div>
      <TimeNow />
      <Scrubber />
      <Speed />
      <Toggle
        pressed={state.loop.value}
        label={words.loop}
        title={words.loop}
        testId="loop"
        onClick={() => actions.toggle('loop')}
      >
        <Icon name="loop" />
      </Toggle>
    </section>
  );
}

function TimeNow() {
  const { state } = useUi().app;
  const shown = useComputed(() => `${formatTime(state.time.value)}${THIN}s`);
  return (
    <output class="time" data-testid="time" aria-label={text.transport.position} aria-live="off">
      {shown}
    </output>
  );
}

function Speed() {
  const { state, actions } = useUi().app;
  const speed = state.speed.value;
  const held = state.heldSpeed.value;
  const lower = state.playing.value && held !== null && held < 0.95 * speed;
  const choices = (speeds as readonly number[]).includes(speed) ? speeds : [...speeds, speed].sort((a, b) => a - b);
  return (
    <span class="speed">
      <select
        aria-label={text.transport.speed}
        value={String(speed)}
        data-testid="speed"
        onChange={(event) => actions.set('speed', Number(event.currentTarget.value))}
      >
        {choices.map((s) => (
          <option key={s} value={String(s)}>
            {formatSpeed(s)}
          </option>
        ))}
      </select>
      {lower && (
        <span class="held" title={text.transport.heldTitle}>
          {text.transport.held(formatSpeed(held))}
        </span>
      )}
    </span>
  );
}
