/** What a regulator does in a run: the largest of each input, and the cost that it was designed to keep small. */
import type { Matrix } from 'ml-matrix';
import { lqrOf } from './scenarioControl.ts';
import type { Scenario } from '../../scenario/types.ts';
import type { System } from '../../model/system.ts';

export interface RegulatorEffect {
  /** Largest size of each input that the regulator has, in its unit. */
  peaks: { name: string; value: number }[];
  /** The integral of x' Q x + u' R u, x the deviation as far as an input reaches it; null with gains over the speed. */
  cost: number | null;
  /** What inputs put in less what they took out, J; null where nothing acts. */
  work: number | null;
  /** How the run ended (a reason's id), and when, s. */
  reason: string;
  time: number;
}

/**
 * Follows a run row by row. The cost is the design's own: of the deviation from the steady motion, `x - (q0 + v0 t, v0)`,
 * only what the regulator can change counts (`Quotient` of lqr.ts), integrated by the trapezoidal rule over the rows.
 *
 * @throws ScenarioError as `lqrOf`
 */
export class EffectMeter {
  private readonly peaks: Map<string, number>;
  private readonly states: readonly string[];
  private readonly R: readonly number[];
  /** `C fromStates`, rows first: its product with a deviation has the square that is the deviation's cost. */
  private readonly root: Matrix | null;
  private readonly motion: { q: ArrayLike<number>; v: ArrayLike<number> };
  private total = 0;
  private last: { t: number; rate: number } | null = null;

  constructor(scenario: Scenario, system: System) {
    const design = lqrOf(scenario, system);
    const { states, inputs, motion } = design.linearization;
    const scheduled = scenario.control?.type === 'lqr' && scenario.control.schedule !== undefined;
    this.peaks = new Map(inputs.map((name) => [name, 0]));
    this.states = states;
    this.R = design.weights.R;
    this.motion = motion;
    this.root = scheduled ? null : design.quotient.C.mmul(design.quotient.fromStates);
  }

  /**
   * @param names of the columns
   * @param columns the next rows of the run, with `t`, the states and the inputs
   */
  take(names: readonly string[], columns: readonly Float64Array[], rows: number): void {
    const column = (name: string): Float64Array => columns[names.indexOf(name)]!;
    const t = column('t');
    const states = this.states.map(column);
    const inputs = [...this.peaks.keys()].map((name) => [name, column(name)] as const);
    for (let row = 0; row < rows; row++) {
      for (const [name, values] of inputs)
        this.peaks.set(name, Math.max(this.peaks.get(name)!, Math.abs(values[row]!)));
      if (!this.root) continue;
      const rate =
        this.costOf(t[row]!, (i) => states[i]![row]!) +
        inputs.reduce((sum, [, values], k) => sum + this.R[k]! * values[row]! ** 2, 0);
      if (this.last) this.total += ((t[row]! - this.last.t) * (rate + this.last.rate)) / 2;
      this.last = { t: t[row]!, rate };
    }
  }

  effect(end: { reason: string; time: number }, work: number | null): RegulatorEffect {
    return {
      peaks: [...this.peaks].map(([name, value]) => ({ name, value })),
      cost: this.root && this.total,
      work,
      reason: end.reason,
      time: end.time,
    };
  }

  /** x' Q x of the deviation at a time. */
  private costOf(t: number, state: (i: number) => number): number {
    const { q, v } = this.motion;
    const n = q.length;
    let sum = 0;
    for (let row = 0; row < this.root!.rows; row++) {
      let y = 0;
      for (let i = 0; i < n; i++) {
        y += this.root!.get(row, i) * (state(i) - q[i]! - v[i]! * t);
        y += this.root!.get(row, n + i) * (state(n + i) - v[i]!);
      }
      sum += y * y;
    }
    return sum;
  }
}
