import { inputsOf } from '../model/inputs.ts';
import type { SystemMeta } from '../model/system.ts';
import { checkPath } from './path.ts';
import { Checker, kindOf } from './checker.ts';
import { checkComputer, COMPUTER_KEYS } from './computer.ts';
import {
  COLUMN_NAMES,
  DEFAULTS,
  EVENT_NAMES,
  FORMULATION_NAMES,
  LONGEST_DURATION,
  LONGEST_FILE,
  METHOD_NAMES,
  MOST_ROWS,
  MOST_SCHEDULED,
} from './defaults.ts';
import { heldOf } from './held.ts';
import { checkRide } from './ride.ts';
import { jsonFault, placeIn } from './json.ts';
import { descriptionIn, isOwn, ownId } from './own.ts';
import {
  ENGINE_NAMES,
  ScenarioError,
  type EngineId,
  type LqrControl,
  type MethodOptions,
  type NumberOrExpression,
  type Scenario,
  type SpeedSchedule,
  type TrackControl,
} from './types.ts';

type Metas = Readonly<Record<string, SystemMeta>>;

const KEYS = [
  'version',
  'system',
  'parameterSet',
  'parameters',
  'constraints',
  'hold',
  'release',
  'initial',
  'inputs',
  'control',
  'at',
  'method',
  'duration',
  'outputStep',
  'events',
  'columns',
] as const;

/**
 * A scenario with every default filled in and every constant a number (SI, radians).
 *
 * @param raw JSON as parsed
 * @param systems metas by id
 * @throws ScenarioError with the path of the first offending key and what would be right
 */
export function checkScenario(raw: unknown, systems: Metas): Scenario {
  const { scenario, errors } = check(raw, systems);
  for (const [path, message] of errors) throw new ScenarioError(path, message);
  return scenario!;
}

/**
 * Every error by path; empty when the scenario can run.
 *
 * @param raw JSON as parsed
 * @param systems metas by id
 */
export function collectScenarioErrors(raw: unknown, systems: Metas): Map<string, string> {
  return check(raw, systems).errors;
}

/**
 * Reads JSON text.
 *
 * @param text as written
 * @param systems metas by id
 * @throws ScenarioError, also for a syntax error, with its line and column
 */
export function parseScenario(text: string, systems: Metas): Scenario {
  if (text.length > LONGEST_FILE)
    throw new ScenarioError('', `${text.length} characters are more than a scenario's ${LONGEST_FILE}`);
  const plain = text.replace(/^\ufeff/, '');
  const fault = jsonFault(plain);
  if (fault) {
    const { line, column } = placeIn(plain, fault.position);
    throw new ScenarioError('', `not JSON: line ${line}, column ${column}: ${fault.message}`);
  }
  return checkScenario(JSON.parse(plain), systems);
}

function check(raw: unknown, systems: Metas): { scenario?: Scenario; errors: Map<string, string> } {
  const c = new Checker();
  if (typeof raw !== 'object' || raw === null || Array.isArray(raw)) {
    c.add('', `a scenario is an object with "version" and "system", not ${kindOf(raw)}`);
    return { errors: c.errors };
  }
  const file = new Map(c.entries('', raw, KEYS));
  if (file.get('version') !== 1)
    c.add(
      'version',
      file.has('version') ? `must be 1, not ${kindOf(file.get('version'))}` : 'is missing; it must be 1',
    );
  const id = systemId(c, file, systems);
  if (id === undefined) return { errors: c.errors };
  const scenario = checkSystem(c, file, id, systems[id]!);
  return { scenario, errors: c.errors };
}

/** By its id, or by its description, which has been read before (`core/systems/own.ts`). */
function systemId(c: Checker, file: ReadonlyMap<string, unknown>, systems: Metas): string | undefined {
  const system = file.get('system');
  const builtIn = Object.keys(systems).filter((id) => !isOwn(id));
  if (system === undefined)
    return c.add('system', `is missing; right would be ${builtIn.join(', ')}, or {"description": "…"}`);
  if (typeof system === 'string') return Object.hasOwn(systems, system) ? system : c.oneOf('system', system, builtIn);
  if (typeof system !== 'object' || system === null || Array.isArray(system))
    return c.add('system', `must be one of ${builtIn.join(', ')}, or {"description": "…"}, not ${kindOf(system)}`);
  c.entries('system', system, ['description']);
  const text = descriptionIn({ system });
  if (text === null) return c.add('system.description', 'must be the text of a description');
  const id = ownId(text);
  return Object.hasOwn(systems, id) ? id : c.add('system.description', 'has not been read');
}

