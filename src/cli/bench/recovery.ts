/** How far a balanced board may be disturbed and still come upright again: by simulation, with one design per speed. */
import { feedbackOf } from '../../core/control/design/feedback.ts';
import { checkScenario } from '../../core/scenario/schema.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import '../../core/simulation/everyMotion.ts';
import { Simulation } from '../../core/simulation/simulation.ts';
import { systems } from '../../core/systems/all.ts';

const system = systems['ripstik']!;
const metas = { ripstik: system.meta };
const DEGREE = Math.PI / 180;
/** A board whose plates are within this of upright at the end has come back, rad. */
const UPRIGHT = 0.5 * DEGREE;
const LEAN_S = 12;
const PUSH_S = 14;
/** Runs are told apart by whether they fall: digits beyond these do not matter. */
const METHOD = { rtol: 1e-6, atol: 1e-9 };

export interface Balance {
  /** m/s. */
  speed: number;
  inputs: readonly string[];
  /** Of each input, N·m; null: none. */
  limit: number | null;
}

/** Whether the board comes upright with its plates (and not its rod) leaning at the start by an angle (rad). */
export function leanTest(balance: Balance): (lean: number) => boolean {
  const recovers = recovery(balance, LEAN_S);
  return (lean) => recovers({ initial: { X_dot: balance.speed, alpha_fp: lean, alpha_bp: lean } });
}

/** Whether it comes upright after the report's two blows (its section 3.5), N·m on each plate, here at 2 s and 6 s. */
export function pushTest(balance: Balance): (size: number) => boolean {
  const recovers = recovery(balance, PUSH_S);
  return (size) => {
    const push = `${size}*exp(-10*(t-2)^2) - ${size}*exp(-10*(t-6)^2)`;
    return recovers({ initial: { X_dot: balance.speed }, inputs: { tau_fp: push, tau_bp: push } });
  };
}

/** The design is made once; it does not depend on what disturbs the board. */
function recovery({ speed, inputs, limit }: Balance, duration: number): (what: Partial<ScenarioFile>) => boolean {
  const limits = limit === null ? {} : Object.fromEntries(inputs.map((name) => [name, limit]));
  const control = { type: 'lqr' as const, inputs: [...inputs], at: { X_dot: speed }, limits };
  const base: ScenarioFile = { version: 1, system: 'ripstik', control, method: METHOD, duration, outputStep: duration };
  const feedback = feedbackOf(checkScenario(base, metas), system);
  return (what) => {
    const simulation = new Simulation(checkScenario({ ...base, ...what }, metas), system, { feedback });
    simulation.advance(() => false);
    if (simulation.end!.reason !== 'end') return false;
    const { columns, rows } = simulation.takeChunk();
    const last = (name: string): number => columns[simulation.columns.indexOf(name)]![rows - 1]!;
    return ['alpha_fp', 'alpha_bp'].every((plate) => Math.abs(last('alpha') + last(plate)) < UPRIGHT);
  };
}

/** Steps in which sizes are tried upwards: islands of survival beyond the first failure are not taken for the limit. */
const STRIDE = 1.08;
/** Where gaps just below what was found are looked for, as shares of it; and how often such a gap becomes the new limit. */
const PROBES = [0.99, 0.98, 0.97, 0.96, 0.94, 0.92];
const MOST_TRIES = 4;

/**
 * How much is survived: halved from `start` until it is, then raised by strides to the first failure (at most to `most`),
 * then bisected until the two ends are within `ratio`. A few sizes just below are looked at too; other gaps narrower than a
 * stride are not seen.
 */
export function largest(
  survives: (size: number) => boolean,
  start: number,
  most: number,
  ratio: number,
): { survived: number; failed: number } {
  let low = start;
  while (!survives(low)) {
    low /= 2;
    if (low < start / 2 ** 24) return { survived: 0, failed: 2 * low };
  }
  let high = low;
  do {
    if (low >= most) return { survived: most, failed: Infinity };
    low = high;
    high = Math.min(most, STRIDE * high);
  } while (survives(high));
  for (let tries = 0; tries < MOST_TRIES; tries++) {
    while (high > ratio * low) {
      const middle = Math.sqrt(low * high);
      if (survives(middle)) low = middle;
      else high = middle;
    }
    const gap = PROBES.map((share) => share * low).find((size) => !survives(size));
    if (gap === undefined) break;
    low = gap;
    do {
      high = low;
      low /= ratio;
    } while (!survives(low));
  }
  return { survived: low, failed: high };
}

export const degrees = (angle: number): number => angle / DEGREE;
