import { Matrix } from 'ml-matrix';
import { AccelerationJacobian } from '../../mechanics/formulations/accelerationJacobian.ts';
import type { InputMeta } from '../../model/system.ts';
import { besides, columnSpace, ControlError, fromRowMajor, maxDifference, solveLinear, stacked } from './matrices.ts';
import type { SteadyMotion } from './steadyMotion.ts';

/**
 * `x' = A x + B u` for deviations x = (coordinates, velocities) from a steady motion, with exact derivatives. Of a system
 * of first order x is the coordinates alone, and A is n x n.
 *
 * Symbols: n coordinates, m constraint rows, M mass matrix, K = d(M a - h)/dq - d(Omega^T lambda0)/dq and
 * D = d(M a - h)/dv at a = 0, C = d(Omega v0)/dq, G the rows of Omega that are gradients of heights, T an orthonormal
 * basis of the velocities that Omega allows. The linearized equations with multipliers are
 *
 *     M da + K dq + D dv - Omega^T dlambda = B u,    Omega dv + C dq = 0,    G dq = 0.
 */
export interface Linearization {
  readonly motion: SteadyMotion;
  /** Names: coordinates, then velocities (2n); and inputs (k). */
  readonly states: readonly string[];
  readonly inputs: readonly string[];
  /** 2n x 2n and 2n x k. */
  readonly A: Matrix;
  readonly B: Matrix;
  /** Orthonormal basis N of the deviations that the constraints allow, 2n x d: orthogonal to (G, 0) and (C, Omega). */
  readonly basis: Matrix;
  /** N^T A N and N^T B: all there is to the motion. */
  readonly tangentA: Matrix;
  readonly tangentB: Matrix;
  /** What each input would do to the bodies without constraints, |M^-1 b|: beside it rounding in B is nothing. */
  readonly inputSizes: readonly number[];
}

/** Derivatives at the steady motion; rows of held coordinates are cleared. */
interface Pieces {
  M: Matrix;
  /** d(M a - h)/dq without the constraint forces, and their d(Omega^T lambda0)/dq. */
  stiffness: Matrix;
  forceQ: Matrix;
  D: Matrix;
  Omega: Matrix;
  C: Matrix;
  /** Of Omega a + dOmega/dt v, by q and by v: 0 and C where the motion is steady in itself, and so left out. */
  rates?: { byQ: Matrix; byV: Matrix };
  inputs: Matrix;
}

/**
 * Order (a): the multipliers are eliminated, then the accelerations are differentiated.
 *
 * @param motion where it is linearized
 * @param inputs the inputs, k
 */
export function linearize(motion: SteadyMotion, inputs: readonly InputMeta[]): Linearization {
  if (motion.dynamics.system.firstOrder) return ofFirstOrder(motion);
  const { dynamics: d, q, v } = motion;
  const n = d.n;
  const jacobian = new AccelerationJacobian(d);
  const data = new Float64Array(4 * n * n);
  if (!jacobian.ofState(0, q, v, data)) throw new ControlError(`there is no acceleration at this point (${d.failure})`);
  const B = new Matrix(2 * n, inputs.length);
  const columns = inputColumns(motion, inputs);
  for (let k = 0; k < inputs.length; k++) {
    const a = Float64Array.from(columns.getColumn(k));
    d.solveSaddle(a, new Float64Array(d.m));
    for (let i = 0; i < n; i++) B.set(n + i, k, a[i]!);
  }
  const pieces = piecesAt(motion, inputs);
  return restricted(motion, inputs, fromRowMajor(data, 2 * n, 2 * n), B, pieces);
}

/**
 * Order (b): the equations with multipliers are differentiated, the force's d(Omega^T lambda0)/dq kept, then eliminated.
 *
 * @param motion where it is linearized
 * @param inputs the inputs, k
 */
export function linearizeWithMultipliers(motion: SteadyMotion, inputs: readonly InputMeta[]): Linearization {
  if (motion.dynamics.system.firstOrder) return ofFirstOrder(motion);
  const p = piecesAt(motion, inputs);
  return eliminated(motion, inputs, { ...p, stiffness: Matrix.sub(p.stiffness, p.forceQ) });
}

