import { normal } from '../../scenario/chance.ts';
import { Formula } from '../../scenario/formula.ts';
import type { Sensor } from '../../scenario/types.ts';

/** What a controller's sensors read of a state: noise, bias and drift added, then rounded to their steps. */
export class Sensors {
  readonly count: number;
  private readonly formulas: readonly Formula[];
  private readonly sensors: readonly Sensor[];
  private readonly deviations: Float64Array;
  private readonly sample: number;
  private readonly seed: number;
  /** The random walk of each so far, and up to which sample. */
  private readonly walked: Float64Array;
  private walkedTo = 0;
  private readonly state: Float64Array;

  /** @param states names, coordinates first @param sample s */
  constructor(sensors: Readonly<Record<string, Sensor>>, states: readonly string[], sample: number, seed: number) {
    this.formulas = Object.keys(sensors).map((text) => new Formula(text, states));
    this.sensors = Object.values(sensors);
    this.count = this.sensors.length;
    this.deviations = Float64Array.from(this.sensors, (s) => s.noise ?? (s.density ?? 0) / Math.sqrt(sample));
    this.sample = sample;
    this.seed = seed;
    this.walked = new Float64Array(this.count);
    this.state = new Float64Array(states.length);
  }

  /** What they would read without errors, into `out`. */
  exact(q: ArrayLike<number>, v: ArrayLike<number>, out: Float64Array): void {
    this.state.set(q);
    this.state.set(v, q.length);
    for (let i = 0; i < this.count; i++) out[i] = this.formulas[i]!.evaluate(this.state);
  }

  /** How what the i-th would read changes with each state, into `out`. */
  slopes(i: number, q: ArrayLike<number>, v: ArrayLike<number>, out: Float64Array): void {
    this.state.set(q);
    this.state.set(v, q.length);
    for (let k = 0; k < out.length; k++) out[k] = this.formulas[i]!.slope(this.state, k);
  }

  /** What they read at the k-th sample (from 0), in the order of their names, into `out`. */
  read(k: number, q: ArrayLike<number>, v: ArrayLike<number>, out: Float64Array): void {
    this.exact(q, v, out);
    this.walkTo(k);
    for (let i = 0; i < this.count; i++) {
      const { bias = 0, resolution } = this.sensors[i]!;
      const read = out[i]! + bias + this.walked[i]! + this.deviations[i]! * normal(this.seed, 2 * i, k);
      out[i] = resolution ? Math.round(read / resolution) * resolution : read;
    }
  }

  private walkTo(k: number): void {
    const step = Math.sqrt(this.sample);
    for (; this.walkedTo < k; this.walkedTo++) {
      for (let i = 0; i < this.count; i++) {
        const { drift } = this.sensors[i]!;
        if (drift) this.walked[i]! += drift * step * normal(this.seed, 2 * i + 1, this.walkedTo + 1);
      }
    }
  }
}
