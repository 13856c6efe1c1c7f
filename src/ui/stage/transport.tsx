/** Playback: the same for a live run and a file. */
import { useComputed } from '@preact/signals';
import { speeds } from '../../app/state/playbackClock.ts';
import { useCommand, useUi } from '../context.ts';
import { Icon, Toggle, type IconName } from '../kit/controls.tsx';
import { formatSpeed, formatTime, THIN } from '../kit/format.ts';
import { Scrubber } from './scrubber.tsx';
import { text } from '../words.ts';

export function Transport() {
  const playing = useUi().app.state.playing.value;
  return (
    <section id="playback" class="transport" tabIndex={-1} aria-label={text.transport.label}>
      <div class="transport-keys">
        <KeyButton id="step-back" icon="back" />
        <KeyButton id="play" icon={playing ? 'pause' : 'play'} />
        <KeyButton id="step-forward" icon="forward" />
      </div>
      <TimeNow />
      <Scrubber />
      <Speed />
      <LoopButton />
    </section>
  );
}

function KeyButton({ id, icon }: { id: string; icon: IconName }) {
  const { label, title, disabled, perform } = useCommand(id);
  return (
    <button
      type="button"
      class={`quiet square${id === 'play' ? ' play' : ''}`}
      data-testid={id}
      aria-label={label}
      title={title}
      disabled={disabled}
      onClick={perform}
    >
      <Icon name={icon} />
    </button>
  );
}

function LoopButton() {
  const { label, title, perform } = useCommand('loop');
  return (
    <Toggle pressed={useUi().app.state.loop.value} label={label} title={title} testId="loop" onClick={perform}>
      <Icon name="loop" />
    </Toggle>
  );
}

function TimeNow() {
  const { state } = useUi().app;
  const shown = useComputed(() => `${formatTime(state.readTime.value)}${THIN}s`);
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
