import { Matrix, SingularValueDecomposition } from 'ml-matrix';
import { complexLuFactor, complexLuSolve } from '../linalg/complexLu.ts';
import { modulus, plainEigenvalues, type Complex } from './linearization/spectrum.ts';
import { held, heldWithDelay } from './sampled/hold.ts';

/**
 * How far a state feedback `u = -K x` of `x' = A x + B u` is from losing its stability, at the inputs:
 * K. J. Åström and R. M. Murray, Feedback Systems, 2nd ed., section 10.3; several inputs at once by the eigenvalues and
 * singular values of L(s) = K (s - A)^-1 B (S. Skogestad and I. Postlethwaite, Multivariable Feedback Control, 2nd ed.,
 * sections 4.9 and 5.2).
 */
export interface Margins {
  /** The shortest pure delay, in all inputs alike, that lets a mode grow, s; Infinity if none does. */
  delay: number;
  /** The shortest sample time, with a zero-order hold, that does, s. */
  sampleTime: number;
  /** By input, the others as they are: factors of its gain between which the loop is stable. */
  gain: Record<string, [number, number]>;
  /** By input: the smallest lag that lets a mode grow, rad; Infinity where the loop gain nowhere passes 1. */
  phase: Record<string, number>;
  /** 1 / (largest singular value of the sensitivity (I + L)^-1): the disc about -1 that the loops stay out of. */
  disc: number;
}

export interface Loop {
  A: Matrix;
  B: Matrix;
  K: Matrix;
}

/**
 * @param loop A n x n, B n x k, K k x n with A - B K stable (modes that the cost leaves alone are left out before)
 * @param inputs names of B's columns
 */
export function marginsOf(loop: Loop, inputs: readonly string[]): Margins {
  const grid = frequencies(loop);
  const single = inputs.map((_, i) => oneInput(loop, i));
  return {
    delay: delayMargin(loop, grid),
    sampleTime: sampleTimeMargin(loop),
    gain: Object.fromEntries(inputs.map((name, i) => [name, gainMargin(single[i]!, grid)])),
    phase: Object.fromEntries(inputs.map((name, i) => [name, phaseMargin(single[i]!, grid)])),
    disc: discMargin(loop, grid),
  };
}

const PER_DECADE = 60;
/** Poles below this share of the largest are integrators. */
const NEUTRAL = 1e-7;
/** Near a pole, frequencies around its own, in shares of its distance from the axis. */
const NEAR = Array.from({ length: 41 }, (_, i) => (i - 20) / 4);

/** Frequencies (rad/s) that see every pole of the open and the closed loop, ascending. */
export function frequencies({ A, B, K }: Loop): number[] {
  const poles = [...plainEigenvalues(A), ...plainEigenvalues(Matrix.sub(A, B.mmul(K)))];
  const largest = Math.max(...poles.map(modulus));
  const sizes = poles.map(modulus).filter((size) => size > NEUTRAL * largest);
  if (sizes.length === 0) return [1];
  const [least, most] = [Math.min(...sizes) / 100, Math.max(...sizes) * 100];
  const count = Math.ceil(Math.log10(most / least) * PER_DECADE);
  const even = Array.from({ length: count + 1 }, (_, i) => least * (most / least) ** (i / count));
  const own = poles.flatMap(([re, im]) => NEAR.map((share) => Math.abs(im) + share * Math.abs(re)));
  return [...even, ...own.filter((w) => w > least)].sort((a, b) => a - b);
}

/**
 * L(i w), k x k, as real and imaginary parts.
 *
 * @param loop A n x n, B n x k, K k x n
 * @param w rad/s
 */
export function loopGain(loop: Loop, w: number): { re: Matrix; im: Matrix } {
  return gainAt(loop, [0, w]);
}

