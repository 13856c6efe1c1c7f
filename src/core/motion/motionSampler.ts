import type { ColourRole, SystemView, TrackedPoint } from '../model/system.ts';
import { matrixOf, quaternionOf, slerp } from './attitude.ts';
import { columnOf } from './columns.ts';
import { interpolate, TURN } from './interpolation.ts';
import { rowAt, valueAt } from './resample.ts';
import type { Trajectory } from './trajectory.ts';

/** Multipliers at a moment as forces on the ground contacts, N in world axes. */
export interface ContactForce {
  role: ColourRole;
  kind: 'lateral' | 'vertical';
  origin: [number, number, number];
  vector: [number, number, number];
}

/** Path of one point: rows so far, 3 floats each. */
export interface PointTrack {
  role: ColourRole;
  points: Float32Array;
  times: Float64Array;
  count: number;
}

/** Rows followed in one call, a few milliseconds' work, so that a large file never stops the page: few at first, while the engine has not compiled this yet. */
const FIRST_ROWS = 250;
const ROWS_AT_ONCE = 6000;

/**
 * A trajectory between its rows: the coordinates of a computed one as `interpolate` has them; of a recorded one the
 * positions linearly and the attitudes on the shorter arc, so that an angle that jumps by a full turn makes no body
 * spin. Wheel angles come from the distance rolled, and with them the paths of the tracked points. Follows a trajectory that still grows.
 */
export class MotionSampler {
  readonly poses: Float64Array;
  readonly wheelAngles: Float64Array;
  private readonly view: SystemView;
  private readonly parameters: Float64Array;
  private readonly trajectory: Trajectory;
  private readonly constraints: string | null;
  private readonly q: Float64Array;
  /** The coordinates' columns, valid until the trajectory grows. */
  private readonly coordinates: Float64Array[] = [];
  private readonly rates: (Float64Array | undefined)[] = [];
  private readonly before: Float64Array;
  private readonly after: Float64Array;
  private readonly quaternions = [new Float64Array(4), new Float64Array(4), new Float64Array(4)] as const;
  private readonly points: readonly TrackedPoint[];
  private readonly pointTracks: PointTrack[];
  /** Of the wheels that leave a path with their rims, 0 for points. */
  private readonly rims: Float64Array;
  private readonly radii: Float64Array;
  /** Where each contact was at the row before, x and y. */
  private readonly last: Float64Array;
  /** Angle rolled at each row, per contact. */
  private rolled: Float64Array[];
  private tracked = 0;
  private generation = 0;
  /** Rows have been followed since the tracks were asked for last. */
  private fresh = false;
  private readonly followed: boolean;
  private readonly along: number;
  private zeros = new Float64Array(0);

  constructor(
    view: SystemView,
    parameters: Readonly<Record<string, number>>,
    trajectory: Trajectory,
    constraints: string | null,
  ) {
    const size = 12 * view.meta.bodies.length;
    this.view = view;
    this.parameters = Float64Array.from(view.meta.parameters, (p) => parameters[p.name] ?? p.default);
    this.trajectory = trajectory;
    this.constraints = constraints;
    this.q = new Float64Array(view.meta.coordinates.length);
    this.poses = new Float64Array(size);
    this.before = new Float64Array(size);
    this.after = new Float64Array(size);
    this.wheelAngles = new Float64Array(view.contacts.length);
    this.radii = Float64Array.from(view.contacts, (c) => parameters[c.radius] ?? 0);
    this.along = view.drawnAlong ?? 0;
    this.followed = (view.tracks ?? view.contacts).length + view.contacts.length > 0;
    this.last = new Float64Array(2 * view.contacts.length);
    this.points = view.tracks ?? view.contacts;
    this.rims = Float64Array.from(this.points, (point) => (point.rim === undefined ? 0 : (parameters[point.rim] ?? 0)));
    this.pointTracks = this.points.map(({ role }) => ({
      role,
      points: new Float32Array(0),
      times: new Float64Array(0),
      count: 0,
    }));
    this.rolled = view.contacts.map(() => new Float64Array(0));
  }

