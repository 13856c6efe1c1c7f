import { Collocation } from './collocation/collocation.ts';
import { gauss, radau } from './collocation/collocationCoefficients.ts';
import type { OdeProblem, Stepper, StepperOptions } from './contract.ts';
import { explicitSteppers, type CreateStepper } from './explicit.ts';
import type { OdeMethodId } from './methods.ts';
import { AdamsMoulton } from './multistep/adamsMoulton.ts';
import { Bdf } from './multistep/bdf.ts';

/** How each method of `methods.ts` is made, but `ida`. */
const steppers: Readonly<Record<OdeMethodId, CreateStepper>> = {
  ...explicitSteppers,
  'adams-moulton': (problem, options) => new AdamsMoulton(problem, options),
  gauss: (problem, options) => new Collocation(problem, options, gauss(options.stages ?? 3)),
  radau: (problem, options) => new Collocation(problem, options, radau(options.stages ?? 3)),
  bdf: (problem, options) => new Bdf(problem, options),
};

/**
 * A stepper of y' = f(t, y).
 *
 * @param id permanent id, of `methods.ts`
 * @param problem the right-hand side and, where it has one, its Jacobian
 * @param options tolerances, steps and, for collocation, stages
 * @returns undefined where there is none of that name
 * @throws RangeError for a number of stages that the method does not have
 */
export function createStepper(id: string, problem: OdeProblem, options: StepperOptions): Stepper | undefined {
  return Object.hasOwn(steppers, id) ? steppers[id as OdeMethodId](problem, options) : undefined;
}
