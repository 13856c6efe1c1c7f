/**
 * Structure-preserving doubling (E. K.-W. Chu, H.-Y. Fan and W.-W. Lin, Linear Algebra and its Applications 396 (2005), 55-80;
 * discrete time: with C.-S. Wang, Int. J. Control 77 (2004), 767-788): A_k, G_k, H_k, each step the square of the one before;
 * H_k tends to the least solution of the Riccati equation, A_k to zero with the closed loop.
 */

/** What it needs of matrices, in whatever precision they are. */
export interface Algebra<M> {
  identity(n: number): M;
  times(a: M, b: M): M;
  plus(a: M, b: M): M;
  transposed(a: M): M;
  symmetric(a: M): M;
  /** X with W X = B; null where W is singular. */
  solve(W: M, B: M): M | null;
  norm(a: M): number;
}

export interface Stopping {
  mostSteps: number;
  /** H changes by less than this share of itself, */
  converged: number;
  /** and A is less than this, where it matters: before, an unstable mode that the cost hardly sees has yet to show. */
  settled?: number;
}

/**
 * @param algebra operations on n x n matrices
 * @param n of the matrices
 * @returns null where it does not converge
 * @param first A_0, G_0 and H_0, each n x n
 */
export function doubled<M>(
  algebra: Algebra<M>,
  n: number,
  first: { Ak: M; Gk: M; Hk: M },
  { mostSteps, converged, settled = Infinity }: Stopping,
): { X: M; steps: number } | null {
  const { times, plus, transposed, symmetric, solve, norm } = algebra;
  const I = algebra.identity(n);
  let { Ak, Gk, Hk } = first;
  for (let steps = 1; steps <= mostSteps; steps++) {
    const W = plus(I, times(Gk, Hk));
    const [WA, WG] = [solve(W, Ak), solve(W, Gk)];
    if (!WA || !WG) return null;
    const change = symmetric(times(times(transposed(Ak), Hk), WA));
    Gk = symmetric(plus(Gk, times(times(Ak, WG), transposed(Ak))));
    Hk = plus(Hk, change);
    Ak = times(Ak, WA);
    if (!Number.isFinite(norm(Hk)) || !Number.isFinite(norm(Gk))) return null;
    if (norm(change) <= converged * norm(Hk) && norm(Ak) < settled) return { X: Hk, steps };
  }
  return null;
}