/**
 * Order (c), Yang's commutation: Omega is frozen at its value, so neither the force's derivative nor C is there.
 *
 * @param motion where it is linearized
 * @param inputs the inputs, k
 */
export function linearizeFrozen(motion: SteadyMotion, inputs: readonly InputMeta[]): Linearization {
  if (motion.dynamics.system.firstOrder) return ofFirstOrder(motion);
  const p = piecesAt(motion, inputs);
  const { rates: _, ...rest } = p;
  return eliminated(motion, inputs, { ...rest, C: Matrix.zeros(p.C.rows, p.C.columns) });
}

/** `q' = f(q)`: no constraints, no inputs, one order. */
function ofFirstOrder(motion: SteadyMotion): Linearization {
  const {
    dynamics: { system, parameters, n },
    q,
  } = motion;
  const data = new Float64Array(n * n);
  system.firstOrder!.jacobian(q, parameters, data);
  const [A, B] = [fromRowMajor(data, n, n), new Matrix(n, 0)];
  const states = system.meta.coordinates.map((c) => c.name);
  return { motion, states, inputs: [], A, B, basis: Matrix.eye(n), tangentA: A, tangentB: B, inputSizes: [] };
}

/** All three orders at one motion. */
export interface OrderComparison {
  eliminateFirst: Linearization;
  linearizeFirst: Linearization;
  frozen: Linearization;
  /** Largest absolute difference of (b) and of (c) from (a) in N^T A N, N of (a). B is the same in all orders. */
  difference: number;
  frozenDifference: number;
}

/**
 * The three orders of linearizing and eliminating, side by side.
 *
 * @param motion where it is linearized
 * @param inputs the inputs, k
 */
export function compareOrders(motion: SteadyMotion, inputs: readonly InputMeta[]): OrderComparison {
  const a = linearize(motion, inputs);
  const b = linearizeWithMultipliers(motion, inputs);
  const c = linearizeFrozen(motion, inputs);
  const N = a.basis;
  const from = (x: Linearization): number => maxDifference(N.transpose().mmul(x.A).mmul(N), a.tangentA);
  return { eliminateFirst: a, linearizeFirst: b, frozen: c, difference: from(b), frozenDifference: from(c) };
}

function piecesAt(motion: SteadyMotion, inputs: readonly InputMeta[]): Pieces {
  const { dynamics: d, q, v, lambda } = motion;
  const { n, m, parameters } = d;
  const { acceleration = new Float64Array(n) } = motion;
  const square = (): Float64Array => new Float64Array(n * n);
  const rows = (): Float64Array => new Float64Array(m * n);
  const [dq, dv, forceQ] = [square(), square(), square()];
  const [rateQ, rateV, velocityQ] = [rows(), rows(), rows()];
  d.evaluate(0, q, v);
  d.system.jacobians(q, v, acceleration, parameters, dq, dv);
  d.constraints?.jacobians(q, v, acceleration, lambda, parameters, forceQ, rateQ, rateV, velocityQ);
  for (const i of d.held) {
    for (const x of [dq, dv, forceQ]) x.fill(0, i * n, (i + 1) * n);
    for (let r = 0; r < m; r++) for (const x of [velocityQ, rateQ, rateV]) x[r * n + i] = 0;
  }
  return {
    M: fromRowMajor(d.massMatrix, n, n),
    stiffness: fromRowMajor(dq, n, n),
    forceQ: fromRowMajor(forceQ, n, n),
    D: fromRowMajor(dv, n, n),
    Omega: fromRowMajor(d.omega, m, n),
    C: fromRowMajor(velocityQ, m, n),
    ...(motion.acceleration && { rates: { byQ: fromRowMajor(rateQ, m, n), byV: fromRowMajor(rateV, m, n) } }),
    inputs: inputColumns(motion, inputs),
  };
}

/** The columns of B in the equations of motion, n x k; nothing acts on a held coordinate. */
function inputColumns({ dynamics: d }: SteadyMotion, inputs: readonly InputMeta[]): Matrix {
  const columns = Matrix.zeros(d.n, inputs.length);
  inputs.forEach((input, k) => {
    for (const [name, weight] of Object.entries(input.column)) {
      const i = d.system.meta.coordinates.findIndex((c) => c.name === name);
      if (!d.held.includes(i)) columns.set(i, k, weight);
    }
  });
  return columns;
}

