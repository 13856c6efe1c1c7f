import { MOST_SWEEP_RUNS } from './sweepAxes.ts';
import { coordinateUnit, perSecond } from '../model/units.ts';
import { inputsOf } from '../model/inputs.ts';
import type { Scenario, ScenarioFile } from './types.ts';
import type { SystemMeta } from '../model/system.ts';

/** A number of a scenario that a sweep may vary. Paths joined by `+` take the same value. */
export interface SweepPath {
  path: string;
  group: 'parameters' | 'start' | 'control' | 'method' | 'time';
  label: string;
  unit: string;
  /** Kept in radians, typed and shown in degrees. */
  angle: boolean;
  /** What it is now, SI. */
  present: number;
}

/**
 * `count` numbers from `from` to `to`, both included.
 *
 * @param from the first
 * @param to the last
 * @param count whole, 2 or more
 * @param scale how they are spaced
 * @throws Error with words for a field
 */
export function spaced(from: number, to: number, count: number, scale: 'linear' | 'logarithmic'): number[] {
  if (!Number.isFinite(from) || !Number.isFinite(to)) throw new Error('from and to must be numbers');
  if (!Number.isInteger(count) || count < 2 || count > MOST_SWEEP_RUNS)
    throw new Error(`the number of values must be a whole number from 2 to ${MOST_SWEEP_RUNS}`);
  if (from === to) throw new Error('from and to must differ');
  if (scale === 'logarithmic' && !(from * to > 0)) throw new Error('a logarithmic range must not reach zero');
  const at = (share: number): number => (scale === 'linear' ? from + share * (to - from) : from * (to / from) ** share);
  return Array.from({ length: count }, (_, i) =>
    i === 0 ? from : i === count - 1 ? to : Number(at(i / (count - 1)).toPrecision(13)),
  );
}

/**
 * Everything in a scenario that a sweep may vary and that a run depends on, in the panel's order.
 *
 * @param meta of the system
 * @param file as written
 * @param checked the same, checked
 */
export function sweepPaths(meta: SystemMeta, file: ScenarioFile, checked: Scenario): SweepPath[] {
  return [
    ...parameterPaths(meta, checked),
    ...startPaths(meta, file, checked),
    ...controlPaths(meta, file, checked),
    ...methodPaths(checked),
  ];
}

function parameterPaths(meta: SystemMeta, checked: Scenario): SweepPath[] {
  return meta.parameters.map(({ name, label, unit, kind }) => ({
    path: `parameters.${name}`,
    group: 'parameters',
    label,
    unit: kind === 'angle' ? '°' : unit,
    angle: kind === 'angle',
    present: checked.parameters[name]!,
  }));
}

interface State {
  name: string;
  label: string;
  unit: string;
  angle: boolean;
  rest: number;
}

/** States by name; of first order the rates follow from them. */
function statesOf({ coordinates, order, speed }: SystemMeta): State[] {
  const positions = coordinates.map((c) => ({
    name: c.name,
    label: c.label,
    unit: coordinateUnit(c),
    angle: c.kind === 'angle',
    rest: c.rest ?? 0,
  }));
  const rates =
    order === 1
      ? []
      : positions.map(({ name, label, unit, angle }) => ({
          name: `${name}_dot`,
          label: `rate of ${label}`,
          unit: perSecond(unit),
          angle,
          rest: 0,
        }));
  return [
    ...positions,
    ...rates,
    ...(speed ? [{ name: speed.name, label: speed.label, unit: 'm/s', angle: false, rest: 0 }] : []),
  ];
}

function startPaths(meta: SystemMeta, file: ScenarioFile, checked: Scenario): SweepPath[] {
  const speed = meta.speed?.name;
  const saysSpeed = speed !== undefined && file.initial?.[speed] !== undefined;
  const [ahead, aside] = meta.speed?.along ?? [];
  return statesOf(meta)
    .filter(({ name }) => (saysSpeed ? name !== ahead && name !== aside : name !== speed))
    .map(({ rest, name, ...state }) => ({
      ...state,
      path: `initial.${name}`,
      group: 'start',
      present: presentState(meta, checked.initial, name, rest),
    }));
}

/** A speed is kept as its velocities. */
function presentState(meta: SystemMeta, states: Readonly<Record<string, unknown>>, name: string, rest: number): number {
  if (name === meta.speed?.name) return Math.hypot(...meta.speed.along.map((along) => Number(states[along] ?? 0)));
  return Number(states[name] ?? rest);
}

function controlPaths(meta: SystemMeta, file: ScenarioFile, { control }: Scenario): SweepPath[] {
  if (!control) return [];
  const path = (name: string, label: string, present: number, unit = '', angle = false): SweepPath => ({
    path: `control.${name}`,
    group: 'control',
    label,
    unit,
    angle,
    present,
  });
  const computer = control.sample
    ? [
        path('sample', 'sample time of the computer', control.sample, 's'),
        path('delay', 'delay of the computer', control.delay ?? 0, 's'),
        ...(control.type !== 'ride' && control.sensors
          ? [path('seed', 'seed of the sensors’ noise', control.seed ?? 0)]
          : []),
      ]
    : [];
  if (control.type === 'track')
    return [path('kp', 'proportional gain', control.kp), path('kd', 'derivative gain', control.kd), ...computer];
  if (control.type === 'ride')
    return [
      path('help', 'help of the stabilizing layer', control.help ?? 1),
      path('speed', 'speed that a start pushes up to', control.speed ?? 0, 'm/s'),
      ...computer,
    ];
  const states = statesOf(meta);
  const written = file.control?.type === 'lqr' ? file.control : undefined;
  const named = states.filter(({ name }) => written?.at?.[name] !== undefined);
  const both = named.filter(({ name }) => file.initial?.[name] !== undefined);
  const at = (name: string): number => presentState(meta, control.at ?? {}, name, 0);
  return [
    ...both.map(({ name, label, unit, angle }): SweepPath => ({
      path: `initial.${name}+control.at.${name}`,
      group: 'control',
      label: `${label}, at the start and the operating point`,
      unit,
      angle,
      present: at(name),
    })),
    ...named.map(({ name, label, unit, angle }) =>
      path(`at.${name}`, `${label} of the operating point`, at(name), unit, angle),
    ),
    ...states
      .filter(({ name }) => name !== meta.speed?.name)
      .map(({ name, label }) =>
        path(`Q.${name}`, `weight of ${label}`, Number(control.Q ? (control.Q[name] ?? 0) : 1)),
      ),
    ...inputsOf(meta)
      .filter(({ name }) => control.inputs.includes(name))
      .map(({ name, label }) => path(`R.${name}`, `weight of ${label}`, Number(control.R?.[name] ?? 1))),
    ...computer,
  ];
}

function methodPaths({ method, duration, outputStep }: Scenario): SweepPath[] {
  const path = (name: string, group: 'method' | 'time', label: string, unit: string, present: number): SweepPath => ({
    path: name,
    group,
    label,
    unit,
    angle: false,
    present,
  });
  return [
    path('method.rtol', 'method', 'relative tolerance', '', method.rtol),
    path('method.atol', 'method', 'absolute tolerance', '', method.atol),
    path('method.step', 'method', 'step (first step if adaptive)', 's', method.step ?? 0.001),
    path('method.maxStep', 'method', 'largest step', 's', method.maxStep ?? duration),
    path('duration', 'time', 'duration', 's', duration),
    path('outputStep', 'time', 'output step', 's', outputStep),
  ];
}
