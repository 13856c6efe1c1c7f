import { luFactor, luSolve } from '../../linalg/lu.ts';
import { derivativeOf, nodePolynomial, valueAt } from '../shared/polynomials.ts';
import { power } from '../../elementary/powers.ts';
import { cosine, sine } from '../../elementary/trigonometry.ts';

/**
 * Eigenvalues and eigenvectors of a collocation method's Runge-Kutta matrix A, by which I - h A (x) J falls apart into
 * I - h gamma J for each eigenvalue gamma: one real block for an odd number of stages, complex pairs else. J. Butcher,
 * "On the implementation of implicit Runge-Kutta methods", BIT 16 (1976), 237-240; Hairer and Wanner, Solving ODEs II,
 * 2nd ed., section IV.8.
 *
 * Both follow from the node polynomial M(x) = (x - c_1) … (x - c_s). An eigenvector holds the values at the nodes of a
 * polynomial p of degree s with p(0) = 0 and p' - mu p a multiple of M, mu = 1 / gamma; so p is a multiple of the sum of
 * M^(k) mu^(s-k) over k = 0 … s, and p(0) = 0 is the equation for mu (the denominator of the stability function:
 * section IV.3 there).
 */
export interface Transform {
  /** Eigenvalues of A: at most one real, first; then one of each pair, its imaginary part positive, the nearest to the axis first. */
  readonly eigenvalues: readonly (readonly [re: number, im: number])[];
  /**
   * s x s: a column for the real eigenvector, two for each pair. In its coordinates (w1, w2) A multiplies w1 + i w2 by
   * the eigenvalue, so the two are the real and the imaginary part of the conjugate's eigenvector.
   */
  readonly T: Float64Array;
  readonly inverse: Float64Array;
}

type Complex = readonly [number, number];

const times = ([a, b]: Complex, [c, d]: Complex): Complex => [a * c - b * d, a * d + b * c];
const over = ([a, b]: Complex, [c, d]: Complex): Complex => [
  (a * c + b * d) / (c * c + d * d),
  (b * c - a * d) / (c * c + d * d),
];

/** Value of a real polynomial at a complex point. */
function complexValueAt(polynomial: readonly number[], x: Complex): Complex {
  return polynomial.reduceRight<Complex>(
    (sum, a) => {
      const [re, im] = times(sum, x);
      return [re + a, im];
    },
    [0, 0],
  );
}

/** All zeros of a real polynomial by the Weierstrass (Durand-Kerner) iteration, until they stand still. */
function zeros(polynomial: readonly number[]): Complex[] {
  const degree = polynomial.length - 1;
  const leading = polynomial[degree]!;
  const radius = power(Math.abs(polynomial[0]! / leading), 1 / degree);
  const x = Array.from({ length: degree }, (_, k): Complex => [
    radius * cosine(1 + (6 * k) / degree),
    radius * sine(1 + (6 * k) / degree),
  ]);
  for (let sweep = 0; sweep < 100; sweep++) {
    x.forEach((xk, k) => {
      const rest = x.reduce<Complex>(
        (product, xj, j) => (j === k ? product : times(product, [xk[0] - xj[0], xk[1] - xj[1]])),
        [leading, 0],
      );
      const [re, im] = over(complexValueAt(polynomial, xk), rest);
      x[k] = [xk[0] - re, xk[1] - im];
    });
  }
  return x;
}

/** The derivatives M, M', …, M^(s) of a polynomial given by rising powers. */
function derivatives(polynomial: number[]): number[][] {
  const list = [polynomial];
  while (list.at(-1)!.length > 1) list.push(derivativeOf(list.at(-1)!));
  return list;
}

/**
 * Eigenvalues and eigenvectors of the Runge-Kutta matrix of a collocation method.
 * @param nodes c_1 … c_s
 */
export function transformOf(nodes: readonly number[]): Transform {
  const s = nodes.length;
  const M = derivatives(nodePolynomial(nodes));
  const mus = zeros(M.map((p) => p[0]!).reverse());
  const rounding = 1e-9 * Math.hypot(...mus[0]!);
  const chosen = [
    ...mus.filter(([, im]) => Math.abs(im) < rounding).map(([re]): Complex => [re, 0]),
    ...mus.filter(([, im]) => im <= -rounding).sort(([a, b], [c, d]) => d / c - b / a),
  ];
  const T = new Float64Array(s * s);
  const eigenvalues = chosen.map((mu) => over([1, 0], mu));
  eigenvalues.forEach((gamma, e) => {
    const column = e === 0 ? 0 : 2 * e - (eigenvalues[0]![1] === 0 ? 1 : 0);
    nodes.forEach((c, i) => {
      const [re, im] = complexValueAt(
        M.map((p) => valueAt(p, c)),
        gamma,
      );
      T[i * s + column] = re;
      if (gamma[1] !== 0) T[i * s + column + 1] = -im;
    });
  });
  return { eigenvalues, T, inverse: inverseOf(T, s) };
}

function inverseOf(matrix: Float64Array, n: number): Float64Array {
  const inverse = new Float64Array(n * n);
  const LU = matrix.slice();
  const pivots = new Int32Array(n);
  luFactor(LU, n, pivots);
  const column = new Float64Array(n);
  for (let j = 0; j < n; j++) {
    column.fill(0);
    column[j] = 1;
    luSolve(LU, n, pivots, column);
    for (let i = 0; i < n; i++) inverse[i * n + j] = column[i]!;
  }
  return inverse;
}