/** K (s - A)^-1 B, k x k, at any complex s. */
function gainAt({ A, B, K }: Loop, [x, y]: Complex): { re: Matrix; im: Matrix } {
  const [n, k] = [A.rows, B.columns];
  const re = Float64Array.from(Matrix.mul(A, -1).to1DArray());
  const im = new Float64Array(n * n);
  for (let i = 0; i < n; i++) {
    re[i * n + i]! += x;
    im[i * n + i] = y;
  }
  const pivots = new Int32Array(n);
  const [X, Y] = [new Matrix(n, k), new Matrix(n, k)];
  if (!complexLuFactor(re, im, n, pivots)) return { re: new Matrix(K.rows, k), im: new Matrix(K.rows, k) };
  for (let c = 0; c < k; c++) {
    const [right, imaginary] = [Float64Array.from(B.getColumn(c)), new Float64Array(n)];
    complexLuSolve(re, im, n, pivots, right, imaginary);
    for (let r = 0; r < n; r++) {
      X.set(r, c, right[r]!);
      Y.set(r, c, imaginary[r]!);
    }
  }
  return { re: K.mmul(X), im: K.mmul(Y) };
}

/**
 * Eigenvalues of a complex k x k matrix, k the number of inputs: the characteristic polynomial by Faddeev and LeVerrier,
 * its roots by the simultaneous iteration of Weierstrass, Durand and Kerner. Good for the handful of inputs there are.
 */
function complexEigenvalues(re: Matrix, im: Matrix): Complex[] {
  const k = re.rows;
  if (k === 1) return [[re.get(0, 0), im.get(0, 0)]];
  const size = Math.hypot(re.norm(), im.norm());
  if (!(size > 0)) return Array.from({ length: k }, (): Complex => [0, 0]);
  const [R, J] = [Matrix.div(re, size), Matrix.div(im, size)];
  // p(x) = x^k + c_1 x^(k-1) + ... + c_k, M_1 = L, c_i = -tr(M_i) / i, M_(i+1) = L (M_i + c_i).
  const coefficients: Complex[] = [];
  let [a, b] = [R, J];
  for (let i = 1; i <= k; i++) {
    const c: Complex = [-a.trace() / i, -b.trace() / i];
    coefficients.push(c);
    const [x, y] = [Matrix.add(a, Matrix.eye(k).mul(c[0])), Matrix.add(b, Matrix.eye(k).mul(c[1]))];
    [a, b] = [Matrix.sub(R.mmul(x), J.mmul(y)), Matrix.add(R.mmul(y), J.mmul(x))];
  }
  return polynomialRoots(coefficients).map(([x, y]): Complex => [x * size, y * size]);
}

const times = ([a, b]: Complex, [c, d]: Complex): Complex => [a * c - b * d, a * d + b * c];
const over = ([a, b]: Complex, [c, d]: Complex): Complex => {
  const square = c * c + d * d || Number.MIN_VALUE;
  return [(a * c + b * d) / square, (b * c - a * d) / square];
};

/** Roots of x^k + c_1 x^(k-1) + ... + c_k. */
function polynomialRoots(c: readonly Complex[]): Complex[] {
  const value = (x: Complex): Complex =>
    c.reduce<Complex>((sum, ci) => [times(sum, x)[0] + ci[0], times(sum, x)[1] + ci[1]], [1, 0]);
  const found = c.map((_, i): Complex => [0.8 * Math.cos(2.3 * i + 0.4), 0.8 * Math.sin(2.3 * i + 0.4)]);
  for (let round = 0; round < 100; round++) {
    let change = 0;
    found.forEach((x, i) => {
      const others = found.reduce<Complex>(
        (product, y, j) => (j === i ? product : times(product, [x[0] - y[0], x[1] - y[1]])),
        [1, 0],
      );
      const step = over(value(x), others);
      found[i] = [x[0] - step[0], x[1] - step[1]];
      change = Math.max(change, Math.hypot(...step));
    });
    if (change < 1e-15) break;
  }
  return found;
}

/** Roots of a function of frequency between neighbours of a grid, bisected to rounding. */
function roots(f: (w: number) => number, grid: readonly number[]): number[] {
  const found: number[] = [];
  let [before, valueBefore] = [grid[0]!, f(grid[0]!)];
  for (const w of grid.slice(1)) {
    const value = f(w);
    if (value !== 0 && Math.sign(value) !== Math.sign(valueBefore) && Number.isFinite(value + valueBefore)) {
      found.push(bisected(f, before, w, valueBefore));
    }
    [before, valueBefore] = [w, value];
  }
  return found;
}

