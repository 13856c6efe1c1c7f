import { AdamsMoulton } from './multistep/adamsMoulton.ts';
import { Bdf } from './multistep/bdf.ts';
import { Collocation } from './collocation/collocation.ts';
import { gauss, radau } from './collocation/collocationCoefficients.ts';
import type { OdeProblem, Stepper, StepperOptions } from './contract.ts';
import { Dop853 } from './runge-kutta/dop853.ts';
import { Dopri5 } from './runge-kutta/dopri5.ts';
import { Euler, Rk4 } from './runge-kutta/explicitFixed.ts';
import type { OdeMethodId } from './methods.ts';

type Create = (problem: OdeProblem, options: StepperOptions) => Stepper;

/** How each method of `methods.ts` is made, but `ida`. */
const steppers: Readonly<Record<OdeMethodId, Create>> = {
  dopri5: (problem, options) => new Dopri5(problem, options),
  dop853: (problem, options) => new Dop853(problem, options),
  euler: (problem, options) => new Euler(problem, options),
  rk4: (problem, options) => new Rk4(problem, options),
  'adams-moulton': (problem, options) => new AdamsMoulton(problem, options),
  gauss: (problem, options) => new Collocation(problem, options, gauss(options.stages ?? 3)),
  radau: (problem, options) => new Collocation(problem, options, radau(options.stages ?? 3)),
  bdf: (problem, options) => new Bdf(problem, options),
};

/** A stepper of y' = f(t, y) by its permanent id, or undefined where there is none of that name. */
export function createStepper(id: string, problem: OdeProblem, options: StepperOptions): Stepper | undefined {
  return Object.hasOwn(steppers, id) ? steppers[id as OdeMethodId](problem, options) : undefined;
}
