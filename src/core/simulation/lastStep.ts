import type { AttitudeCharts } from '../mechanics/attitudeCharts.ts';
import type { ConstrainedSystem } from '../mechanics/constrainedSystem.ts';
import type { Projection } from '../mechanics/projection.ts';
import { zeroCounters, type Counters, type StepFailure, type Stepper } from '../integrators/contract.ts';
import type { Motion } from './motion.ts';

/** What puts states on the constraints: the ends of steps, and rows within them. */
export interface Projections {
  readonly ends: Projection;
  /** Of dynamics of its own, so that a look between steps leaves the factors of the step's end alone. */
  readonly rows: Projection;
}

/**
 * The last step of a run in the system's own coordinates: where it ended, and what the motion was at any time within it. Takes
 * the next one, or takes it back.
 */
export class LastStep {
  /** State at its end. */
  readonly q: Float64Array;
  readonly v: Float64Array;
  /** State at the time within it that was looked at last. */
  readonly atQ: Float64Array;
  readonly atV: Float64Array;
  readonly stepper: Stepper;
  /** Null where nothing is projected. */
  readonly projections: Projections | null;
  /** The formulation, or the residual of `ida`. */
  private readonly map: Motion['map'];
  private readonly dynamics: ConstrainedSystem;
  /** Where the attitude is free: the formulation works in their present one. */
  private readonly charts: AttitudeCharts | null;
  private readonly y: Float64Array;
  /** Work before the stepper was last set anew. */
  private readonly earlier = zeroCounters();

  /** @param motion whose formulation is that of the charts, where there are any */
  constructor(
    motion: Pick<Motion, 'map' | 'stepper'>,
    dynamics: ConstrainedSystem,
    charts: AttitudeCharts | null,
    projections: Projections | null,
  ) {
    const n = dynamics.n;
    this.map = motion.map;
    this.stepper = motion.stepper;
    this.dynamics = dynamics;
    this.charts = charts;
    this.projections = projections;
    this.y = new Float64Array(this.stepper.y.length);
    this.q = new Float64Array(n);
    this.v = new Float64Array(n);
    this.atQ = new Float64Array(n);
    this.atV = new Float64Array(n);
  }

  get t(): number {
    return this.stepper.t;
  }

  get previousT(): number {
    return this.stepper.previousT;
  }

  /** Of all steps. */
  get counters(): Counters {
    return addCounters(this.earlier, this.stepper.counters);
  }

  /** Before the first step. */
  begin(t: number, q: Float64Array, v: Float64Array): void {
    Object.assign(this.earlier, zeroCounters());
    this.q.set(q);
    this.v.set(v);
    this.map.rebase(q, v);
    this.map.fromState(q, v, this.y);
    this.stepper.reset(t, this.y);
    this.atQ.set(q);
    this.atV.set(v);
  }

  /** @returns null, or why no step could be taken and the time to name */
  take(limit: number, maxStep: number | undefined): { reason: StepFailure; time: number } | null {
    const { stepper, map, q, v } = this;
    const failure = stepper.step(limit, maxStep);
    if (failure) return { reason: failure, time: stepper.t };
    if (this.projections && !stepper.projects) {
      if (!this.projectEnd(stepper.t, stepper.y))
        return { reason: this.dynamics.failure ?? 'constraint-singular', time: stepper.previousT };
      stepper.stateChanged();
    }
    map.toState(stepper.y, q, v);
    this.charts?.stepped(q);
    return null;
  }

  /** Puts y, the end of a step, on the constraint manifold; false where it cannot. */
  projectEnd(t: number, y: Float64Array): boolean {
    const { map, q, v } = this;
    map.toState(y, q, v);
    if (!this.projections!.ends.project(t, q, v, true)) return false;
    map.fromState(q, v, y);
    return true;
  }

  /** State at a time within the step into `atQ`, `atV`, by the method's dense output. */
  lookAt(time: number): void {
    this.stepper.interpolate(time, this.y);
    this.map.toState(this.y, this.atQ, this.atV);
  }

  /** The same as a row shows it: on the constraints, where projection is on. Whether it was put there. */
  project(time: number): boolean {
    return this.projections !== null && this.projections.rows.project(time, this.atQ, this.atV);
  }

  /** The end becomes what is looked at. */
  lookAtEnd(): void {
    this.atQ.set(this.q);
    this.atV.set(this.v);
  }

  /** The step is taken back to where it began, of which y is known. */
  rewind(t: number, y: Float64Array): void {
    Object.assign(this.earlier, this.counters);
    this.stepper.reset(t, y);
    this.map.toState(y, this.q, this.v);
    this.dynamics.forget();
  }

  /** Whether the formulation changed the meaning of y; then the stepper has begun anew. Nothing more is read from within the step. */
  rebase(): boolean {
    if (!this.map.rebase(this.q, this.v)) return false;
    this.dynamics.forget();
    this.restart();
    return true;
  }

  /** `q` or `v` was changed, or what y means: the stepper begins anew from there, at most last digits later. */
  restart(t = this.stepper.t): void {
    Object.assign(this.earlier, this.counters);
    this.map.fromState(this.q, this.v, this.y);
    this.stepper.reset(t, this.y);
  }
}

function addCounters(a: Counters, b: Counters): Counters {
  return {
    steps: a.steps + b.steps,
    rejected: a.rejected + b.rejected,
    evaluations: a.evaluations + b.evaluations,
    jacobians: a.jacobians + b.jacobians,
    factorizations: a.factorizations + b.factorizations,
  };
}
