"""Writes riccati.json: algebraic Riccati equations solved by another program.

`scipy.linalg.solve_continuous_are` (SciPy 1.17.1, NumPy 2.4.6; ordered Schur form of the Hamiltonian pencil) on
- random stabilizable systems of 2 to 30 states, from a seed;
- the same with a mode, stable or not, that the inputs reach only through a coupling of 1e-2 to 1e-5;
- the board's reachable part at rest, at 1 m/s and at 3 m/s, taken from `npm run ripstik -- linearize` (first argument:
  a folder with rest.json, slow.json, fast.json), Q = identity.
SciPy's result is refined by Newton's method in 60 digits (mpmath) until it no longer changes, so that the stored gain
is right in all its digits even where the equation is ill conditioned.

    python3 tests/reference/riccati.py FOLDER > tests/reference/riccati.json
"""

import json
import sys

import mpmath as mp
import numpy as np
from scipy.linalg import solve_continuous_are, solve_continuous_lyapunov

mp.mp.dps = 60


def refined(A, B, Q, R, X):
    """Newton's method: the correction's Lyapunov equation in double precision, the residual in 60 digits."""
    a, q = mp.matrix(A.tolist()), mp.matrix(Q.tolist())
    f = mp.matrix((B / np.sqrt(R)).tolist())
    x = mp.matrix(X.tolist())
    # Coordinates in which X is near the identity keep the double-precision part well conditioned.
    w, V = np.linalg.eigh((X + X.T) / 2)
    w = np.maximum(w, 1e-14 * w.max())
    T, Ti = V / np.sqrt(w), (V * np.sqrt(w)).T
    for _ in range(60):
        k = f.T * x
        rest = a.T * x + x * a - k.T * k + q
        closed = Ti @ np.array((a - f * k).tolist(), dtype=float) @ T
        small = np.array((mp.matrix(T.T.tolist()) * rest * mp.matrix(T.tolist())).tolist(), dtype=float)
        change = Ti.T @ solve_continuous_lyapunov(closed.T, -small) @ Ti
        change = mp.matrix(((change + change.T) / 2).tolist())
        x = x + change
        if mp.norm(change) <= mp.mpf(10) ** -25 * mp.norm(x):
            return k, x, np.linalg.eigvals(closed)
    raise RuntimeError("no convergence")


def case(name, A, B, C, R):
    Q = C.T @ C
    X = solve_continuous_are(A, B, Q, np.diag(R))
    k, x, eig = refined(A, B, Q, R, X)
    gain = np.array([[float(k[i, j] / mp.sqrt(R[i])) for j in range(A.shape[0])] for i in range(B.shape[1])])
    assert eig.real.max() < 0, name
    exact = np.array(x.tolist(), dtype=float)
    return {
        "name": name,
        "A": A.tolist(),
        "B": B.tolist(),
        "C": C.tolist(),
        "R": list(R),
        "gain": gain.tolist(),
        "closedLoop": sorted([float(e.real), float(e.imag)] for e in eig),
        "scipy": float(np.linalg.norm(X - exact) / np.linalg.norm(exact)),
    }


def random_case(rng, n, k, coupling=None, unstable=True):
    A = rng.standard_normal((n, n)) / np.sqrt(n) * 3
    B = rng.standard_normal((n, k))
    if coupling is not None:
        # The last state moves by itself, but for the coupling.
        A[-1, :-1] *= coupling
        B[-1, :] = 0
        A[-1, -1] = 0.7 if unstable else -0.7
        H = np.linalg.qr(rng.standard_normal((n, n)))[0]
        A, B = H @ A @ H.T, H @ B
    C = rng.standard_normal((max(2, n // 2), n))
    R = [float(r) for r in 10.0 ** rng.uniform(-1, 1, k)]
    kind = "" if coupling is None else f", a {'growing' if unstable else 'decaying'} mode reached through {coupling:g}"
    return case(f"{n} states, {k} inputs{kind}", A, B, C, R)


def board_case(folder, file, name):
    with open(f"{folder}/{file}.json", encoding="utf8") as f:
        d = json.load(f)
    A, B, N = np.array(d["A"]), np.array(d["B"]), np.array(d["basis"])
    At, Bt = N.T @ A @ N, N.T @ B
    # The reachable subspace, built up orthonormally.
    V = block = np.linalg.svd(Bt, full_matrices=False)[0]
    while block.shape[1]:
        block = At @ block
        for _ in range(2):
            block = block - V @ (V.T @ block)
        u, s, _ = np.linalg.svd(block, full_matrices=False)
        block = u[:, s > 1e-9 * np.linalg.norm(At)]
        V = np.hstack([V, block])
    return case(name, V.T @ At @ V, V.T @ Bt, np.eye(V.shape[1]), [1.0] * B.shape[1])


if __name__ == "__main__":
    rng = np.random.default_rng(20170512)
    cases = [random_case(rng, n, k) for n, k in [(2, 1), (5, 2), (9, 1), (14, 2), (20, 3), (30, 4)]]
    for coupling in (1e-2, 1e-3, 1e-4, 1e-5):
        for n in (6, 12, 30) if coupling in (1e-3, 1e-5) else (6, 12):
            cases.append(random_case(rng, n, 2, coupling, True))
            cases.append(random_case(rng, n, 2, coupling, False))
    folder = sys.argv[1]
    cases += [
        board_case(folder, "rest", "the board at rest, by its feet"),
        board_case(folder, "slow", "the board at 1 m/s, by its steering motors"),
        board_case(folder, "fast", "the board at 3 m/s, by one steering motor"),
    ]
    json.dump({"cases": cases}, sys.stdout)
    print()
