import type { DaeProblem } from '../integrators/shared/dae.ts';
import type { OdeProblem } from '../integrators/contract.ts';
import type { ConstrainedSystem } from './constrainedSystem.ts';
import type { StateMap } from './formulations/contract.ts';

/** A system of first order in place of a formulation: y = q, `y' = f(q)`; the velocities of a state are the rates. */
export class FirstOrder implements OdeProblem, StateMap {
  readonly dimension: number;
  readonly failure = null;
  private readonly equations: NonNullable<ConstrainedSystem['system']['firstOrder']>;
  private readonly parameters: Float64Array;
  private readonly held: readonly number[];

  /** @param dynamics of a system that has `firstOrder` */
  constructor(dynamics: ConstrainedSystem) {
    this.dimension = dynamics.n;
    this.equations = dynamics.system.firstOrder!;
    this.parameters = dynamics.parameters;
    this.held = dynamics.held;
  }

  derivative(_t: number, y: Float64Array, out: Float64Array): boolean {
    this.equations.rate(y, this.parameters, out);
    for (const i of this.held) out[i] = 0;
    return true;
  }

  jacobian(_t: number, y: Float64Array, out: Float64Array): boolean {
    const n = this.dimension;
    this.equations.jacobian(y, this.parameters, out);
    for (const i of this.held) out.fill(0, i * n, (i + 1) * n);
    return true;
  }

  fromState(q: Float64Array, _v: Float64Array, y: Float64Array): void {
    y.set(q);
  }

  toState(y: Float64Array, q: Float64Array, v: Float64Array): void {
    q.set(y);
    this.derivative(0, y, v);
  }

  rebase(): boolean {
    return false;
  }
}

/** The same as F = y' - f(y) = 0, for `ida`. */
export class FirstOrderResidual implements DaeProblem {
  readonly dimension: number;
  readonly differential: Uint8Array;
  readonly failure = null;
  private readonly problem: FirstOrder;

  constructor(problem: FirstOrder) {
    this.problem = problem;
    this.dimension = problem.dimension;
    this.differential = new Uint8Array(problem.dimension).fill(1);
  }

  start(t: number, y: Float64Array, yp: Float64Array): boolean {
    return this.problem.derivative(t, y, yp);
  }

  residual(t: number, y: Float64Array, yp: Float64Array, out: Float64Array): boolean {
    this.problem.derivative(t, y, out);
    for (let i = 0; i < this.dimension; i++) out[i] = yp[i]! - out[i]!;
    return true;
  }

  jacobian(t: number, y: Float64Array, _yp: Float64Array, cj: number, out: Float64Array): boolean {
    const n = this.dimension;
    this.problem.jacobian(t, y, out);
    for (let i = 0; i < n * n; i++) out[i] = -out[i]!;
    for (let i = 0; i < n; i++) out[i * n + i]! += cj;
    return true;
  }
}
