import { cosine, sine } from '../../elementary/trigonometry.ts';
import { Matrix } from 'ml-matrix';
import { inputsOf } from '../../model/inputs.ts';
import type { Feedback } from '../../mechanics/forcing.ts';
import { ScenarioError, type LqrControl, type Scenario } from '../../scenario/types.ts';
import type { System, SystemMeta } from '../../model/system.ts';
import { GainSchedule } from './gainSchedule.ts';
import { designLqr } from './lqr.ts';
import { located, preparedPlant } from '../linearization/preparedPlant.ts';
import { plantOf, weightsOf } from './scenarioControl.ts';

/** A gain on how far the motion has come, beside the largest, above which a schedule can't leave it out. */
const NO_GAIN = 1e-9;

/** The velocity along the heading, and what it depends on. */
interface Forward {
  ahead: number;
  aside: number;
  heading: number;
}

/**
 * State feedback with the gain and the steady motion of the speed s that there is: `u = -K(s) (x - x_ref(s))`. Of x_ref
 * only what stands still and the velocities are held; how far along the motion is (X, the turns of wheels) is not.
 */
export class ScheduledFeedback implements Feedback {
  private readonly gains: GainSchedule;
  private readonly forward: Forward;
  private readonly q0: Float64Array;
  /** Velocities of the steady motion per speed: v0 = s times it. */
  private readonly perSpeed: Float64Array;
  readonly limit: number;
  private readonly K: Float64Array;
  private readonly slope: Float64Array;

  /** @param gains one row, 2n, without entries for coordinates that move */
  constructor(gains: GainSchedule, forward: Forward, q0: Float64Array, perSpeed: Float64Array, limit: number) {
    this.gains = gains;
    this.forward = forward;
    this.q0 = q0;
    this.perSpeed = perSpeed;
    this.limit = limit;
    this.K = new Float64Array(gains.columns);
    this.slope = new Float64Array(gains.columns);
  }

  /** What the gain asks, before any limit; `K` is then that of the state. */
  asked(_t: number, q: Float64Array, v: Float64Array): number {
    const { K, q0, perSpeed } = this;
    const n = q0.length;
    const s = this.speed(q, v);
    this.gains.at(s, K);
    let u = 0;
    for (let i = 0; i < n; i++) u -= K[i]! * (q[i]! - q0[i]!) + K[n + i]! * (v[i]! - s * perSpeed[i]!);
    return u;
  }

  private speed(q: Float64Array, v: Float64Array): number {
    const { ahead, aside, heading } = this.forward;
    return v[ahead]! * cosine(q[heading]!) + v[aside]! * sine(q[heading]!);
  }

  /** Exact: K, and what the speed does to K and to the reference. */
  addSlopes(
    _t: number,
    q: Float64Array,
    v: Float64Array,
    weight: number,
    row: number,
    forceQ: Float64Array,
    forceV: Float64Array,
  ): void {
    const {
      K,
      slope,
      q0,
      perSpeed,
      forward: { ahead, aside, heading },
    } = this;
    const n = q0.length;
    const s = this.speed(q, v);
    this.gains.at(s, K);
    this.gains.slopeAt(s, slope);
    let bySpeed = 0;
    for (let i = 0; i < n; i++) {
      forceQ[row + i]! -= weight * K[i]!;
      forceV[row + i]! -= weight * K[n + i]!;
      bySpeed -= slope[i]! * (q[i]! - q0[i]!) + slope[n + i]! * (v[i]! - s * perSpeed[i]!) - K[n + i]! * perSpeed[i]!;
    }
    const [c, d] = [cosine(q[heading]!), sine(q[heading]!)];
    forceV[row + ahead]! += weight * bySpeed * c;
    forceV[row + aside]! += weight * bySpeed * d;
    forceQ[row + heading]! += weight * bySpeed * (v[aside]! * c - v[ahead]! * d);
  }
}

/**
 * An lqr with a schedule, by input.
 *
 * @param scenario checked, SI
 * @param system that the scenario names
 * @param control with a schedule
 * @throws ScenarioError where one of its speeds has no design, or the gain asks how far along the motion is
 */
export function scheduledFeedbackOf(scenario: Scenario, system: System, control: LqrControl): Map<string, Feedback> {
  const { meta } = system;
  const { from, to, count } = control.schedule!;
  const forward = forwardOf(meta);
  // Evenly in their ratios: gains change most at low speed.
  const speeds = Array.from({ length: count }, (_, i) => from * (to / from) ** (i / (count - 1)));
  const inputs = control.inputs.map((name) => inputsOf(meta).find((input) => input.name === name)!);
  const weights = weightsOf(control, meta);
  const plant = plantOf(scenario, system);
  const designs = speeds.map((speed) => {
    const prepared = preparedPlant(
      plant,
      atSpeed(control.at as Record<string, number>, meta, speed),
      inputs,
      'control.schedule',
    );
    const { gain } = located('control.schedule', () => designLqr(prepared.plant, weights));
    return { motion: prepared.motion, gain: withoutPlace(gain, prepared.motion.moving, meta) };
  });
  const { q, v } = designs.at(-1)!.motion;
  const perSpeed = v.map((x) => x / speeds.at(-1)!);
  const limits = control.limits ?? {};
  return new Map(
    inputs.map(({ name }, k) => {
      const rows = new Map(designs.map(({ gain }, i) => [speeds[i]!, { gain: Matrix.rowVector(gain.getRow(k)) }]));
      const gains = new GainSchedule(speeds, (speed) => rows.get(speed)!);
      return [name, new ScheduledFeedback(gains, forward, q, perSpeed, Number(limits[name] ?? Infinity))];
    }),
  );
}

function forwardOf(meta: SystemMeta): Forward {
  const { along, heading } = (meta.forward ?? meta.speed)!;
  const index = (name: string): number => meta.coordinates.findIndex((c) => c.name === name);
  const rate = (name: string): number => meta.coordinates.findIndex((c) => `${c.name}_dot` === name);
  return { ahead: rate(along[0]), aside: rate(along[1]), heading: index(heading) };
}

/** The point with another speed in the direction that it heads for. */
function atSpeed(at: Readonly<Record<string, number>>, meta: SystemMeta, speed: number): Record<string, number> {
  const { along, heading } = (meta.forward ?? meta.speed)!;
  const angle = at[heading] ?? 0;
  const sideways = speed * sine(angle);
  return {
    ...at,
    [along[0]]: speed * cosine(angle),
    ...(sideways === 0 && at[along[1]] === undefined ? {} : { [along[1]]: sideways }),
  };
}

/** The gain with exact zeros at coordinates that move: a schedule has no place for them to be. */
function withoutPlace(gain: Matrix, moving: readonly string[], meta: SystemMeta): Matrix {
  const cleared = gain.clone();
  const most = NO_GAIN * gain.clone().abs().max();
  for (const name of moving) {
    const i = meta.coordinates.findIndex((c) => c.name === name);
    for (let k = 0; k < gain.rows; k++) {
      if (Math.abs(gain.get(k, i)) > most)
        throw new ScenarioError(
          'control.schedule',
          `the gain would hold ${name} to a place, which a schedule has not; give ${name} no weight, or name inputs that do not reach it`,
        );
      cleared.set(k, i, 0);
    }
  }
  return cleared;
}
