import { Matrix, pseudoInverse } from 'ml-matrix';
import { maxAbs } from '../../linalg/dense.ts';
import { ConstrainedSystem } from '../../mechanics/constrainedSystem.ts';
import type { Forcing } from '../../mechanics/forcing.ts';
import type { InputMeta, SystemMeta } from '../../model/system.ts';
import { linearize, type Linearization } from '../linearization/linearize.ts';
import { columnSpace, ControlError } from '../linearization/matrices.ts';
import { steadyMotionAt, type Plant, type SteadyMotion } from '../linearization/steadyMotion.ts';

/**
 * Steady turns: motions on a circle at constant speed, with the inputs u0 that hold them. Neither place nor heading stand
 * still, but seen from the turning vehicle nothing changes (a relative equilibrium; J. E. Marsden and T. S. Ratiu,
 * Introduction to Mechanics and Symmetry, 2nd ed., section 1.10).
 *
 * Symbols: V speed, kappa curvature (to the left positive), omega = kappa V; x0 = (q0, v0) with the vehicle at the origin,
 * going along x; G the rate at which a turning vehicle's deviations are turned with it. From x = x0(t) + R(t) xi follows
 * xi' = (A - G) xi + B du, A the derivative of the motion at x0.
 */
export interface SteadyTurn {
  readonly motion: SteadyMotion;
  readonly speed: number;
  readonly curvature: number;
  /** By input, in the order that they were asked for. */
  readonly u0: Float64Array;
  /** About it, in the turning vehicle's own axes, how far along it has come left out; coordinates, then velocities. */
  readonly linearization: Linearization;
  /** The same with how far along it has come. */
  readonly whole: Linearization;
}

/** Where the plane is in a system's coordinates. */
export interface Plane {
  x: number;
  y: number;
  heading: number;
}

/**
 * @param meta of the system
 * @throws ControlError for a system that goes nowhere
 */
export function planeOf(meta: SystemMeta): Plane {
  const forward = meta.forward ?? meta.speed;
  if (!forward) throw new ControlError(`${meta.id} has no heading to turn`);
  const place = (name: string): number => meta.coordinates.findIndex((c) => c.name === name);
  const [x, y] = forward.along.map((name) => place(name.replace(/_dot$/, '')));
  return { x: x!, y: y!, heading: place(forward.heading) };
}

/** Newton's steps; each halves the turn's distance to go where it fails. */
const MOST_STEPS = 40;
/** What a found turn may still accelerate, beside gravity, and slip, beside its speed. */
const STEADY = 1e-9;
/** Of the difference quotients that Newton's method goes by. */
const DIFFERENCE = 1e-6;
/** From straight on, the curvature grows by so much of 1/m at most. */
const STRIDE = 0.25;

/**
 * The steady turn nearest to going straight on: the one of least norm, followed from curvature 0.
 *
 * @param plant system, parameters (SI), constraint set and what is held
 * @param at the straight motion, as `steadyMotionAt` takes it: along x
 * @param curvature of the turn, 1/m
 * @param inputs the inputs, k
 * @throws ControlError where there is none
 */
export function steadyTurn(
  plant: Plant,
  at: Readonly<Record<string, number>>,
  curvature: number,
  inputs: readonly InputMeta[],
): SteadyTurn {
  const straight = steadyMotionAt(plant, at);
  const plane = planeOf(plant.system.meta);
  const speed = straight.v[plane.x]!;
  if (!(speed > 0) || straight.v[plane.y] !== 0 || straight.q[plane.heading] !== 0)
    throw new ControlError('a path is followed from a straight motion along x: give its speed ahead alone, above 0');
  const absolute = inputs.filter(({ column }) =>
    Object.keys(column).some((name) =>
      [plane.x, plane.y].includes(plant.system.meta.coordinates.findIndex((c) => c.name === name)),
    ),
  );
  if (absolute.length > 0 && curvature !== 0)
    throw new ControlError(
      `${absolute.map((i) => i.name).join(', ')} pushes along the ground's own axes, whichever way the vehicle heads: it holds no turn; name other inputs`,
    );
  const search = new TurnSearch(plant, straight, plane, speed, inputs);
  const count = Math.max(1, Math.ceil(Math.abs(curvature) / STRIDE));
  for (let k = curvature === 0 ? count : 1; k <= count; k++) search.solve((curvature * k) / count);
  return search.turn(curvature);
}