function checkSystem(c: Checker, file: ReadonlyMap<string, unknown>, id: string, meta: SystemMeta): Scenario {
  const coordinates = meta.coordinates.map((q) => q.name);
  // Of first order, the rates follow from the state.
  const states = meta.order === 1 ? coordinates : [...coordinates, ...coordinates.map((name) => `${name}_dot`)];
  const points = meta.speed ? [...states, meta.speed.name] : states;
  const inputs = inputsOf(meta).map((i) => i.name);
  const set =
    file.get('parameterSet') === undefined
      ? null
      : (c.oneOf('parameterSet', file.get('parameterSet'), Object.keys(meta.parameterSets)) ?? null);
  const sets = meta.constraintSets.map((s) => s.id);
  const constraints =
    file.get('constraints') === undefined
      ? sets[0]!
      : (c.oneOf('constraints', file.get('constraints'), sets) ?? sets[0]!);
  const duration = optional(c, file, 'duration', { above: 0, most: LONGEST_DURATION }) ?? DEFAULTS.duration;
  const outputStep = optional(c, file, 'outputStep', { above: 0 }) ?? DEFAULTS.outputStep;
  if (duration / outputStep > MOST_ROWS)
    c.add(
      'outputStep',
      `${duration} s in steps of ${outputStep} s are more than ${MOST_ROWS} rows; take a larger step`,
    );
  const events: Scenario['events'] = {};
  for (const [name, action] of c.entries('events', file.get('events'), [
    ...EVENT_NAMES,
    ...(meta.events ?? []).map((event) => event.id),
  ])) {
    const known = c.oneOf(`events.${name}`, action, ['stop', 'ignore']);
    if (known) events[name] = known as 'stop' | 'ignore';
  }
  const parameters = checkParameters(c, file.get('parameters'), meta, set);
  const holding = checkHeld(c, file, meta, coordinates);
  checkParts(c, parameters, meta, holding.hold);
  return {
    version: 1,
    system: id,
    ...(meta.description === undefined ? {} : { description: meta.description }),
    parameterSet: set,
    parameters,
    constraints,
    ...holding,
    initial: statesOf(c, 'initial', file.get('initial'), meta, points),
    inputs: expressions(c, 'inputs', file.get('inputs'), inputs),
    control: checkControl(c, file.get('control'), meta, { states, points, inputs, hold: holding.hold }),
    at: statesOf(c, 'at', file.get('at'), meta, points),
    method: checkMethod(c, file.get('method')),
    duration,
    outputStep,
    events,
    columns: c.names('columns', file.get('columns'), COLUMN_NAMES),
  };
}

/** Held coordinates, those by default among them; `release` stays where there is one, so that it reads the same again. */
function checkHeld(
  c: Checker,
  file: ReadonlyMap<string, unknown>,
  meta: SystemMeta,
  coordinates: readonly string[],
): Pick<Scenario, 'hold' | 'release'> {
  const { held = [] } = meta;
  const raw = file.get('release');
  if (raw !== undefined && held.length === 0)
    c.add('release', `${meta.id} holds nothing by default: leave it out, and name in "hold" what stays where it is`);
  const release = held.length > 0 ? c.names('release', raw, held) : [];
  const hold = file.get('hold') === undefined ? undefined : c.names('hold', file.get('hold'), coordinates);
  release.forEach((name, i) => {
    if (hold?.includes(name)) c.add(`release[${i}]`, `"${name}" is in "hold" too; leave it out of one of them`);
  });
  return { hold: heldOf(meta, { hold, release }), ...(release.length > 0 ? { release } : {}) };
}

function optional(
  c: Checker,
  file: ReadonlyMap<string, unknown>,
  key: string,
  rule: Parameters<Checker['number']>[2],
): number | undefined {
  return file.get(key) === undefined ? undefined : c.number(key, file.get(key), rule);
}

function constants(c: Checker, path: string, raw: unknown, known: readonly string[]): Record<string, number> {
  const result: Record<string, number> = {};
  for (const [name, value] of c.entries(path, raw, known)) {
    const number = c.constant(`${path}.${name}`, value);
    if (number !== undefined) result[name] = number;
  }
  return result;
}

/** States by name; a speed is said in velocities. */
function statesOf(
  c: Checker,
  path: string,
  raw: unknown,
  { speed }: SystemMeta,
  known: readonly string[],
): Record<string, number> {
  const named = constants(c, path, raw, known);
  const value = speed && named[speed.name];
  if (!speed || value === undefined) return named;
  const { [speed.name]: _, ...states } = named;
  const [ahead, aside] = speed.along;
  for (const name of speed.along)
    if (states[name] !== undefined) c.add(`${path}.${name}`, `is said by "${speed.name}" too; leave one of them out`);
  const heading = states[speed.heading] ?? 0;
  return { ...states, [ahead]: value * Math.cos(heading), [aside]: value * Math.sin(heading) };
}