  /** Puts `poses` and `wheelAngles` at a time, clamped to the rows there are. False when there is none. */
  sample(time: number): boolean {
    const { trajectory } = this;
    if (trajectory.length === 0) return false;
    this.gather();
    this.follow();
    this.fresh = true;
    const row = trajectory.locate(time);
    const t = trajectory.column('t')!;
    const next = Math.min(row + 1, trajectory.length - 1);
    const span = t[next]! - t[row]!;
    const share = span > 0 ? Math.min(1, Math.max(0, (time - t[row]!) / span)) : 0;
    if (trajectory.recorded || trajectory.straight) {
      this.posesAt(row, this.before);
      this.posesAt(next, this.after);
      this.blend(share);
    } else {
      const last = rowAt(trajectory, time);
      for (let i = 0; i < this.q.length; i++)
        this.q[i] = interpolate(t, this.coordinates[i]!, this.rates[i], last, time);
      this.view.poses(this.q, this.parameters, this.poses);
    }
    // Beyond the rows that have been followed a wheel keeps the last angle.
    const [known, ahead] = [Math.min(row, this.tracked - 1), Math.min(next, this.tracked - 1)];
    this.rolled.forEach(
      (angles, c) => (this.wheelAngles[c] = known < 0 ? 0 : angles[known]! + share * (angles[ahead]! - angles[known]!)),
    );
    return true;
  }

  /** Rows have come that paths and wheel angles do not know yet: look again in the next frame. */
  get behind(): boolean {
    return this.followed && this.tracked < this.trajectory.settled;
  }

  /** Paths over the rows that have been followed, all where they are few; the arrays are replaced when they grow. */
  tracks(): readonly PointTrack[] {
    if (!this.fresh) {
      this.gather();
      this.follow();
    }
    this.fresh = false;
    return this.pointTracks;
  }

  /** Constraint forces at a time, after `sample(time)`; empty where the multipliers are not known. */
  forces(time: number): ContactForce[] {
    const { trajectory, poses } = this;
    const list: ContactForce[] = [];
    if (!this.constraints || this.constraints === 'none' || trajectory.length === 0) return list;
    for (const contact of this.view.contacts) {
      const o = 12 * contact.body;
      const origin: [number, number, number] = [poses[o]!, poses[o + 1]!, poses[o + 2]!];
      const lateral = this.interpolated(`lambda_${contact.lateral + 1}`, time);
      const vertical = this.interpolated(`lambda_${contact.vertical + 1}`, time);
      if (lateral === null || vertical === null) continue;
      const axle: [number, number, number] = contact.worldLateral.includes(this.constraints)
        ? [0, 1, 0]
        : [poses[o + 4]!, poses[o + 7]!, poses[o + 10]!];
      list.push({
        role: contact.role,
        kind: 'lateral',
        origin,
        vector: [axle[0] * lateral, axle[1] * lateral, axle[2] * lateral],
      });
      list.push({ role: contact.role, kind: 'vertical', origin, vector: [0, 0, vertical] });
    }
    return list;
  }

  /** One column at a time, or null if there is no such column or value. */
  interpolated(column: string, time: number): number | null {
    const { trajectory, view } = this;
    const period = trajectory.recorded && columnOf(view.meta, column).turns ? TURN : 0;
    const value = valueAt(trajectory, column, time, period);
    return value !== null && Number.isFinite(value) ? value : null;
  }

  private gather(): void {
    this.view.meta.coordinates.forEach(({ name }, i) => {
      this.coordinates[i] = this.trajectory.column(name) ?? this.still();
      this.rates[i] = this.trajectory.rateOf(name);
    });
  }

  /** Of a coordinate that is held by default and that rows from before there was one do not name. */
  private still(): Float64Array {
    if (this.zeros.length < this.trajectory.length) this.zeros = new Float64Array(2 * this.trajectory.length);
    return this.zeros;
  }

