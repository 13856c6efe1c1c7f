import { Matrix } from 'ml-matrix';
import { cosine, sine } from '../../elementary/trigonometry.ts';
import type { Estimator, Feedback } from '../../mechanics/forcing.ts';
import type { System } from '../../model/system.ts';
import type { LqrControl, Scenario } from '../../scenario/types.ts';
import { GainSchedule } from '../design/gainSchedule.ts';
import { designLqr, reachablePlant, type LqrDesign } from '../design/lqr.ts';
import { timingOf, weightsOf } from '../design/scenarioControl.ts';
import { located } from '../linearization/preparedPlant.ts';
import { sampledLqr } from '../sampled/sampledLqr.ts';
import { pathCurve, turned, type PathCurve, type PathPlace } from './pathCurve.ts';
import { PathEstimator } from './pathEstimator.ts';
import { pathFilterOf } from './pathFilter.ts';
import { planeOf, type Plane, type SteadyTurn } from './steadyTurn.ts';
import { turnOf } from './turnOf.ts';

/**
 * Follows a path: at the place nearest to the vehicle the path has a curvature, and that a steady turn with inputs u0 and a
 * regulator K about it, `u = u0 - K x`; x is the deviation from that turn, seen from the path's place and heading. How far
 * along the vehicle has come, and its speed, are left as they are.
 */

/** Curvatures that turns are found at, where a path's changes. */
const COUNT = 9;

/** A regulator about a turn. */
export interface TurnDesign {
  turn: SteadyTurn;
  design: LqrDesign;
}

/**
 * @param scenario checked, SI
 * @param system that the scenario names
 * @param control the scenario's own
 * @param curvature of the turn, 1/m
 * @throws ScenarioError at `control.path` where there is no such turn or regulator
 */
export function turnDesign(scenario: Scenario, system: System, control: LqrControl, curvature: number): TurnDesign {
  const turn = turnOf(scenario, system, control, curvature);
  return located('control.path', () => ({
    turn,
    design: designLqr(reachablePlant(turn.linearization), weightsOf(control, system.meta)),
  }));
}

/** What a turn is held by in one row per input, for interpolation: what it asks in the turn, the steady state, the gains. */
function rowsOf({ turn, design }: TurnDesign, control: LqrControl): Matrix {
  const sampled = control.design === 'sampled' ? sampledLqr(design, timingOf(control)) : null;
  const { gain } = sampled ?? design;
  const state = [...turn.motion.q, ...turn.motion.v];
  return new Matrix(
    control.inputs.map((_, k) => {
      const onInputs = sampled ? [...sampled.actingGain.getRow(k), ...sampled.inputGain.getRow(k)] : [];
      // Those gains are taken of inputs, not of what they are off u0: what u0 makes of them is added back.
      const steady = onInputs.reduce((sum, g, i) => sum + g * turn.u0[i % turn.u0.length]!, turn.u0[k]!);
      return [steady, ...state, ...gain.getRow(k), ...onInputs];
    }),
  );
}

/**
 * An lqr that follows a path, by input.
 *
 * @param scenario checked, SI
 * @param system that the scenario names
 * @param control with a path
 * @throws ScenarioError as `turnDesign`
 */
export function pathFeedbackOf(scenario: Scenario, system: System, control: LqrControl): Map<string, Feedback> {
  const curve = pathCurve(control.path!);
  const [least, most] = curve.bends;
  const count = most - least > 1e-9 ? COUNT : 1;
  const curvatures = Array.from({ length: count }, (_, i) =>
    count === 1 ? least : least + ((most - least) * i) / (count - 1),
  );
  const designs = curvatures.map((curvature) => turnDesign(scenario, system, control, curvature));
  const rows = designs.map((design) => rowsOf(design, control));
  const plane = planeOf(system.meta);
  const n = system.meta.coordinates.length;
  const limits = control.limits ?? {};
  const estimator = control.sensors
    ? new PathEstimator(
        pathFilterOf(
          scenario,
          system,
          control,
          curve,
          curvatures,
          designs.map(({ turn }) => turn),
          plane,
        ),
        curve,
        plane,
      )
    : null;
  return new Map(
    control.inputs.map((name, k) => {
      const schedule = new GainSchedule(curvatures, (value) => ({
        gain: Matrix.rowVector(rows[curvatures.indexOf(value)]!.getRow(k)),
      }));
      return [
        name,
        new PathFeedback(schedule, curve, plane, n, control.inputs.length, Number(limits[name] ?? Infinity), estimator),
      ];
    }),
  );
}

class PathFeedback implements Feedback {
  readonly limit: number;
  readonly acting: Float64Array;
  readonly past: Float64Array;
  private readonly schedule: GainSchedule;
  private readonly curve: PathCurve;
  private readonly plane: Plane;
  private readonly n: number;
  private readonly row: Float64Array;
  private readonly place: PathPlace = { x: 0, y: 0, heading: 0, curvature: 0 };

  constructor(
    schedule: GainSchedule,
    curve: PathCurve,
    plane: Plane,
    n: number,
    inputs: number,
    limit: number,
    readonly estimator: Estimator | null,
  ) {
    this.schedule = schedule;
    this.curve = curve;
    this.plane = plane;
    this.n = n;
    this.limit = limit;
    this.row = new Float64Array(schedule.columns);
    const rest = this.row.subarray(1 + 4 * n);
    this.acting = rest.subarray(0, Math.min(inputs, rest.length));
    this.past = rest.subarray(this.acting.length);
  }

  asked(_t: number, q: Float64Array, v: Float64Array): number {
    const { n, row, plane, place } = this;
    this.curve.nearest(q[plane.x]!, q[plane.y]!, q[plane.heading]!, place);
    this.schedule.at(place.curvature, row);
    const [c, s] = [cosine(place.heading), sine(place.heading)];
    const [dx, dy] = [q[plane.x]! - place.x, q[plane.y]! - place.y];
    let u = row[0]!;
    for (let i = 0; i < n; i++) {
      let [position, rate] = [q[i]!, v[i]!];
      // Along the path it is where it is.
      if (i === plane.x) [position, rate] = [0, c * v[plane.x]! + s * v[plane.y]!];
      else if (i === plane.y) [position, rate] = [c * dy - s * dx, c * v[plane.y]! - s * v[plane.x]!];
      const off = i === plane.heading ? turned(position - place.heading - row[1 + i]!) : position - row[1 + i]!;
      u -= row[1 + 2 * n + i]! * off + row[1 + 3 * n + i]! * (rate - row[1 + n + i]!);
    }
    return u;
  }

  /** A computer's inputs do not react between its samples. */
  addSlopes(): void {}
}
