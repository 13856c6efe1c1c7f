import { maxAbs } from '../../linalg/dense.ts';
import { luFactor, luSolve } from '../../linalg/lu.ts';
import { DEPENDENT } from '../../linalg/saddle.ts';
import type { ConstrainedSystem } from '../constrainedSystem.ts';
import { AccelerationJacobian } from './accelerationJacobian.ts';
import { blockOrder } from './blockOrder.ts';
import type { Formulation } from './contract.ts';
import { pairToState, stateToPair } from './multipliers.ts';

/**
 * y = [q, v]; accelerations and multipliers from `[M -Omega^T; Omega 0] [a; lambda] = [h + B u; -gamma]`, ordered
 * into blocks that are solved one after another by LU (see `blockOrder.ts` for sources). What is known from earlier
 * blocks moves to the right-hand side. Held coordinates drop out.
 *
 * The incidence is found by looking at the numbers of several states, so it belongs to these parameters.
 *
 * Not guaranteed: that an entry which is zero at all of those states is zero everywhere. That `Omega v` stays zero:
 * it drifts as with multipliers.
 */

/** States at which the entries are looked at; two would do for entries that do not vanish on purpose. */
const PROBES = 8;
/** Angles and positions are drawn from -RANGE to RANGE: away from zeros of sines, short of singular attitudes. */
const RANGE = 0.9;
/** Entries below this share of the largest are rounding. */
const ROUNDING = 1e-13;

/** Where the numbers of a block come from. */
interface BlockPlan {
  size: number;
  /** Rows and columns of the whole system. */
  equations: Int32Array;
  unknowns: Int32Array;
  /** Unknowns of earlier blocks that occur here. */
  known: Int32Array;
  matrix: Float64Array;
  right: Float64Array;
  pivots: Int32Array;
  hasMultiplier: boolean;
}

export class BlockTriangular implements Formulation {
  readonly dimension: number;
  failure: string | null = null;
  /** Names of the unknowns of each block, in the order in which the blocks are solved; none if structurally singular. */
  readonly blocks: readonly (readonly string[])[];
  jacobian?: (t: number, y: Float64Array, out: Float64Array) => boolean;

  private readonly dynamics: ConstrainedSystem;
  private readonly q: Float64Array;
  private readonly v: Float64Array;
  /** Indices of the coordinates that are not held. */
  private readonly free: readonly number[];
  private readonly plans: readonly BlockPlan[];
  /** a of the free coordinates, then lambda. */
  private readonly x: Float64Array;
  private readonly size: number;
  private readonly K: Float64Array;

  constructor(dynamics: ConstrainedSystem) {
    const { n, m, held } = dynamics;
    this.dynamics = dynamics;
    this.dimension = 2 * n;
    this.q = new Float64Array(n);
    this.v = new Float64Array(n);
    this.free = Array.from({ length: n }, (_, i) => i).filter((i) => !held.includes(i));
    const size = (this.size = this.free.length + m);
    this.x = new Float64Array(size);
    this.K = new Float64Array(size * size);
    const incidence = this.probe();
    const order = blockOrder(incidence) ?? [];
    const names = [
      ...this.free.map((i) => `${dynamics.system.meta.coordinates[i]!.name}_ddot`),
      ...Array.from({ length: m }, (_, r) => `lambda_${r + 1}`),
    ];
    this.blocks = order.map((block) => block.unknowns.map((u) => names[u]!));
    this.plans = order.map(({ equations, unknowns }) => ({
      size: equations.length,
      equations: Int32Array.from(equations),
      unknowns: Int32Array.from(unknowns),
      known: Int32Array.from(new Set(equations.flatMap((i) => incidence[i]!).filter((u) => !unknowns.includes(u)))),
      matrix: new Float64Array(equations.length ** 2),
      right: new Float64Array(equations.length),
      pivots: new Int32Array(equations.length),
      hasMultiplier: unknowns.some((u) => u >= this.free.length),
    }));
    if (dynamics.differentiable) {
      const jacobian = new AccelerationJacobian(dynamics);
      this.jacobian = (t, y, out) => {
        this.toState(y, this.q, this.v);
        return jacobian.ofState(t, this.q, this.v, out) || this.fail(dynamics.failure ?? 'non-finite');
      };
    }
  }

