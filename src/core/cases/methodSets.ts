import type { MethodOptions } from '../scenario/types.ts';

/** Named choices for comparing methods: the report's four, and those beside them. */
export interface MethodChoice {
  id: string;
  label: string;
  method: Partial<MethodOptions>;
  /** What the report's Table 1 has for it: computation and output time, s. */
  report?: { seconds: number; reached: number; reconfigurability: string };
}

const tolerances = { rtol: 1e-6, atol: 1e-8 };

export const reportMethods: readonly MethodChoice[] = [
  { id: 'qr', label: 'QR decomposition', method: { name: 'dopri5', formulation: 'nullspace-qr', ...tolerances }, report: { seconds: 1.2, reached: 0.6, reconfigurability: 'Poor' } },
  { id: 'collocation', label: 'Collocation (Radau IIA)', method: { name: 'radau', stages: 3, ...tolerances }, report: { seconds: 26.4, reached: 5.8, reconfigurability: 'Excellent' } },
  { id: 'ida', label: 'IDA', method: { name: 'ida', ...tolerances }, report: { seconds: 1.2, reached: 0.6, reconfigurability: 'Good' } },
  { id: 'blt', label: 'BLT', method: { name: 'dopri5', formulation: 'blt', ...tolerances }, report: { seconds: 1.2, reached: 0.6, reconfigurability: 'Poor' } },
];

export const otherMethods: readonly MethodChoice[] = [
  { id: 'dopri5', label: 'Dormand–Prince 5(4)', method: { name: 'dopri5', ...tolerances } },
  { id: 'dop853', label: 'DOP853', method: { name: 'dop853', ...tolerances } },
  { id: 'gauss', label: 'Gauss, 3 stages', method: { name: 'gauss', stages: 3, ...tolerances } },
  { id: 'bdf', label: 'BDF', method: { name: 'bdf', ...tolerances } },
  { id: 'rk4', label: 'Runge–Kutta 4, fixed', method: { name: 'rk4', step: 0.001 } },
  { id: 'adams-moulton', label: 'Adams–Moulton, fixed', method: { name: 'adams-moulton', step: 0.001 } },
  { id: 'euler', label: 'Euler, fixed', method: { name: 'euler', step: 0.0005 } },
];
