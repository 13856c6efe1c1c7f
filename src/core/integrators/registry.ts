import { AdamsMoulton } from './multistep/adamsMoulton.ts';
import { Bdf } from './multistep/bdf.ts';
import { Collocation } from './collocation/collocation.ts';
import { gauss, radau } from './collocation/collocationCoefficients.ts';
import type { OdeProblem, Stepper, StepperOptions } from './contract.ts';
import { EmbeddedRungeKutta } from './runge-kutta/embeddedRungeKutta.ts';
import { Euler, Rk4 } from './runge-kutta/explicitFixed.ts';
import type { EmbeddedTableau } from './runge-kutta/tableau.ts';
import { bs23 } from './runge-kutta/tableaus/bs23.ts';
import { dop853 } from './runge-kutta/tableaus/dop853.ts';
import { dopri5 } from './runge-kutta/tableaus/dopri5.ts';
import { tsit5 } from './runge-kutta/tableaus/tsit5.ts';
import type { OdeMethodId } from './methods.ts';

/** The embedded explicit pairs by id: methods that are told apart by their tableaus alone. */
export const embeddedPairs = { dopri5, dop853, tsit5, bs23 } as const satisfies Partial<
  Record<OdeMethodId, EmbeddedTableau>
>;

const embedded =
  (tableau: EmbeddedTableau): Create =>
  (problem, options) =>
    new EmbeddedRungeKutta(problem, options, tableau);

type Create = (problem: OdeProblem, options: StepperOptions) => Stepper;

/** How each method of `methods.ts` is made, but `ida`. */
const steppers: Readonly<Record<OdeMethodId, Create>> = {
  dopri5: embedded(dopri5),
  dop853: embedded(dop853),
  tsit5: embedded(tsit5),
  bs23: embedded(bs23),
  euler: (problem, options) => new Euler(problem, options),
  rk4: (problem, options) => new Rk4(problem, options),
  'adams-moulton': (problem, options) => new AdamsMoulton(problem, options),
  gauss: (problem, options) => new Collocation(problem, options, gauss(options.stages ?? 3)),
  radau: (problem, options) => new Collocation(problem, options, radau(options.stages ?? 3)),
  bdf: (problem, options) => new Bdf(problem, options),
};

/**
 * A stepper of y' = f(t, y).
 * @param id permanent id, of `methods.ts`
 * @returns undefined where there is none of that name
 * @throws RangeError for a number of stages that the method does not have
 */
export function createStepper(id: string, problem: OdeProblem, options: StepperOptions): Stepper | undefined {
  return Object.hasOwn(steppers, id) ? steppers[id as OdeMethodId](problem, options) : undefined;
}
