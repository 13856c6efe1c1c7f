import type { OdeProblem, StepFailure, StepperOptions } from '../integrators/contract.ts';
import { EmbeddedRungeKutta } from '../integrators/runge-kutta/embeddedRungeKutta.ts';
import type { EmbeddedTableau } from '../integrators/runge-kutta/tableau.ts';
import type { ConstrainedSystem } from '../mechanics/constrainedSystem.ts';
import { Projection } from '../mechanics/projection.ts';
import { BYTES, PLACES, TOLD } from './layout.ts';
import type { Machine, Tenant } from './machine.ts';
import { WasmProjection } from './wasmProjection.ts';

/** Steps that are computed ahead at first, and by how much more each time: a run may end soon. */
const FIRST_AHEAD = 2;

/** What the steps of a machine stand for. */
export interface Work {
  readonly dynamics: ConstrainedSystem;
  readonly machine: Machine;
  /** What the derivation's `prepare` makes of the parameters. */
  readonly constants: Float64Array;
  /** Forces from outside at t (s), q and v into `out` (n each), where there are any. */
  readonly forces: ((t: number, q: Float64Array, v: Float64Array, out: Float64Array) => void) | null;
}

/**
 * An embedded pair whose steps are computed in WebAssembly, some ahead of those asked for: the same steps, errors and digits as
 * the class that it extends, which takes over, from the same slope, wherever a step does not come about.
 *
 * A step ahead is dropped where anything is changed beneath it (`reset`, `restart`, `stateChanged`, another limit). Where forces
 * act from outside, which may change with every step, none is made.
 *
 * `problem.project`, where it is set, has to be the Projection of the same dynamics: the machine does it by itself.
 */
export class WasmRungeKutta extends EmbeddedRungeKutta implements Tenant {
  private readonly work: Work;
  private readonly machine: Machine;
  private readonly memory: Float64Array;
  /** What forces from outside are asked at, and what they answer. */
  private readonly q: Float64Array;
  private readonly v: Float64Array;
  private readonly outside: Float64Array;
  /** Place of the last accepted step in the memory; -1 where TypeScript made it. */
  private at = -1;
  /** Steps in the places after it that were not asked for yet, and for what limit and bound they hold. */
  private ahead = 0;
  private limit = NaN;
  private most = NaN;
  /** How many are to be computed next time. */
  private count = FIRST_AHEAD;
  private denseMade = false;
  /** The parameters may have changed since they were brought to the memory. */
  private stale = true;

  constructor(problem: OdeProblem, options: StepperOptions, tableau: EmbeddedTableau, work: Work) {
    super(problem, options, tableau);
    this.work = work;
    this.machine = work.machine;
    this.memory = work.machine.memory;
    const n = problem.dimension / 2;
    this.q = new Float64Array(n);
    this.v = new Float64Array(n);
    this.outside = new Float64Array(n);
  }

  override reset(t: number, y: Float64Array): void {
    super.reset(t, y);
    this.stale = true;
    this.at = -1;
    this.ahead = 0;
  }

  override stateChanged(): void {
    super.stateChanged();
    this.ahead = 0;
  }

  override restart(): void {
    super.restart();
    this.ahead = 0;
  }

  override step(limit: number, maxStep = Infinity): StepFailure | null {
    const most = this.bound(maxStep);
    if (this.ahead === 0 || limit !== this.limit || most !== this.most) {
      const slopeThere = this.fresh && this.at >= 0;
      const failure = this.begin(Math.min(limit - this.t, most));
      if (failure) return failure;
      this.compute(limit, most, slopeThere);
    }
    if (this.ahead > 0) {
      this.take();
      return null;
    }
    this.release();
    return super.step(limit, maxStep);
  }

  override interpolate(t: number, out: Float64Array): void {
    if (this.at < 0) return super.interpolate(t, out);
    const { machine, memory, at } = this;
    const from = this.stateAt(at) * BYTES;
    if (!this.denseMade) {
      if (machine.run.makeDense(from, this.previousT, this.stepTaken) === 0) {
        this.release();
        return super.interpolate(t, out);
      }
      this.counters.evaluations += this.tableau.A.length - this.tableau.stages - 1;
      this.denseMade = true;
    }
    machine.run.interpolate(from, this.fraction(t));
    const { sample } = machine.layout;
    for (let i = 0; i < out.length; i++) out[i] = memory[sample + i]!;
  }