function expressions(
  c: Checker,
  path: string,
  raw: unknown,
  known: readonly string[],
): Record<string, NumberOrExpression> {
  const result: Record<string, NumberOrExpression> = {};
  for (const [name, value] of c.entries(path, raw, known)) {
    if (c.expression(`${path}.${name}`, value, ['t'])) result[name] = value as NumberOrExpression;
  }
  return result;
}

function checkParameters(c: Checker, raw: unknown, meta: SystemMeta, set: string | null): Record<string, number> {
  const values = Object.fromEntries(meta.parameters.map((p) => [p.name, p.default]));
  Object.assign(values, set === null ? {} : meta.parameterSets[set]);
  const named = constants(
    c,
    'parameters',
    raw,
    meta.parameters.map((p) => p.name),
  );
  for (const p of meta.parameters) {
    const value = named[p.name];
    if (value === undefined) continue;
    const rule = {
      ...(p.positive ? { above: 0 } : {}),
      ...(p.min === undefined ? {} : { least: p.min }),
      ...(p.max === undefined ? {} : { most: p.max }),
    };
    if (c.number(`parameters.${p.name}`, value, rule) !== undefined) values[p.name] = value;
  }
  return values;
}

/** A part of a body is no more than the whole where it moves against the rest. */
function checkParts(
  c: Checker,
  values: Readonly<Record<string, number>>,
  meta: SystemMeta,
  hold: readonly string[],
): void {
  for (const { name, unit, partOf } of meta.parameters) {
    if (!partOf || hold.includes(partOf.free) || values[name]! <= values[partOf.parameter]!) continue;
    const most = `${partOf.parameter} (${values[partOf.parameter]} ${unit})`;
    c.add(
      `parameters.${name}`,
      `${values[name]} ${unit} is more than ${most}, a part of which it is while ${partOf.free} is free`,
    );
  }
}

function checkMethod(c: Checker, raw: unknown): MethodOptions {
  const method = new Map(
    c.entries('method', raw, [
      'name',
      'formulation',
      'rtol',
      'atol',
      'step',
      'maxStep',
      'stages',
      'projection',
      'engine',
    ]),
  );
  const number = (key: string, rule: Parameters<Checker['number']>[2]): number | undefined =>
    method.get(key) === undefined ? undefined : c.number(`method.${key}`, method.get(key), rule);
  const name = (key: string, known: readonly string[], byDefault: string): string =>
    method.get(key) === undefined ? byDefault : (c.oneOf(`method.${key}`, method.get(key), known) ?? byDefault);
  const projection = method.get('projection') ?? true;
  if (typeof projection !== 'boolean') c.add('method.projection', `must be true or false, not ${kindOf(projection)}`);
  const [step, maxStep, stages] = [
    number('step', { above: 0 }),
    number('maxStep', { above: 0 }),
    number('stages', { least: 1, most: 4, integer: true }),
  ];
  const methodName = name('name', METHOD_NAMES, DEFAULTS.method);
  const formulation = name('formulation', FORMULATION_NAMES, DEFAULTS.formulation);
  const engine =
    method.get('engine') === undefined ? undefined : c.oneOf('method.engine', method.get('engine'), ENGINE_NAMES);
  const residual = methodName === 'ida';
  if (residual && method.get('formulation') !== undefined)
    c.add('method.formulation', 'is for every method but ida, which takes the residual as it is; leave it out');
  return {
    name: methodName,
    ...(residual ? {} : { formulation }),
    rtol: number('rtol', { above: 0, most: 1 }) ?? DEFAULTS.rtol,
    atol: number('atol', { above: 0 }) ?? DEFAULTS.atol,
    projection: projection === true,
    ...(step === undefined ? {} : { step }),
    ...(maxStep === undefined ? {} : { maxStep }),
    ...(stages === undefined ? {} : { stages }),
    ...(engine === undefined ? {} : { engine: engine as EngineId }),
  };
}

/** Names a controller may use. */
interface Names {
  states: readonly string[];
  /** States, and what else an operating point may be given by. */
  points: readonly string[];
  inputs: readonly string[];
  /** Coordinates that are held. */
  hold: readonly string[];
}

