/**
 * The methods there are, as names and facts: all that a page needs to offer them. `registry.ts` makes the steppers of
 * y' = f(t, y); `ida`, for F(t, y, y') = 0, is made where the residual is (`../simulation/motion.ts`).
 */
export interface MethodInfo {
  id: string;
  label: string;
  /** False for fixed-step methods: tolerances then have no meaning. */
  adaptive: boolean;
  /** Solves equations at every step, with the Jacobians of the system. */
  implicit: boolean;
  /** Numbers of stages to choose from; the method has its own default. */
  stages?: readonly number[];
}

/** Every stepper by its permanent id; the first is the default. */
export const methods = [
  { id: 'dopri5', label: 'Dormand–Prince 5(4)', adaptive: true, implicit: false },
  { id: 'dop853', label: 'Dormand–Prince 8(5,3)', adaptive: true, implicit: false },
  { id: 'tsit5', label: 'Tsitouras 5(4)', adaptive: true, implicit: false },
  { id: 'bs23', label: 'Bogacki–Shampine 3(2)', adaptive: true, implicit: false },
  { id: 'euler', label: 'Euler', adaptive: false, implicit: false },
  { id: 'rk4', label: 'Runge–Kutta 4', adaptive: false, implicit: false },
  { id: 'adams-moulton', label: 'Adams–Moulton 2', adaptive: false, implicit: true },
  { id: 'gauss', label: 'Gauss', adaptive: true, implicit: true, stages: [1, 2, 3, 4] },
  { id: 'radau', label: 'Radau IIA', adaptive: true, implicit: true, stages: [2, 3] },
  { id: 'bdf', label: 'BDF', adaptive: true, implicit: true },
  { id: 'ida', label: 'IDA (BDF on the residual)', adaptive: true, implicit: true },
] as const satisfies readonly MethodInfo[];

export type MethodId = (typeof methods)[number]['id'];

/** Those that advance any y' = f(t, y), so every formulation. */
export type OdeMethodId = Exclude<MethodId, 'ida'>;
