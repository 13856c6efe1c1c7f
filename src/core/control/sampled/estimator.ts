import { Matrix } from 'ml-matrix';
import type { Estimate, Estimator } from '../../mechanics/forcing.ts';
import { toRowMajor } from '../linearization/matrices.ts';
import type { SteadyMotion } from '../linearization/steadyMotion.ts';
import { held, lagged, memoryOf, type Memory } from './hold.ts';
import type { Sensors } from './sensors.ts';
import { correctionGain, type KalmanFilter, type ObservedPlant } from './kalman.ts';

/**
 * A sampled Kalman filter at work: it corrects what it expects by a measurement, and expects the next from the inputs that
 * its computer has sent, each acting when it does (delay) and as it does (lag). Plain arrays; nothing is allocated.
 */
export class SampledEstimator implements Estimator {
  /** State before the first measurement: the steady motion, each state known to ±1 (SI). */
  private readonly firstGain: Float64Array;
  private readonly gain: Float64Array;
  private readonly C: Float64Array;
  private readonly toStates: Float64Array;
  private readonly fromStates: Float64Array;
  /** Over the parts of a sample between which another input acts: transition of (s, lagged inputs), and what an input does. */
  private readonly parts: readonly { age: number; A: Float64Array; B: Float64Array }[];
  readonly memory: Memory;
  private readonly motion: SteadyMotion;
  private readonly makeSensors: () => Sensors;
  /** Inputs that lag. */
  private readonly slow: readonly number[];
  /** Dimensions: s, with the lagged inputs, inputs, sensors. */
  private readonly o: number;
  private readonly e: number;
  private readonly k: number;
  private readonly p: number;

  /** @param makeSensors what is read, anew for each run @param deviations of their noise per sample @param lags of the actuators, s @param sample, delay s */
  constructor(
    plant: ObservedPlant,
    filter: KalmanFilter,
    makeSensors: () => Sensors,
    deviations: readonly number[],
    motion: SteadyMotion,
    { sample, delay, lags }: { sample: number; delay: number; lags: readonly number[] },
  ) {
    const R = Matrix.diag(deviations.map((d) => d * d));
    const driven = lagged(plant.A, plant.B, lags);
    this.memory = memoryOf(sample, delay);
    this.parts = this.memory.acting.map(({ age, duration }) => {
      const { A, B } = held(driven.A, driven.B, duration);
      return { age, A: toRowMajor(A), B: toRowMajor(B) };
    });
    const known = Matrix.eye(plant.A.rows);
    const { biases = [] } = plant;
    biases.forEach(({ first }, i) =>
      known.set(known.rows - biases.length + i, known.rows - biases.length + i, first * first),
    );
    this.firstGain = toRowMajor(correctionGain(known, plant.C, R));
    this.gain = toRowMajor(filter.gain);
    this.C = toRowMajor(plant.C);
    this.toStates = toRowMajor(plant.toStates);
    this.fromStates = toRowMajor(plant.fromStates);
    this.motion = motion;
    this.makeSensors = makeSensors;
    this.slow = [...lags.keys()].filter((i) => lags[i]! > 0);
    this.o = plant.A.rows;
    this.e = driven.A.rows;
    this.k = plant.B.columns;
    this.p = plant.C.rows;
  }

  begin(): Estimate {
    const { o, e, k, p, memory, parts, motion } = this;
    const n = motion.q.length;
    const s = new Float64Array(e);
    const next = new Float64Array(e);
    const innovation = new Float64Array(p);
    const past = new Float64Array(k * (memory.count + 1));
    const [q, v] = [new Float64Array(n), new Float64Array(n)];
    const reference = new Float64Array(n);
    const sensors = this.makeSensors();
    const [read, expected] = [new Float64Array(p), new Float64Array(p)];
    let first = true;
    const spread = (t: number): void => {
      for (let i = 0; i < 2 * n; i++) {
        let x = 0;
        for (let j = 0; j < o; j++) x += this.toStates[i * o + j]! * s[j]!;
        if (i < n) q[i] = motion.q[i]! + motion.v[i]! * t + x;
        else v[i - n] = motion.v[i - n]! + x;
      }
    };
    const estimate: Estimate = {
      q,
      v,
      measure: (k, t, trueQ, trueV) => {
        sensors.read(k, trueQ, trueV, read);
        for (let i = 0; i < n; i++) reference[i] = motion.q[i]! + motion.v[i]! * t;
        sensors.exact(reference, motion.v, expected);
        for (let i = 0; i < p; i++) read[i]! -= expected[i]!;
        estimate.correct(t, read);
      },
      know: (t, knownQ, knownV) => {
        first = false;
        for (let j = 0; j < o; j++) {
          s[j] = 0;
          for (let i = 0; i < n; i++)
            s[j]! +=
              this.fromStates[j * 2 * n + i]! * (knownQ[i]! - motion.q[i]! - motion.v[i]! * t) +
              this.fromStates[j * 2 * n + n + i]! * (knownV[i]! - motion.v[i]!);
        }
        spread(t);
      },
      correct: (t, off) => {
        for (let i = 0; i < p; i++) {
          innovation[i] = off[i]!;
          for (let j = 0; j < o; j++) innovation[i]! -= this.C[i * o + j]! * s[j]!;
        }
        const gain = first ? this.firstGain : this.gain;
        first = false;
        for (let j = 0; j < o; j++) for (let i = 0; i < p; i++) s[j]! += gain[j * p + i]! * innovation[i]!;
        spread(t);
      },
      predict: (asked) => {
        past.copyWithin(k, 0);
        past.set(asked);
        for (const { age, A, B } of parts) {
          for (let r = 0; r < e; r++) {
            next[r] = 0;
            for (let c = 0; c < e; c++) next[r]! += A[r * e + c]! * s[c]!;
            for (let c = 0; c < k; c++) next[r]! += B[r * k + c]! * past[age * k + c]!;
          }
          s.set(next);
        }
      },
      fill: (value) => {
        for (let i = 0; i < past.length; i++) past[i] = value[i % k]!;
        let at = o;
        for (const i of this.slow) s[at++] = value[i]!;
      },
    };
    return estimate;
  }
}
