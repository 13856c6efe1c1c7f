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

/** One input as it goes: open loop, closed loop or both. */
interface Signal {
  value(t: number, q: Float64Array, v: Float64Array): number;
  /** What it reacts to; `sensitivity` tells how much. */
  tracked: readonly number[];
  /** Derivatives by each tracked position and by each tracked speed, into `out`. */
  sensitivity(t: number, q: Float64Array, v: Float64Array, out: [number, number]): void;
}

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
    for (let i = 0; i < parts.length; i++) out[i] = parts[i]!.signal?.value(t, q, v) ?? 0;
  };
  const driven = [...parts.keys()].filter((i) => parts[i]!.signal);
  const forcing: Forcing = (t, q, v, force) => {
    for (const i of driven) {
      const u = parts[i]!.signal!.value(t, q, v);
      const column = columns[i]!;
      for (let k = 0; k < column.length; k++) force[column[k]!.index]! += column[k]!.weight * u;
    }
  };
  const slopes: [number, number] = [0, 0];
  const n = meta.coordinates.length;
  forcing.jacobians = (t, q, v, forceQ, forceV) => {
    for (const i of driven) {
      const { tracked, sensitivity } = parts[i]!.signal!;
      if (tracked.length === 0) continue;
      sensitivity(t, q, v, slopes);
      for (const { index, weight } of columns[i]!) {
        for (const k of tracked) {
          forceQ[index * n + k]! += weight * slopes[0];
          forceV[index * n + k]! += weight * slopes[1];
        }
      }
    }
  };
  return { names: parts.map((p) => p.input.name), forcing: driven.length > 0 ? forcing : null, values };
}

/** An open-loop signal adds to what the controller asks, and reacts to nothing. */
function total(open: Signal | null, closed: Signal | null): Signal | null {
  if (!open || !closed) return open ?? closed;
  return { ...closed, value: (t, q, v) => open.value(t, q, v) + closed.value(t, q, v) };
}

function openLoop(scenario: Scenario, input: InputMeta): Signal | null {
  const text = scenario.inputs[input.name];
  if (text === undefined) return null;
  const expression = compileExpression(text, { variables: ['t'] });
  return { value: (t) => expression.evaluate(t), tracked: [], sensitivity: () => {} };
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
  const asked = (t: number, q: Float64Array, v: Float64Array): number => {
    let position = -reference.evaluate(t);
    let rate = -reference.derivative(t);
    for (let k = 0; k < index.length; k++) {
      position += q[index[k]!]!;
      rate += v[index[k]!]!;
    }
    return -kp * position - kd * rate;
  };
  return {
    value: (t, q, v) => Math.max(-limit, Math.min(limit, asked(t, q, v))),
    tracked: index,
    sensitivity: (t, q, v, out) => {
      // At its limit the controller no longer reacts.
      const reacts = Math.abs(asked(t, q, v)) < limit;
      out[0] = reacts ? -kp : 0;
      out[1] = reacts ? -kd : 0;
    },
  };
}
