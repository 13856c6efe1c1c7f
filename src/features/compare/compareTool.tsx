/** Runs beside each other: kept, overlaid, subtracted; and one scenario many times. */
import { useSignal } from '@preact/signals';
import { words } from './words.ts';
import { Toggle } from '../../ui/kit/controls.tsx';
import { RunsPart } from './runsPart.tsx';
import { SweepPart } from './sweepPart.tsx';
import './compare.css';

type Part = keyof typeof words.parts;

export function CompareTool() {
  const part = useSignal<Part>('runs');
  return (
    <div class="scroll compare">
      <div class="segments compare-parts" role="group" aria-label={words.part}>
        {(Object.keys(words.parts) as Part[]).map((id) => (
          <Toggle
            key={id}
            pressed={part.value === id}
            testId={`compare-${id}`}
            onClick={() => {
              part.value = id;
            }}
          >
            {words.parts[id]}
          </Toggle>
        ))}
      </div>
      <div hidden={part.value !== 'runs'}>
        <RunsPart />
      </div>
      <div hidden={part.value !== 'sweep'}>
        <SweepPart />
      </div>
    </div>
  );
}
