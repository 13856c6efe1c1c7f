// Regulators as a computer runs them, against an independent implementation (tests/reference/sampled-regulator.json) and
// by properties.
import { readFileSync } from 'node:fs';
import { Matrix } from 'ml-matrix';
import { describe, expect, test } from 'vitest';
import { designLqr, reachablePlant, type LqrDesign } from '../../../src/core/control/design/lqr.ts';
import { modulus } from '../../../src/core/control/linearization/spectrum.ts';
import { marginsOf } from '../../../src/core/control/margins.ts';
import { solveDare } from '../../../src/core/control/sampled/dare.ts';
import { exponential } from '../../../src/core/control/sampled/exponential.ts';
import { delayedCost, held, heldWithDelay, sampledCost } from '../../../src/core/control/sampled/hold.ts';
import { heldTwice } from '../../../src/core/control/sampled/holdTwice.ts';
import { heldDesign, sampledLqr } from '../../../src/core/control/sampled/sampledLqr.ts';
import { seeded } from '../../helpers.ts';
import { linearizationOf, randomMatrix } from './helpers.ts';

interface Reference {
  designs: {
    scenario: { Q?: Record<string, number> };
    largestStableSampleTime: number;
    delayMargin: number;
    spectralRadiusAt: Record<string, number>;
  }[];
  sampledLqr: { scenario: { Q: Record<string, number> }; sample: number; closedModuli: number[] }[];
}
const reference = JSON.parse(
  readFileSync(new URL('../../reference/sampled-regulator.json', import.meta.url), 'utf8'),
) as Reference;

const plant = reachablePlant(
  linearizationOf({ control: { type: 'lqr', inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 } } }),
);
const designOf = (Q: Record<string, number> | undefined): LqrDesign =>
  designLqr(plant, { Q: plant.linearization.states.map((s) => (Q ? (Q[s] ?? 0) : 1)), R: [1, 1] });

describe.each(reference.designs)('the continuous regulator held by a computer, Q = $scenario.Q', (known) => {
  const design = designOf(known.scenario.Q);
  const { A, B } = design.quotient;
  const margins = marginsOf({ A, B, K: design.riccati.gain }, design.linearization.inputs);

  test('is unstable from the sample time and the delay that are known', () => {
    expect(Math.abs(margins.sampleTime / known.largestStableSampleTime - 1)).toBeLessThan(1e-3);
    expect(Math.abs(margins.delay / known.delayMargin - 1)).toBeLessThan(1e-3);
  });

  test('grows as is known', () => {
    for (const [h, radius] of Object.entries(known.spectralRadiusAt)) {
      if (Number(h) < 0.002) continue; // there the largest modulus is that of the modes that are left alone
      expect(heldDesign(design, { sample: Number(h), delay: 0 }).spectralRadius).toBeCloseTo(radius, 8);
    }
  });

  test('has the margins that any regulator with equal weights on its inputs has', () => {
    // Anderson and Moore, Optimal Control, section 5.4: half to infinite gain, 60 degrees, |I + L| at least 1.
    for (const [down, up] of Object.values(margins.gain)) {
      expect(down).toBeLessThan(0.5);
      expect(up).toBe(Infinity);
    }
    for (const phase of Object.values(margins.phase)) expect(phase).toBeGreaterThan(Math.PI / 3);
    expect(margins.disc).toBeCloseTo(1, 9);
  });
});

test.each(reference.sampledLqr)('the sampled regulator at $sample s has the known moduli', (known) => {
  const design = sampledLqr(designOf(known.scenario.Q), { sample: known.sample, delay: 0 });
  const moduli = design.closedLoop.map(modulus);
  moduli.forEach((m, i) => expect(m).toBeCloseTo(known.closedModuli[i]!, 8));
  expect(design.riccatiResidual).toBeLessThan(1e-10);
});

test.each([0.001, 0.005, 0.0075, 0.012, 0.1])(
  'with a delay of %f s the sampled regulator is stable, the held one not',
  (delay) => {
    const design = designOf(reference.sampledLqr[0]!.scenario.Q);
    const sampled = sampledLqr(design, { sample: 0.005, delay: delay });
    expect(sampled.spectralRadius).toBeLessThan(1);
    expect(sampled.inputGain.columns).toBe(2 * Math.ceil(delay / 0.005 - 1e-9));
    expect(heldDesign(design, { sample: 0.005, delay: delay }).spectralRadius).toBeGreaterThan(1);
  },
);

