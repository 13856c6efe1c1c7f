import { compileExpression } from '../scenario/expressions.ts';
import { ScenarioError, type Scenario, type TrackControl } from '../scenario/types.ts';
import type { InputMeta, SystemMeta } from '../systems/types.ts';
import type { Forcing } from './constrainedSystem.ts';

/** All inputs a scenario drives: their names, and the forces and values at a moment. */
export interface Actuation {
  /** The system's named inputs, then raw forces that are driven; in the order of their values. */
  readonly names: readonly string[];
  /** Adds B u onto `force`. */
  readonly forcing: Forcing | null;
  /** u at a moment, into `out` (one per name). */
  values(t: number, q: Float64Array, v: Float64Array, out: Float64Array): void;
}

/** Value of one input at a moment. */
type Signal = (t: number, q: Float64Array, v: Float64Array) => number;

/** The named inputs of a system and a raw generalized force `f_<coordinate>` on each coordinate (spec, section 3). */
export function inputsOf(meta: SystemMeta): InputMeta[] {
  const raw = meta.coordinates
    .filter((c) => !meta.inputs.some((i) => i.name === `f_${c.name}`))
    .map((c) => ({
      name: `f_${c.name}`,
      symbol: `f_${c.name}`,
      label: `generalized force on ${c.name}`,
      unit: c.kind === 'angle' ? 'N·m' : 'N',
      column: { [c.name]: 1 },
    }));
  return [...meta.inputs, ...raw];
}

/**
 * Binds a scenario's open-loop inputs and controller.
 * @throws ScenarioError for a controller that can't be had
 */
export function actuationOf(scenario: Scenario, meta: SystemMeta): Actuation {
  const control = scenario.control;
  if (control?.type === 'lqr') {
    throw new ScenarioError('control.type', '"lqr" is not available in this version; "track" is, or leave control out');
  }
  const parts: { input: InputMeta; signal: Signal | null }[] = [];
  for (const input of inputsOf(meta)) {
    const signal = total(openLoop(scenario, input), control ? tracking(control, input, meta) : null);
    // The named inputs are always there, so that a file of a run with inputs has the same columns for every run.
    if (signal || meta.inputs.includes(input)) parts.push({ input, signal });
  }
  const columns = parts.map(({ input }) =>
    Object.entries(input.column).map(([name, weight]) => ({ index: meta.coordinates.findIndex((c) => c.name === name), weight })),
  );
  const values = (t: number, q: Float64Array, v: Float64Array, out: Float64Array): void => {
    for (let i = 0; i < parts.length; i++) out[i] = parts[i]!.signal?.(t, q, v) ?? 0;
  };
  const driven = [...parts.keys()].filter((i) => parts[i]!.signal);
  const forcing: Forcing = (t, q, v, force) => {
    for (const i of driven) {
      const u = parts[i]!.signal!(t, q, v);
      const column = columns[i]!;
      for (let k = 0; k < column.length; k++) force[column[k]!.index]! += column[k]!.weight * u;
    }
  };
  return { names: parts.map((p) => p.input.name), forcing: driven.length > 0 ? forcing : null, values };
}

function total(open: Signal | null, closed: Signal | null): Signal | null {
  return open && closed ? (t, q, v) => open(t, q, v) + closed(t, q, v) : (open ?? closed);
}

function openLoop(scenario: Scenario, input: InputMeta): Signal | null {
  const text = scenario.inputs[input.name];
  if (text === undefined) return null;
  const expression = compileExpression(text, { variables: ['t'] });
  return (t) => expression.evaluate(t);
}

/** PD on what the input tracks: -kp (sum q - r) - kd (sum v - r_dot), within the limit if there is one. */
function tracking(control: TrackControl, input: InputMeta, meta: SystemMeta): Signal | null {
  const text = control.reference[input.name];
  if (text === undefined || !input.tracks) return null;
  const reference = compileExpression(text, { variables: ['t'] });
  const index = input.tracks.map((name) => meta.coordinates.findIndex((c) => c.name === name));
  const { kp, kd } = control;
  const bound = control.limits?.[input.name];
  const limit = bound === undefined ? Infinity : compileExpression(bound, { variables: [] }).evaluate(0);
  return (t, q, v) => {
    let position = -reference.evaluate(t);
    let rate = -reference.derivative(t);
    for (let k = 0; k < index.length; k++) {
      position += q[index[k]!]!;
      rate += v[index[k]!]!;
    }
    return Math.max(-limit, Math.min(limit, -kp * position - kd * rate));
  };
}
