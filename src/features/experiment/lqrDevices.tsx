/** What is between the computer and the vehicle, by fields: sensors, actuators; and the path that it follows. */
import { MathSymbol } from '../../charts/textView.tsx';
import { columnOf } from '../../core/motion/columns.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import type { Actuator, LqrControl, NumberOrExpression, Sensor } from '../../core/scenario/types.ts';
import { useUi } from '../../ui/context.ts';
import { NumberField } from '../../ui/kit/numberField.tsx';
import { formatShort } from '../../ui/kit/format.ts';
import { numberOf } from '../../ui/kit/useNumberField.ts';
import { deviceWords as words } from './deviceWords.ts';

interface Props {
  control: LqrControl;
  change(part: Partial<LqrControl>): void;
}

const SENSOR_KEYS = ['noise', 'density', 'resolution', 'bias', 'drift', 'follow'] as const;
const ACTUATOR_KEYS = ['limit', 'rate', 'lag', 'resolution'] as const;
/** What a sensor has when it is added. */
const FIRST: Sensor = { noise: 0.001 };

/** An expression of states with their symbols: α + α_fp. */
function Shown({ meta, text }: { meta: SystemMeta; text: string }) {
  const states = new Set(meta.coordinates.flatMap(({ name }) => [name, `${name}_dot`]));
  return (
    <>
      {text.split(/([A-Za-z_]\w*)/).map((part, i) => {
        if (!states.has(part)) return part;
        const { symbol, rate } = columnOf(meta, part);
        return <MathSymbol key={i} of={rate ? symbol.replace(/^./u, '$&\u0307') : symbol} />;
      })}
    </>
  );
}

/** What may be measured at a choice: states, and sums that have a name (a plate's own roll). */
function measurable(meta: SystemMeta): { text: string; label: string }[] {
  const sums = (meta.sums ?? []).flatMap(({ label, of }) =>
    ['', '_dot'].map((rate) => ({
      text: of.map((c) => c + rate).join(' + '),
      label: rate ? words.rateOf(label) : label,
    })),
  );
  const states = ['', '_dot'].flatMap((rate) =>
    meta.coordinates.map(({ name, label }) => ({ text: name + rate, label: rate ? words.rateOf(label) : label })),
  );
  return [...sums, ...states];
}

/** A record with one number changed; without it where it is empty. */
function withNumber<T extends object>(of: T, key: keyof T, value: NumberOrExpression | undefined): T {
  const { [key]: _, ...rest } = of;
  const number = value === undefined ? 0 : numberOf(value, 0);
  return (number === 0 ? rest : { ...rest, [key]: number }) as T;
}

function Numbers<K extends string>({
  path,
  keys,
  of,
  labels,
  testId,
  commit,
}: {
  path: string;
  keys: readonly K[];
  of: Partial<Record<K, number>>;
  labels: Record<K, string>;
  testId: string;
  commit: (next: Partial<Record<K, number>>) => void;
}) {
  return (
    <>
      {keys.map((key) => (
        <NumberField
          key={key}
          placeholder={words.none}
          testId={`${testId}-${key}`}
          spec={{
            path: `${path}.${key}`,
            label: labels[key],
            angle: false,
            numeric: true,
            optional: true,
            ...(key === 'bias' ? {} : { min: 0 }),
            value: of[key],
            base: undefined,
            commit: (value) => commit(withNumber(of, key, value)),
          }}
        />
      ))}
    </>
  );
}

export function SensorFields({ control, change }: Props) {
  const meta = useUi().system.value!.meta;
  const sensors = control.sensors ?? {};
  const put = (next: Record<string, Sensor>): void =>
    // A filter without sensors is none: what it expects of the process goes with them.
    change(
      Object.keys(next).length > 0 ? { sensors: next } : { sensors: undefined, process: undefined, seed: undefined },
    );
  const short = (sensor: Sensor): string => {
    const size = sensor.noise ?? sensor.density ?? sensor.resolution;
    const say = sensor.noise ? words.aSample : sensor.density ? words.aRootHertz : words.stepsOf;
    return size ? say(formatShort(size, 3)) : '';
  };
  return (
    <details class="group-fold" data-testid="lqr-sensors" open={Object.keys(sensors).length > 0}>
      <summary>{words.sensors}</summary>
      <p class="hint">{Object.keys(sensors).length > 0 ? words.sensorsNote : words.noSensors}</p>
      {Object.entries(sensors).map(([name, sensor]) => (
        <details key={name} class="device">
          <summary>
            <Shown meta={meta} text={name} /> <span class="hint">{short(sensor)}</span>
          </summary>
          <Numbers
            path={`control.sensors.${name}`}
            keys={SENSOR_KEYS}
            of={sensor}
            labels={words.sensor}
            testId={`sensor-${name}`}
            commit={(next) => put({ ...sensors, [name]: next })}
          />
          <button
            type="button"
            onClick={() => {
              const { [name]: _, ...rest } = sensors;
              put(rest);
            }}
          >
            {words.remove}
          </button>
        </details>
      ))}
      <label class="device-add">
        {words.add}{' '}
        <select
          data-testid="sensor-add"
          value=""
          onChange={({ currentTarget: select }) => {
            if (select.value) put({ ...sensors, [select.value]: FIRST });
            select.value = '';
          }}
        >
          <option value="">{words.choose}</option>
          {measurable(meta)
            .filter(({ text }) => !sensors[text])
            .map(({ text, label }) => (
              <option key={text} value={text}>
                {label}
              </option>
            ))}
        </select>
      </label>
    </details>
  );
}

export function ActuatorFields({ control, change }: Props) {
  const meta = useUi().system.value!.meta;
  const actuators = control.actuators ?? {};
  const labelOf = (name: string): string => meta.inputs.find((i) => i.name === name)?.label ?? name;
  const commit = (name: string, next: Actuator): void => {
    const all = Object.fromEntries(
      Object.entries({ ...actuators, [name]: next }).filter(([, of]) => Object.keys(of).length > 0),
    );
    change({ actuators: Object.keys(all).length > 0 ? all : undefined });
  };
  return (
    <details class="group-fold" data-testid="lqr-actuators" open={Object.keys(actuators).length > 0}>
      <summary>{words.actuators}</summary>
      {control.inputs.map((name) => (
        <details key={name} class="device">
          <summary>
            {labelOf(name)} <span class="hint">{actuators[name] ? '' : words.ideal}</span>
          </summary>
          <Numbers
            path={`control.actuators.${name}`}
            keys={ACTUATOR_KEYS}
            of={actuators[name] ?? {}}
            labels={words.actuator}
            testId={`actuator-${name}`}
            commit={(next) => commit(name, next)}
          />
        </details>
      ))}
    </details>
  );
}