describe.each([1, 2, 3])('random plants, seed %i', (seed) => {
  const random = seeded(seed);
  const [A, B] = [randomMatrix(random, 6, 6), randomMatrix(random, 6, 2)];

  test('the exponential has the group property and the inverse', () => {
    const whole = exponential(A);
    const half = exponential(Matrix.mul(A, 0.5));
    expect(Matrix.sub(whole, half.mmul(half)).norm() / whole.norm()).toBeLessThan(1e-13);
    expect(Matrix.sub(whole.mmul(exponential(Matrix.mul(A, -1))), Matrix.eye(6)).norm()).toBeLessThan(1e-9);
  });

  test('two half samples are one, the cost included', () => {
    const [one, half] = [held(A, B, 0.2), held(A, B, 0.1)];
    expect(Matrix.sub(one.A, half.A.mmul(half.A)).norm()).toBeLessThan(1e-12);
    expect(Matrix.sub(one.B, half.A.mmul(half.B).add(half.B)).norm()).toBeLessThan(1e-12);
    const [Q, R] = [Matrix.eye(6), Matrix.eye(2)];
    const [cost, part] = [sampledCost(A, B, Q, R, 0.2), sampledCost(A, B, Q, R, 0.1)];
    const both = Matrix.add(part.Q, half.A.transpose().mmul(part.Q).mmul(half.A));
    expect(Matrix.sub(cost.Q, both).norm() / cost.Q.norm()).toBeLessThan(1e-12);
  });

  test('a delay is a plant whose input comes later, to the last state', () => {
    const [h, delay] = [0.1, 0.23];
    const delayed = heldWithDelay(A, B, h, delay);
    let z = Matrix.zeros(delayed.A.rows, 1);
    const inputs = Array.from({ length: 8 }, () => randomMatrix(random, 2, 1));
    for (const u of inputs) z = Matrix.add(delayed.A.mmul(z), delayed.B.mmul(u));
    // The same piece by piece: between switches at k h + delay.
    let x = Matrix.zeros(6, 1);
    const end = inputs.length * h;
    for (let k = 0; k < inputs.length; k++) {
      const [from, to] = [k * h + delay, Math.min((k + 1) * h + delay, end)];
      if (from >= end) break;
      const piece = held(A, B, to - from);
      x = Matrix.add(piece.A.mmul(x), piece.B.mmul(inputs[k]!));
    }
    expect(Matrix.sub(z.subMatrix(0, 5, 0, 0), x).norm() / x.norm()).toBeLessThan(1e-11);
  });

  test('the sampled Riccati equation: residual, stability, and no neighbouring gain is better', () => {
    const plant = held(A, B, 0.1);
    const cost = sampledCost(A, B, Matrix.eye(6), Matrix.eye(2), 0.1);
    const { residual, closedLoop, X } = solveDare(plant.A, plant.B, cost.Q, cost.R, cost.N);
    expect(residual).toBeLessThan(1e-12);
    for (const value of closedLoop) expect(modulus(value)).toBeLessThan(1);
    // With no delay the delayed cost is the plain one.
    const same = delayedCost(A, B, Matrix.eye(6), Matrix.eye(2), 0.1, 0);
    expect(Matrix.sub(same.Q, cost.Q).norm() + Matrix.sub(same.R, cost.R).norm()).toBeLessThan(1e-12);
    expect(Matrix.sub(X, X.transpose()).norm()).toBeLessThan(1e-12 * X.norm());
  });
});

// Each was refused: a mode that dies away within a sample stood beside its inverse, or weights beside each other.
test.each([
  {
    name: 'stiff ankles, a delay of two samples',
    raw: {
      system: 'ripstik-rider',
      control: { type: 'lqr', inputs: ['tau_af', 'tau_ab'], at: { X_dot: -0.798 }, Q: { X: 1, psi: 1 } },
    },
    timing: { sample: 0.018, delay: 0.0305 },
  },
  {
    name: 'weights from 1e-7 to 1e5',
    raw: {
      control: {
        type: 'lqr',
        inputs: ['tau_fc', 'tau_bc'],
        at: {},
        R: { tau_fc: 9e4, tau_bc: 9.5 },
        Q: { alpha_fp: 2.4e-7, X: 2.5e4, Y: 99, Z_dot: 1.6e-5 },
      },
    },
    timing: { sample: 0.00113, delay: 0.00087 },
  },
  {
    name: 'a light rider',
    raw: {
      system: 'ripstik-rider',
      parameters: { ankleStiffness: 2875, ankleDamping: 1.85, riderMass: 17.9, riderHeight: 1.19 },
      control: { type: 'lqr', inputs: ['tau_af', 'tau_ab'], at: { X_dot: 0.36 }, Q: { theta: 1, alpha_dot: 1 } },
    },
    timing: { sample: 0.0127, delay: 0 },
  },
])('a sampled regulator that is there is found: $name', ({ raw, timing }) => {
  const { Q, R, inputs } = raw.control as { Q: Record<string, number>; R?: Record<string, number>; inputs: string[] };
  const stiff = reachablePlant(linearizationOf(raw));
  const design = designLqr(stiff, {
    Q: stiff.linearization.states.map((s) => Q[s] ?? 0),
    R: inputs.map((name) => R?.[name] ?? 1),
  });
  const { spectralRadius, riccatiResidual } = sampledLqr(design, timing);
  expect(spectralRadius).toBeLessThan(1);
  expect(riccatiResidual).toBeLessThan(1e-9);
});

test('plant and cost are the same in twice the precision, modes of -4000/s beside 3/s included', () => {
  const random = seeded(315);
  const A = randomMatrix(random, 5, 5);
  A.set(0, 0, -4000);
  const [B, C, R] = [randomMatrix(random, 5, 2), randomMatrix(random, 3, 5), Matrix.diag([2, 0.3])];
  const Q = C.transpose().mmul(C);
  for (const [h, delay] of [
    [0.02, 0],
    [0.01, 0.0037],
    [0.008, 0.016],
    [0.008, 0.03],
  ] as const) {
    const plain = { ...heldWithDelay(A, B, h, delay), cost: delayedCost(A, B, Q, R, h, delay) };
    const precise = heldTwice(A, B, C, R, h, delay);
    for (const [a, b] of [
      [plain.A, precise.A],
      [plain.B, precise.B],
      [plain.cost.Q, precise.Q],
      [plain.cost.N, precise.N],
      [plain.cost.R, precise.R],
    ] as const) {
      const rounded = Matrix.from1DArray(b.rows, b.columns, [...b.hi]);
      expect(Matrix.sub(a, rounded).norm()).toBeLessThanOrEqual(1e-12 * rounded.norm());
    }
  }
});
