/** Somebody on a board that is computed without a rider: seen, and no part of the run. */
import type { Motion } from '../app/runs/motion.ts';
import type { Figure } from '../app/state/settingsTable.ts';
import { systemViews } from '../core/systems/registry.ts';
import type { SystemMeta } from '../core/model/system.ts';
import type { Cast } from '../scene/contract.ts';
import { rolledOn } from '../core/systems/rolledOn.ts';

/** Whether feet move the board: a controller asks their torques, which come from outside, from somebody who is not there. */
export function movedByFeet({ system, written }: Pick<Motion, 'system' | 'written'>): boolean {
  const control = written?.control;
  const feet = system.meta.gait?.feet ?? [];
  if (!control) return false;
  if (control.type === 'ride') return true;
  const driven = control.type === 'lqr' ? (control.inputs ?? []) : Object.keys(control.reference ?? {});
  return feet.some((foot) => driven.includes(foot));
}

/** What a motion is drawn as: the same system, or that of the board with its rider on it. */
export function drawnAs(motion: Motion, figure: Figure): SystemMeta {
  const { meta } = motion.system;
  const shown = figure === 'always' || (figure === 'auto' && movedByFeet(motion));
  return (shown && systemViews[meta.rider?.drawnAs ?? '']?.meta) || meta;
}

/**
 * The poses of all that is drawn of a motion: of its bodies, and of somebody who stands upright on a board, where there is one.
 *
 * @param cast on the stage
 * @param motion that is drawn
 * @param poses 12 numbers a body, of its own bodies
 */
export function posesFor(
  { bodies }: Pick<Cast, 'bodies'>,
  { system, parameters }: Motion,
  poses: Float64Array,
): Float64Array {
  const { rider } = system.meta;
  if (!rider || bodies.length <= system.meta.bodies.length) return poses;
  const out = new Float64Array(12 * bodies.length);
  out.set(poses);
  // The carrier's own roll is taken back: plates turn under the feet.
  const first = system.meta.bodies.length;
  rolledOn(out, 0, first, -Math.atan2(poses[10]!, poses[11]!), 0, rider.height);
  const { meta, limbs } = systemViews[rider.drawnAs]!;
  for (let body = first + 1; body < meta.bodies.length; body++) out.copyWithin(12 * body, 12 * first, 12 * first + 12);
  limbs?.place(
    Float64Array.from(meta.parameters, ({ name, default: otherwise }) => parameters[name] ?? otherwise),
    out,
  );
  return out;
}
