/** Where the camera stands for each named view: pure geometry, no renderer. */
import type { ViewName } from './contract.ts';

export type Triple = readonly [number, number, number];

/** Vertical field of view (rad): a slightly long lens, which keeps proportions. */
export const FIELD_OF_VIEW = (30 * Math.PI) / 180;

interface View {
  /** Direction from the target to the camera, in the board's heading frame: x forward, y to the left, z up. */
  direction: Triple;
  /** From the body looked at to the target, same frame (m). */
  lift: Triple;
  /** Half of what must fit across and upright (m). */
  halfWidth: number;
  halfHeight: number;
  /** How far the subject reaches towards the camera (m). */
  depth: number;
}

const VIEWS: Readonly<Record<ViewName, View>> = {
  orbit: { direction: [0.62, -1, 0.6], lift: [0, 0, -0.04], halfWidth: 0.5, halfHeight: 0.3, depth: 0.2 },
  front: { direction: [1, 0, 0.14], lift: [0, 0, -0.02], halfWidth: 0.26, halfHeight: 0.19, depth: 0.45 },
  // From the right, so that forward is to the right on the screen.
  side: { direction: [0, -1, 0.07], lift: [0, 0, -0.04], halfWidth: 0.56, halfHeight: 0.24, depth: 0.11 },
  // A hair off the vertical: straight down has no heading of its own.
  top: { direction: [0, -1e-3, 1], lift: [0, 0, 0], halfWidth: 0.58, halfHeight: 0.32, depth: 0.03 },
  caster: { direction: [0.7, -1, 0.16], lift: [-0.01, 0, 0.06], halfWidth: 0.13, halfHeight: 0.115, depth: 0.05 },
};

/** The body that a view looks at, by index: the front caster in the close-up, else the rod. */
export function subjectOf(name: ViewName, bodies: number): number {
  return name === 'caster' && bodies > 3 ? 3 : 0;
}

/** Distance (m) from which a rectangle of the given halves fills the frame. `aspect` is width over height. */
export function fitDistance(halfWidth: number, halfHeight: number, aspect: number): number {
  const tangent = Math.tan(FIELD_OF_VIEW / 2);
  return Math.max(halfHeight / tangent, halfWidth / (tangent * aspect));
}

/** Heading (rad) of a pose: angle of its forward axis about world z. `offset` is where its 12 numbers start. */
export function headingOf(poses: ArrayLike<number>, offset = 0): number {
  return Math.atan2(poses[offset + 6]!, poses[offset + 3]!);
}

/** Camera and target in world axes (m) for a view of a subject at `position` with the given heading (rad). */
export function placeView(name: ViewName, position: Triple, heading: number, aspect: number): { camera: Triple; target: Triple } {
  const view = VIEWS[name];
  const tall = name === 'top' && aspect < 0.8;
  const [x, y, z] = tall ? [-1e-3, 0, 1] : view.direction;
  const distance = view.depth + fitDistance(tall ? view.halfHeight : view.halfWidth, tall ? view.halfWidth : view.halfHeight, aspect);
  const length = Math.hypot(x, y, z);
  const c = Math.cos(heading);
  const s = Math.sin(heading);
  const turn = ([a, b, h]: Triple): Triple => [c * a - s * b, s * a + c * b, h];
  const lift = turn(view.lift);
  const offset = turn([(x * distance) / length, (y * distance) / length, (z * distance) / length]);
  const target: Triple = [position[0] + lift[0], position[1] + lift[1], position[2] + lift[2]];
  return { target, camera: [target[0] + offset[0], target[1] + offset[1], target[2] + offset[2]] };
}
