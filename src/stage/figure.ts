/** Somebody on a board that is computed without a rider: seen, and no part of the run. */
import type { Motion } from '../app/runs/motion.ts';
import type { Figure } from '../app/state/settingsTable.ts';
import { systemViews } from '../core/systems/registry.ts';
import type { SystemMeta } from '../core/model/system.ts';
import type { Cast, Ghost } from '../scene/contract.ts';
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
  { bodies, limbs }: Pick<Cast, 'bodies' | 'limbs'>,
  { system: { meta } }: Motion,
  poses: Float64Array,
): Float64Array {
  const own = meta.bodies.length;
  if (bodies.length <= own) return poses;
  const out = new Float64Array(12 * bodies.length);
  out.set(poses);
  const figure = bodies.length - (limbs?.ids.length ?? 0);
  if (meta.rider && figure > own) {
    // The carrier's own roll is taken back: plates turn under the feet. Whatever more there is of the body stands as it does.
    rolledOn(out, 0, own, -Math.atan2(poses[10]!, poses[11]!), 0, meta.rider.height);
    for (let body = own + 1; body < figure; body++) out.copyWithin(12 * body, 12 * own, 12 * own + 12);
  }
  limbs?.place(out);
  return out;
}

/** Ghosts with the limbs of the cast, where they are of its system. */
export function withLimbs(ghosts: readonly Ghost[], cast: Cast | null): readonly Ghost[] {
  const { bodies = [], limbs } = cast ?? {};
  const count = bodies.length - (limbs?.ids.length ?? 0);
  if (!limbs) return ghosts;
  return ghosts.map((ghost) => {
    if (ghost.poses.length !== 12 * count) return ghost;
    const poses = new Float64Array(12 * bodies.length);
    poses.set(ghost.poses);
    limbs.place(poses);
    return { ...ghost, poses };
  });
}
