import type { Forcing } from '../mechanics/forcing.ts';
import { ScenarioError } from '../scenario/types.ts';
import type { System } from '../model/system.ts';
import type { Push } from './push.ts';

/** By how much coordinates are moved (of at least 1) for the change of J along the motion: third root of rounding. */
const STEP = Math.cbrt(Number.EPSILON);
const AT_REST = { velocity: [0, 0, 0], since: 0 } as const;

/**
 * A push as a generalized force: Q = J^T F, F = k (h - p) + c (h' - p'), with h the hand, p the pushed point and J = dp/dq exact, so
 * that the power Q v is F p' to rounding. None until one is set.
 */
export class PushForce {
  /** The force, with its derivatives for implicit methods (see `addSlopes`). */
  readonly forcing: Forcing;
  /** p, p' and F (3 each) at the state of the last call. */
  readonly place = new Float64Array(3);
  readonly velocity = new Float64Array(3);
  readonly pull = new Float64Array(3);

  private readonly system: System;
  private readonly parameters: Float64Array;
  private readonly n: number;
  private readonly poses: Float64Array;
  private readonly poseJacobian: Float64Array;
  /** dp/dq, 3 x n, and what it is a little aside. */
  private readonly J: Float64Array;
  private readonly aside: Float64Array;
  private readonly moved: Float64Array;
  private push: Push | null = null;
  private body = 0;

  constructor(system: System, parameters: Float64Array) {
    this.system = system;
    this.parameters = parameters;
    const { bodies, coordinates } = system.meta;
    const n = (this.n = coordinates.length);
    this.poses = new Float64Array(12 * bodies.length);
    this.poseJacobian = new Float64Array(12 * bodies.length * n);
    this.J = new Float64Array(3 * n);
    this.aside = new Float64Array(3 * n);
    this.moved = new Float64Array(n);
    this.forcing = (t, q, v, force) => this.addForce(t, q, v, force);
    this.forcing.jacobians = (t, q, v, forceQ, forceV) => this.addSlopes(t, q, v, forceQ, forceV);
  }

  get current(): Push | null {
    return this.push;
  }

  /** @throws ScenarioError for a body that is not there, numbers that are none, or a system that nothing can push */
  set(push: Push | null): void {
    if (push) {
      const { meta, poseJacobian } = this.system;
      if (!poseJacobian) throw new ScenarioError('push', `nothing of ${meta.id} can be pushed`);
      const body = meta.bodies.findIndex((b) => b.id === push.body);
      if (body < 0)
        throw new ScenarioError(
          'push.body',
          `there is no body "${push.body}"; right would be ${meta.bodies.map((b) => b.id).join(', ')}`,
        );
      const { velocity, since } = push.moving ?? AT_REST;
      const numbers = [...push.point, ...push.target, ...velocity, since, push.stiffness, push.damping];
      if (numbers.length !== 12 || !numbers.every(Number.isFinite))
        throw new ScenarioError(
          'push',
          'point, target and velocity need three finite numbers each, since, stiffness and damping one',
        );
      this.body = body;
    }
    this.push = push;
  }

  /** Evaluates `place`, `velocity` and `pull` at a time and state; nothing while there is no push. */
  at(t: number, q: Float64Array, v: Float64Array): void {
    const { push, n, J, place, velocity, pull } = this;
    if (!push) return;
    const { velocity: hand, since } = push.moving ?? AT_REST;
    this.system.poses(q, this.parameters, this.poses);
    this.differentiate(q, J);
    const o = 12 * this.body;
    for (let c = 0; c < 3; c++) {
      let p = this.poses[o + c]!;
      let rate = 0;
      for (let k = 0; k < 3; k++) p += this.poses[o + 3 + 3 * c + k]! * push.point[k]!;
      for (let k = 0; k < n; k++) rate += J[c * n + k]! * v[k]!;
      place[c] = p;
      velocity[c] = rate;
      pull[c] = push.stiffness * (push.target[c]! + hand[c]! * (t - since) - p) + push.damping * (hand[c]! - rate);
    }
  }

  private addForce(t: number, q: Float64Array, v: Float64Array, force: Float64Array): void {
    if (!this.push) return;
    const { n, J, pull } = this;
    this.at(t, q, v);
    for (let c = 0; c < 3; c++) for (let k = 0; k < n; k++) force[k]! += J[c * n + k]! * pull[c]!;
  }

  /** dp/dq at q into out (3 x n). */
  private differentiate(q: Float64Array, out: Float64Array): void {
    const { n, poseJacobian: all } = this;
    const [x, y, z] = this.push!.point;
    this.system.poseJacobian!(q, this.parameters, all);
    for (let c = 0; c < 3; c++) {
      const origin = (12 * this.body + c) * n;
      const row = (12 * this.body + 3 + 3 * c) * n;
      for (let k = 0; k < n; k++)
        out[c * n + k] = all[origin + k]! + x * all[row + k]! + y * all[row + n + k]! + z * all[row + 2 * n + k]!;
    }
  }

  /**
   * dQ/dv = -c J^T J, exact; dQ/dq = -J^T (k J + c d(J v)/dq) + d(J^T F)/dq with J's own change from central differences of
   * the exact J (1e-10 of it): good for Newton's iterations, which converge to the same point with it.
   */
  private addSlopes(t: number, q: Float64Array, v: Float64Array, forceQ: Float64Array, forceV: Float64Array): void {
    const { push, n, J, aside, moved } = this;
    if (!push) return;
    this.at(t, q, v);
    moved.set(q);
    for (let j = 0; j < n; j++) {
      const step = STEP * Math.max(1, Math.abs(q[j]!));
      moved[j] = q[j]! + step;
      const up = moved[j]!;
      this.differentiate(moved, aside);
      moved[j] = q[j]! - step;
      const width = up - moved[j]!;
      this.addChange(j, 1 / width, v, forceQ);
      this.differentiate(moved, aside);
      this.addChange(j, -1 / width, v, forceQ);
      moved[j] = q[j]!;
      for (let i = 0; i < n; i++) {
        let square = 0;
        for (let c = 0; c < 3; c++) square += J[c * n + i]! * J[c * n + j]!;
        forceQ[i * n + j]! -= push.stiffness * square;
        forceV[i * n + j]! -= push.damping * square;
      }
    }
  }

  /** `aside` times a weight as the change of J along coordinate j, into column j of dQ/dq. */
  private addChange(j: number, weight: number, v: Float64Array, forceQ: Float64Array): void {
    const { n, J, aside, pull } = this;
    const { damping } = this.push!;
    for (let c = 0; c < 3; c++) {
      let rate = 0;
      for (let k = 0; k < n; k++) rate += aside[c * n + k]! * v[k]!;
      for (let i = 0; i < n; i++)
        forceQ[i * n + j]! += weight * (aside[c * n + i]! * pull[c]! - damping * J[c * n + i]! * rate);
    }
  }
}

/**
 * Two outside forces as one; `second` has its derivatives, and so has the sum where the first has.
 *
 * @param first outside force, or none
 * @param second outside force with its derivatives
 */
export function together(first: Forcing | null, second: Forcing): Forcing {
  if (!first) return second;
  const sum: Forcing = (t, q, v, force) => {
    first(t, q, v, force);
    second(t, q, v, force);
  };
  if (first.jacobians && second.jacobians) {
    sum.jacobians = (t, q, v, forceQ, forceV) => {
      first.jacobians!(t, q, v, forceQ, forceV);
      second.jacobians!(t, q, v, forceQ, forceV);
    };
  }
  return sum;
}
