import { Matrix } from 'ml-matrix';
import { StartError } from '../../mechanics/consistentStart.ts';
import { ScenarioError, type Scenario } from '../../scenario/types.ts';
import type { System } from '../../model/system.ts';
import { setTo, type OneOpen } from './families.ts';
import { linearize } from '../linearization/linearize.ts';
import { ControlError } from '../linearization/matrices.ts';
import { rootLocus, type CriticalValue, type RootLocus } from './rootLocus.ts';
import { linearizedInputs, lqrOf, plantOf } from '../design/scenarioControl.ts';
import type { Complex } from '../linearization/spectrum.ts';
import { steadyMotionAt } from '../linearization/steadyMotion.ts';

/** Which number of a scenario is varied, and over what (SI). */
export interface LocusRequest {
  /** A value of the operating point (a state, or `speed` where the system has it), or a parameter. */
  vary: 'at' | 'parameter';
  name: string;
  from: number;
  to: number;
  /** Values asked for, both ends among them; more are put between where eigenvalues move fast. */
  count: number;
  /** With the scenario's gain, as it is at its own operating point, kept over the whole range. */
  closed: boolean;
}

export interface ScenarioLocus extends Omit<RootLocus, 'critical'> {
  request: LocusRequest;
  /** Where the number of growing modes changes, ascending; crossings that lie together are one. */
  critical: CriticalPoint[];
  /** Values at which there is no steady motion, with the reason; they are left out. */
  skipped: { value: number; reason: string }[];
}

export interface CriticalPoint {
  value: number;
  /** On the imaginary axis there, imaginary parts not negative. */
  eigenvalues: Complex[];
  unstableBelow: number;
  unstableAbove: number;
}

/** Crossings nearer than this share of the range are one place: a board at rest, a caster without trail. */
const TOGETHER = 1e-6;

/** More than this is no plot any more. */
export const MOST_VALUES = 2000;

/**
 * Eigenvalues of a scenario's linearization against one of its numbers.
 *
 * @param scenario checked, SI
 * @param system that the scenario names
 * @param request which number varies, and its range
 * @param progress is told the share of the range that is done
 * @throws ScenarioError where the range is none, or there is no steady motion in it, or no gain to keep
 */
export function scenarioLocus(
  scenario: Scenario,
  system: System,
  request: LocusRequest,
  progress: (share: number) => void,
): ScenarioLocus {
  const { from, to, count, closed } = request;
  checkRange(request);
  const open = oneOpen(scenario, system, request);
  const inputs = closed ? linearizedInputs(scenario, system.meta) : [];
  const gain = closed ? lqrOf(scenario, system).gain : null;
  const skipped: ScenarioLocus['skipped'] = [];
  const asked = new Set<number>();
  const family = (value: number): Matrix | null => {
    try {
      const { plant, at } = setTo(open, value);
      const { A, B, basis: N, tangentA } = linearize(steadyMotionAt(plant, at), inputs);
      return gain
        ? N.transpose()
            .mmul(Matrix.sub(A, B.mmul(gain)))
            .mmul(N)
        : tangentA;
    } catch (error) {
      if (!(error instanceof ControlError || error instanceof StartError)) throw error;
      if (asked.has(value)) skipped.push({ value, reason: error.message });
      return null;
    } finally {
      if (asked.has(value)) progress((value - from) / (to - from));
    }
  };
  const values = spread(from, to, count);
  for (const value of values) asked.add(value);
  const locus = rootLocus(family, values);
  if (locus.values.length === 0)
    throw new ScenarioError('', `there is no steady motion in this range: ${skipped[0]?.reason ?? ''}`);
  return { ...locus, critical: together(locus.critical, TOGETHER * (to - from)), request, skipped };
}

/**
 * Refuses a range that is none.
 *
 * @throws ScenarioError
 */
export function checkRange({ from, to, count }: Pick<LocusRequest, 'from' | 'to' | 'count'>): void {
  if (!(Number.isFinite(from) && Number.isFinite(to) && from < to))
    throw new ScenarioError('', 'the range must rise from a number to a larger one');
  if (!(Number.isInteger(count) && count >= 2 && count <= MOST_VALUES))
    throw new ScenarioError('', `between 2 and ${MOST_VALUES} values can be asked for`);
}

/**
 * Evenly spaced, without the dust of binary fractions: rest is rest, not 1e-17 m/s.
 *
 * @param from first value
 * @param to last value
 * @param count how many, both ends among them
 */
export function spread(from: number, to: number, count: number): number[] {
  const size = Math.max(Math.abs(from), Math.abs(to));
  return Array.from({ length: count }, (_, i) => {
    if (i === 0 || i === count - 1) return i === 0 ? from : to;
    const value = from + ((to - from) * i) / (count - 1);
    return Math.abs(value) < 1e-12 * size ? 0 : Number(value.toPrecision(12));
  });
}

function together(critical: readonly CriticalValue[], width: number): CriticalPoint[] {
  const points: CriticalPoint[] = [];
  let last = -Infinity;
  for (const { value, eigenvalue, unstableBelow, unstableAbove } of critical) {
    const point = points.at(-1);
    if (point && value - last <= width) {
      point.eigenvalues.push(eigenvalue);
      point.unstableAbove = unstableAbove;
    } else {
      points.push({ value, eigenvalues: [eigenvalue], unstableBelow, unstableAbove });
    }
    last = value;
  }
  return points.filter((point) => point.unstableBelow !== point.unstableAbove);
}

/**
 * What of a scenario stays, and what is open.
 *
 * @param scenario checked, SI
 * @param system that the scenario names
 * @throws ScenarioError where it has no such number
 */
export function oneOpen(
  scenario: Scenario,
  system: System,
  { vary, name }: Pick<LocusRequest, 'vary' | 'name'>,
): OneOpen {
  const { control } = scenario;
  const at = ((control?.type === 'lqr' ? control.at : undefined) ?? scenario.at) as Record<string, number>;
  if (vary === 'parameter' && !system.meta.parameters.some((p) => p.name === name))
    throw new ScenarioError('', `there is no parameter "${name}"`);
  const { coordinates, speed } = system.meta;
  const states = coordinates.flatMap((c) => [c.name, `${c.name}_dot`]);
  if (vary === 'at' && name !== speed?.name && !states.includes(name))
    throw new ScenarioError('', `"${name}" is neither a parameter nor a state, as ${states.slice(0, 3).join(', ')}`);
  return { plant: plantOf(scenario, system), at, varied: { kind: vary, name } };
}
