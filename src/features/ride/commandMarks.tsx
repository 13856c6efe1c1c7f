/** What a ride was told, along the time line: a tick for each command, and its words when it is pointed at. */
import { useUi } from '../../ui/context.ts';
import './commandMarks.css';
import { words } from './words.ts';

/** So many ticks at most: an analog hand is never still. */
const MOST = 400;

export function CommandMarks() {
  const { state } = useUi().app;
  const motion = state.motion.value;
  const control = motion?.scenario?.control;
  void state.rowsVersion.value;
  if (!motion || control?.type !== 'ride' || state.run.value?.kind !== 'ended') return null;
  const { start, end } = motion.trajectory;
  const told = (control.commands ?? []).filter(([time]) => time >= start && time <= end).slice(0, MOST);
  return (
    <span class="ride-marks" role="img" aria-label={words.marks(told.length)} data-testid="ride-marks">
      {told.map(([time, name, value], i) => (
        <span
          key={i}
          class={value === 0 ? 'ride-mark end' : 'ride-mark'}
          style={{ left: `${((100 * (time - start)) / Math.max(end - start, 1e-9)).toFixed(3)}%` }}
          title={words.mark(name, value ?? 1, time)}
        />
      ))}
    </span>
  );
}
