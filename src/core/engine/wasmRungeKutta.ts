import type { OdeProblem, StepperOptions } from '../integrators/contract.ts';
import { EmbeddedRungeKutta } from '../integrators/runge-kutta/embeddedRungeKutta.ts';
import type { EmbeddedTableau } from '../integrators/runge-kutta/tableau.ts';
import type { ConstrainedSystem } from '../mechanics/constrainedSystem.ts';
import type { Machine, Tenant } from './machine.ts';

const BYTES = 8;

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
 * An embedded pair whose attempts are computed in WebAssembly: the same steps, errors and digits as the class that it
 * extends, which takes over, from the same slope, wherever an attempt has no value there.
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
  /** Places of the step being tried and of the last accepted one, numbers from the memory's start. */
  private trialAt: number;
  private keptAt: number;
  /** The last try, and the last accepted step, lie in the memory. */
  private tried = false;
  private inMemory = false;
  private denseMade = false;

  constructor(problem: OdeProblem, options: StepperOptions, tableau: EmbeddedTableau, work: Work) {
    super(problem, options, tableau);
    this.work = work;
    this.machine = work.machine;
    this.memory = work.machine.memory;
    const n = problem.dimension / 2;
    this.q = new Float64Array(n);
    this.v = new Float64Array(n);
    this.outside = new Float64Array(n);
    [this.trialAt, this.keptAt] = work.machine.layout.steps;
  }

  override reset(t: number, y: Float64Array): void {
    super.reset(t, y);
    this.inMemory = false;
  }

  override interpolate(t: number, out: Float64Array): void {
    if (!this.inMemory || !(this.stepTaken > 0)) return super.interpolate(t, out);
    const { machine, memory, keptAt } = this;
    if (!this.denseMade) {
      const extra = this.tableau.A.length - this.tableau.stages - 1;
      if (machine.run.makeDense(keptAt * BYTES, this.previousT, this.stepTaken) === 0) {
        this.release();
        return super.interpolate(t, out);
      }
      this.counters.evaluations += extra;
      this.denseMade = true;
    }
    machine.run.interpolate(keptAt * BYTES, this.fraction(t));
    const from = machine.layout.sample;
    for (let i = 0; i < out.length; i++) out[i] = memory[from + i]!;
  }

  protected override attempt(h: number): number {
    const { machine, memory, y, trialAt, startSlope: slope, options } = this;
    const { stages } = this.tableau;
    const N = y.length;
    if (machine.takenBy(this)) memory.set(this.work.constants, machine.layout.constants);
    for (let i = 0; i < N; i++) {
      memory[trialAt + i] = y[i]!;
      memory[trialAt + 2 * N + i] = slope[i]!;
    }
    const projecting = this.problem.project ? 1 : 0;
    const error = machine.run.attempt(trialAt * BYTES, this.t, h, options.rtol, options.atol, projecting);
    this.tried = error === error;
    if (!this.tried) return super.attempt(h);
    this.counters.evaluations += this.estimateAtEnd || error <= 1 ? stages : stages - 1;
    return error;
  }

  protected override accept(h: number, error: number): void {
    if (!this.tried) {
      this.inMemory = false;
      return super.accept(h, error);
    }
    const { memory, y, trialAt, startSlope: slope } = this;
    const N = y.length;
    const last = trialAt + (2 + this.tableau.stages) * N;
    for (let i = 0; i < N; i++) {
      y[i] = memory[trialAt + N + i]!;
      slope[i] = memory[last + i]!;
    }
    this.trialAt = this.keptAt;
    this.keptAt = trialAt;
    this.inMemory = true;
    this.denseMade = false;
    // An event looks at the end of every step: it finds there what the last slope was made of.
    const { lambda, factors } = this.machine.layout;
    this.work.dynamics.adopt(this.previousT + h, memory, trialAt + N, last, lambda, factors);
    this.chooseNext(h, error, 1);
  }

  /** The last accepted step goes where the class above looks for it. */
  release(): void {
    if (!this.inMemory) return;
    const { memory, keptAt, kept } = this;
    const N = this.y.length;
    const part = (k: number): Float64Array => memory.subarray(keptAt + k * N, keptAt + (k + 1) * N);
    this.y0.set(part(0));
    this.y1.set(part(1));
    for (let j = 0; j <= this.tableau.stages; j++) kept.k[j]!.set(part(2 + j));
    this.terms = 0;
    this.inMemory = false;
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
