import { signal } from '@preact/signals';
import type { Command } from '../../app/commands.ts';
import type { Feature } from '../../ui/feature.ts';
import { useCommand, useUi } from '../../ui/context.ts';
import { Toggle } from '../../ui/kit/controls.tsx';
import { later } from '../../ui/kit/later.tsx';
import { firstWords } from './firstWords.ts';

/** Whether the page is in riding mode. */
const riding = signal(false);

const RideView = later(async () => (await import('./rideView.tsx')).RideView);

const commands: readonly Command[] = [
  {
    id: 'ride',
    label: firstWords.ride,
    hint: firstWords.title,
    keys: [{ key: 'u', line: { what: firstWords.keyLine } }],
    perform: () => void (riding.value = !riding.value),
  },
];

function RideSlot() {
  return riding.value ? <RideView onLeave={() => void (riding.value = false)} /> : null;
}

function RideSwitch() {
  const { label, title, perform } = useCommand('ride');
  return (
    <Toggle pressed={riding.value} title={title} testId="ride" onClick={perform}>
      {label}
    </Toggle>
  );
}

const CommandMarks = later(async () => (await import('./commandMarks.tsx')).CommandMarks);

function TimeLine() {
  const { state } = useUi().app;
  return state.motion.value?.scenario?.control?.type === 'ride' ? <CommandMarks /> : null;
}

export const ride: Feature = {
  id: 'ride',
  order: 115,
  stageSwitch: RideSwitch,
  stagePad: RideSlot,
  timeLine: TimeLine,
  commands,
};
