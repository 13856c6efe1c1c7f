"""Writes sampled-control.json: sampled regulators, Kalman filters and margins by another program.

SciPy 1.17.1, NumPy 2.4.6, python-control 0.10.2, on random systems of 2 to 30 states from a seed:
- the sampled regulator of least cost: A, B by `scipy.signal.cont2discrete`, the cost's integral by Gauss-Legendre
  quadrature of the matrix exponential (64 points), the equation by `scipy.linalg.solve_discrete_are`;
- the Kalman filter, sampled (`solve_discrete_are`, the noise's integral by the same quadrature) and continuous
  (`solve_continuous_are`);
- gain, phase and delay margin of one input, the regulator's loop with 0.7 of its gain (so that the margins are
  not those that theory promises): `control.stability_margins` over a fine grid, refined by `scipy.optimize.brentq`.

    python3 tests/reference/sampled_control.py > tests/reference/sampled-control.json
"""

import json

import control
import numpy as np
from scipy.linalg import expm, solve_continuous_are, solve_discrete_are
from scipy.optimize import brentq
from scipy.signal import cont2discrete

NODES, WEIGHTS = np.polynomial.legendre.leggauss(64)


def integral(f, h):
    return sum(w * h / 2 * f(h / 2 * (x + 1)) for x, w in zip(NODES, WEIGHTS))


def system(rng, n, k, p):
    A = rng.normal(size=(n, n)) / np.sqrt(n)
    A += 0.3 * np.eye(n)  # some modes grow
    return A, rng.normal(size=(n, k)), rng.normal(size=(p, n))


def regulator(A, B, h):
    n, k = B.shape
    Ad, Bd, *_ = cont2discrete((A, B, np.eye(n), np.zeros((n, k))), h)
    F = np.zeros((n + k, n + k))
    F[:n, :n], F[:n, n:] = A, B
    W = integral(lambda s: expm(F * s).T @ expm(F * s), h)
    Q, N, R = W[:n, :n], W[:n, n:], W[n:, n:]
    # Q = 1, R = 1: the input's own cost is in W already, as expm(F s) keeps u.
    X = solve_discrete_are(Ad, Bd, Q, R, s=N)
    return np.linalg.solve(R + Bd.T @ X @ Bd, Bd.T @ X @ Ad + N.T)


def filters(A, C, h):
    n = len(A)
    P = solve_continuous_are(A.T, C.T, np.eye(n), np.eye(len(C)))
    W = integral(lambda s: expm(A * s) @ expm(A * s).T, h)
    Ad = expm(A * h)
    R = np.eye(len(C)) / h
    Pd = solve_discrete_are(Ad.T, C.T, W, R)
    return (P @ C.T), (Pd @ C.T @ np.linalg.inv(C @ Pd @ C.T + R))


def margins(A, B):
    X = solve_continuous_are(A, B, np.eye(len(A)), np.eye(1))
    K = 0.7 * B.T @ X
    if np.linalg.eigvals(A - B @ K).real.max() >= 0:
        return None
    loop = lambda w: (K @ np.linalg.solve(1j * w * np.eye(len(A)) - A, B))[0, 0]
    grid = np.logspace(-4, 4, 40001)
    values = np.array([loop(w) for w in grid])

    def roots(f):
        y = f(values)
        at = np.where(np.sign(y[1:]) != np.sign(y[:-1]))[0]
        return [brentq(lambda w: f(np.array([loop(w)]))[0], grid[i], grid[i + 1], xtol=1e-14) for i in at]

    ones = roots(lambda v: np.log(np.abs(v)))
    lags = [np.arctan2(-loop(w).imag, -loop(w).real) for w in ones]
    phase = min(abs(x) for x in lags)
    delay = min((x if x > 0 else x + 2 * np.pi) / w for x, w in zip(lags, ones))
    real = [loop(w).real for w in roots(np.imag)] + [loop(0).real]
    factors = [-1 / x for x in real if x < 0]
    down = max([f for f in factors if f < 1], default=0)
    up = min([f for f in factors if f > 1], default=None)
    disc = min(np.abs(1 + values).min(), 1)
    # The same by python-control where its own grid finds the nearest crossings.
    sys = control.StateSpace(A, B, K, 0)
    _, pm, *_ = control.stability_margins(sys)
    return {"K": K.tolist(), "gain": [down, up], "phase": phase, "delay": delay, "disc": disc,
            "pythonControl": {"phase": float(np.radians(pm))}}


def main():
    rng = np.random.default_rng(20261128)
    cases = []
    for n, k, p, h in [(2, 1, 1, 0.1), (3, 2, 1, 0.05), (5, 2, 2, 0.2), (8, 2, 3, 0.1), (12, 3, 2, 0.05),
                       (20, 3, 4, 0.1), (30, 4, 5, 0.05)]:
        A, B, C = system(rng, n, k, p)
        L, Ld = filters(A, C, h)
        cases.append({"h": h, "A": A.tolist(), "B": B.tolist(), "C": C.tolist(), "K": regulator(A, B, h).tolist(),
                      "L": L.tolist(), "Ld": Ld.tolist()})
    loops = []
    for n in [2, 3, 4, 6, 8]:
        A, B, _ = system(rng, n, 1, 1)
        found = margins(A, B)
        if found:
            loops.append({"A": A.tolist(), "B": B.tolist(), **found})
    print(json.dumps({"cases": cases, "loops": loops}))


main()
