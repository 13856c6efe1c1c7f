/**
 * The methods there are, as names and facts: all that a page needs to offer them. `registry.ts` makes the steppers of
 * y' = f(t, y); `ida`, for F(t, y, y') = 0, is made where the residual is (`../simulation/motion.ts`).
 */
export interface MethodInfo {
  id: string;
  label: string;
  /** False for fixed-step methods: tolerances then have no meaning. */
  adaptive: boolean;
  /** Numbers of stages to choose from; the method has its own default. */
  stages?: readonly number[];
}

/** Every stepper by its permanent id; the first is the default. */
export const methods = [
  { id: 'dopri5', label: 'Dormand–Prince 5(4)', adaptive: true },
  { id: 'dop853', label: 'Dormand–Prince 8(5,3)', adaptive: true },
  { id: 'tsit5', label: 'Tsitouras 5(4)', adaptive: true },
  { id: 'bs23', label: 'Bogacki–Shampine 3(2)', adaptive: true },
  { id: 'euler', label: 'Euler', adaptive: false },
  { id: 'rk4', label: 'Runge–Kutta 4', adaptive: false },
  { id: 'adams-moulton', label: 'Adams–Moulton 2', adaptive: false },
  { id: 'gauss', label: 'Gauss', adaptive: true, stages: [1, 2, 3, 4] },
  { id: 'radau', label: 'Radau IIA', adaptive: true, stages: [2, 3] },
  { id: 'bdf', label: 'BDF', adaptive: true },
  { id: 'ida', label: 'IDA (BDF on the residual)', adaptive: true },
] as const satisfies readonly MethodInfo[];

export type MethodId = (typeof methods)[number]['id'];

/** Those that advance any y' = f(t, y), so every formulation. */
export type OdeMethodId = Exclude<MethodId, 'ida'>;