const CONTROL_KEYS: Readonly<Record<string, readonly string[]>> = {
  lqr: ['type', 'inputs', 'at', 'Q', 'R', 'limits', 'schedule', 'path', ...COMPUTER_KEYS],
  track: ['type', 'reference', 'kp', 'kd', 'limits', ...COMPUTER_KEYS.filter((key) => key !== 'design')],
  ride: ['type', 'commands', 'help', 'speed', 'limits', 'sample', 'delay', 'actuators'],
};

function checkControl(c: Checker, raw: unknown, meta: SystemMeta, names: Names): Scenario['control'] {
  if (raw === undefined || raw === null) return null;
  const all = new Map(c.entries('control', raw));
  if (c.errors.has('control')) return null;
  const type = c.oneOf('control.type', all.get('type'), ['lqr', 'track', 'ride']);
  if (type === undefined) return null;
  const control = new Map(c.entries('control', raw, CONTROL_KEYS[type]));
  const limits = constants(c, 'control.limits', control.get('limits'), names.inputs);
  for (const [name, value] of Object.entries(limits)) c.number(`control.limits.${name}`, value, { above: 0 });
  if (type === 'ride') return checkRide(c, control, meta, names.inputs, limits, names.hold);
  return type === 'lqr' ? checkLqr(c, control, meta, names, limits) : checkTrack(c, control, meta, limits);
}

function checkLqr(
  c: Checker,
  control: ReadonlyMap<string, unknown>,
  meta: SystemMeta,
  { states, points, inputs }: Names,
  limits: Record<string, number>,
): LqrControl {
  const names = c.names('control.inputs', control.get('inputs'), inputs);
  if (names.length === 0)
    c.add('control.inputs', `name at least one input; there are ${inputs.slice(0, 12).join(', ')}`);
  const Q = constants(c, 'control.Q', control.get('Q'), states);
  const R = constants(c, 'control.R', control.get('R'), names);
  for (const [name, value] of Object.entries(Q)) c.number(`control.Q.${name}`, value, { least: 0 });
  for (const [name, value] of Object.entries(R)) c.number(`control.R.${name}`, value, { above: 0 });
  return {
    type: 'lqr',
    inputs: names,
    at: statesOf(c, 'control.at', control.get('at'), meta, points),
    ...(control.get('Q') === undefined ? {} : { Q }),
    R,
    limits,
    ...(control.get('schedule') === undefined ? {} : { schedule: checkSchedule(c, control.get('schedule'), meta) }),
    ...(control.get('path') === undefined ? {} : { path: followedPath(c, control, meta) }),
    ...checkComputer(c, control, names, limits, states),
  };
}

/** A path goes with a computer, and with no schedule: its regulators follow the path's curvature. */
function followedPath(c: Checker, control: ReadonlyMap<string, unknown>, meta: SystemMeta): LqrControl['path'] {
  if (!control.get('sample')) c.add('control.path', 'is followed by a computer: give control.sample (s) too');
  if (control.get('schedule') !== undefined)
    c.add(
      'control.schedule',
      `can't go with control.path, whose regulators are about turns, not about control.at; leave one of them out`,
    );
  return checkPath(c, control.get('path'), meta);
}

function checkSchedule(c: Checker, raw: unknown, meta: SystemMeta): SpeedSchedule {
  const path = 'control.schedule';
  if (!(meta.forward ?? meta.speed))
    c.add(path, `${meta.id} has no forward speed to schedule gains over; leave it out`);
  const given = new Map(c.entries(path, raw, ['from', 'to', 'count']));
  const from = c.number(`${path}.from`, given.get('from'), { above: 0 }) ?? 1;
  const to = c.number(`${path}.to`, given.get('to'), { above: from }) ?? from;
  const count =
    given.get('count') === undefined
      ? DEFAULTS.scheduled
      : c.number(`${path}.count`, given.get('count'), { least: 2, most: MOST_SCHEDULED, integer: true });
  return { from, to, count: count ?? DEFAULTS.scheduled };
}

function checkTrack(
  c: Checker,
  control: ReadonlyMap<string, unknown>,
  meta: SystemMeta,
  limits: Record<string, number>,
): TrackControl {
  const followers = meta.inputs.filter((i) => i.tracks).map((i) => i.name);
  const reference = expressions(c, 'control.reference', control.get('reference'), followers);
  if (control.get('reference') === undefined)
    c.add('control.reference', `is missing; it names what an input follows, by ${followers.join(', ')}`);
  const gain = (key: 'kp' | 'kd'): number => c.number(`control.${key}`, control.get(key), { least: 0 }) ?? 0;
  return {
    type: 'track',
    reference,
    kp: gain('kp'),
    kd: gain('kd'),
    limits,
    ...checkComputer(c, control, Object.keys(reference), limits, null),
  };
}