  derivative(t: number, y: Float64Array, out: Float64Array): boolean {
    const { dynamics: d, q, v, x, free } = this;
    pairToState(y, q, v);
    d.evaluate(t, q, v);
    this.assemble();
    if (this.plans.length === 0 && this.size > 0) return this.fail('constraint-singular');
    for (const plan of this.plans) if (!this.solveBlock(plan)) return false;
    if (!(maxAbs(x) < Infinity)) return this.fail('non-finite');
    for (let i = 0; i < d.n; i++) {
      out[i] = v[i]!;
      out[d.n + i] = 0;
    }
    for (let i = 0; i < free.length; i++) out[d.n + free[i]!] = x[i]!;
    this.failure = null;
    return true;
  }

  fromState(q: Float64Array, v: Float64Array, y: Float64Array): void {
    stateToPair(q, v, y);
  }

  toState(y: Float64Array, q: Float64Array, v: Float64Array): void {
    pairToState(y, q, v);
  }

  rebase(): boolean {
    return false;
  }

  /** Unknowns that occur in each equation at any of the probed states. */
  private probe(): number[][] {
    const { dynamics: d, size, K, q, v } = this;
    const occurs = new Uint8Array(size * size);
    const ratio = (Math.sqrt(5) - 1) / 2;
    for (let s = 0, draw = 1; s < PROBES; s++) {
      for (let i = 0; i < d.n; i++) {
        q[i] = RANGE * (2 * ((draw++ * ratio) % 1) - 1);
        v[i] = 2 * ((draw++ * ratio) % 1) - 1;
      }
      d.evaluate(0, q, v);
      this.assemble();
      const rounding = ROUNDING * maxAbs(K);
      for (let e = 0; e < K.length; e++) if (!(Math.abs(K[e]!) <= rounding)) occurs[e] = 1;
    }
    return Array.from({ length: size }, (_, i) =>
      Array.from({ length: size }, (_, j) => j).filter((j) => occurs[i * size + j] === 1),
    );
  }

  /** The whole matrix of the state last evaluated. */
  private assemble(): void {
    const { dynamics: d, free, size, K } = this;
    const f = free.length;
    for (let i = 0; i < f; i++) {
      const row = free[i]! * d.n;
      for (let j = 0; j < f; j++) K[i * size + j] = d.massMatrix[row + free[j]!]!;
      for (let r = 0; r < d.m; r++) {
        const entry = d.omega[r * d.n + free[i]!]!;
        K[i * size + f + r] = -entry;
        K[(f + r) * size + i] = entry;
      }
    }
  }

  private solveBlock(plan: BlockPlan): boolean {
    const { dynamics: d, free, size, K, x } = this;
    const { equations, unknowns, known, matrix, right } = plan;
    const b = plan.size;
    for (let i = 0; i < b; i++) {
      const e = equations[i]!;
      let sum = e < free.length ? d.force[free[e]!]! : -d.gamma[e - free.length]!;
      for (let k = 0; k < known.length; k++) sum -= K[e * size + known[k]!]! * x[known[k]!]!;
      right[i] = sum;
      for (let j = 0; j < b; j++) matrix[i * b + j] = K[e * size + unknowns[j]!]!;
    }
    if (!luFactor(matrix, b, plan.pivots, DEPENDENT * maxAbs(matrix))) {
      if (!(maxAbs(K) < Infinity)) return this.fail('non-finite');
      return this.fail(plan.hasMultiplier ? 'constraint-singular' : 'mass-matrix-singular');
    }
    luSolve(matrix, b, plan.pivots, right);
    for (let j = 0; j < b; j++) x[unknowns[j]!] = right[j]!;
    return true;
  }

  private fail(reason: string): false {
    this.failure = reason;
    return false;
  }
}
