import { logarithm } from '../../elementary/powers.ts';
import type { Scenario } from '../../scenario/types.ts';
import type { System } from '../../model/system.ts';
import { inputsOf } from '../../model/inputs.ts';
import { plantOf } from '../design/scenarioControl.ts';
import { ControlError } from '../linearization/matrices.ts';
import { plainEigenvalues } from '../linearization/spectrum.ts';
import { compareOrders } from '../linearization/linearize.ts';
import type { InputMeta } from '../../model/system.ts';
import { steadyTurn, type SteadyTurn } from './steadyTurn.ts';
import { StartError } from '../../mechanics/consistentStart.ts';

/** Steady turns over radius and speed. */
export interface TurnMap {
  /** m, ascending. */
  radii: readonly number[];
  /** m/s, ascending. */
  speeds: readonly number[];
  /** By speed, then by radius: the growth rate of the fastest mode, the inputs held at u0 (1/s); null where there is no turn. */
  growth: (number | null)[][];
  /** Likewise: the largest of the inputs u0 that hold it. */
  effort: (number | null)[][];
  /** The orders of linearizing and eliminating at one of them, under the inputs that hold it; null where there is no turn at all. */
  orders: TurnOrders | null;
}

/** Eliminating first (a), linearizing first (b), and with the constraints frozen (c), at a turn held by inputs u0. */
export interface TurnOrders {
  /** m, m/s */
  radius: number;
  speed: number;
  /** By input. */
  u0: Record<string, number>;
  /** Largest difference of (b) and of (c) from (a). */
  difference: number;
  frozenDifference: number;
}

/** The turn whose orders are compared: the one nearest to this radius (m) and speed (m/s), in ratios. */
const COMPARED = [1, 1] as const;

export const TURN_RADII = [0.5, 0.7, 1, 1.5, 2, 3, 5, 10] as const;
export const TURN_SPEEDS = [0.5, 0.75, 1, 1.5, 2, 3, 4] as const;

/**
 * Turns to the left; those to the right are their mirror images.
 *
 * @param scenario checked, SI
 * @param system that the scenario names
 * @param tell share done
 * @param radii m
 * @param speeds m/s
 */
export function turnMap(
  scenario: Scenario,
  system: System,
  tell: (share: number) => void = () => {},
  radii: readonly number[] = TURN_RADII,
  speeds: readonly number[] = TURN_SPEEDS,
): TurnMap {
  const { meta } = system;
  const plant = plantOf(scenario, system);
  const { control } = scenario;
  const names = control?.type === 'lqr' ? control.inputs : meta.inputs.map((i) => i.name);
  const inputs = inputsOf(meta).filter((input) => names.includes(input.name));
  const along = (meta.forward ?? meta.speed)?.along[0] ?? '';
  const growth: TurnMap['growth'] = [];
  const effort: TurnMap['effort'] = [];
  const turns: { away: number; radius: number; turn: SteadyTurn }[] = [];
  speeds.forEach((speed, row) => {
    const [rates, inputSizes]: [(number | null)[], (number | null)[]] = [[], []];
    for (const radius of radii) {
      try {
        const turn = steadyTurn(plant, { [along]: speed }, 1 / radius, inputs);
        const { linearization, u0 } = turn;
        const away = Math.abs(logarithm(radius / COMPARED[0])) + Math.abs(logarithm(speed / COMPARED[1]));
        turns.push({ away, radius, turn });
        rates.push(Math.max(...plainEigenvalues(linearization.tangentA).map(([re]) => re)));
        inputSizes.push(Math.max(0, ...u0.map(Math.abs)));
      } catch (error) {
        if (!(error instanceof ControlError || error instanceof StartError)) throw error;
        rates.push(null);
        inputSizes.push(null);
      }
    }
    growth.push(rates);
    effort.push(inputSizes);
    tell((row + 1) / speeds.length);
  });
  const compared = turns.sort((a, b) => a.away - b.away)[0];
  return { radii, speeds, growth, effort, orders: compared ? ordersAt(compared.turn, compared.radius, inputs) : null };
}

function ordersAt({ motion, speed, u0 }: SteadyTurn, radius: number, inputs: readonly InputMeta[]): TurnOrders {
  const { difference, frozenDifference } = compareOrders(motion, inputs);
  const named = Object.fromEntries(inputs.map(({ name }, i) => [name, u0[i]!]));
  return { radius, speed, u0: named, difference, frozenDifference };
}
