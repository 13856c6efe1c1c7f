// Random regulators over systems, speeds, inputs and weights from 1e-8 to 1e8: each is solved, or refused for a reason
// that holds. DESIGNS=10000 DESIGNS_SEED=7 makes the long form of it.
import { EigenvalueDecomposition, Matrix, SingularValueDecomposition } from 'ml-matrix';
import { expect, test } from 'vitest';
import { designLqr, reachablePlant, type ReachablePlant } from '../../../src/core/control/design/lqr.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { seeded } from '../../helpers.ts';
import { linearizationOf } from './helpers.ts';

const COUNT = Number(process.env.DESIGNS ?? 250);
const SEED = Number(process.env.DESIGNS_SEED ?? 4711);

interface Plant {
  at(random: () => number): Record<string, number | string>;
  parameters?(random: () => number): Record<string, number>;
  inputs: readonly string[];
}

const speed = (random: () => number, least: number, most: number): number => least * (most / least) ** random();

const PLANTS: Record<string, Plant> = {
  ripstik: {
    at: (random) => (random() < 0.2 ? {} : { X_dot: speed(random, 0.01, 10) }),
    inputs: ['tau_fc', 'tau_bc', 'tau_fp', 'tau_bp', 'tau_twist', 'f_X', 'f_Y', 'f_theta', 'f_alpha'],
  },
  'ripstik-rider': {
    at: (random) => (random() < 0.2 ? {} : { X_dot: speed(random, 0.1, 25) }),
    // Up to ankles so stiff that the fastest mode is a thousand times the slowest.
    parameters: (random) => ({
      ankleStiffness: speed(random, 10, 2000),
      ankleDamping: speed(random, 0.1, 50),
      riderMass: speed(random, 20, 120),
    }),
    inputs: ['tau_af', 'tau_ab', 'tau_fp', 'tau_bp', 'tau_fc', 'tau_bc', 'f_beta'],
  },
  bicycle: {
    at: (random) => ({ speed: random() < 0.1 ? 0 : speed(random, 0.1, 10) }),
    inputs: ['tau_roll', 'tau_steer', 'tau_rear', 'f_roll', 'f_y'],
  },
  'cart-pendulum': { at: (random) => (random() < 0.5 ? {} : { theta: '-pi/2' }), inputs: ['f_X', 'f_theta'] },
  'wheel-pendulum': { at: (random) => (random() < 0.5 ? {} : { psi: 'pi/2' }), inputs: ['tau_phi', 'f_X', 'f_psi'] },
  'rolling-wheel': { at: (random) => ({ phi_dot: speed(random, 0.1, 10) }), inputs: ['tau_theta', 'tau_phi'] },
  'casterboard-robot': { at: () => ({}), inputs: ['tau_f', 'tau_r', 'f_x', 'f_theta'] },
  'chaplygin-sleigh': { at: (random) => ({ x_dot: speed(random, 0.1, 10) }), inputs: ['f_x', 'f_theta'] },
};

/** Some of a list, at least one. */
function some<T>(random: () => number, all: readonly T[], share: number): T[] {
  const chosen = all.filter(() => random() < share);
  return chosen.length > 0 ? chosen : [all[Math.floor(random() * all.length)]!];
}

function draw(random: () => number) {
  const ids = Object.keys(PLANTS);
  const id = random() < 0.5 ? 'ripstik' : ids[Math.floor(random() * ids.length)]!;
  const inputs = id === 'ripstik' && random() < 0.5 ? ['tau_fc', 'tau_bc'] : some(random, PLANTS[id]!.inputs, 0.4);
  const names = systems[id]!.meta.coordinates.map((c) => c.name);
  const states = [...names, ...names.map((name) => `${name}_dot`)];
  const wild = random() < 0.5;
  const count = random() < 0.3 ? 2 : random() < 0.5 ? 3 : 1 + Math.floor(random() * states.length);
  const Q: Record<string, number> = {};
  for (let i = 0; i < count; i++)
    Q[states[Math.floor(random() * states.length)]!] = wild ? 10 ** (-8 + 16 * random()) : 1;
  const R = Object.fromEntries(inputs.map((name) => [name, wild ? 10 ** (-4 + 8 * random()) : 1]));
  return {
    system: id,
    parameters: PLANTS[id]!.parameters?.(random) ?? {},
    control: { type: 'lqr', inputs, at: PLANTS[id]!.at(random), Q, R },
  };
}

