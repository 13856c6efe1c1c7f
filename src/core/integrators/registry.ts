import { AdamsMoulton } from './adamsMoulton.ts';
import type { OdeProblem, Stepper, StepperOptions } from './contract.ts';
import { Collocation } from './collocation.ts';
import { GAUSS_STAGES, RADAU_STAGES, gauss, radau } from './collocationCoefficients.ts';
import { Dop853 } from './dop853.ts';
import { Dopri5 } from './dopri5.ts';
import { Euler, Rk4 } from './explicitFixed.ts';

export interface MethodInfo {
  id: string;
  label: string;
  adaptive: boolean;
  /** Numbers of stages to choose from; the method has its own default. */
  stages?: readonly number[];
  create(problem: OdeProblem, options: StepperOptions): Stepper;
}

/** Every stepper by its permanent id; the first is the default. */
export const methods: readonly MethodInfo[] = [
  { id: 'dopri5', label: 'Dormand–Prince 5(4)', adaptive: true, create: (problem, options) => new Dopri5(problem, options) },
  { id: 'dop853', label: 'Dormand–Prince 8(5,3)', adaptive: true, create: (problem, options) => new Dop853(problem, options) },
  { id: 'euler', label: 'Euler', adaptive: false, create: (problem, options) => new Euler(problem, options) },
  { id: 'rk4', label: 'Runge–Kutta 4', adaptive: false, create: (problem, options) => new Rk4(problem, options) },
  { id: 'adams-moulton', label: 'Adams–Moulton 2', adaptive: false, create: (problem, options) => new AdamsMoulton(problem, options) },
  {
    id: 'gauss', label: 'Gauss', adaptive: true, stages: GAUSS_STAGES,
    create: (problem, options) => new Collocation(problem, options, gauss(options.stages ?? 3)),
  },
  {
    id: 'radau', label: 'Radau IIA', adaptive: true, stages: RADAU_STAGES,
    create: (problem, options) => new Collocation(problem, options, radau(options.stages ?? 3)),
  },
];

export function methodNamed(id: string): MethodInfo | undefined {
  return methods.find((m) => m.id === id);
}

/** Ways to get accelerations, by permanent id. */
export const formulations: readonly { id: string; label: string }[] = [{ id: 'multipliers', label: 'Lagrange multipliers' }];
