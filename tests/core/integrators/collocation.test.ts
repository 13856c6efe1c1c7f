import { describe, expect, test } from 'vitest';
import { cases } from '../../../src/core/systems/registry.ts';
import { ComplexBlock, isSecondOrder, RealBlock } from '../../../src/core/integrators/collocation/collocationBlocks.ts';
import { gauss, radau, type Tableau } from '../../../src/core/integrators/collocation/collocationCoefficients.ts';
import { StageEquations } from '../../../src/core/integrators/collocation/collocationStages.ts';
import { zeroCounters, type OdeProblem } from '../../../src/core/integrators/contract.ts';
import { createStepper } from '../../../src/core/integrators/registry.ts';
import { complexLuFactor, complexLuSolve } from '../../../src/core/linalg/complexLu.ts';
import { luFactor, luSolve } from '../../../src/core/linalg/lu.ts';
import { runOf, seeded } from '../../helpers.ts';

const SEED = 20171206;
const methods = [
  { id: 'gauss', stages: 1 },
  { id: 'gauss', stages: 2 },
  { id: 'gauss', stages: 3 },
  { id: 'gauss', stages: 4 },
  { id: 'radau', stages: 2 },
  { id: 'radau', stages: 3 },
];
const tableauOf = ({ id, stages }: (typeof methods)[number]): Tableau =>
  id === 'gauss' ? gauss(stages) : radau(stages);

function randomMatrix(n: number, random: () => number): Float64Array {
  return Float64Array.from({ length: n * n }, () => 2 * random() - 1);
}

/** [0 I; K D] with random K and D. */
function secondOrderMatrix(n: number, random: () => number): Float64Array {
  const J = randomMatrix(n, random);
  for (let i = 0; i < n / 2; i++) for (let j = 0; j < n; j++) J[i * n + j] = j === n / 2 + i ? 1 : 0;
  return J;
}

function product(A: Float64Array, B: Float64Array, n: number): Float64Array {
  return Float64Array.from({ length: n * n }, (_, k) => {
    const [i, j] = [Math.floor(k / n), k % n];
    let sum = 0;
    for (let m = 0; m < n; m++) sum += A[i * n + m]! * B[m * n + j]!;
    return sum;
  });
}

describe.each(methods)('$id $stages', (method) => {
  const tableau = tableauOf(method);
  const s = tableau.stages;

  test('its eigenvectors make A block diagonal; products of eigenvalues give the determinant', () => {
    const { T, inverse, eigenvalues } = tableau.transform;
    const blocks = product(inverse, product(tableau.A, T, s), s);
    const expected = new Float64Array(s * s);
    let row = 0;
    for (const [re, im] of eigenvalues) {
      expected[row * s + row] = re;
      if (im === 0) {
        row += 1;
        continue;
      }
      expected[(row + 1) * s + row + 1] = re;
      expected[row * s + row + 1] = -im;
      expected[(row + 1) * s + row] = im;
      row += 2;
    }
    expect(row).toBe(s);
    blocks.forEach((x, k) => expect(Math.abs(x - expected[k]!), `entry ${k}`).toBeLessThan(1e-14));
    // Last coefficient of the denominator of the stability function, a Padé approximation of exp.
    const determinant = eigenvalues.reduce((sum, [re, im]) => sum * (im === 0 ? re : re * re + im * im), 1);
    const known: Record<string, number> = {
      gauss1: 1 / 2,
      gauss2: 1 / 12,
      gauss3: 1 / 120,
      gauss4: 1 / 1680,
      radau2: 1 / 6,
      radau3: 1 / 60,
    };
    expect(determinant * (1 / known[`${method.id}${s}`]!)).toBeCloseTo(1, 12);
  });

  test.each([false, true])('one iteration is the step of the whole system (second order: %s)', (secondOrder) => {
    const random = seeded(SEED + s);
    const n = 6;
    const h = 0.3;
    const J = secondOrder ? secondOrderMatrix(n, random) : randomMatrix(n, random);
    expect(isSecondOrder(J, n)).toBe(secondOrder);
    const M = randomMatrix(n, random);
    const problem: OdeProblem = {
      dimension: n,
      failure: null,
      derivative: (t, y, out) => {
        for (let i = 0; i < n; i++) out[i] = Math.sin(t + y.reduce((sum, x, j) => sum + M[i * n + j]! * x, 0));
        return true;
      },
    };
    const [y, z] = [Float64Array.from({ length: n }, random), Float64Array.from({ length: s * n }, random)];
    const [slope, point, b] = [new Float64Array(n), new Float64Array(n), new Float64Array(s * n)];
    const W = new Float64Array((s * n) ** 2);
    for (let j = 0; j < s; j++) {
      for (let i = 0; i < n; i++) point[i] = y[i]! + z[j * n + i]!;
      problem.derivative(1 + tableau.c[j]! * h, point, slope);
      for (let a = 0; a < s; a++) {
        const weight = h * tableau.A[a * s + j]!;
        for (let i = 0; i < n; i++) {
          b[a * n + i]! += weight * slope[i]! - (a === j ? z[a * n + i]! : 0);
          for (let k = 0; k < n; k++)
            W[(a * n + i) * s * n + j * n + k] = (a === j && i === k ? 1 : 0) - weight * J[i * n + k]!;
        }
      }
    }
    const pivots = new Int32Array(s * n);
    expect(luFactor(W, s * n, pivots)).toBe(true);
    luSolve(W, s * n, pivots, b);
    const stages = new StageEquations(problem, zeroCounters(), tableau);
    expect(stages.factor(h, J)).toBe(true);
    const after = z.slice();
    const size = stages.correct(1, y, h, after, new Float64Array(n).fill(1));
    after.forEach((x, i) => expect(Math.abs(x - z[i]! - b[i]!), `seed ${SEED + s}, entry ${i}`).toBeLessThan(1e-12));
    expect(size).toBeCloseTo(Math.hypot(...b) / Math.sqrt(s * n), 10);
  });
});

