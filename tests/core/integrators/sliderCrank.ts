import { luFactor, luSolve } from '../../../src/core/linalg/lu.ts';
import type { OdeProblem } from '../../../src/core/integrators/contract.ts';
import type { DaeProblem } from '../../../src/core/integrators/shared/dae.ts';
import { problem } from './problems.ts';

/**
 * Slider-crank of two slender bars, q = [crank's angle, rod's angle, slider's x], gravity along -y; the loop closes by
 * l1 cos q0 + l2 cos q1 = q2 and l1 sin q0 + l2 sin q1 = 0.
 */
export interface SliderCrank {
  m1: number;
  l1: number;
  m2: number;
  l2: number;
  m3: number;
  g: number;
}

/** M, h, G and the rate of G times v at a state, for `M a = h + G^T lambda`, `G a + gamma = 0`. */
function mechanics({ m1, l1, m2, l2, m3, g }: SliderCrank, y: Float64Array) {
  const [a, b, , u, w] = y as unknown as [number, number, number, number, number];
  const cross = (m2 * l1 * l2) / 2;
  const [c, s] = [cross * Math.cos(a - b), cross * Math.sin(a - b)];
  return {
    M: [(m1 / 3 + m2) * l1 * l1, c, 0, c, (m2 * l2 * l2) / 3, 0, 0, 0, m3],
    h: [-s * w * w - g * (m1 / 2 + m2) * l1 * Math.cos(a), s * u * u - g * (m2 / 2) * l2 * Math.cos(b), 0],
    G: [-l1 * Math.sin(a), -l2 * Math.sin(b), -1, l1 * Math.cos(a), l2 * Math.cos(b), 0],
    gamma: [-l1 * Math.cos(a) * u * u - l2 * Math.cos(b) * w * w, -l1 * Math.sin(a) * u * u - l2 * Math.sin(b) * w * w],
    loop: [l1 * Math.cos(a) + l2 * Math.cos(b) - y[2]!, l1 * Math.sin(a) + l2 * Math.sin(b)],
  };
}

/** Accelerations (3) and multipliers (2) into `x`. */
function accelerations(crank: SliderCrank, y: Float64Array, x: Float64Array): boolean {
  const { M, h, G, gamma } = mechanics(crank, y);
  const K = new Float64Array(25);
  for (let i = 0; i < 3; i++) {
    for (let j = 0; j < 3; j++) K[i * 5 + j] = M[i * 3 + j]!;
    for (let r = 0; r < 2; r++) K[(3 + r) * 5 + i] = -(K[i * 5 + 3 + r] = -G[r * 3 + i]!);
  }
  x.set([...h, -gamma[0]!, -gamma[1]!]);
  const pivots = new Int32Array(5);
  if (!luFactor(K, 5, pivots)) return false;
  luSolve(K, 5, pivots, x);
  return true;
}

/** Index reduced to 1 and the multipliers solved for: y = [q, v]. The loop may drift. */
export function sliderCrankOde(crank: SliderCrank): OdeProblem {
  const x = new Float64Array(5);
  return problem(6, (_t, y, out) => {
    if (!accelerations(crank, y, x)) return false;
    out.set([y[3]!, y[4]!, y[5]!, x[0]!, x[1]!, x[2]!]);
  });
}

/** Index 2, stabilized as Gear, Leimkuhler and Gupta do: y = [q, v, lambda, mu]. Its Jacobian by central differences. */
export function sliderCrankDae(crank: SliderCrank): DaeProblem {
  const x = new Float64Array(5);
  const dae: DaeProblem = {
    dimension: 10,
    differential: Uint8Array.of(1, 1, 1, 1, 1, 1, 0, 0, 0, 0),
    failure: null,
    start(_t, y, yp) {
      if (!accelerations(crank, y, x)) return false;
      y.set([x[3]!, x[4]!, 0, 0], 6);
      yp.fill(0);
      yp.set([y[3]!, y[4]!, y[5]!, x[0]!, x[1]!, x[2]!]);
      return true;
    },
    residual(_t, y, yp, out) {
      const { M, h, G, loop } = mechanics(crank, y);
      for (let i = 0; i < 3; i++) {
        out[i] = yp[i]! - y[3 + i]! - G[i]! * y[8]! - G[3 + i]! * y[9]!;
        out[3 + i] = -h[i]! - G[i]! * y[6]! - G[3 + i]! * y[7]!;
        for (let j = 0; j < 3; j++) out[3 + i]! += M[i * 3 + j]! * yp[3 + j]!;
      }
      for (let r = 0; r < 2; r++) {
        out[6 + r] = G[r * 3]! * y[3]! + G[r * 3 + 1]! * y[4]! + G[r * 3 + 2]! * y[5]!;
        out[8 + r] = loop[r]!;
      }
      return true;
    },
    jacobian(t, y, yp, cj, out) {
      const [up, down] = [new Float64Array(10), new Float64Array(10)];
      for (let j = 0; j < 10; j++) {
        const moved = (sign: number, residual: Float64Array): void => {
          const [z, zp] = [y.slice(), yp.slice()];
          z[j]! += sign * 1e-5;
          dae.residual(t, z, zp, residual);
        };
        moved(1, up);
        moved(-1, down);
        for (let i = 0; i < 10; i++) out[i * 10 + j] = (up[i]! - down[i]!) / 2e-5;
      }
      const { M } = mechanics(crank, y);
      for (let i = 0; i < 3; i++) {
        out[i * 10 + i]! += cj;
        for (let j = 0; j < 3; j++) out[(3 + i) * 10 + 3 + j]! += cj * M[i * 3 + j]!;
      }
      return true;
    },
  };
  return dae;
}