/**
 * Hautus' test, another way than the code's own: whether some unstable eigenvalue's left eigenvectors are all but
 * orthogonal to what the inputs do.
 */
function hasUnreachableUnstableMode({ linearization }: ReachablePlant): boolean {
  const { tangentA: A, tangentB, inputSizes } = linearization;
  // What an input does, as a share of what it would do without constraints.
  const B = tangentB.clone();
  inputSizes.forEach((s, k) => B.mulColumn(k, 1 / s));
  const { realEigenvalues, imaginaryEigenvalues } = new EigenvalueDecomposition(A);
  const size = A.norm();
  return realEigenvalues.some((re, i) => {
    if (re < 1e-8 * size) return false;
    const im = imaginaryEigenvalues[i]!;
    const [n, k] = [A.rows, B.columns];
    // [A - lambda, B] over the reals: twice the size.
    const pencil = Matrix.zeros(2 * n, 2 * n + 2 * k);
    const shifted = Matrix.sub(A, Matrix.eye(n).mul(re));
    pencil.setSubMatrix(shifted, 0, 0).setSubMatrix(shifted, n, n);
    pencil.setSubMatrix(Matrix.eye(n).mul(im), 0, n).setSubMatrix(Matrix.eye(n).mul(-im), n, 0);
    pencil.setSubMatrix(Matrix.mul(B, size), 0, 2 * n).setSubMatrix(Matrix.mul(B, size), n, 2 * n + k);
    const { diagonal } = new SingularValueDecomposition(pencil, { autoTranspose: true });
    return Math.min(...diagonal) < 1e-8 * size;
  });
}

/** |Vp^T A V| as a share of |A|, where ranks are decided. */
function leavingReach({ split: { balance } }: ReachablePlant): number {
  const { A, reachable: V } = balance;
  const inside = V.mmul(V.transpose().mmul(A).mmul(V));
  return Matrix.sub(A.mmul(V), inside).norm() / A.norm();
}

/** The largest share of an input that lies outside. */
function inputsOutside({ split: { balance } }: ReachablePlant): number {
  const { B, reachable: V } = balance;
  const outside = Matrix.sub(B, V.mmul(V.transpose().mmul(B)));
  const shares = Array.from({ length: B.columns }, (_, k) => {
    const size = B.getColumnVector(k).norm();
    return size > 1e-12 ? outside.getColumnVector(k).norm() / size : 0;
  });
  return Math.max(...shares);
}

test(`${COUNT} random designs of seed ${SEED} are solved, or refused because no input reaches an unstable mode`, () => {
  const random = seeded(SEED);
  let solved = 0;
  for (let i = 0; i < COUNT; i++) {
    const raw = draw(random);
    const told = JSON.stringify(raw);
    const plant = reachablePlant(linearizationOf(raw));
    // A direction too few shows: what is reached is then no invariant subspace.
    expect(leavingReach(plant), told).toBeLessThan(1e-12);
    expect(inputsOutside(plant), told).toBeLessThan(1e-9);
    const { Q, R, inputs } = raw.control;
    const weights = { Q: plant.linearization.states.map((s) => Q[s] ?? 0), R: inputs.map((name) => R[name]!) };
    let design;
    try {
      design = designLqr(plant, weights);
    } catch (error) {
      expect((error as Error).message, told).toMatch(/no input reaches the unstable mode/);
      expect(hasUnreachableUnstableMode(plant), told).toBe(true);
      continue;
    }
    solved++;
    expect(design.riccati.residual, told).toBeLessThan(1e-10);
    for (const [re] of design.placed) expect(re, told).toBeLessThan(0);
  }
  expect(solved).toBeGreaterThan(0.8 * COUNT);
});

