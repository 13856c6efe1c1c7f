import type { Checker } from './checker.ts';
import { formulaTree } from './expressions.ts';
import type { Actuator, Computer, Sensor } from './types.ts';

/** What a controller's entries say of the computer that runs it: `sample`, `delay`, `design`, `actuators`, `sensors`. */

export const COMPUTER_KEYS = ['sample', 'delay', 'design', 'actuators', 'sensors', 'process', 'seed'] as const;

/** Shorter, a run would stop at every rounding of its time; longer, nothing is controlled. */
const LEAST_SAMPLE = 1e-5;
const MOST_SAMPLE = 100;
const MOST_DELAY = 100;
/** Past inputs that a sampled design may hold: its equation grows with them. */
export const MOST_MEMORY = 100;

const MOST_SENSORS = 100;
/** Seeds are whole numbers of 32 bits. */
const MOST_SEED = 2 ** 32 - 1;

/**
 * @param c collects the errors
 * @param control entries as written, by key
 * @param inputs what the controller drives
 * @param limits `control.limits`
 * @param states names; null where the controller has no model to estimate them by
 */
export function checkComputer(
  c: Checker,
  control: ReadonlyMap<string, unknown>,
  inputs: readonly string[],
  limits: Readonly<Record<string, number>>,
  states: readonly string[] | null,
): Computer {
  const sample = numberOf(c, control, 'sample', MOST_SAMPLE);
  const delay = numberOf(c, control, 'delay', MOST_DELAY);
  const design =
    control.get('design') === undefined
      ? undefined
      : c.oneOf('control.design', control.get('design'), ['continuous', 'sampled']);
  if (sample !== undefined && sample !== 0 && sample < LEAST_SAMPLE)
    c.add('control.sample', `must be 0 (continuous) or at least ${LEAST_SAMPLE} s, not ${sample}`);
  const needsSample = (key: string): undefined =>
    c.add(`control.${key}`, 'is for a controller that a computer runs: give control.sample (s) too, or leave it out');
  if (!sample) {
    if (delay) needsSample('delay');
    if (design === 'sampled') needsSample('design');
    if (control.get('actuators') !== undefined) needsSample('actuators');
    return checkSensors(c, control, states, false);
  }
  if (design === 'sampled' && control.get('schedule') !== undefined)
    c.add(
      'control.design',
      'must be "continuous" with a schedule, whose gains are designed so; or leave the schedule out',
    );
  if (design === 'sampled' && (delay ?? 0) > MOST_MEMORY * sample)
    c.add('control.delay', `must be at most ${MOST_MEMORY} samples for a sampled design, not ${delay} s`);
  return {
    sample,
    ...(delay ? { delay } : {}),
    ...(design === 'sampled' ? { design } : {}),
    ...(control.get('actuators') !== undefined
      ? { actuators: checkActuators(c, control.get('actuators'), inputs, limits) }
      : {}),
    ...checkSensors(c, control, states, true),
  };
}

/** What a Kalman filter is made of: `sensors`, `process`, `seed`. */
function checkSensors(
  c: Checker,
  control: ReadonlyMap<string, unknown>,
  states: readonly string[] | null,
  sampled: boolean,
): Pick<Computer, 'sensors' | 'process' | 'seed'> {
  const raw = control.get('sensors');
  if (raw === undefined) {
    for (const key of ['process', 'seed'])
      if (control.get(key) !== undefined)
        c.add(`control.${key}`, 'is for a controller with sensors: give control.sensors too, or leave it out');
    return {};
  }
  if (!states || control.get('schedule') !== undefined) {
    c.add(
      'control.sensors',
      'are for an lqr without a schedule, whose one model a Kalman filter estimates by; leave them out',
    );
    return {};
  }
  const entries = c.entries('control.sensors', raw);
  if (entries.length === 0 && !c.errors.has('control.sensors'))
    c.add('control.sensors', `name at least one state or expression of states, as "${states[0]!}"`);
  if (entries.length > MOST_SENSORS) c.add('control.sensors', `must be at most ${MOST_SENSORS}, not ${entries.length}`);
  const sensors = Object.fromEntries(
    entries.slice(0, MOST_SENSORS).map(([name, value]) => [name, checkSensor(c, name, value, states, sampled)]),
  );
  const process = control.get('process');
  const seed = control.get('seed');
  const checkedSeed =
    seed === undefined ? undefined : c.number('control.seed', seed, { least: 0, most: MOST_SEED, integer: true });
  return {
    sensors,
    ...(process === undefined ? {} : { process: checkProcess(c, process, states) }),
    ...(checkedSeed === undefined ? {} : { seed: checkedSeed }),
  };
}

function checkSensor(c: Checker, name: string, raw: unknown, states: readonly string[], sampled: boolean): Sensor {
  const path = `control.sensors.${name}`;
  try {
    if (formulaTree(name, states).constant) c.add(path, 'measures no state; name one, or an expression of states');
  } catch (error) {
    c.add(path, (error as Error).message);
  }
  const sensor: Sensor = {};
  for (const [key, value] of c.entries(path, raw, ['noise', 'density', 'resolution', 'bias', 'drift', 'follow'])) {
    const checked = c.number(`${path}.${key}`, value, key === 'bias' ? {} : { least: 0 });
    if (checked) sensor[key as keyof Sensor] = checked;
  }
  if (sensor.noise && sensor.density) c.add(`${path}.density`, 'says again what noise says; leave one of them out');
  else if (!sampled && !sensor.density)
    c.add(path, 'needs a density above 0 (per √Hz) for a continuous filter; or give control.sample');
  else if (!sensor.noise && !sensor.density && !sensor.resolution)
    c.add(path, 'needs noise (per sample), a density (per √Hz) or a resolution above 0: no sensor is exact');
  return sensor;
}

function checkProcess(c: Checker, raw: unknown, states: readonly string[]): Record<string, number> {
  const process: Record<string, number> = {};
  for (const [name, value] of c.entries('control.process', raw, states)) {
    const checked = c.number(`control.process.${name}`, value, { least: 0 });
    if (checked !== undefined) process[name] = checked;
  }
  return process;
}

function numberOf(c: Checker, control: ReadonlyMap<string, unknown>, key: string, most: number): number | undefined {
  return control.get(key) === undefined ? undefined : c.number(`control.${key}`, control.get(key), { least: 0, most });
}

function checkActuators(
  c: Checker,
  raw: unknown,
  inputs: readonly string[],
  limits: Readonly<Record<string, number>>,
): Record<string, Actuator> {
  const actuators: Record<string, Actuator> = {};
  for (const [name, value] of c.entries('control.actuators', raw, inputs)) {
    const path = `control.actuators.${name}`;
    const actuator: Actuator = {};
    for (const [key, number] of c.entries(path, value, ['limit', 'rate', 'lag', 'resolution'])) {
      const checked = c.number(`${path}.${key}`, number, { above: 0 });
      if (checked !== undefined) actuator[key as keyof Actuator] = checked;
    }
    if (actuator.limit !== undefined && limits[name] !== undefined)
      c.add(`${path}.limit`, `is said by control.limits.${name} too; leave one of them out`);
    actuators[name] = actuator;
  }
  return actuators;
}