  /** Where y0 of the step at a place begins; y1 and the slopes follow it. */
  private stateAt(place: number): number {
    const { layout } = this.machine;
    return layout.steps + place * layout.place + TOLD.count;
  }

  /** Computes steps from the end of the last one on. @param slopeThere its slope is in the memory, not in `startSlope` */
  private compute(limit: number, most: number, slopeThere: boolean): void {
    const { machine, memory, options, startSlope: slope, y } = this;
    const N = y.length;
    this.claim();
    const first = (this.at + 1) % PLACES;
    const to = this.stateAt(first);
    const from = slopeThere && this.at >= 0 ? this.stateAt(this.at) + (2 + this.tableau.stages) * N : -1;
    for (let i = 0; i < N; i++) {
      memory[to + i] = y[i]!;
      memory[to + 2 * N + i] = from < 0 ? slope[i]! : memory[from + i]!;
    }
    this.limit = limit;
    this.most = most;
    this.ahead = machine.run.steps(
      (to - TOLD.count) * BYTES,
      this.work.forces ? 1 : Math.min(this.count, PLACES - first),
      this.t,
      this.h,
      this.controller.lastError,
      limit,
      most,
      options.rtol,
      options.atol,
      this.problem.project ? 1 : 0,
    );
    this.count = Math.min(2 * this.count, PLACES - 1);
  }

  /** Accepts the first of the steps ahead. */
  private take(): void {
    const { memory, counters, y, work } = this;
    const { stages } = this.tableau;
    this.at = (this.at + 1) % PLACES;
    this.ahead--;
    this.denseMade = false;
    const from = this.stateAt(this.at);
    const told = from - TOLD.count;
    const rejected = memory[told + TOLD.rejected]!;
    counters.steps++;
    counters.rejected += rejected;
    counters.evaluations += stages + rejected * (this.estimateAtEnd ? stages : stages - 1);
    this.previousT = this.t;
    this.t = memory[told + TOLD.end]!;
    this.stepTaken = memory[told + TOLD.taken]!;
    this.h = memory[told + TOLD.next]!;
    this.controller.lastError = memory[told + TOLD.error]!;
    for (let i = 0, end = from + y.length; i < y.length; i++) y[i] = memory[end + i]!;
    // An event looks at the end of every step: it finds there what the last slope was made of.
    work.dynamics.adopt(this.t, y, memory[told + TOLD.factor]!);
  }

  claim(): void {
    const { machine, memory, work } = this;
    if (!machine.takenBy(this) && !this.stale) return;
    memory.set(work.constants, machine.layout.constants);
    this.stale = false;
  }

  /** Projects states of the same dynamics, where no forces act. */
  projectionOf(dynamics: ConstrainedSystem): Projection {
    return this.work.forces ? new Projection(dynamics) : new WasmProjection(dynamics, this.machine, this);
  }

  /** The last accepted step goes where the class above looks for it. */
  release(): void {
    this.ahead = 0;
    if (this.at < 0) return;
    const { memory, kept, startSlope: slope, y } = this;
    const { stages } = this.tableau;
    const N = y.length;
    const from = this.stateAt(this.at);
    const part = (k: number): Float64Array => memory.subarray(from + k * N, from + (k + 1) * N);
    this.y0.set(part(0));
    this.y1.set(part(1));
    for (let j = 0; j <= stages; j++) kept.k[j]!.set(part(2 + j));
    if (this.fresh) slope.set(part(2 + stages));
    this.terms = 0;
    this.at = -1;
  }

  force(t: number, address: number): void {
    const { memory, q, v, outside } = this;
    const n = q.length;
    const from = address / BYTES;
    for (let i = 0; i < n; i++) {
      q[i] = memory[from + i]!;
      v[i] = memory[from + n + i]!;
    }
    this.work.forces!(t, q, v, outside);
    const to = this.machine.layout.force;
    for (let i = 0; i < n; i++) memory[to + i] = outside[i]!;
  }
}