function bisected(f: (x: number) => number, from: number, to: number, valueFrom: number): number {
  let [a, b] = [from, to];
  for (let i = 0; i < 60 && b - a > 1e-15 * b; i++) {
    const middle = (a + b) / 2;
    if (Math.sign(f(middle)) === Math.sign(valueFrom)) a = middle;
    else b = middle;
  }
  return (a + b) / 2;
}

/**
 * The shortest pure delay, in all inputs alike, that lets a mode grow, s; Infinity if none does.
 *
 * @param loop with A - B K stable
 * @param grid frequencies, rad/s, ascending
 */
export function delayMargin(loop: Loop, grid: readonly number[] = frequencies(loop)): number {
  return shortestDelay((w) => loopGain(loop, w), loop.B.columns, grid);
}

/** A common delay T turns all of L by w T: a mode is on the axis where an eigenvalue of modulus 1 comes to -1. */
function shortestDelay(gain: (w: number) => { re: Matrix; im: Matrix }, k: number, grid: readonly number[]): number {
  const sorted = (w: number): Complex[] => {
    const { re, im } = gain(w);
    return complexEigenvalues(re, im).sort((a, b) => modulus(b) - modulus(a));
  };
  let least = Infinity;
  for (let i = 0; i < k; i++) {
    for (const w of roots((x) => Math.log(modulus(sorted(x)[i]!)), grid)) {
      const [re, im] = sorted(w)[i]!;
      const lag = Math.atan2(-im, -re);
      least = Math.min(least, (lag > 0 ? lag : lag + 2 * Math.PI) / w);
    }
  }
  return least;
}

/** Corrections of the part of a sample; the delay falls almost by what is added to it. */
const MOST_PARTS = 30;

/**
 * The shortest delay in all inputs alike, from measurement to actuation, that lets a mode grow where the gain is held
 * between samples (zero-order hold), s; 0 where it grows without one, Infinity if none does.
 *
 * A delay is m samples and a part f of one: m turns L by w h m, f is in the sampled plant. At the margin both fit.
 *
 * @param loop continuous, with A - B K stable
 * @param h sample time, s
 */
export function heldDelayMargin(loop: Loop, h: number): number {
  const { A, B, K } = loop;
  const plant = held(A, B, h);
  if (plainEigenvalues(Matrix.sub(plant.A, plant.B.mmul(K))).some((value) => modulus(value) >= 1)) return 0;
  const most = Math.PI / h;
  const grid = [...frequencies(loop).filter((w) => w < most), most];
  const samples = (part: number): number => {
    const { A: Ah, B: Bh } = heldWithDelay(A, B, h, part * h);
    const Kh = Matrix.zeros(K.rows, Ah.rows);
    Kh.setSubMatrix(K, 0, 0);
    const sampled = { A: Ah, B: Bh, K: Kh };
    return shortestDelay((w) => gainAt(sampled, [Math.cos(w * h), Math.sin(w * h)]), B.columns, grid) / h;
  };
  const first = samples(0);
  if (!(first < Infinity)) return Infinity;
  const whole = Math.floor(first);
  let part = first - whole;
  for (let i = 0; i < MOST_PARTS; i++) {
    const rest = samples(part) - whole;
    if (Math.abs(rest) < 1e-9) break;
    part = Math.min(1, Math.max(0, part + rest));
  }
  return (whole + part) * h;
}

const SAMPLES_PER_DECADE = 60;

