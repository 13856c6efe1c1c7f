/**
 * What every export starts from: the description of a scenario's system with its numbers, and states at which the program's
 * own equations say what comes out, so that whoever takes the export can check it.
 */
import { readSystem } from '../description/index.ts';
import { MOST_NODES } from '../description/graph.ts';
import type { Model, SetModel } from '../description/model.ts';
import { templates } from '../description/templates.ts';
import { ConstrainedSystem } from '../mechanics/constrainedSystem.ts';
import type { Forcing } from '../mechanics/forcing.ts';
import type { System } from '../model/system.ts';
import { ScenarioError, type Scenario } from '../scenario/types.ts';
import { Simulation } from '../simulation/simulation.ts';

/** One state with what the program computes there. Lengths: n, n, inputs, n, rows of the constraints. */
export interface TestVector {
  what: string;
  q: Float64Array;
  v: Float64Array;
  /** Inputs in the order of the description. */
  u: Float64Array;
  acceleration: Float64Array;
  lambda: Float64Array;
}

export interface Source {
  model: Model;
  /** A word that every language takes as a name. */
  id: string;
  /** Parameters in the order of the description. */
  p: Float64Array;
  /** The constraint set; null where the motion is free. */
  set: SetModel | null;
  /** Coordinates that do not move: indices. */
  held: readonly number[];
  /** The state in which the scenario starts. */
  q: Float64Array;
  v: Float64Array;
  tests: readonly TestVector[];
}

/** Any: the file has to be the same every time. */
const SEED = 20171207;
/** How far the second test state lies from the start: generic, and short of what a description may exclude. */
const AWAY = 0.3;

/**
 * Reads the description that says the same as the scenario's system, and computes the test vectors.
 *
 * @param scenario checked
 * @param system that the scenario names
 * @throws ScenarioError where there is nothing to export
 */
export async function sourceOf(scenario: Scenario, system: System): Promise<Source> {
  const model = await modelOf(scenario);
  model.graph.most = MOST_NODES;
  const { coordinates, constraintSets } = system.meta;
  const names = model.coordinates.map(({ name }) => name);
  if (names.join() !== coordinates.map(({ name }) => name).join())
    throw new ScenarioError('system', `the description of ${scenario.system} has other coordinates than the system`);
  const p = Float64Array.from(model.parameters, ({ name }) => scenario.parameters[name]!);
  const start = new Simulation({ ...scenario, control: null, inputs: {} }, system);
  const held = [
    ...new Set([
      ...scenario.hold.map((name) => names.indexOf(name)),
      ...(model.clock === null || !model.mechanical ? [] : [model.clock]),
    ]),
  ];
  const bound = constraintSets.some(({ id, rows }) => id === scenario.constraints && (rows ?? 0) > 0);
  const set = bound ? (model.sets.find(({ id }) => id === scenario.constraints) ?? null) : null;
  const source = { model, id: nameOf(system), p, set, held, q: start.q.slice(), v: start.v.slice() };
  return { ...source, tests: testVectors(source, scenario, system) };
}

async function modelOf(scenario: Scenario): Promise<Model> {
  const template = templates.find(({ id }) => id === scenario.system);
  const text = scenario.description ?? (template && (await template.load()).default);
  if (text === undefined) throw new ScenarioError('system', `there is no description of ${scenario.system}`);
  const { model, faults } = readSystem(text);
  if (!model) throw new ScenarioError('system.description', faults[0]!.message);
  return model;
}

/** `ripstik_rider`; of an own system its title's letters. */
function nameOf({ meta }: System): string {
  const words = meta.description === undefined ? meta.id : meta.title;
  const name = words
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '_')
    .replace(/^_+|_+$/g, '')
    .slice(0, 40);
  return /^[a-z]/.test(name) ? name : `system_${name || 'own'}`;
}

/**
 * A linear congruential generator (Press et al., Numerical Recipes, 3rd ed., section 7.1.1), so that the same scenario always
 * gives the same file.
 */
function numbers(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    // Three decimals: a person can copy them.
    return Math.round((state / 2 ** 32) * 2000 - 1000) / 1000;
  };
}

function testVectors({ model, held, q, v }: Omit<Source, 'tests'>, scenario: Scenario, system: System): TestVector[] {
  const n = q.length;
  const p = Float64Array.from(system.meta.parameters, ({ name }) => scenario.parameters[name]!);
  const draw = numbers(SEED);
  const fixed = new Set(held);
  const away = {
    q: q.map((x, i) => x + (fixed.has(i) ? 0 : AWAY * draw())),
    v: v.map((x, i) => x + (fixed.has(i) ? 0 : draw())),
    u: Float64Array.from(model.inputs, draw),
  };
  const states = [
    { what: 'at the start, without inputs', q, v, u: new Float64Array(model.inputs.length) },
    { what: 'elsewhere, moving, with every input', ...away },
  ];
  return states.flatMap((state) => {
    const result = { acceleration: new Float64Array(n), lambda: new Float64Array(0) };
    if (system.firstOrder) {
      system.firstOrder.rate(state.q, p, result.acceleration);
      return [{ ...state, v: new Float64Array(n), ...result }];
    }
    const dynamics = new ConstrainedSystem(system, p, scenario.constraints, held, inputsAs(model, state.u));
    const lambda = new Float64Array(dynamics.m);
    // Where the constraints are singular there is nothing to compare with.
    if (!dynamics.acceleration(0, state.q, state.v, result.acceleration, lambda)) return [];
    return [{ ...state, ...result, lambda }];
  });
}

function inputsAs(model: Model, u: Float64Array): Forcing {
  const places = new Map(model.coordinates.map(({ name }, i) => [name, i]));
  return (_t, _q, _v, force) => {
    model.inputs.forEach(({ column }, k) => {
      for (const [name, weight] of Object.entries(column)) force[places.get(name)!]! += weight * u[k]!;
    });
  };
}
