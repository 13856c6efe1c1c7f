import type { OdeProblem, Stepper, StepperOptions } from './contract.ts';
import type { OdeMethodId } from './methods.ts';
import { EmbeddedRungeKutta } from './runge-kutta/embeddedRungeKutta.ts';
import { Euler, Rk4 } from './runge-kutta/explicitFixed.ts';
import type { EmbeddedTableau } from './runge-kutta/tableau.ts';
import { bs23 } from './runge-kutta/tableaus/bs23.ts';
import { dop853 } from './runge-kutta/tableaus/dop853.ts';
import { dopri5 } from './runge-kutta/tableaus/dopri5.ts';
import { tsit5 } from './runge-kutta/tableaus/tsit5.ts';

export type CreateStepper = (problem: OdeProblem, options: StepperOptions) => Stepper;

/** The embedded explicit pairs by id: methods that are told apart by their tableaus alone. */
export const embeddedPairs = { dopri5, dop853, tsit5, bs23 } as const satisfies Partial<
  Record<OdeMethodId, EmbeddedTableau>
>;

const embedded =
  (tableau: EmbeddedTableau): CreateStepper =>
  (problem, options) =>
    new EmbeddedRungeKutta(problem, options, tableau);

/** How each explicit method of `methods.ts` is made. */
export const explicitSteppers = {
  dopri5: embedded(dopri5),
  dop853: embedded(dop853),
  tsit5: embedded(tsit5),
  bs23: embedded(bs23),
  euler: (problem, options) => new Euler(problem, options),
  rk4: (problem, options) => new Rk4(problem, options),
} as const satisfies Partial<Record<OdeMethodId, CreateStepper>>;
