/**
 * A free body through any attitude, in a sequence of angles that is singular at a pitch of ±90°.
 *
 * The angles of R = Rz(yaw) Ry(pitch) Rx(roll) have no rates at pitch ±90°: M is singular there. Without constraints
 * nothing but gravity tells one direction of the world from another, so the same equations hold in a world turned by any
 * constant rotation Q, with gravity turned along: p' = Q p, R' = Q R. A *chart* is such a Q. Near the singularity of one
 * chart the run goes on in the chart in which the body stands upright, and its rows are turned back.
 *
 * Symbols: g the vector of gravity; a uniform field accelerates all alike, so its generalized force is M e with e = Q g in
 * the three rates of position and 0 elsewhere, and the generated equations are evaluated with their own gravity zero.
 * E: rates of the angles to angular velocity in body axes, the same body, so that E(angles) rates = E(angles') rates'.
 * Euler angles and their singularity: Goldstein, Poole and Safko, Classical Mechanics (3rd ed.), section 4.4 and 4.9.
 *
 * Not guaranteed: a fixed step that is long beside the pole has the error of such a step (`nearness`).
 */
import { cosine, sine } from '../elementary/trigonometry.ts';
import type { Forcing } from './forcing.ts';
import type { StateMap } from './formulations/contract.ts';
import { parameterIndex, type System } from '../model/system.ts';

/** A chart is left where |cos pitch'| falls below this (60°): far from the singularity, and rarely. */
const LEFT_BELOW = 0.5;
/** Within this of ±90° yaw and roll turn about one axis: the yaw stays as it was. Some hundred roundings. */
const POLE = 1e-13;
/** For forces known in the angles' own terms |cos pitch| is kept above this: at the pole itself they are 0/0. */
const SMALLEST_COSINE = 1e-9;
const STEP = Math.cbrt(Number.EPSILON);

