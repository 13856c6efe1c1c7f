/** Where the camera stands for each named view: pure geometry, no renderer. */
import type { StagePlan, ViewName } from '../contract.ts';

export type Triple = readonly [number, number, number];

/** A block (m) in a subject's own frame: x the way it faces, y to the left, z up. */
export interface Block {
  low: Triple;
  high: Triple;
}

/** Vertical field of view (rad): a slightly long lens, which keeps proportions. */
export const FIELD_OF_VIEW = (30 * Math.PI) / 180;

interface View {
  /** Direction from the target to the camera, in the frame of the block. */
  direction: Triple;
  /** Space left around the block, across and upright; above and below lie words and buttons. */
  margin: readonly [number, number];
}

const VIEWS: Readonly<Record<Exclude<ViewName, 'rider'>, View>> = {
  orbit: { direction: [0.62, -1, 0.6], margin: [1.02, 1.08] },
  front: { direction: [1, 0, 0.14], margin: [1.3, 1.3] },
  // From the right, so that forward is to the right on the screen.
  side: { direction: [0, -1, 0.07], margin: [1.2, 1.3] },
  // A hair off the vertical: straight down has no heading of its own.
  top: { direction: [0, -1e-3, 1], margin: [1.25, 1.4] },
  caster: { direction: [0.7, -1, 0.16], margin: [1.15, 1.1] },
};

/** Whether something long is best seen lying down in a picture of this aspect, width over height. */
export const liesDown = (aspect: number): boolean => aspect >= 0.8;

/** The body that a view looks at, by index. */
export function subjectOf(name: ViewName, stage: Pick<StagePlan, 'subject' | 'closeUp'>): number {
  return name === 'caster' ? (stage.closeUp ?? stage.subject) : stage.subject;
}

/** Distance (m) from which a rectangle of the given halves fills the frame. `aspect` is width over height. */
export function fitDistance(halfWidth: number, halfHeight: number, aspect: number): number {
  const tangent = Math.tan(FIELD_OF_VIEW / 2);
  return Math.max(halfHeight / tangent, halfWidth / (tangent * aspect));
}

/** Heading (rad) about world z of a pose, whose 12 numbers start at `offset`: of its x axis, or of what rolls across its y axis. */
export function headingOf(poses: ArrayLike<number>, offset = 0, facing: StagePlan['facing'] = 'nose'): number {
  if (facing === 'world') return 0;
  if (facing === 'axle') return Math.atan2(-poses[offset + 4]!, poses[offset + 7]!);
  return Math.atan2(poses[offset + 6]!, poses[offset + 3]!);
}

/** Camera and target in world axes (m) for a view (the rider's has a place of its own: the orbit's here) of a block whose frame stands at `position` with the given heading (rad). `mirrored` looks from the other side. */
export function placeView(
  name: ViewName,
  block: Block,
  position: Triple,
  heading: number,
  aspect: number,
  mirrored = false,
): { camera: Triple; target: Triple } {
  const view = VIEWS[name === 'rider' ? 'orbit' : name];
  const { low, high } = block;
  const half = [0, 1, 2].map((i) => (high[i]! - low[i]!) / 2) as unknown as Triple;
  const centre = [0, 1, 2].map((i) => (high[i]! + low[i]!) / 2) as unknown as Triple;
  // From above, what is longer than wide stands upright on a tall picture.
  const [x, side, z]: Triple =
    name === 'top' && !liesDown(aspect) && half[0] > half[1] ? [-1e-3, 0, 1] : view.direction;
  const y = mirrored ? -side : side;
  const length = Math.hypot(x, y, z);
  const level = Math.hypot(x, y);
  const right: Triple = [-y / level, x / level, 0];
  const up: Triple = [(-x * z) / (level * length), (-y * z) / (level * length), level / length];
  const reach = (axis: Triple): number =>
    Math.abs(axis[0]) * half[0] + Math.abs(axis[1]) * half[1] + Math.abs(axis[2]) * half[2];
  const distance =
    reach([x / length, y / length, z / length]) +
    fitDistance(view.margin[0] * reach(right), view.margin[1] * reach(up), aspect);
  const c = Math.cos(heading);
  const s = Math.sin(heading);
  const turn = ([a, b, h]: Triple): Triple => [c * a - s * b, s * a + c * b, h];
  const middle = turn(centre);
  const offset = turn([(x * distance) / length, (y * distance) / length, (z * distance) / length]);
  const target: Triple = [position[0] + middle[0], position[1] + middle[1], position[2] + middle[2]];
  return { target, camera: [target[0] + offset[0], target[1] + offset[1], target[2] + offset[2]] };
}