class TurnSearch {
  private readonly dynamics: ConstrainedSystem;
  private readonly q: Float64Array;
  private readonly v: Float64Array;
  private readonly u: Float64Array;
  private readonly columns: { index: number; weight: number }[][];
  /** Coordinates that a turn may set, and velocities of what rolls. */
  private readonly freeQ: readonly number[];
  private readonly freeV: readonly number[];
  private readonly a: Float64Array;
  private readonly lambda: Float64Array;

  constructor(
    private readonly plant: Plant,
    private readonly straight: SteadyMotion,
    private readonly plane: Plane,
    private readonly speed: number,
    private readonly inputs: readonly InputMeta[],
  ) {
    const { system, parameters, constraints, hold } = plant;
    const { coordinates } = system.meta;
    const n = coordinates.length;
    this.columns = inputs.map(({ column }) =>
      Object.entries(column).map(([name, weight]) => ({
        index: coordinates.findIndex((c) => c.name === name),
        weight,
      })),
    );
    this.u = new Float64Array(inputs.length);
    this.dynamics = new ConstrainedSystem(system, parameters, constraints, hold, this.forcing(this.u));
    this.q = straight.q.slice();
    this.v = straight.v.slice();
    const rolls = coordinates.flatMap(({ name }, i) =>
      straight.moving.includes(name) && i !== plane.x && i !== plane.y && i !== plane.heading ? [i] : [],
    );
    this.freeV = rolls;
    this.freeQ = [...Array(n).keys()].filter(
      (i) => i !== plane.x && i !== plane.y && !rolls.includes(i) && !hold.includes(i),
    );
    this.a = new Float64Array(n);
    this.lambda = new Float64Array(this.dynamics.m);
  }

  private forcing(u: Float64Array): Forcing {
    const forcing: Forcing = (_t, _q, _v, force) => {
      this.columns.forEach((column, i) => {
        for (const { index, weight } of column) force[index]! += weight * u[i]!;
      });
    };
    // Constant.
    forcing.jacobians = () => {};
    return forcing;
  }

  private get unknowns(): Float64Array {
    return Float64Array.from([...this.freeQ.map((i) => this.q[i]!), ...this.freeV.map((i) => this.v[i]!), ...this.u]);
  }

  private set(x: Float64Array): void {
    this.freeQ.forEach((i, k) => (this.q[i] = x[k]!));
    this.freeV.forEach((i, k) => (this.v[i] = x[this.freeQ.length + k]!));
    for (let k = 0; k < this.u.length; k++) this.u[k] = x[this.freeQ.length + this.freeV.length + k]!;
  }

  /** What is wrong with a turn: heights (m), slip (as a share of the speed), acceleration beside the turn's own (of gravity). */
  private residual(x: Float64Array, omega: number): Float64Array | null {
    const { dynamics: d, q, v, a, speed, plane } = this;
    this.set(x);
    v[plane.x] = speed;
    v[plane.y] = 0;
    v[plane.heading] = omega;
    d.forget();
    if (!d.acceleration(0, q, v, a, this.lambda) || !d.prepareFactors(0, q, v)) return null;
    d.measure(q, v);
    const { n, m } = d;
    const out = new Float64Array(d.contactCount + m + n);
    out.set(d.heights);
    for (let r = 0; r < m; r++) out[d.contactCount + r] = d.slip[r]! / speed;
    for (let i = 0; i < n; i++) out[d.contactCount + m + i] = a[i]! / 10;
    // The turn's own acceleration, to its centre.
    out[d.contactCount + m + plane.y]! -= (omega * speed) / 10;
    return out;
  }

