import { Matrix } from 'ml-matrix';
import { axisSubspace } from '../linearization/axisSubspace.ts';
import type { Linearization } from '../linearization/linearize.ts';
import { columnSpace, ControlError, norm } from '../linearization/matrices.ts';
import {
  reachByInput,
  splitByReachability,
  unobservableSubspace,
  unreachableModes,
  type InputReach,
  type ReachableSplit,
} from '../linearization/reachability.ts';
import { solveCare, type RiccatiSolution } from './riccati.ts';
import {
  byParts,
  complexText,
  eigenvalues,
  modesOf,
  modulus,
  ON_AXIS,
  type Complex,
  type Mode,
} from '../linearization/spectrum.ts';

/** Diagonals of Q (one per state) and R (one per input). */
export interface Weights {
  Q: readonly number[];
  R: readonly number[];
}

/** A mode that no input reaches; `weighted` where Q asks for it all the same: that part of the cost no gain can lower. */
export interface UnreachableMode extends Mode {
  weighted: boolean;
}

export interface LqrDesign {
  readonly linearization: Linearization;
  readonly weights: Weights;
  readonly split: ReachableSplit;
  /** K in `u = -K x`, by input and state: k x 2n. */
  readonly gain: Matrix;
  /** Neutral eigenvalues are exact zeros; both lists have one entry per dimension of the tangent space. */
  readonly openLoop: Complex[];
  readonly closedLoop: Complex[];
  /** The closed-loop eigenvalues that the design placed: those of the quotient, all with negative real parts. */
  readonly placed: Complex[];
  readonly unreachable: UnreachableMode[];
  /** Reachable, on the imaginary axis, and without weight: left as they are. */
  readonly unseen: Mode[];
  readonly byInput: InputReach[];
  readonly riccati: RiccatiSolution;
  /** The plant that the equation was solved for: reachable, and seen by the cost or off the axis. */
  readonly quotient: Quotient;
}

/** `z' = A z + B u` with the cost |C z|², z = fromStates x; the shapes of its coordinates in states are toStates' columns. */
export interface Quotient {
  A: Matrix;
  B: Matrix;
  C: Matrix;
  fromStates: Matrix;
  toStates: Matrix;
}

/** What a design needs of the plant and what does not depend on the weights: kept while a person turns them. */
export interface ReachablePlant {
  readonly linearization: Linearization;
  readonly split: ReachableSplit;
  /** Modes that no input reaches. */
  readonly modes: Mode[];
  /** Made when it is first asked for: no design needs it. */
  readonly byInput: InputReach[];
}

/**
 * What a regulator is designed for: the motion that constraints allow, split by what the inputs reach.
 *
 * @param linearization about a steady motion
 */
export function reachablePlant(linearization: Linearization): ReachablePlant {
  const { basis, tangentA, tangentB, states, inputs, inputSizes } = linearization;
  const split = splitByReachability(
    tangentA,
    tangentB,
    inputSizes,
    linearization.motion.dynamics.system.firstOrder ? undefined : basis,
  );
  let byInput: InputReach[] | null = null;
  return {
    linearization,
    split,
    modes: unreachableModes(split, basis, states),
    get byInput() {
      return (byInput ??= reachByInput(tangentA, tangentB, inputs, inputSizes));
    },
  };
}

/**
 * The linear-quadratic regulator where a plain Riccati solver fails: the motion is restricted to what the constraints
 * allow, then to what the inputs reach, then to what matters to the cost or is unstable.
 *
 * Symbols: N tangent basis; V, Vp reachable directions and their complement; W = V^T - S Vp^T, which leaves out modes
 * that no input reaches; U, Up the unseen modes on the imaginary axis and their complement. `u = -K_q Up^T W N^T x`.
 *
 * @param plant what `reachablePlant` makes of a linearization
 * @param weights diagonals: Q by state (2n), R by input (k)
 * @throws ControlError naming an unstable mode that no input reaches, or where the Riccati equation has no
 * stabilizing solution
 */
export function designLqr(plant: ReachablePlant, weights: Weights): LqrDesign {
  const { linearization, split, modes } = plant;
  const { basis: N, states, inputs } = linearization;
  const root = Matrix.diag(weights.Q.map(Math.sqrt));
  const unreachable = modes.map((mode) => ({ ...mode, weighted: isWeighted(mode, weights.Q) }));
  refuseUnstable(unreachable, split.scale, inputs);
  const seen = withoutRounding(root.mmul(N).mmul(split.reachable), weights.Q);
  const { U, Up } = unseenOnAxis(split, weights.Q);
  const Upt = Up.transpose();
  const [A, B, C] = [Upt.mmul(split.A).mmul(Up), Upt.mmul(split.B), seen.mmul(Up)];
  const toStates = N.mmul(split.reachable).mmul(Up);
  const fromStates = Upt.mmul(split.W).mmul(N.transpose());
  const riccati = solveNamed(A, B, C, weights.R, toStates, linearization);
  const unseenA = U.transpose().mmul(split.A).mmul(U);
  // What a run does without is made when it is asked for.
  const spectra = once(() => {
    const untouched = [...eigenvalues(unseenA, split.scale), ...eigenvalues(split.unreachableA, split.scale)];
    return {
      open: [...eigenvalues(A, split.scale), ...untouched].sort(byParts),
      closed: [...riccati.closedLoop, ...untouched].sort(byParts),
    };
  });
  const unseen = once(() => modesOf(unseenA, N.mmul(split.reachable).mmul(U), states, split.scale));
  return {
    linearization,
    weights,
    split,
    gain: riccati.gain.mmul(fromStates),
    get openLoop() {
      return spectra().open;
    },
    get closedLoop() {
      return spectra().closed;
    },
    placed: [...riccati.closedLoop].sort(byParts),
    unreachable,
    get unseen() {
      return unseen();
    },
    get byInput() {
      return plant.byInput;
    },
    riccati,
    quotient: { A, B, C, fromStates, toStates },
  };
}