/** dv' = T w - P (C dv), P = Omega^T (Omega Omega^T)^-1 (with `rates` those in place of C): w from the equations of motion times T^T. */
function eliminated(motion: SteadyMotion, inputs: readonly InputMeta[], p: Pieces): Linearization {
  const n = motion.dynamics.n;
  const T = columnSpace(p.Omega.transpose(), RANK * Math.max(1, p.Omega.isEmpty() ? 0 : p.Omega.norm())).complement;
  const along = (rows: Matrix): Matrix => {
    if (p.Omega.rows === 0) return Matrix.zeros(n, n);
    const solved = solveLinear(p.Omega.mmul(p.Omega.transpose()), rows);
    if (!solved) throw new ControlError('the constraints are dependent at this point');
    return p.Omega.transpose().mmul(solved);
  };
  const drift = along(p.rates?.byV ?? p.C);
  const driftQ = p.rates ? along(p.rates.byQ) : Matrix.zeros(n, n);
  const byQ = Matrix.sub(p.M.mmul(driftQ), p.stiffness);
  const forces = besides(besides(byQ, Matrix.sub(p.M.mmul(drift), p.D)), p.inputs);
  const w = solveLinear(T.transpose().mmul(p.M).mmul(T), T.transpose().mmul(forces));
  if (!w) throw new ControlError('the mass matrix is singular at this point');
  const a = T.mmul(w);
  const A = Matrix.zeros(2 * n, 2 * n);
  A.setSubMatrix(Matrix.eye(n), 0, n);
  A.setSubMatrix(Matrix.sub(a.subMatrix(0, n - 1, 0, n - 1), driftQ), n, 0);
  A.setSubMatrix(Matrix.sub(a.subMatrix(0, n - 1, n, 2 * n - 1), drift), n, n);
  const B = Matrix.zeros(2 * n, inputs.length);
  if (inputs.length > 0) B.setSubMatrix(a.subMatrix(0, n - 1, 2 * n, 2 * n + inputs.length - 1), n, 0);
  return restricted(motion, inputs, A, B, p);
}

/** Rows that are shorter than this share of the longest beside the others are dependent on them. */
const RANK = 1e-10;

/** Orthonormal basis of what is orthogonal to (G, 0), (C, Omega), and of held coordinates to both their unit vectors. */
function tangentBasis({ dynamics: d }: SteadyMotion, Omega: Matrix, C: Matrix): Matrix {
  const { n, m, held } = d;
  const heights = d.constraints?.contact?.rows ?? [];
  const rows: Matrix[] = [];
  if (m > 0) rows.push(besides(C, Omega));
  for (const r of heights) rows.push(besides(Matrix.rowVector(Omega.getRow(r)), Matrix.zeros(1, n)));
  for (const i of held) rows.push(unitRow(2 * n, i), unitRow(2 * n, n + i));
  if (rows.length === 0) return Matrix.eye(2 * n);
  const all = stacked(rows);
  const { basis, complement } = columnSpace(all.transpose(), RANK * all.norm());
  if (basis.columns < all.rows) throw new ControlError('the constraints are dependent at this point');
  return complement;
}

function unitRow(length: number, i: number): Matrix {
  const row = Matrix.zeros(1, length);
  row.set(0, i, 1);
  return row;
}

function restricted(
  motion: SteadyMotion,
  inputs: readonly InputMeta[],
  A: Matrix,
  B: Matrix,
  p: Pieces,
): Linearization {
  const N = tangentBasis(motion, p.Omega, p.C);
  const free = solveLinear(p.M, p.inputs);
  const names = motion.dynamics.system.meta.coordinates.map((c) => c.name);
  const Nt = N.transpose();
  return {
    motion,
    states: [...names, ...names.map((name) => `${name}_dot`)],
    inputs: inputs.map((i) => i.name),
    A,
    B,
    basis: N,
    tangentA: Nt.mmul(A).mmul(N),
    tangentB: inputs.length > 0 ? Nt.mmul(B) : new Matrix(N.columns, 0),
    inputSizes: inputs.map((_, k) => free?.getColumnVector(k).norm() ?? 0),
  };
}
