import { cosine, sine } from '../../elementary/trigonometry.ts';
import type { Matrix } from 'ml-matrix';
import { StartError } from '../../mechanics/consistentStart.ts';
import type { InputMeta, SystemMeta } from '../../model/system.ts';
import { linearize } from '../linearization/linearize.ts';
import { designLqr, reachablePlant, type LqrDesign, type Weights } from '../design/lqr.ts';
import { ControlError } from '../linearization/matrices.ts';
import type { Family } from './rootLocus.ts';
import { steadyMotionAt, type Plant } from '../linearization/steadyMotion.ts';

/** What is varied: a state (or other word) of the operating point, or a parameter of the system. */
export type Varied = { kind: 'at'; name: string } | { kind: 'parameter'; name: string };

/** A plant and a point in which one number is open. */
export interface OneOpen {
  plant: Plant;
  at: Readonly<Record<string, number>>;
  varied: Varied;
}

/**
 * The plant and the point with that number set.
 *
 * @param value of the number that varies, SI
 */
export function setTo({ plant, at, varied }: OneOpen, value: number): { plant: Plant; at: Record<string, number> } {
  if (varied.kind === 'at') return { plant, at: { ...at, ...saidBy(plant.system.meta, at, varied.name, value) } };
  const index = plant.system.meta.parameters.findIndex((p) => p.name === varied.name);
  if (index < 0) throw new ControlError(`there is no parameter "${varied.name}"`);
  const parameters = plant.parameters.slice();
  parameters[index] = value;
  return { plant: { ...plant, parameters }, at: { ...at } };
}

/** A state, or the velocities that a speed along the heading says. */
function saidBy({ speed }: SystemMeta, at: OneOpen['at'], name: string, value: number): Record<string, number> {
  if (name !== speed?.name) return { [name]: value };
  const heading = at[speed.heading] ?? 0;
  return { [speed.along[0]]: value * cosine(heading), [speed.along[1]]: value * sine(heading) };
}

/**
 * For `rootLocus`: the open loop on the tangent space, d x d; null where there is no steady motion.
 *
 * @param open the loop and which number varies
 */
export function openLoopFamily(open: OneOpen): Family {
  return (value) => {
    const { plant, at } = setTo(open, value);
    return orNull(() => linearize(steadyMotionAt(plant, at), []).tangentA);
  };
}

/**
 * For `rootLocus`: the closed loop N^T (A - B K) N with one fixed gain K (k x 2n), as the plant varies under it.
 *
 * @param open the loop and which number varies
 * @param inputs the inputs, k
 * @param gain K, k x 2n
 */
export function closedLoopFamily(open: OneOpen, inputs: readonly InputMeta[], gain: Matrix): Family {
  return (value) => {
    const { plant, at } = setTo(open, value);
    return orNull(() => {
      const { tangentA, tangentB, basis } = linearize(steadyMotionAt(plant, at), inputs);
      return tangentA.clone().sub(tangentB.mmul(gain.mmul(basis)));
    });
  };
}

/**
 * The design at each value.
 *
 * @param open the loop and which number varies
 * @param inputs the inputs, k
 * @param weights diagonals: Q by state (2n), R by input (k)
 * @throws ControlError, StartError where there is none
 */
export function designFamily(
  open: OneOpen,
  inputs: readonly InputMeta[],
  weights: Weights,
): (value: number) => LqrDesign {
  return (value) => {
    const { plant, at } = setTo(open, value);
    return designLqr(reachablePlant(linearize(steadyMotionAt(plant, at), inputs)), weights);
  };
}

function orNull<T>(make: () => T): T | null {
  try {
    return make();
  } catch (error) {
    if (error instanceof ControlError || error instanceof StartError) return null;
    throw error;
  }
}
