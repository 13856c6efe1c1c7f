import { methods, type MethodId } from '../integrators/methods.ts';
import type { MethodOptions, ScenarioFile } from '../scenario/types.ts';

/** Named choices for comparing methods: the report's four, and those beside them. */
export interface MethodChoice {
  id: string;
  label: string;
  method: Partial<MethodOptions>;
  /** Rows of its curve where the scenario's would hide the method's steps, s. */
  outputStep?: number;
  /** What the report's Table 1 has for it: computation and output time, s. */
  report?: { seconds: number; reached: number; reconfigurability: string };
}

const tolerances = { rtol: 1e-6, atol: 1e-8 };

export const reportMethods: readonly MethodChoice[] = [
  {
    id: 'qr',
    label: 'QR decomposition',
    method: { name: 'dopri5', formulation: 'nullspace-qr', ...tolerances },
    report: { seconds: 1.2, reached: 0.6, reconfigurability: 'Poor' },
  },
  {
    id: 'collocation',
    label: 'Collocation (Radau IIA)',
    method: { name: 'radau', stages: 3, ...tolerances },
    report: { seconds: 26.4, reached: 5.8, reconfigurability: 'Excellent' },
  },
  {
    id: 'ida',
    label: 'IDA',
    method: { name: 'ida', ...tolerances },
    report: { seconds: 1.2, reached: 0.6, reconfigurability: 'Good' },
  },
  {
    id: 'blt',
    label: 'BLT',
    method: { name: 'dopri5', formulation: 'blt', ...tolerances },
    report: { seconds: 1.2, reached: 0.6, reconfigurability: 'Poor' },
  },
];

/** Words and settings of those that need more than a name and tolerances. */
const particular: Readonly<Partial<Record<MethodId, { label: string; settings: Partial<MethodOptions> }>>> = {
  dop853: { label: 'DOP853', settings: tolerances },
  gauss: { label: 'Gauss, 3 stages', settings: { stages: 3, ...tolerances } },
  rk4: { label: 'Runge–Kutta 4, fixed', settings: { step: 0.001 } },
  'adams-moulton': { label: 'Adams–Moulton, fixed', settings: { step: 0.001 } },
  euler: { label: 'Euler, fixed', settings: { step: 0.0005 } },
};

/** Every method that is none of the report's, those of fixed step last. */
export const otherMethods: readonly MethodChoice[] = [true, false].flatMap((adaptive) =>
  methods
    .filter((m) => m.adaptive === adaptive && m.id !== 'radau' && m.id !== 'ida')
    .map(({ id, label }) => {
      const { label: words, settings } = particular[id] ?? { label, settings: tolerances };
      return { id, label: words, method: { name: id, ...settings } };
    }),
);

/** A comparison ready to run: methods, which of them to begin with, and what to draw. */
export interface MethodSet {
  id: string;
  label: string;
  choices: readonly MethodChoice[];
  /** Ids of the choices that are ticked to begin with. */
  chosen: readonly string[];
  /** Column of the first curve. */
  column: string;
  /** What is run; the scenario in the panel where it is absent. */
  scenario?: ScenarioFile;
}

/** Curves of the report's Fig. 13, each with a row per step; the exact ones are those of a method of order 8 at its finest. */
const figure13: readonly MethodChoice[] = [
  { id: 'euler-4', label: 'Euler, h = 1/4', method: { name: 'euler', step: 1 / 4 }, outputStep: 1 / 4 },
  { id: 'euler-8', label: 'Euler, h = 1/8', method: { name: 'euler', step: 1 / 8 }, outputStep: 1 / 8 },
  {
    id: 'adams-moulton-8',
    label: 'Adams–Moulton, h = 1/8',
    method: { name: 'adams-moulton', step: 1 / 8 },
    outputStep: 1 / 8,
  },
  { id: 'exact', label: 'Exact (DOP853, 1e-12)', method: { name: 'dop853', rtol: 1e-12, atol: 1e-12 } },
];

export const methodSets: readonly MethodSet[] = [
  {
    id: 'panel',
    label: 'Scenario in the panel',
    choices: [...reportMethods, ...otherMethods],
    chosen: ['qr', 'collocation', 'ida', 'blt', 'dopri5', 'dop853'],
    column: 'alpha_fp',
  },
  {
    id: 'figure-13',
    label: 'Fig. 13: a stiff equation',
    choices: figure13,
    chosen: figure13.map((c) => c.id),
    column: 'y',
    scenario: { version: 1, system: 'stiff-decay', duration: 1, outputStep: 0.005 },
  },
];