/** The first sample time at which the held loop grows: scanned upwards from a hundredth of the fastest rate, bisected. */
export function sampleTimeMargin({ A, B, K }: Loop): number {
  const growth = (h: number): number => {
    const plant = held(A, B, h);
    return Math.max(...plainEigenvalues(Matrix.sub(plant.A, plant.B.mmul(K))).map(modulus)) - 1;
  };
  const rates = [...plainEigenvalues(A), ...plainEigenvalues(Matrix.sub(A, B.mmul(K)))]
    .map(modulus)
    .filter((r) => r > 0);
  if (rates.length === 0) return Infinity;
  const [fastest, slowest] = [Math.max(...rates), Math.min(...rates.filter((r) => r > 1e-6 * Math.max(...rates)))];
  const [start, end] = [0.05 / fastest, 50 / slowest];
  let before = start;
  for (let i = 0; before < end; i++) {
    const h = start * 10 ** (i / SAMPLES_PER_DECADE);
    // A slow mode's modulus is below 1 by little more than rounding.
    if (growth(h) > 1e-12) return i === 0 ? h : bisected((x) => growth(x) - 1e-12, before, h, -1);
    before = h;
  }
  return Infinity;
}

/**
 * One input's loop with the others closed.
 *
 * @param i place of the input, from 0
 */
export function oneInput({ A, B, K }: Loop, i: number): Loop {
  const others = B.mmul(K).sub(B.getColumnVector(i).mmul(K.getRowVector(i)));
  return { A: Matrix.sub(A, others), B: B.getColumnVector(i), K: K.getRowVector(i) };
}

/** L(i w) of a loop of one input. */
function singleGain(loop: Loop, w: number): Complex {
  const { re, im } = loopGain(loop, w);
  return [re.get(0, 0), im.get(0, 0)];
}

/** Factors of the gain, down and up, at which a mode comes onto the axis: where L is real and negative, or at w = 0. */
function gainMargin(loop: Loop, grid: readonly number[]): [number, number] {
  const part = (w: number): Complex => singleGain(loop, w);
  const crossings = [...roots((w) => part(w)[1], grid), 0].map((w) => part(w)[0]).filter((re) => re < 0);
  const factors = crossings.map((re) => -1 / re);
  return [
    Math.max(0, ...factors.filter((factor) => factor < 1)),
    Math.min(Infinity, ...factors.filter((factor) => factor > 1)),
  ];
}

function phaseMargin(loop: Loop, grid: readonly number[]): number {
  const at = (w: number): Complex => singleGain(loop, w);
  const lags = roots((w) => Math.log(modulus(at(w))), grid).map((w) => {
    const [re, im] = at(w);
    return Math.abs(Math.atan2(-im, -re));
  });
  return Math.min(Infinity, ...lags);
}

function discMargin({ A, B, K }: Loop, grid: readonly number[]): number {
  const k = B.columns;
  // The sensitivity through the closed loop, I - K (s - A + B K)^-1 B: bounded where L itself has poles.
  const closed = { A: Matrix.sub(A, B.mmul(K)), B, K };
  const radius = (w: number): number => {
    const { re, im } = loopGain(closed, w);
    const R = Matrix.sub(Matrix.eye(k), re);
    const M = Matrix.zeros(2 * k, 2 * k);
    M.setSubMatrix(R, 0, 0).setSubMatrix(im, 0, k).setSubMatrix(Matrix.mul(im, -1), k, 0).setSubMatrix(R, k, k);
    return 1 / Math.max(...new SingularValueDecomposition(M).diagonal);
  };
  const values = grid.map(radius);
  // At infinite frequency nothing comes back: the sensitivity is the identity.
  let least = Math.min(1, ...values);
  // Around each local minimum of the grid, by golden sections.
  values.forEach((value, i) => {
    if (i === 0 || i === values.length - 1 || value > values[i - 1]! || value > values[i + 1]!) return;
    if (value < 1.2 * least) least = Math.min(least, golden(radius, grid[i - 1]!, grid[i + 1]!));
  });
  return least;
}

function golden(f: (x: number) => number, from: number, to: number): number {
  const ratio = (Math.sqrt(5) - 1) / 2;
  let [a, b] = [from, to];
  let [x, y] = [b - ratio * (b - a), a + ratio * (b - a)];
  let [fx, fy] = [f(x), f(y)];
  for (let i = 0; i < 40; i++) {
    if (fx < fy) {
      [b, y, fy] = [y, x, fx];
      x = b - ratio * (b - a);
      fx = f(x);
    } else {
      [a, x, fx] = [x, y, fy];
      y = a + ratio * (b - a);
      fy = f(y);
    }
  }
  return Math.min(fx, fy);
}