export class AttitudeCharts {
  /** The system in the present chart. */
  readonly system: System;
  /**
   * How near steps came to the singularity for their length: the largest turn of the roll axis within a step, beside the angle
   * then left to the chart's pole. A fixed step of the classical method errs by some 1e-4 rad at half, by 1e-3 at one.
   */
  nearness = 0;
  private readonly axis = new Float64Array(3);
  private started = false;
  /** Q by rows. */
  private readonly Q = Float64Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);
  private turned = false;

  private readonly n: number;
  private readonly own: System;
  private readonly position: readonly number[];
  /** Indices of yaw, pitch and roll. */
  private readonly angles: readonly number[];
  private readonly gravity: number;
  private readonly weightless: Float64Array;
  private readonly e: Float64Array;
  private readonly a: Float64Array;
  private readonly R = new Float64Array(9);
  private readonly S = new Float64Array(9);
  private readonly w = new Float64Array(3);
  private readonly q: Float64Array;
  private readonly v: Float64Array;
  private readonly moved: Float64Array;
  private readonly force: Float64Array;
  private readonly beside: Float64Array;
  /** Angles of the last end of a step, which those of rows continue: yaw, pitch, roll. */
  private readonly reference = new Float64Array(3);

  /** @returns null where the attitude is not free: constraints, coordinates of the body held, or angles that are never singular */
  static of(
    system: System,
    parameters: Float64Array,
    constraintSet: string,
    hold: readonly number[],
  ): AttitudeCharts | null {
    const { attitude, coordinates } = system.meta;
    if (!attitude || constraintSet !== 'none') return null;
    const held = new Set(hold.map((i) => coordinates[i]!.name));
    const places = attitude.position.filter((name) => held.has(name)).length;
    if (attitude.angles.some((name) => held.has(name)) || (places > 0 && places < 3)) return null;
    return new AttitudeCharts(system, parameters);
  }

  private constructor(system: System, parameters: Float64Array) {
    const { meta } = system;
    const n = (this.n = meta.coordinates.length);
    const indexOf = (name: string): number => meta.coordinates.findIndex((c) => c.name === name);
    this.own = system;
    this.position = meta.attitude!.position.map(indexOf);
    this.angles = meta.attitude!.angles.map(indexOf);
    this.gravity = parameterIndex(meta, meta.attitude!.gravity);
    this.weightless = parameters.slice();
    this.weightless[this.gravity] = 0;
    // Forces of the surroundings know the world's own directions: they come with the forces from outside.
    for (const name of meta.optionalForces ?? []) this.weightless[parameterIndex(meta, name)] = 0;
    this.e = new Float64Array(n);
    this.a = new Float64Array(n);
    this.q = new Float64Array(n);
    this.v = new Float64Array(n);
    this.moved = new Float64Array(n);
    this.force = new Float64Array(n);
    this.beside = new Float64Array(n);
    this.system = {
      ...system,
      mechanics: (q, v, p, massMatrix, h) => {
        if (!this.turned) return system.mechanics(q, v, p, massMatrix, h);
        system.mechanics(q, v, this.weightless, massMatrix, h);
        this.weigh(p);
        for (let i = 0; i < n; i++) for (const k of this.position) h[i]! += massMatrix[i * n + k]! * this.e[k]!;
      },
      jacobians: (q, v, a, p, dq, dv) => {
        if (!this.turned) return system.jacobians(q, v, a, p, dq, dv);
        this.weigh(p);
        for (let i = 0; i < n; i++) this.a[i] = a[i]! - this.e[i]!;
        system.jacobians(q, v, this.a, this.weightless, dq, dv);
      },
    };
  }

  /**
   * Forces from outside, which know the world's own coordinates, in those of the present chart; with them the system's
   * optional forces where the chart is a turned one.
   *
   * @param outside null for none
   * @param parameters values in the order of the meta
   */
  forcing(outside: Forcing | null, parameters: Float64Array): Forcing | null {
    const losses = this.own.optionalForces;
    const lossy = losses?.some(({ parameter }) => parameters[parameter] !== 0) ?? false;
    if (!outside && !lossy) return null;
    const { n } = this;
    const inChart = (t: number, q: Float64Array, v: Float64Array, force: Float64Array): void => {
      const own = this.force.fill(0);
      this.toWorld(q, v, this.q, this.v);
      outside?.(t, this.q, this.v, own);
      for (const { parameter, force: loss } of losses ?? []) {
        if (parameters[parameter] === 0) continue;
        loss(this.q, this.v, parameters, this.beside);
        for (let i = 0; i < n; i++) own[i]! += this.beside[i]!;
      }
      this.pullBack(q, this.q, own);
      for (let i = 0; i < n; i++) force[i]! += own[i]!;
    };
    const forcing: Forcing = (t, q, v, force) => {
      if (this.turned) inChart(t, q, v, force);
      else outside?.(t, q, v, force);
    };
    if (outside && !outside.jacobians) return forcing;
    const [high, low] = [new Float64Array(n), new Float64Array(n)];
    forcing.jacobians = (t, q, v, forceQ, forceV) => {
      if (!this.turned) return outside?.jacobians!(t, q, v, forceQ, forceV);
      // By central differences: what implicit methods iterate with, not what they converge to.
      for (const [x, out] of [
        [q, forceQ],
        [v, forceV],
      ] as const) {
        const difference = (c: number, h: number, into: Float64Array): void => {
          this.moved.set(x);
          this.moved[c]! += h;
          if (x === q) inChart(t, this.moved, v, into.fill(0));
          else inChart(t, q, this.moved, into.fill(0));
        };
        for (let c = 0; c < n; c++) {
          const h = STEP * Math.max(1, Math.abs(x[c]!));
          difference(c, h, high);
          difference(c, -h, low);
          for (let i = 0; i < n; i++) out[i * n + c]! += (high[i]! - low[i]!) / (2 * h);
        }
      }
    };
    return forcing;
  }

  /** The formulation's numbers as a state in the contract's coordinates, changing the chart where it is due. */
  map(inner: StateMap): StateMap {
    const [q, v] = [new Float64Array(this.n), new Float64Array(this.n)];
    return {
      fromState: (worldQ, worldV, y) => {
        this.fromWorld(worldQ, worldV, q, v);
        inner.fromState(q, v, y);
      },
      toState: (y, worldQ, worldV) => {
        inner.toState(y, q, v);
        this.toWorld(q, v, worldQ, worldV);
      },
      rebase: (worldQ, worldV) => {
        const changed = this.choose(worldQ);
        this.fromWorld(worldQ, worldV, q, v);
        return inner.rebase(q, v) || changed;
      },
    };
  }

  /**
   * Kinetic and potential energy, J; near the pole, where the angles' rates are large, from the chart's.
   *
   * @param q, v in the contract's coordinates (n each)
   * @param out kinetic, potential
   */
  energy(q: Float64Array, v: Float64Array, p: Float64Array, out: Float64Array): void {
    this.own.energy(q, v, p, out);
    if (!this.turned) return;
    const potential = out[1]!;
    this.fromWorld(q, v, this.q, this.v);
    this.own.energy(this.q, this.v, this.weightless, out);
    out[1] = potential;
  }

  /** e = Q g in the places of the position. */
  private weigh(p: Float64Array): void {
    const g = -p[this.gravity]!;
    for (let k = 0; k < 3; k++) this.e[this.position[k]!] = g * this.Q[3 * k + 2]!;
  }

  /** A step ended in this state: how near it came to the pole of its chart. */
  stepped(q: Float64Array): void {
    const { Q, axis } = this;
    const turn = this.turnAxis(q);
    const away = Math.acos(Math.min(1, Math.abs(axis[0]! * Q[6]! + axis[1]! * Q[7]! + axis[2]! * Q[8]!)));
    if (turn > this.nearness * away) this.nearness = turn / away;
  }

  /** Sets the roll axis to that of a state; @returns the angle between both, rad */
  private turnAxis(q: Float64Array): number {
    const { axis, angles } = this;
    const [yaw, pitch] = [q[angles[0]!]!, q[angles[1]!]!];
    const [x, y, z] = [cosine(yaw) * cosine(pitch), sine(yaw) * cosine(pitch), -sine(pitch)];
    const along = x * axis[0]! + y * axis[1]! + z * axis[2]!;
    axis[0] = x;
    axis[1] = y;
    axis[2] = z;
    return Math.acos(Math.max(-1, Math.min(1, along)));
  }

  /** @returns whether another chart was chosen for the state */
  private choose(q: Float64Array): boolean {
    for (let k = 0; k < 3; k++) this.reference[k] = q[this.angles[k]!]!;
    const { Q, R, S, angles } = this;
    rotation(q[angles[0]!]!, q[angles[1]!]!, q[angles[2]!]!, R);
    product(Q, R, S);
    if (!this.started) this.turnAxis(q);
    this.started = true;
    if (Math.hypot(S[0]!, S[3]!) >= LEFT_BELOW) return false;
    this.turned = Math.hypot(R[0]!, R[3]!) < LEFT_BELOW;
    for (let i = 0; i < 3; i++)
      for (let j = 0; j < 3; j++) Q[3 * i + j] = this.turned ? R[3 * j + i]! : i === j ? 1 : 0;
    return true;
  }

  private fromWorld(q: Float64Array, v: Float64Array, chartQ: Float64Array, chartV: Float64Array): void {
    chartQ.set(q);
    chartV.set(v);
    if (!this.turned) return;
    const { Q, R, S, w, angles, position } = this;
    const [yaw, pitch, roll] = [angles[0]!, angles[1]!, angles[2]!];
    for (let i = 0; i < 3; i++) {
      const to = position[i]!;
      chartQ[to] = chartV[to] = 0;
      for (let j = 0; j < 3; j++) {
        chartQ[to]! += Q[3 * i + j]! * q[position[j]!]!;
        chartV[to]! += Q[3 * i + j]! * v[position[j]!]!;
      }
    }
    rotation(q[yaw]!, q[pitch]!, q[roll]!, R);
    product(Q, R, S);
    chartQ[yaw] = Math.atan2(S[3]!, S[0]!);
    chartQ[pitch] = Math.atan2(-S[6]!, Math.hypot(S[0]!, S[3]!));
    chartQ[roll] = Math.atan2(S[7]!, S[8]!);
    angular(q, v, angles, w);
    rates(chartQ, w, angles, chartV, 0);
  }

  private toWorld(chartQ: Float64Array, chartV: Float64Array, q: Float64Array, v: Float64Array): void {
    q.set(chartQ);
    v.set(chartV);
    if (!this.turned) return;
    const { Q, R, S, w, angles, position, reference } = this;
    const [yaw, pitch, roll] = [angles[0]!, angles[1]!, angles[2]!];
    for (let i = 0; i < 3; i++) {
      const to = position[i]!;
      q[to] = v[to] = 0;
      for (let j = 0; j < 3; j++) {
        q[to]! += Q[3 * j + i]! * chartQ[position[j]!]!;
        v[to]! += Q[3 * j + i]! * chartV[position[j]!]!;
      }
    }
    rotation(chartQ[yaw]!, chartQ[pitch]!, chartQ[roll]!, S);
    for (let i = 0; i < 3; i++)
      for (let j = 0; j < 3; j++) R[3 * i + j] = Q[i]! * S[j]! + Q[3 + i]! * S[3 + j]! + Q[6 + i]! * S[6 + j]!;
    // Two triples of angles give R, (yaw, pitch, roll) and (yaw + pi, pi - pitch, roll + pi): the one that goes on from the last.
    const atPole = Math.hypot(R[0]!, R[3]!) < POLE;
    let nearest = Infinity;
    for (let family = 0; family < 2; family++) {
      const theta = atPole ? reference[0]! : near(Math.atan2(R[3]!, R[0]!) + family * Math.PI, reference[0]!);
      const [c, s] = [cosine(theta), sine(theta)];
      const psi = near(Math.atan2(-R[6]!, c * R[0]! + s * R[3]!), reference[1]!);
      const alpha = near(Math.atan2(s * R[2]! - c * R[5]!, c * R[4]! - s * R[1]!), reference[2]!);
      const away = Math.hypot(theta - reference[0]!, psi - reference[1]!, alpha - reference[2]!);
      if (away >= nearest) continue;
      nearest = away;
      q[yaw] = theta;
      q[pitch] = psi;
      q[roll] = alpha;
    }
    angular(chartQ, chartV, angles, w);
    rates(q, w, angles, v, atPole ? Infinity : 0);
  }

  /** f' = J^T f in place, with J = d(rates)/d(chart's rates). */
  private pullBack(chartQ: Float64Array, q: Float64Array, f: Float64Array): void {
    const { Q, w, angles, position } = this;
    const [yaw, pitch, roll] = [angles[0]!, angles[1]!, angles[2]!];
    const [x, y, z] = [f[position[0]!]!, f[position[1]!]!, f[position[2]!]!];
    for (let i = 0; i < 3; i++) f[position[i]!] = Q[3 * i]! * x + Q[3 * i + 1]! * y + Q[3 * i + 2]! * z;
    // The torque T in body axes with E^T T = f, then E'^T T.
    let [sr, cr, sp, cp] = [sine(q[roll]!), cosine(q[roll]!), sine(q[pitch]!), cosine(q[pitch]!)];
    if (Math.abs(cp) < SMALLEST_COSINE) cp = cp < 0 ? -SMALLEST_COSINE : SMALLEST_COSINE;
    const across = (f[yaw]! + sp * f[roll]!) / cp;
    w[0] = f[roll]!;
    w[1] = cr * f[pitch]! + sr * across;
    w[2] = -sr * f[pitch]! + cr * across;
    [sr, cr, sp, cp] = [sine(chartQ[roll]!), cosine(chartQ[roll]!), sine(chartQ[pitch]!), cosine(chartQ[pitch]!)];
    f[yaw] = -sp * w[0] + cp * (sr * w[1] + cr * w[2]);
    f[pitch] = cr * w[1] - sr * w[2];
    f[roll] = w[0];
  }
}