/** Made at the first call, and kept. */
function once<T>(make: () => T): () => T {
  let made: { value: T } | null = null;
  return () => (made ??= { value: make() }).value;
}

/**
 * What a state takes part in reachable motion, at the least: below it is what rounding over weak stages has left in V (1e-8
 * of the rod's roll for one steering motor under a rider), in which no input has a say.
 */
const UNSEEN = 1e-7;

/** Rows of Q^1/2 N V that are rounding beside their weight ask for nothing that the inputs reach: exact zeros. */
function withoutRounding(seen: Matrix, Q: readonly number[]): Matrix {
  Q.forEach((q, i) => {
    if (norm(seen.getRowVector(i)) <= UNSEEN * Math.sqrt(q)) seen.setRow(i, new Array<number>(seen.columns).fill(0));
  });
  return seen;
}

/** Whether the cost of a motion in this mode is more than rounding. */
function isWeighted(mode: Mode, Q: readonly number[]): boolean {
  const cost = mode.shape.reduce((sum, x, i) => sum + Q[i]! * x * x, 0);
  return cost > 1e-16 * Math.max(...Q) * mode.shape.reduce((sum, x) => sum + x * x, 0);
}

function refuseUnstable(modes: readonly Mode[], scale: number, inputs: readonly string[]): void {
  const unstable = modes.filter((m) => m.eigenvalue[0] > ON_AXIS * scale && m.eigenvalue[1] >= 0);
  if (unstable.length === 0) return;
  const named = unstable.map((m) => `${complexText(m.eigenvalue)} (${m.moves.slice(0, 4).join(', ')})`).join('; ');
  throw new ControlError(
    `${inputs.join(', ')} can't stabilize this motion: no input reaches the unstable mode with eigenvalue ${named}; name further inputs`,
  );
}

/** Modes of the reachable part on the imaginary axis that never show in the cost, and the complement; in V's coordinates. */
function unseenOnAxis(
  { balance, reachable: V, strength }: ReachableSplit,
  Q: readonly number[],
): { U: Matrix; Up: Matrix } {
  const { A, basis, back, reachable } = balance;
  const inner = reachable.transpose().mmul(A).mmul(reachable);
  const axis = axisSubspace(inner, norm(A));
  // A weight is there or not: its size does not matter to what it sees.
  const weighted = Q.map((q) => (q > 0 ? 1 : 0));
  const seen = Matrix.diag(weighted).mmul(basis).mmul(reachable).mmul(axis);
  const { unseen } = unobservableSubspace(axis.transpose().mmul(inner).mmul(axis), seen, weighted, strength);
  const inV = V.transpose().mmul(back).mmul(reachable).mmul(axis).mmul(unseen);
  const { basis: U, complement: Up } = columnSpace(inV, () => unseen.columns);
  return { U, Up };
}

/** The Riccati solution; a failure names what moves in the mode that is nearest to the axis. */
function solveNamed(
  A: Matrix,
  B: Matrix,
  C: Matrix,
  R: readonly number[],
  toStates: Matrix,
  { states }: Linearization,
): RiccatiSolution {
  try {
    return solveCare(A, B, C.transpose().mmul(C), R, C);
  } catch (error) {
    if (!(error instanceof ControlError)) throw error;
    const nearest = modesOf(A, toStates, states).sort(
      (a, b) => Math.abs(a.eigenvalue[0]) - Math.abs(b.eigenvalue[0]),
    )[0];
    throw new ControlError(
      nearest ? `${error.message} (nearest to the axis: ${nearest.moves.slice(0, 4).join(', ')})` : error.message,
    );
  }
}

/** How a mode dies away: |lambda| (rad/s), damping ratio -re/|lambda|, time constant -1/re (s; negative: it grows). */
export interface Decay {
  eigenvalue: Complex;
  frequency: number;
  damping: number | null;
  timeConstant: number | null;
}

/**
 * Frequency, damping and time constant of each eigenvalue.
 *
 * @param values eigenvalues, 1/s
 */
export function decays(values: readonly Complex[]): Decay[] {
  return values.map((eigenvalue) => {
    const frequency = modulus(eigenvalue);
    return {
      eigenvalue,
      frequency,
      damping: frequency > 0 ? -eigenvalue[0] / frequency : null,
      timeConstant: eigenvalue[0] !== 0 ? -1 / eigenvalue[0] : null,
    };
  });
}

/** Largest absolute entry of A - B K seen from outside: closed-loop matrix on the tangent space, d x d. */
export function closedLoopMatrix({ linearization: { basis: N, A, B }, gain }: LqrDesign): Matrix {
  return N.transpose()
    .mmul(Matrix.sub(A, B.mmul(gain)))
    .mmul(N);
}

/** Size of K on what the inputs can't reach, K (Vp + V S), as a share of K: 0 but for rounding. */
export function gainOnUnreachable({ linearization: { basis: N }, split, gain }: LqrDesign): number {
  const complement = N.mmul(Matrix.add(split.complement, split.reachable.mmul(split.S)));
  return norm(gain.mmul(complement)) / (norm(gain) || 1);
}