describe('complex systems', () => {
  test('factors solve random systems to rounding, a zero first pivot included', () => {
    const random = seeded(SEED);
    for (const n of [1, 2, 5, 12]) {
      const [re, im] = [randomMatrix(n, random), randomMatrix(n, random)];
      if (n > 1) re[0] = im[0] = 0;
      const [x, y] = [Float64Array.from({ length: n }, random), Float64Array.from({ length: n }, random)];
      const [b, c] = [new Float64Array(n), new Float64Array(n)];
      for (let i = 0; i < n; i++) {
        for (let j = 0; j < n; j++) {
          b[i]! += re[i * n + j]! * x[j]! - im[i * n + j]! * y[j]!;
          c[i]! += re[i * n + j]! * y[j]! + im[i * n + j]! * x[j]!;
        }
      }
      const pivots = new Int32Array(n);
      expect(complexLuFactor(re, im, n, pivots)).toBe(true);
      complexLuSolve(re, im, n, pivots, b, c);
      x.forEach((value, i) => expect(Math.abs(b[i]! - value), `seed ${SEED}, n ${n}`).toBeLessThan(1e-12));
      y.forEach((value, i) => expect(Math.abs(c[i]! - value), `seed ${SEED}, n ${n}`).toBeLessThan(1e-12));
    }
  });

  test('a singular matrix and one that is not a number are refused', () => {
    const pivots = new Int32Array(2);
    expect(complexLuFactor(Float64Array.of(1, 2, 2, 4), Float64Array.of(0, 0, 0, 0), 2, pivots)).toBe(false);
    expect(complexLuFactor(Float64Array.of(NaN, 0, 0, 1), new Float64Array(4), 2, pivots)).toBe(false);
  });

  test('blocks of half the size give what whole ones give', () => {
    const random = seeded(SEED + 1);
    const n = 8;
    const J = secondOrderMatrix(n, random);
    for (const make of [() => new RealBlock(n, 0.3), () => new ComplexBlock(n, 0.2, 0.1)]) {
      const b = Float64Array.from({ length: 2 * n }, random);
      const [whole, half] = [false, true].map((secondOrder) => {
        const block = make();
        expect(block.factor(0.7, J, secondOrder)).toBe(true);
        const [x, y] = [b.slice(0, n), b.slice(n)];
        block.solve(x, y);
        return [...x, ...y];
      }) as [number[], number[]];
      half.forEach((x, i) => expect(Math.abs(x - whole[i]!), `seed ${SEED + 1}`).toBeLessThan(1e-13));
    }
  });
});

