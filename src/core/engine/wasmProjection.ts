import type { ConstrainedSystem } from '../mechanics/constrainedSystem.ts';
import { Projection } from '../mechanics/projection.ts';
import { BYTES } from './layout.ts';
import type { Machine, Tenant } from './machine.ts';

/** A projection whose work is done in WebAssembly, to the same bits; the class that it extends takes over where that fails. */
export class WasmProjection extends Projection {
  private readonly machine: Machine;
  private readonly tenant: Tenant;

  /**
   * @param dynamics without forces from outside
   * @param tenant the stepper of the same parameters, which has the machine's memory
   */
  constructor(dynamics: ConstrainedSystem, machine: Machine, tenant: Tenant) {
    super(dynamics);
    this.machine = machine;
    this.tenant = tenant;
  }

  override project(t: number, q: Float64Array, v: Float64Array, near = false): boolean {
    const { memory, layout, run } = this.machine;
    const { sample } = layout;
    if (near) return super.project(t, q, v, near);
    this.put(q, v);
    if (run.project(sample * BYTES) === 0) return super.project(t, q, v);
    const { slip, heights } = this.dynamics;
    const n = q.length;
    for (let i = 0; i < n; i++) {
      q[i] = memory[sample + i]!;
      v[i] = memory[sample + n + i]!;
    }
    for (let r = 0; r < slip.length; r++) slip[r] = memory[layout.slip + r]!;
    for (let c = 0; c < heights.length; c++) heights[c] = memory[layout.heights + c]!;
    return true;
  }

  override multipliers(t: number, q: Float64Array, v: Float64Array, lambda: Float64Array): boolean {
    const { memory, layout, run } = this.machine;
    this.put(q, v);
    if (run.accelerations(layout.sample * BYTES, layout.rate * BYTES) === 0) return super.multipliers(t, q, v, lambda);
    for (let r = 0; r < lambda.length; r++) lambda[r] = memory[layout.lambda + r]!;
    return true;
  }

  /** A state to where the machine finds it. */
  private put(q: Float64Array, v: Float64Array): void {
    const { memory, layout } = this.machine;
    this.tenant.claim();
    for (let i = 0, at = layout.sample, n = q.length; i < n; i++) {
      memory[at + i] = q[i]!;
      memory[at + n + i] = v[i]!;
    }
  }
}
