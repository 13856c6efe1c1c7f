import { Sensors } from '../sampled/sensors.ts';
import { SampledEstimator } from '../sampled/estimator.ts';
import type { LqrDesign } from './lqr.ts';
import { filterOf, lqrOf, sampledDesignOf, timingOf } from './scenarioControl.ts';
import { rideFeedbackOf } from '../ride/rideFeedback.ts';
import { pathFeedbackOf } from '../path/pathFeedback.ts';
import { scheduledFeedbackOf } from './scheduledFeedback.ts';
import type { Estimator, Feedback } from '../../mechanics/forcing.ts';
import { ScenarioError, type Scenario } from '../../scenario/types.ts';
import type { System } from '../../model/system.ts';

/**
 * State feedback `u = -K (x - x_ref(t))`, x_ref(t) = (q0 + v0 t, v0): what one input of the controller asks.
 * Nothing is allocated.
 */
export class StateFeedback implements Feedback {
  private readonly gainQ: Float64Array;
  private readonly gainV: Float64Array;
  readonly point: Float64Array;
  private readonly v0: Float64Array;
  readonly limit: number;
  readonly past: Float64Array;
  readonly acting: Float64Array;
  readonly estimator: Estimator | null;

  /** @param gain the input's row of K, 2n @param computer its rows of the gains on past and acting inputs (see `Feedback`) */
  constructor(
    gain: ArrayLike<number>,
    q0: Float64Array,
    v0: Float64Array,
    limit: number,
    computer: { past?: ArrayLike<number>; acting?: ArrayLike<number>; estimator?: Estimator | null } = {},
  ) {
    this.past = Float64Array.from(computer.past ?? []);
    this.acting = Float64Array.from(computer.acting ?? []);
    this.estimator = computer.estimator ?? null;
    const n = q0.length;
    this.gainQ = Float64Array.from({ length: n }, (_, i) => gain[i]!);
    this.gainV = Float64Array.from({ length: n }, (_, i) => gain[n + i]!);
    this.point = q0;
    this.v0 = v0;
    this.limit = limit;
  }

  /** What the gain asks, before any limit. */
  asked(t: number, q: Float64Array, v: Float64Array): number {
    const { gainQ, gainV, point: q0, v0 } = this;
    let u = 0;
    for (let i = 0; i < q0.length; i++) {
      u -= gainQ[i]! * (q[i]! - q0[i]! - v0[i]! * t) + gainV[i]! * (v[i]! - v0[i]!);
    }
    return u;
  }

  /** Adds du/dq and du/dv times `weight` onto a row of each. */
  addSlopes(
    _t: number,
    _q: Float64Array,
    _v: Float64Array,
    weight: number,
    row: number,
    forceQ: Float64Array,
    forceV: Float64Array,
  ): void {
    const { gainQ, gainV } = this;
    for (let i = 0; i < gainQ.length; i++) {
      forceQ[row + i]! -= weight * gainQ[i]!;
      forceV[row + i]! -= weight * gainV[i]!;
    }
  }
}

/**
 * The scenario's lqr or ride, by input; null where it has neither.
 *
 * @param scenario checked, SI
 * @param system that the scenario names
 * @throws ScenarioError where there is no such design
 */
export function feedbackOf(scenario: Scenario, system: System): Map<string, Feedback> | null {
  if (scenario.control?.type === 'ride') return rideFeedbackOf(scenario, system, scenario.control);
  if (scenario.control?.type !== 'lqr') return null;
  if (scenario.control.schedule) return scheduledFeedbackOf(scenario, system, scenario.control);
  if (scenario.control.path) return pathFeedbackOf(scenario, system, scenario.control);
  const design = lqrOf(scenario, system);
  const { linearization } = design;
  const sampled = scenario.control.design === 'sampled' ? sampledDesignOf(scenario, design) : null;
  const { gain } = sampled ?? design;
  const { q, v } = linearization.motion;
  const limits = scenario.control.limits ?? {};
  const estimator = estimatorOf(scenario, design);
  return new Map(
    linearization.inputs.map((name, k) => [
      name,
      new StateFeedback(gain.getRow(k), q, v, Number(limits[name] ?? Infinity), {
        past: sampled?.inputGain.getRow(k) ?? [],
        acting: sampled?.actingGain.getRow(k) ?? [],
        estimator,
      }),
    ]),
  );
}

function estimatorOf(scenario: Scenario, design: LqrDesign): Estimator | null {
  const found = filterOf(scenario, design);
  if (!found || scenario.control?.type !== 'lqr') return null;
  const { sample, sensors = {}, seed = 0 } = scenario.control;
  if (!sample)
    throw new ScenarioError(
      'control.sensors',
      'white noise has no value at a moment, so that a run with sensors needs a computer: give control.sample (s)',
    );
  const { plant, filter, deviations } = found;
  const { states } = design.linearization;
  const make = (): Sensors => new Sensors(sensors, states, sample, seed);
  return new SampledEstimator(plant, filter, make, deviations, design.linearization.motion, timingOf(scenario.control));
}
