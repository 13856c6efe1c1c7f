import type { System } from '../../model/system.ts';
import { ScenarioError, type Scenario } from '../../scenario/types.ts';
import { StartError } from '../../mechanics/consistentStart.ts';
import type { LqrDesign } from '../design/lqr.ts';
import { linearizedInputs, weightsOf } from '../design/scenarioControl.ts';
import { linearize } from '../linearization/linearize.ts';
import { ControlError } from '../linearization/matrices.ts';
import { eigenvalues } from '../linearization/spectrum.ts';
import { steadyMotionAt } from '../linearization/steadyMotion.ts';
import { delayMargin, heldDelayMargin } from '../margins.ts';
import { designFamily, setTo } from './families.ts';
import { checkRange, oneOpen, spread, type LocusRequest } from './scenarioLocus.ts';

/** Which number of a scenario is varied, over what (SI). */
export type CurvesRequest = Omit<LocusRequest, 'closed'>;

/** One value of what is varied: how fast the plant falls by itself, and what its regulator, designed anew there, takes. */
export interface CurvePoint {
  value: number;
  /** Real part of the fastest growing mode of the open loop, 1/s; 0 where none grows. */
  growth: number;
  /** How many modes grow. */
  growing: number;
  /** Largest entry of K by size, and which it is; null where there is no design. */
  gain: number | null;
  gainOf: { input: string; state: string } | null;
  /** The shortest pure delay that lets a mode grow, s; null without a design, or where no delay does. */
  delay: number | null;
  /** The same with the inputs held between the scenario's samples; null without `control.sample`. */
  heldDelay: number | null;
  /** Why there is no design, or (the other numbers then null or 0) no steady motion. */
  problem: string | null;
}

export interface DesignCurves {
  request: CurvesRequest;
  /** s; null where the scenario's regulator is not sampled. */
  sample: number | null;
  points: CurvePoint[];
}

/**
 * The regulator of a scenario designed anew at every value of one of its numbers (a speed, above all).
 *
 * @param scenario checked, SI, with an lqr
 * @param system that the scenario names
 * @param request which number varies, and its range
 * @param progress is told the share of the range that is done
 * @throws ScenarioError without an lqr, or where the range is none
 */
export function designCurves(
  scenario: Scenario,
  system: System,
  request: CurvesRequest,
  progress: (share: number) => void = () => {},
): DesignCurves {
  const { control } = scenario;
  if (control?.type !== 'lqr')
    throw new ScenarioError('control', 'must be of type "lqr": its gain is what the curves tell');
  checkRange(request);
  const open = oneOpen(scenario, system, request);
  const inputs = linearizedInputs(scenario, system.meta);
  const design = designFamily(open, inputs, weightsOf(control, system.meta));
  const sample = control.sample || null;
  const values = spread(request.from, request.to, request.count);
  const points = values.map((value, i): CurvePoint => {
    const point: CurvePoint = {
      value,
      growth: 0,
      growing: 0,
      gain: null,
      gainOf: null,
      delay: null,
      heldDelay: null,
      problem: null,
    };
    try {
      const { plant, at } = setTo(open, value);
      const growing = eigenvalues(linearize(steadyMotionAt(plant, at), inputs).tangentA)
        .map(([re]) => re)
        .filter((re) => re > GROWS);
      Object.assign(point, { growing: growing.length, growth: Math.max(0, ...growing) });
      Object.assign(point, toldOf(design(value), sample));
    } catch (error) {
      if (!(error instanceof ControlError || error instanceof StartError)) throw error;
      point.problem = error.message;
    }
    progress((i + 1) / values.length);
    return point;
  });
  return { request, sample, points };
}

/** A double zero that feedback or rounding split grows no faster than this, 1/s. */
const GROWS = 1e-6;

function toldOf(
  { gain, linearization: { inputs, states }, quotient: { A, B }, riccati }: LqrDesign,
  sample: number | null,
): Partial<CurvePoint> {
  let [row, column] = [0, 0];
  for (let r = 0; r < gain.rows; r++) {
    for (let c = 0; c < gain.columns; c++)
      if (Math.abs(gain.get(r, c)) > Math.abs(gain.get(row, column))) [row, column] = [r, c];
  }
  const loop = { A, B, K: riccati.gain };
  const bounded = (x: number): number | null => (x < Infinity ? x : null);
  return {
    gain: Math.abs(gain.get(row, column)),
    gainOf: { input: inputs[row]!, state: states[column]! },
    delay: A.rows > 0 ? bounded(delayMargin(loop)) : null,
    heldDelay: A.rows > 0 && sample ? bounded(heldDelayMargin(loop, sample)) : null,
  };
}

/** One value a line, SI: what was varied, then the curves; an empty field where there is none. */
export function curvesCsv({ request, sample, points }: DesignCurves): string {
  const head = [request.name, 'growth', 'growing', 'gain', 'delay', ...(sample ? ['heldDelay'] : []), 'problem'];
  const field = (x: number | null): string => (x === null ? '' : String(x));
  const rows = points.map(({ value, growth, growing, gain, delay, heldDelay, problem }) => [
    field(value),
    field(growth),
    String(growing),
    field(gain),
    field(delay),
    ...(sample ? [field(heldDelay)] : []),
    problem === null ? '' : JSON.stringify(problem).replaceAll('\\"', '""'),
  ]);
  return `${[head, ...rows].map((row) => row.join(',')).join('\n')}\n`;
}