/** Rz(yaw) Ry(pitch) Rx(roll) by rows. */
function rotation(yaw: number, pitch: number, roll: number, out: Float64Array): void {
  const [cy, sy, cp, sp] = [cosine(yaw), sine(yaw), cosine(pitch), sine(pitch)];
  const [cr, sr] = [cosine(roll), sine(roll)];
  out[0] = cy * cp;
  out[1] = cy * sp * sr - sy * cr;
  out[2] = cy * sp * cr + sy * sr;
  out[3] = sy * cp;
  out[4] = sy * sp * sr + cy * cr;
  out[5] = sy * sp * cr - cy * sr;
  out[6] = -sp;
  out[7] = cp * sr;
  out[8] = cp * cr;
}

function product(A: Float64Array, B: Float64Array, out: Float64Array): void {
  for (let i = 0; i < 3; i++)
    for (let j = 0; j < 3; j++)
      out[3 * i + j] = A[3 * i]! * B[j]! + A[3 * i + 1]! * B[3 + j]! + A[3 * i + 2]! * B[6 + j]!;
}

/** The angular velocity in body axes, w = E rates. */
function angular(q: Float64Array, v: Float64Array, angles: readonly number[], w: Float64Array): void {
  const [yaw, pitch, roll] = [angles[0]!, angles[1]!, angles[2]!];
  const [sr, cr, cp] = [sine(q[roll]!), cosine(q[roll]!), cosine(q[pitch]!)];
  w[0] = v[roll]! - v[yaw]! * sine(q[pitch]!);
  w[1] = v[pitch]! * cr + v[yaw]! * cp * sr;
  w[2] = -v[pitch]! * sr + v[yaw]! * cp * cr;
}

/** The angles' rates of an angular velocity in body axes; @param without more than |cos pitch|: the yaw stands still */
function rates(q: Float64Array, w: Float64Array, angles: readonly number[], v: Float64Array, without: number): void {
  const [yaw, pitch, roll] = [angles[0]!, angles[1]!, angles[2]!];
  const [sr, cr, cp] = [sine(q[roll]!), cosine(q[roll]!), cosine(q[pitch]!)];
  const turn = Math.abs(cp) > without ? (sr * w[1]! + cr * w[2]!) / cp : 0;
  v[yaw] = turn;
  v[pitch] = cr * w[1]! - sr * w[2]!;
  v[roll] = w[0]! + turn * sine(q[pitch]!);
}

/** The angle that differs from another by less than half a turn. */
const near = (angle: number, reference: number): number =>
  angle - 2 * Math.PI * Math.round((angle - reference) / (2 * Math.PI));
