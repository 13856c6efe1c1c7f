import { DEFAULT_STEP } from '../integrators/shared/fixedStepper.ts';
import { methods } from '../integrators/methods.ts';
import type { AttitudeCharts } from '../mechanics/attitudeCharts.ts';
import type { Scenario } from '../scenario/types.ts';
import type { InputPlan } from './inputPlan.ts';

/** What is said of a fixed step that is too long: nothing shortens it. */

/** A fixed step that passes over less than this part of an input is as good as its method is. */
export const SMALL_PART = 1e-3;

/** A shorter step (s) is not advised: the formula has an end of its range there, and no step would do. */
const SHORTEST_ADVISED = 1e-7;

/** Of how near a free body's fixed steps may come to pitch 90° (`AttitudeCharts.nearness`) without a word. */
const MOST_NEARNESS = 0.5;

/**
 * The step of a method that has no other; null for one that chooses its steps.
 *
 * @param method of the scenario
 */
export function fixedStepOf({ name, step, maxStep }: Scenario['method']): number | null {
  if (methods.find((m) => m.id === name)?.adaptive !== false) return null;
  return Math.min(step ?? DEFAULT_STEP, maxStep ?? Infinity);
}

/**
 * A warning where a fixed step passes over what an input does.
 *
 * @param plan of the inputs, which is spent
 * @param step s
 */
export function tooFast(plan: InputPlan | null, step: number): string[] {
  const found = plan?.unresolved(step);
  if (!found) return [];
  const shorter = found.step < SHORTEST_ADVISED ? '' : `one of ${found.step.toPrecision(2)} s, or `;
  return [
    `${found.name} changes within a step at t = ${found.time.toPrecision(6)} s: a fixed step of ${step} s cannot follow it; ` +
      `take ${shorter}a method that chooses its steps`,
  ];
}

/**
 * What is to be said at the end of a free body's run whose fixed steps were too long beside pitch 90°.
 *
 * @param method of the scenario
 * @param charts of the run; null where there are none
 */
export function doubtAtPole(method: Scenario['method'], charts: AttitudeCharts | null): string {
  const step = fixedStepOf(method);
  const nearness = charts?.nearness ?? 0;
  if (step === null || !(nearness > MOST_NEARNESS)) return '';
  return (
    `; a step of ${step} s passed too near to pitch 90° to be right there: take one of ` +
    `${((step * MOST_NEARNESS) / Math.max(2 * MOST_NEARNESS, nearness)).toPrecision(1)} s, or a method that chooses its steps`
  );
}
