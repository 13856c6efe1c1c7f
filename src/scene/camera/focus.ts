/** What the camera looks at: the cast's subject, which way it faces, and the space around it that a view must hold. */
import { Sphere, Vector3 } from 'three';
import type { Bodies } from '../actors/bodies.ts';
import type { Cast, StagePlan, ViewName } from '../contract.ts';
import { Follower } from './follower.ts';
import { riderPlace, type RiderPlace } from '../actors/rider.ts';
import { type Block, headingOf, placeView, subjectOf, type Triple } from './views.ts';

/** A cast that changed its size by more than this is looked at anew. */
const GROWN = 1.25;
/** What the strong lines of the grid may be apart (m), and how far for each metre that a view must hold. */
const UNITS = [0.1, 0.2, 0.5, 1, 2, 5];
const UNIT_PER_SIZE = 0.7;
/** How briskly the camera follows what it looks at, and a rider's eye the heading, place and lean (1/s). */
const BRISK = 8;
const EASY = 6;
/** So far a body leans over before the close-up's camera changes sides: a sine. */
const SIDE = 0.2;
/** So much higher than long is somebody who stands. */
const STANDS = 1.2;

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
  /** Where the body of the current view is (m), and what the camera has made of its path. */
  private readonly subject = new Vector3();
  private readonly follower = new Follower(3, BRISK);
  /** Place, heading without its full turns, and the subject's upward axis. */
  private readonly rider = new Follower(7, EASY);
  private turned = 0;
  private mirrored = false;

  get unit(): number {
    return UNITS.find((unit) => unit >= UNIT_PER_SIZE * this.size) ?? 10;
  }

  setCast(cast: Cast): void {
    this.waiting = cast.id === this.id && this.waiting !== 'new' ? 'same' : 'new';
    this.id = cast.id;
    this.plan = cast.stage;
  }

  /** Takes the poses of a frame. Answers how far what the view follows has moved (m), and whether the stage and then the camera have to be set anew. */
  take(
    poses: Float64Array,
    time: number,
    view: ViewName,
    bodies: Bodies,
  ): { moved: Vector3; stage: boolean; camera: boolean } {
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
    const next = this.followed(at(plan.still ? plan.subject : follows), view);
    const moved = new Vector3();
    if (next.every(Number.isFinite)) {
      moved.set(...(this.follower.at as unknown as Triple)).negate();
      this.follower.take(next, time);
      moved.add(place.set(...(this.follower.at as unknown as Triple)));
      this.subject.set(...next);
    }
    this.seat(poses, time);
    const { stage, camera } = this.measure(bodies);
    const turnsOver = this.lean(poses) && view === 'caster' && !stage;
    return { moved, stage, camera: camera || turnsOver };
  }

  /** The rider's eye, where it looks, and which way is up. @param level keeps the horizon */
  ride(level: boolean): RiderPlace {
    const { at } = this.rider;
    const { low, high } = this.block;
    const up: Triple | null = level ? null : [at[4]!, at[5]!, at[6]!];
    return riderPlace(this.size, [at[0]!, at[1]!, at[2]!], at[3]!, up, high[2] - low[2] > STANDS * (high[0] - low[0]));
  }

  /** How fast the camera of a view goes along with what it follows, m/s. */
  pace(view: ViewName): Triple {
    const { speed } = view === 'rider' ? this.rider : this.follower;
    return [speed[0]!, speed[1]!, speed[2]!];
  }

  /** How much farther a view has to stand off in another picture. */
  dolly(view: ViewName, before: number, after: number, bodies: Bodies): number {
    const far = (aspect: number): number => {
      const { camera, target } = this.place(view, aspect, bodies);
      return Math.hypot(...camera.map((x, i) => x - target[i]!));
    };
    return far(after) / far(before);
  }

  /** The place that the camera goes along with, of a body at a place: the middle of the cast, so that it stays in the picture when it turns. */
  private followed(at: Triple, view: ViewName): Triple {
    const { plan, block, heading } = this;
    if (plan.still) return beyond(at, block);
    if (view === 'caster' && plan.closeUp !== null) return at;
    const [x, y] = [0, 1].map((i) => (block.low[i]! + block.high[i]!) / 2) as [number, number];
    const [c, s] = [Math.cos(heading), Math.sin(heading)];
    return [at[0] + c * x - s * y, at[1] + s * x + c * y, at[2]];
  }

  /** On which side the close-up's body shows its underside: that is where its camera stands. Says whether it is another one now. */
  private lean(poses: Float64Array): boolean {
    const { plan, heading, mirrored } = this;
    if (plan.closeUp === null) return false;
    const o = 12 * plan.closeUp;
    const left = Math.cos(heading) * poses[o + 8]! - Math.sin(heading) * poses[o + 5]!;
    this.mirrored = left < (mirrored ? SIDE : -SIDE);
    return this.mirrored !== mirrored;
  }

  private seat(poses: Float64Array, time: number): void {
    const o = 12 * this.plan.subject;
    const { x, y, z } = this.position;
    this.turned += Math.atan2(Math.sin(this.heading - this.turned), Math.cos(this.heading - this.turned));
    const up = this.plan.facing === 'nose' ? [poses[o + 5]!, poses[o + 8]!, poses[o + 11]!] : [0, 0, 1];
    const goal = [x, y, z, this.turned, ...up];
    if (goal.every(Number.isFinite)) this.rider.take(goal, time);
  }

  /** Camera and target for a view, from where things stand now. */
  place(view: ViewName, aspect: number, bodies: Bodies): { camera: Triple; target: Triple } {
    const body = subjectOf(view, this.plan);
    const close = view === 'caster' && this.plan.closeUp !== null;
    const at = bodies.matrix(body);
    if (at) this.subject.setFromMatrixPosition(at);
    const followed = this.followed(this.subject.toArray(), view);
    const origin = this.plan.still ? place.set(...followed) : close ? this.subject : this.position;
    this.follower.put(followed);
    return placeView(
      view,
      close ? this.around(bodies, [body], origin) : this.block,
      origin.toArray(),
      this.heading,
      aspect,
      close && this.mirrored,
    );
  }

  /** Camera and target for a look at the close-up's body, whatever the view. */
  closeUp(aspect: number, bodies: Bodies): { camera: Triple; target: Triple } | null {
    const body = this.plan.closeUp;
    const matrix = body === null ? null : bodies.matrix(body);
    if (!matrix) return null;
    // A ball around it: what turns about stays the same size.
    const ball = new Sphere().setFromPoints(bodies.corners(body!));
    const half = 0.62 * ball.radius;
    return placeView(
      'caster',
      { low: [-half, -half, -half], high: [half, half, half] },
      ball.center.toArray(),
      this.heading,
      aspect,
      this.mirrored,
    );
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

const place = new Vector3();

/** How far (m) a place lies outside a block that stays where it is: so far the camera goes along. */
const beyond = (at: Triple, { low, high }: Block): Triple =>
  at.map((x, i) => Math.min(x - low[i]!, 0) + Math.max(x - high[i]!, 0)) as unknown as Triple;