  solve(curvature: number): void {
    const omega = curvature * this.speed;
    let x = this.unknowns;
    let size = Infinity;
    for (let step = 0; step < MOST_STEPS; step++) {
      const here = this.residual(x, omega);
      if (!here) break;
      size = maxAbs(here);
      if (size <= STEADY / 100) break;
      const J = new Matrix(here.length, x.length);
      for (let k = 0; k < x.length; k++) {
        const [up, down] = [DIFFERENCE, -DIFFERENCE].map((d) =>
          this.residual(
            x.map((y, i) => (i === k ? y + d : y)),
            omega,
          ),
        );
        if (!up || !down) throw this.none(curvature);
        for (let r = 0; r < here.length; r++) J.set(r, k, (up[r]! - down[r]!) / (2 * DIFFERENCE));
      }
      const change = pseudoInverse(J, 1e-9).mmul(Matrix.columnVector([...here]));
      const next = x.map((y, i) => y - change.get(i, 0));
      const then = this.residual(next, omega);
      if (!then || !(maxAbs(then) < size)) break;
      x = next;
    }
    this.residual(x, omega);
    if (!(size <= STEADY)) throw this.none(curvature);
  }

  private none(curvature: number): ControlError {
    return new ControlError(
      `there is no steady turn of radius ${Number((1 / Math.abs(curvature)).toPrecision(3))} m at ${Number(this.speed.toPrecision(3))} m/s that ` +
        `${this.inputs.map((i) => i.name).join(', ')} could hold (drag stops it, or it is too tight); choose another speed or a wider path`,
    );
  }

  turn(curvature: number): SteadyTurn {
    const { plant, straight, speed, plane, inputs, q, v, u } = this;
    const fixed = u.slice();
    const dynamics = new ConstrainedSystem(
      plant.system,
      plant.parameters,
      plant.constraints,
      plant.hold,
      this.forcing(fixed),
    );
    const lambda = new Float64Array(dynamics.m);
    const acceleration = new Float64Array(q.length);
    dynamics.acceleration(0, q, v, acceleration, lambda);
    const motion: SteadyMotion = { ...straight, dynamics, q: q.slice(), v: v.slice(), lambda, acceleration };
    const whole = turning(linearize(motion, inputs), plane, curvature * speed);
    const linearization = alongside(whole, plane, curvature * speed);
    return { motion, speed, curvature, u0: fixed, linearization, whole };
  }
}

/** The linearization in the turning vehicle's axes, A - G: places and velocities turn with the vehicle. */
function turning(world: Linearization, plane: Plane, omega: number): Linearization {
  const n = world.motion.q.length;
  const A = world.A.clone();
  for (const offset of [0, n]) {
    A.set(offset + plane.x, offset + plane.y, A.get(offset + plane.x, offset + plane.y) + omega);
    A.set(offset + plane.y, offset + plane.x, A.get(offset + plane.y, offset + plane.x) - omega);
  }
  return { ...world, A, tangentA: world.basis.transpose().mmul(A).mmul(world.basis) };
}

/** The same, deviations along the path taken out: xi - g xi_x / V, g the flow's own direction. */
function alongside(whole: Linearization, plane: Plane, omega: number): Linearization {
  const { motion, basis: N, A, B } = whole;
  const { q, v } = motion;
  const n = q.length;
  const P = Matrix.eye(2 * n);
  const flow = new Float64Array(2 * n);
  flow.set(v);
  flow[n + plane.x] = -omega * v[plane.y]!;
  flow[n + plane.y] = omega * v[plane.x]!;
  for (let i = 0; i < 2 * n; i++) P.set(i, plane.x, P.get(i, plane.x) - flow[i]! / v[plane.x]!);
  const basis = columnSpace(P.mmul(N), () => N.columns - 1).basis;
  const [Ap, Bp] = [P.mmul(A).mmul(P), P.mmul(B)];
  const Nt = basis.transpose();
  return { ...whole, A: Ap, B: Bp, basis, tangentA: Nt.mmul(Ap).mmul(basis), tangentB: Nt.mmul(Bp) };
}
