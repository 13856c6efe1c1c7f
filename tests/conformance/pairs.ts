import { formulations } from '../../src/core/mechanics/formulations/formulations.ts';
import { methods, type MethodId, type MethodInfo } from '../../src/core/integrators/methods.ts';
import type { MethodOptions } from '../../src/core/scenario/types.ts';

/** How a method is run in the suite. A new one is tested as soon as its line stands here. */
interface Settings {
  /** Solves equations by Newton's method. */
  implicit: boolean;
  /** What brings it within 1e-6 of the truth on the smooth motions of the suite; by number of stages where that matters. */
  sharp(stages: number | undefined): Partial<MethodOptions>;
  /** Fixed step and of low order: agrees at this order instead, from this step on, s. */
  order?: number;
  coarse?: number;
  /** Step for the falling board, whose light rod spins, s; the tolerance of `loose` where there is none. */
  quick?: number;
}

/** An engineer's tolerance. */
export const loose = { rtol: 1e-5, atol: 1e-7 };
const tolerance = { rtol: 1e-9, atol: 1e-10 };
const explicit: Settings = { implicit: false, sharp: () => tolerance };
const implicit: Settings = { implicit: true, sharp: () => tolerance };

export const settings: Readonly<Record<MethodId, Settings>> = {
  dopri5: explicit,
  dop853: explicit,
  tsit5: explicit,
  bs23: explicit,
  euler: { implicit: false, sharp: () => ({ step: 1e-4 }), order: 1, coarse: 2e-4, quick: 2e-4 },
  rk4: { implicit: false, sharp: () => ({ step: 1e-3 }), quick: 2e-3 },
  'adams-moulton': { implicit: true, sharp: () => ({ step: 1e-3 }), order: 2, coarse: 2e-3, quick: 5e-4 },
  // One stage is of order 2: at rtol 1e-9 it would take 400,000 steps for what 1e-8 gives as well.
  gauss: { implicit: true, sharp: (stages) => (stages === 1 ? { rtol: 1e-8, atol: 1e-9 } : tolerance) },
  radau: implicit,
  bdf: implicit,
  ida: implicit,
};

export interface Pair extends Settings {
  name: string;
  id: MethodId;
  method: Partial<MethodOptions>;
  formulation: string | undefined;
}

/** Every method, with every number of stages, on every formulation; `ida` alone. */
export const pairs: readonly Pair[] = (methods as readonly (MethodInfo & { id: MethodId })[]).flatMap((info) =>
  (info.stages ?? [undefined]).flatMap((stages) =>
    (info.id === 'ida' ? [undefined] : formulations.map((f) => f.id)).map((formulation) => ({
      ...settings[info.id],
      name: [info.id, stages, formulation].filter((part) => part !== undefined).join(' '),
      id: info.id,
      formulation,
      method: { name: info.id, ...(formulation ? { formulation } : {}), ...(stages ? { stages } : {}) },
    })),
  ),
);
