import { compileExpression } from '../scenario/expressions.ts';
import type { Scenario, TrackControl } from '../scenario/types.ts';
import type { InputMeta, SystemMeta } from '../model/system.ts';
import type { Feedback, Forcing } from '../mechanics/forcing.ts';
import { inputsOf } from '../model/inputs.ts';
import { HeldControl } from './heldControl.ts';
import { InputPlan, type PlanOptions } from './inputPlan.ts';
import { Saturation } from './saturation.ts';

/** All inputs a scenario drives: their names, and the forces and values at a moment. */
export interface Actuation {
  /** The system's named inputs, then raw forces that are driven; in the order of their values. */
  readonly names: readonly string[];
  /** Adds B u onto `force`. */
  readonly forcing: Forcing | null;
  /** u at a moment, into `out` (one per name). */
  values(t: number, q: Float64Array, v: Float64Array, out: Float64Array): void;
  /** What is known of the inputs beforehand, for a run that steps by it; null where they are constant or none. */
  readonly plan: InputPlan | null;
  /** The computer that the controller runs on, whose inputs change only as its run does. */
  readonly held: HeldControl | null;
}

/** One input as it goes: open loop, closed loop or both; what does not react to the state has no slopes. */
type Signal = Pick<Saturation, 'value'> & Partial<Pick<Saturation, 'addSlopes'>>;

/**
 * Binds a scenario's open-loop inputs and controller.
 * With a plan, formulas keep what their switches decided for the stretch that the plan is in, and a controller the side of
 * its limit; without one everything is decided anew at every moment.
 *
 * @param scenario checked
 * @param meta of its system
 * @param feedback an lqr's state feedback by input; its design is no part of a run (`control/feedback.ts`)
 * @param planned formulas keep what their switches decided; null: they decide at every evaluation
 * @param computer the one to take in place of a new one, so that rows show what acts in the steps
 */
export function actuationOf(
  scenario: Scenario,
  meta: SystemMeta,
  feedback: ReadonlyMap<string, Feedback> | null = null,
  planned: PlanOptions | null = null,
  computer: HeldControl | null = null,
): Actuation {
  const { control } = scenario;
  if ((control?.type === 'lqr' || control?.type === 'ride') && !feedback)
    throw new Error('a scenario with an lqr or a ride needs its feedback: feedbackOf(scenario, system)');
  const plan = planned && new InputPlan(planned);
  const loops = control?.type === 'track' ? trackers(control, meta, plan) : (feedback ?? new Map<string, Feedback>());
  const held = computer ?? HeldControl.of(control, loops);
  if (plan) plan.held = held;
  const parts: { input: InputMeta; signal: Signal | null }[] = [];
  for (const input of inputsOf(meta)) {
    const loop = loops.get(input.name);
    const closed = loop ? closedLoop(input, loop, held, plan) : null;
    const signal = total(openLoop(scenario, input, plan), closed);
    // The named inputs are always there, so that a file of a run with inputs has the same columns for every run.
    if (signal || meta.inputs.includes(input)) parts.push({ input, signal });
  }
  const columns = parts.map(({ input }) =>
    Object.entries(input.column).map(([name, weight]) => ({
      index: meta.coordinates.findIndex((c) => c.name === name),
      weight,
    })),
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
  const n = meta.coordinates.length;
  const reacting = driven.filter((i) => parts[i]!.signal!.addSlopes);
  forcing.jacobians = (t, q, v, forceQ, forceV) => {
    for (const i of reacting) {
      const column = columns[i]!;
      for (let k = 0; k < column.length; k++) {
        parts[i]!.signal!.addSlopes!(t, q, v, column[k]!.weight, column[k]!.index * n, forceQ, forceV);
      }
    }
  };
  return {
    names: parts.map((p) => p.input.name),
    forcing: driven.length > 0 ? forcing : null,
    values,
    plan: plan?.idle === false ? plan : null,
    held,
  };
}

function closedLoop(input: InputMeta, loop: Feedback, held: HeldControl | null, plan: InputPlan | null): Signal {
  if (held) {
    const index = held.indexOf(input.name);
    return { value: (t) => held.value(index, t) };
  }
  const closed = new Saturation(loop);
  if (closed.limited) plan?.saturations.push(closed);
  return closed;
}

/** An open-loop signal adds to what the controller asks, and reacts to nothing. */
function total(open: Signal | null, closed: Signal | null): Signal | null {
  if (!open || !closed) return open ?? closed;
  const value: Signal['value'] = (t, q, v) => open.value(t, q, v) + closed.value(t, q, v);
  if (!closed.addSlopes) return { value };
  return {
    value,
    addSlopes: (t, q, v, weight, row, forceQ, forceV) => closed.addSlopes?.(t, q, v, weight, row, forceQ, forceV),
  };
}

function openLoop(scenario: Scenario, input: InputMeta, plan: InputPlan | null): Signal | null {
  const text = scenario.inputs[input.name];
  if (text === undefined) return null;
  const expression = compileExpression(text, { variables: ['t'] });
  const inside = plan?.add(expression, input.name, false);
  return { value: inside ? (t) => expression.evaluate(inside(t)) : (t) => expression.evaluate(t) };
}

function trackers(control: TrackControl, meta: SystemMeta, plan: InputPlan | null): Map<string, Feedback> {
  const found = inputsOf(meta).flatMap((input): [string, Feedback][] => {
    const feedback = tracking(control, input, meta, plan);
    return feedback ? [[input.name, feedback]] : [];
  });
  return new Map(found);
}

/** PD on what the input tracks: -kp (sum q - r) - kd (sum v - r_dot). */
function tracking(control: TrackControl, input: InputMeta, meta: SystemMeta, plan: InputPlan | null): Feedback | null {
  const text = control.reference[input.name];
  if (text === undefined || !input.tracks) return null;
  const reference = compileExpression(text, { variables: ['t'] });
  const inside = plan?.add(reference, input.name, true) ?? ((t: number) => t);
  const index = input.tracks.map((name) => meta.coordinates.findIndex((c) => c.name === name));
  const { kp, kd } = control;
  const bound = control.limits?.[input.name];
  return {
    limit: bound === undefined ? Infinity : compileExpression(bound, { variables: [] }).evaluate(0),
    asked(t, q, v) {
      const at = inside(t);
      let position = -reference.evaluate(at);
      let rate = -reference.derivative(at);
      for (let k = 0; k < index.length; k++) {
        position += q[index[k]!]!;
        rate += v[index[k]!]!;
      }
      return -kp * position - kd * rate;
    },
    addSlopes(_t, _q, _v, weight, row, forceQ, forceV) {
      for (let k = 0; k < index.length; k++) {
        forceQ[row + index[k]!]! -= weight * kp;
        forceV[row + index[k]!]! -= weight * kd;
      }
    },
  };
}
