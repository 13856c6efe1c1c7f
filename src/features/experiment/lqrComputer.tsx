/** The computer that runs the regulator: sample time, delay, design; and what they make of the loop, in words. */
import { useSignal } from '@preact/signals';
import type { Answer } from '../../app/app.ts';
import { MathSymbol } from '../../charts/textView.tsx';
import type { ComputerReport } from '../../core/control/sampled/computerReport.ts';
import type { LqrControl } from '../../core/scenario/types.ts';
import { useUi } from '../../ui/context.ts';
import { formatShort } from '../../ui/kit/format.ts';
import { ActuatorFields, SensorFields } from './lqrDevices.tsx';
import { ProgramField } from './lqrProgram.tsx';
import { Margins } from './lqrMargins.tsx';
import { NumberField } from '../../ui/kit/numberField.tsx';
import { numberOf } from '../../ui/kit/useNumberField.ts';
import { useRestedRegulator } from './useRestedRegulator.ts';
import { lqrWords as words } from './lqrWords.ts';

interface Props {
  control: LqrControl;
  change(part: Partial<LqrControl>): void;
}

export function ComputerFields({ control, change }: Props) {
  const { design, sample } = control;
  const field = (key: 'sample' | 'delay', symbol: string, commit: (value: number) => void) => (
    <NumberField
      symbol={<MathSymbol of={symbol} />}
      testId={`lqr-${key}`}
      spec={{
        path: `control.${key}`,
        label: words[key],
        unit: 's',
        angle: false,
        numeric: true,
        min: 0,
        value: control[key] ?? 0,
        base: undefined,
        rest: 0,
        step: 0.001,
        commit: (value) => commit(numberOf(value, 0)),
      }}
    />
  );
  return (
    <fieldset class="group">
      <legend>{words.computer}</legend>
      {field('sample', 'h', (value) =>
        // Without a sample time nothing of a computer means anything.
        change(
          value > 0
            ? { sample: value }
            : {
                sample: undefined,
                delay: undefined,
                design: undefined,
                actuators: undefined,
                sensors: undefined,
                process: undefined,
                seed: undefined,
                path: undefined,
              },
        ),
      )}
      {sample ? field('delay', 'T', (value) => change({ delay: value })) : null}
      {sample ? (
        <label>
          {words.design}{' '}
          <select
            data-testid="lqr-design"
            value={design ?? 'continuous'}
            onChange={(event) => change({ design: event.currentTarget.value as 'continuous' | 'sampled' })}
          >
            {(['continuous', 'sampled'] as const).map((id) => (
              <option key={id} value={id}>
                {words.designs[id]}
              </option>
            ))}
          </select>
        </label>
      ) : null}
      {sample ? (
        <>
          <SensorFields control={control} change={change} />
          <ActuatorFields control={control} change={change} />
          <ProgramField control={control} change={change} />
        </>
      ) : null}
      <ComputerReadout />
    </fieldset>
  );
}

function ComputerReadout() {
  const { app } = useUi();
  const answer = useSignal<Answer<ComputerReport> | null>(null);
  useRestedRegulator((draft) => {
    void app.control.computer(draft, 'computer').then((found) => {
      if (found) answer.value = found;
    });
  });
  // What keeps the design from being had stands in the readout above.
  if (!answer.value?.ok) return null;
  const { margins, sampled, estimator } = answer.value.value;
  return (
    <div data-testid="lqr-computer" aria-live="polite">
      {margins && (
        <p class="hint">
          {words.needs(
            margins.sampleTime === null ? null : formatShort(1 / margins.sampleTime, 3),
            margins.delay === null ? null : formatShort(1000 * margins.delay, 3),
          )}
        </p>
      )}
      {sampled && sampled.spectralRadius >= 1 && (
        <p class="error" role="alert">
          {words.unstable(formatShort(sampled.spectralRadius, 3))}
        </p>
      )}
      {sampled && sampled.spectralRadius < 1 && <p class="hint">{words.stable}</p>}
      {margins && <Margins margins={margins} sampled={sampled} estimator={estimator} />}
    </div>
  );
}
