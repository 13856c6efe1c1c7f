import type { Checker } from './checker.ts';
import type { Actuator, Computer } from './types.ts';

/** What a controller's entries say of the computer that runs it: `sample`, `delay`, `design`, `actuators`. */

export const COMPUTER_KEYS = ['sample', 'delay', 'design', 'actuators', 'sensors', 'process', 'seed'] as const;

/** Shorter, a run would stop at every rounding of its time; longer, nothing is controlled. */
const LEAST_SAMPLE = 1e-5;
const MOST_SAMPLE = 100;
const MOST_DELAY = 100;
/** Past inputs that a sampled design may hold: its equation grows with them. */
const MOST_MEMORY = 40;

const NOT_YET = {
  sensors: 'runs measure every state exactly so far',
  process: 'there is no Kalman filter in a run so far',
  seed: 'nothing in a run is random so far',
} as const;

/** @param inputs what the controller drives @param limits `control.limits` */
export function checkComputer(
  c: Checker,
  control: ReadonlyMap<string, unknown>,
  inputs: readonly string[],
  limits: Readonly<Record<string, number>>,
): Computer {
  for (const key of ['sensors', 'process', 'seed'] as const)
    if (control.get(key) !== undefined) c.add(`control.${key}`, `is not carried out: ${NOT_YET[key]}; leave it out`);
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
    return {};
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
  };
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
      if (key === 'lag') {
        c.add(`${path}.lag`, 'is not carried out: held inputs act at once so far; leave it out');
        continue;
      }
      const checked = c.number(`${path}.${key}`, number, { above: 0 });
      if (checked !== undefined) actuator[key as keyof Actuator] = checked;
    }
    if (actuator.limit !== undefined && limits[name] !== undefined)
      c.add(`${path}.limit`, `is said by control.limits.${name} too; leave one of them out`);
    actuators[name] = actuator;
  }
  return actuators;
}
