/** What the camera looks at: the cast's subject, which way it faces, and the space around it that a view must hold. */
import { Vector3 } from 'three';
import type { Bodies } from './bodies.ts';
import type { Cast, StagePlan, ViewName } from './contract.ts';
import { type Block, headingOf, placeView, subjectOf, type Triple } from './views.ts';

/** A cast that changed its size by more than this is looked at anew. */
const GROWN = 1.25;
/** What the strong lines of the grid may be apart (m), and how far for each metre that a view must hold. */
const UNITS = [0.1, 0.2, 0.5, 1, 2, 5];
const UNIT_PER_SIZE = 0.7;

export class Focus {
  /** Of the subject (m), or the world's origin where the camera stays with the world. */
  readonly position = new Vector3();
  heading = 0;
  /** Largest extent of what a view must hold (m). */
  size = 0.88;
  plan: StagePlan = { subject: 0, facing: 'nose', still: false, floor: 0, closeUp: null };
  private id: string | null = null;
  private block: Block = { low: [-0.44, -0.11, -0.1], high: [0.44, 0.11, 0.05] };
  /** A cast that has not been looked at yet. */
  private waiting: 'new' | 'same' | null = null;
  /** Where the body of the current view is (m). */
  private readonly subject = new Vector3();

  get unit(): number {
    return UNITS.find((unit) => unit >= UNIT_PER_SIZE * this.size) ?? 10;
  }

  setCast(cast: Cast): void {
    this.waiting = cast.id === this.id && this.waiting !== 'new' ? 'same' : 'new';
    this.id = cast.id;
    this.plan = cast.stage;
  }

  /** Takes the poses of a frame. Answers how far what the view follows has moved (m), and whether the stage and then the camera have to be set anew. */
  take(poses: Float64Array, view: ViewName, bodies: Bodies): { moved: Vector3; stage: boolean; camera: boolean } {
    const { plan } = this;
    const at = (body: number): Triple => [poses[12 * body]!, poses[12 * body + 1]!, poses[12 * body + 2]!];
    const follows = subjectOf(view, plan);
    if (!plan.still) {
      const position = at(plan.subject);
      if (position.every(Number.isFinite)) this.position.set(...position);
      this.heading = headingOf(poses, 12 * plan.subject, plan.facing);
    } else {
      this.position.set(0, 0, 0);
      this.heading = 0;
    }
    const next = plan.still ? this.position.clone() : new Vector3(...at(follows));
    const moved = next.toArray().every(Number.isFinite) ? next.clone().sub(this.subject) : new Vector3();
    if (next.toArray().every(Number.isFinite)) this.subject.copy(next);
    return { moved, ...this.measure(bodies) };
  }

  /** Camera and target for a view, from where things stand now. */
  place(view: ViewName, aspect: number, bodies: Bodies): { camera: Triple; target: Triple } {
    const body = subjectOf(view, this.plan);
    const close = view === 'caster' && this.plan.closeUp !== null;
    const at = bodies.matrix(body);
    if (at && !this.plan.still) this.subject.setFromMatrixPosition(at);
    const origin = close ? this.subject : this.position;
    return placeView(view, close ? this.around(bodies, [body], origin) : this.block, origin.toArray() as unknown as Triple, this.heading, aspect);
  }

  /** Once the cast stands in its first poses: the space it needs. */
  private measure(bodies: Bodies): { stage: boolean; camera: boolean } {
    if (!this.waiting || bodies.count === 0) return { stage: false, camera: false };
    const { plan, waiting, size } = this;
    this.waiting = null;
    const all = Array.from({ length: bodies.count }, (_, i) => i);
    this.block = plan.frame ? { low: plan.frame[0], high: plan.frame[1] } : this.around(bodies, all, this.position);
    const { low, high } = this.block;
    this.size = Math.max(high[0] - low[0], high[1] - low[1], high[2] - low[2], 1e-3);
    const ratio = this.size / size;
    return { stage: true, camera: waiting === 'new' || ratio > GROWN || ratio < 1 / GROWN };
  }

  /** Bounds of bodies about a point, in the subject's heading. */
  private around(bodies: Bodies, indices: readonly number[], origin: Vector3): Block {
    const [c, s] = [Math.cos(this.heading), Math.sin(this.heading)];
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    for (const corner of indices.flatMap((i) => bodies.corners(i))) {
      const { x, y, z } = corner.sub(origin);
      [c * x + s * y, c * y - s * x, z].forEach((value, i) => {
        low[i] = Math.min(low[i]!, value);
        high[i] = Math.max(high[i]!, value);
      });
    }
    return low.every(Number.isFinite) ? { low: low as unknown as Triple, high: high as unknown as Triple } : this.block;
  }
}