  private posesAt(row: number, out: Float64Array): void {
    const { q, coordinates } = this;
    for (let i = 0; i < q.length; i++) q[i] = coordinates[i]![row]!;
    this.view.poses(q, this.parameters, out);
    if (!this.along) return;
    const way = this.along * this.trajectory.column('t')![row]!;
    for (let o = 0; o < out.length; o += 12) out[o]! += way;
  }

  private blend(share: number): void {
    const { poses, before, after } = this;
    const [qa, qb, qc] = this.quaternions;
    for (let o = 0; o < poses.length; o += 12) {
      for (let i = 0; i < 3; i++) poses[o + i] = before[o + i]! + share * (after[o + i]! - before[o + i]!);
      quaternionOf(before, o + 3, qa);
      quaternionOf(after, o + 3, qb);
      slerp(qa, qb, share, qc);
      matrixOf(qc, poses, o + 3);
    }
  }

  /** Extends paths and rolled angles to the rows that have come since, a share of them where they are many. */
  private follow(): void {
    const { trajectory, view, points } = this;
    if (!this.followed) return;
    if (trajectory.generation !== this.generation) {
      this.generation = trajectory.generation;
      this.tracked = 0;
    }
    const share = Math.min(ROWS_AT_ONCE, Math.max(FIRST_ROWS, this.tracked));
    const rows = Math.min(trajectory.settled, this.tracked + share);
    if (rows <= this.tracked) return;
    this.reserve(rows);
    const t = trajectory.column('t')!;
    for (let row = this.tracked; row < rows; row++) {
      this.posesAt(row, this.after);
      for (let i = 0; i < points.length; i++) this.extend(i, 12 * points[i]!.body, row, t[row]!);
      for (let c = 0; c < view.contacts.length; c++) this.roll(c, 12 * view.contacts[c]!.body, row);
    }
    this.tracked = rows;
  }

  private extend(i: number, o: number, row: number, time: number): void {
    const track = this.pointTracks[i]!;
    const { points } = track;
    const pose = this.after;
    // From the hub down in the wheel's plane: -z less its part along the axle y.
    const [ax, ay, az] = [pose[o + 4]!, pose[o + 7]!, pose[o + 10]!];
    const level = Math.hypot(ax, ay);
    const reach = level > 1e-9 ? this.rims[i]! / level : 0;
    points[3 * row] = pose[o]! + reach * az * ax;
    points[3 * row + 1] = pose[o + 1]! + reach * az * ay;
    points[3 * row + 2] = pose[o + 2]! - reach * (1 - az * az);
    track.times[row] = time;
    track.count = row + 1;
  }

  private roll(c: number, o: number, row: number): void {
    const { last, after: pose } = this;
    const angles = this.rolled[c]!;
    const dx = pose[o]! - last[2 * c]!;
    const dy = pose[o + 1]! - last[2 * c + 1]!;
    last[2 * c] = pose[o]!;
    last[2 * c + 1] = pose[o + 1]!;
    if (row === 0) return;
    // Heading e_y x z of the wheel on the ground; its length shrinks as the wheel lies down, and so does rolling.
    const hx = pose[o + 7]!;
    const hy = -pose[o + 4]!;
    const length = Math.hypot(hx, hy);
    const distance = length > 1e-9 ? (hx * dx + hy * dy) / length : 0;
    angles[row] = angles[row - 1]! + (this.radii[c]! > 0 ? distance / this.radii[c]! : 0);
  }

  private reserve(rows: number): void {
    for (const track of this.pointTracks) {
      if (track.times.length >= rows) continue;
      const room = Math.max(rows, 2 * track.times.length, 1024);
      const points = new Float32Array(3 * room);
      points.set(track.points.subarray(0, 3 * track.count));
      const times = new Float64Array(room);
      times.set(track.times.subarray(0, track.count));
      track.points = points;
      track.times = times;
    }
    for (let c = 0; c < this.rolled.length; c++) {
      if (this.rolled[c]!.length >= rows) continue;
      const angles = new Float64Array(Math.max(rows, 2 * this.rolled[c]!.length, 1024));
      angles.set(this.rolled[c]!.subarray(0, this.tracked));
      this.rolled[c] = angles;
    }
  }
}
