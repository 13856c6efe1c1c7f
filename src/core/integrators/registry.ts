import { AdamsMoulton } from './adamsMoulton.ts';
import type { OdeProblem, Stepper, StepperOptions } from './contract.ts';
import { Dop853 } from './dop853.ts';
import { Dopri5 } from './dopri5.ts';
import { Euler, Rk4 } from './explicitFixed.ts';

export interface MethodInfo {
  id: string;
  label: string;
  adaptive: boolean;
  create(problem: OdeProblem, options: StepperOptions): Stepper;
}

/** Every stepper by its permanent id; the first is the default. */
export const methods: readonly MethodInfo[] = [
  { id: 'dopri5', label: 'Dormand–Prince 5(4)', adaptive: true, create: (problem, options) => new Dopri5(problem, options) },
  { id: 'dop853', label: 'Dormand–Prince 8(5,3)', adaptive: true, create: (problem, options) => new Dop853(problem, options) },
  { id: 'euler', label: 'Euler', adaptive: false, create: (problem, options) => new Euler(problem, options) },
  { id: 'rk4', label: 'Runge–Kutta 4', adaptive: false, create: (problem, options) => new Rk4(problem, options) },
  { id: 'adams-moulton', label: 'Adams–Moulton 2', adaptive: false, create: (problem, options) => new AdamsMoulton(problem, options) },
];

export function methodNamed(id: string): MethodInfo | undefined {
  return methods.find((m) => m.id === id);
}

/** Ways to get accelerations, by permanent id. */
export const formulations: readonly { id: string; label: string }[] = [{ id: 'multipliers', label: 'Lagrange multipliers' }];