describe('what is delivered', () => {
  const hanging = { ...cases.find((c) => c.id === 'hanging')!.scenario, duration: 2 };
  const leaning = { version: 1, system: 'ripstik', initial: { X_dot: 1, alpha: '0.5 deg' }, duration: 0.5 };
  type Run = ReturnType<typeof runOf>;

  /** Largest difference of any coordinate or velocity in any row. */
  function worst(a: Run, b: Run): number {
    let largest = 0;
    for (const { name } of a.simulation.dynamics.system.meta.coordinates) {
      for (const key of [name, `${name}_dot`])
        a.columns.get(key)!.forEach((x, k) => (largest = Math.max(largest, Math.abs(x - b.columns.get(key)![k]!))));
    }
    return largest;
  }

  describe.each([
    ['hanging board', hanging],
    ['rolling board', leaning],
  ])('%s', (_, scenario) => {
    const truth = runOf({ ...scenario, method: { name: 'dop853', rtol: 1e-13, atol: 1e-14 } });

    test.each(methods.slice(1))(
      '$id $stages: every row, between the steps as well, is within ten times of what dopri5 gives at the same tolerance',
      ({ id, stages }) => {
        for (const rtol of [1e-5, 1e-7, 1e-9]) {
          const method = { rtol, atol: rtol / 100 };
          const run = runOf({ ...scenario, method: { ...method, name: id, stages } });
          const error = worst(run, truth);
          expect(error, `rtol ${rtol}`).toBeLessThan(
            10 * worst(runOf({ ...scenario, method: { ...method, name: 'dopri5' } }), truth),
          );
          if (rtol === 1e-9) expect(error).toBeLessThan(1e-6);
        }
      },
    );
  });

  test('work: on the swinging board three stages need at most twice the evaluations of dopri5, and far fewer steps than two', () => {
    const evaluations = (name: string, stages?: number) =>
      runOf({ ...hanging, method: { name, stages, rtol: 1e-6, atol: 1e-8 } }).counts;
    const explicit = evaluations('dopri5');
    for (const id of ['radau', 'gauss']) {
      const [two, three] = [evaluations(id, 2), evaluations(id, 3)];
      expect(three.evaluations).toBeLessThan(2 * explicit.evaluations);
      expect(three.jacobians).toBeLessThan(three.steps);
      expect(three.steps).toBeLessThan(0.6 * two.steps);
    }
  });

  test('the falling board of the report keeps its energy within 1e-3 over 10 s at rtol 1e-6', () => {
    const scenario = { ...cases.find((c) => c.id === 'falling-report')!.scenario, duration: 10 };
    for (const { id, stages } of methods.filter((m) => m.stages >= 3)) {
      const run = runOf({ ...scenario, method: { name: id, stages, rtol: 1e-6, atol: 1e-8 } });
      expect(run.end.reason).toBe('end');
      expect(Math.abs(run.counts.energyDrift!), `${id} ${stages}`).toBeLessThan(1e-3);
      expect(run.counts.residual).toBeLessThan(1e-12);
    }
  });
});

test('factors of another step and an old Jacobian do not change what a stiff run gives', () => {
  // Decay to cos t at 1e5 per second, with a step that grows from the transient's to the curve's.
  const problem: OdeProblem = {
    dimension: 1,
    failure: null,
    derivative: (t, y, out) => {
      out[0] = -1e5 * (y[0]! - Math.cos(t)) - Math.sin(t);
      return true;
    },
  };
  for (const { id, stages } of methods.slice(1)) {
    const stepper = createStepper(id, problem, { rtol: 1e-7, atol: 1e-9, stages })!;
    stepper.reset(0, Float64Array.of(2));
    while (stepper.t < 10) expect(stepper.step(10)).toBeNull();
    expect(Math.abs(stepper.y[0]! - Math.cos(10)), `${id} ${stages}`).toBeLessThan(1e-6);
    expect(stepper.counters.factorizations).toBeLessThan(stepper.counters.steps);
  }
});
