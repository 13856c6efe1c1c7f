/** Problems with known solutions, and what every test of a stepper does with one. */
import type { OdeProblem, StepFailure, Stepper } from '../../../src/core/integrators/contract.ts';

type Derivative = (t: number, y: Float64Array, out: Float64Array) => boolean | void;

export function problem(dimension: number, f: Derivative, more: Partial<OdeProblem> = {}): OdeProblem {
  return { dimension, failure: null, derivative: (t, y, out) => f(t, y, out) !== false, ...more };
}

/** Kepler's problem with eccentricity 0.3, from the pericentre: nonlinear, smooth, known. */
const ECCENTRICITY = 0.3;
export const kepler = problem(4, (_t, y, out) => {
  const r3 = Math.hypot(y[0]!, y[1]!) ** 3;
  out.set([y[2]!, y[3]!, -y[0]! / r3, -y[1]! / r3]);
});

export function keplerAt(t: number): Float64Array {
  let E = t;
  for (let i = 0; i < 60; i++) E -= (E - ECCENTRICITY * Math.sin(E) - t) / (1 - ECCENTRICITY * Math.cos(E));
  const d = 1 - ECCENTRICITY * Math.cos(E);
  const q = Math.sqrt(1 - ECCENTRICITY ** 2);
  return Float64Array.of(Math.cos(E) - ECCENTRICITY, q * Math.sin(E), -Math.sin(E) / d, (q * Math.cos(E)) / d);
}

export function distance(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return Math.max(...Array.from(a, (x, i) => Math.abs(x - b[i]!)));
}

export function run(stepper: Stepper, limit: number, afterStep: () => void = () => {}): StepFailure | null {
  for (let i = 0; i < 1e6 && stepper.t < limit; i++) {
    const failure = stepper.step(limit);
    if (failure) return failure;
    afterStep();
  }
  return null;
}

/** Robertson's reaction, from (1, 0, 0). */
export const robertson = (exact: boolean): OdeProblem =>
  problem(
    3,
    (_t, y, out) => {
      const [a, b, c] = y as unknown as [number, number, number];
      out[0] = -0.04 * a + 1e4 * b * c;
      out[2] = 3e7 * b * b;
      out[1] = -out[0]! - out[2]!;
    },
    exact
      ? {
          jacobian: (_t, y, out) => {
            const [, b, c] = y as unknown as [number, number, number];
            out.set([-0.04, 1e4 * c, 1e4 * b, 0.04, -1e4 * c - 6e7 * b, -1e4 * b, 0, 6e7 * b, 0]);
            return true;
          },
        }
      : {},
  );

/** Robertson's reaction at t = 40; SciPy 1.17.1's Radau at rtol 1e-11 gives the same digits. */
export const ROBERTSON_40 = [0.7158270688, 9.185534765e-6, 0.2841637457];

/** A stiff oscillator (van der Pol, 1e-6) from (2, -0.66); its first component at t = 2 by SciPy 1.17.1's Radau at rtol 1e-10. */
export const vanDerPol = problem(2, (_t, y, out) => {
  out[0] = y[1]!;
  out[1] = ((1 - y[0]! * y[0]!) * y[1]! - y[0]!) / 1e-6;
});
export const VAN_DER_POL_2 = 1.70616743754;

/** Prothero and Robinson's: cos t, and whatever is off it dies out like exp(-1000 t). */
export const prothero = problem(1, (t, y, out) => void (out[0] = -1000 * (y[0]! - Math.cos(t)) - Math.sin(t)), {
  jacobian: (_t, _y, out) => ((out[0] = -1000), true),
});