test('speed sideways and both plates at 1 m/s are a cost like any other', () => {
  const plant = reachablePlant(
    linearizationOf({ system: 'ripstik', control: { type: 'lqr', inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 } } }),
  );
  const Q = plant.linearization.states.map((s) => (['alpha_fp', 'alpha_bp', 'Y_dot'].includes(s) ? 1 : 0));
  const design = designLqr(plant, { Q, R: [1, 1] });
  // Where the board is across its way costs nothing and is left alone: the heading is seen, Y is not.
  expect(design.unseen.map(({ moves }) => moves)).toEqual([['Y']]);
  expect(design.placed).toHaveLength(9);
  expect(design.riccati.residual).toBeLessThan(1e-12);
});

test('beside ankles whose modes are four thousand times the fall, rounding of the neutral modes is no reach', () => {
  const plant = reachablePlant(
    linearizationOf({
      system: 'ripstik-rider',
      parameters: { ankleStiffness: 86.77870515576011, ankleDamping: 49.311286496822774, riderMass: 89.72448211220629 },
      control: { type: 'lqr', inputs: ['tau_fp', 'tau_bc'], at: { X_dot: 2.324341518242621 } },
    }),
  );
  expect(plant.split.A.rows).toBe(12);
  const Q = plant.linearization.states.map((s) => (['alpha_fp', 'Y'].includes(s) ? 1 : 0));
  expect(designLqr(plant, { Q, R: [1, 1] }).riccati.residual).toBeLessThan(1e-10);
});

// Gaps between singular values said 11, 13 and 9, beside stages of 1e-6.
test.each([
  {
    name: 'two inputs at 0.03 m/s',
    parameters: { ankleStiffness: 502, ankleDamping: 0.74, riderMass: 129, riderHeight: 1.004 },
    inputs: ['tau_bp', 'tau_fc'],
    at: { X_dot: 0.0344 },
    dimension: 12,
  },
  {
    name: 'a push forwards besides',
    parameters: { ankleStiffness: 382, ankleDamping: 78, riderMass: 21.6, riderHeight: 0.77 },
    inputs: ['tau_fp', 'tau_bp', 'tau_fc', 'tau_bc', 'f_X'],
    at: { X_dot: -0.371 },
    dimension: 14,
  },
  { name: 'two inputs at rest', parameters: {}, inputs: ['tau_bp', 'f_beta'], at: {}, dimension: 10 },
])('what is reached under a rider is invariant: $name', ({ parameters, inputs, at, dimension }) => {
  const plant = reachablePlant(
    linearizationOf({ system: 'ripstik-rider', parameters, control: { type: 'lqr', inputs, at } }),
  );
  expect(plant.split.A.rows).toBe(dimension);
  expect(leavingReach(plant)).toBeLessThan(1e-13);
});

test('a push along the blade does not reach the turning of a sleigh that goes backwards, whatever 6e-17 of it says', () => {
  const plant = reachablePlant(
    linearizationOf({
      system: 'chaplygin-sleigh',
      control: { type: 'lqr', inputs: ['f_x'], at: { x_dot: -3.2293229346508214 } },
    }),
  );
  const Q = plant.linearization.states.map(() => 1);
  expect(() => designLqr(plant, { Q, R: [1] })).toThrow(/no input reaches the unstable mode with eigenvalue 7\.176/);
});

// There 14 directions were as invariant as 12, with rounding as the share of the last two.
test.each([12, 15, 21.737929270254018])(
  'under a fast rider the smaller of two invariant subspaces is reached: %s m/s',
  (speed) => {
    const parameters = { ankleStiffness: 34.117, ankleDamping: 6.445, riderMass: 59.12, riderHeight: 0.91835 };
    const plant = reachablePlant(
      linearizationOf({
        system: 'ripstik-rider',
        parameters,
        control: { type: 'lqr', inputs: ['tau_af', 'tau_ab'], at: { X_dot: speed } },
      }),
    );
    expect(plant.split.A.rows).toBe(12);
    const Q = plant.linearization.states.map(() => 1);
    expect(designLqr(plant, { Q, R: [1, 1] }).riccati.residual).toBeLessThan(1e-10);
  },
);
