"""Writes radau-counts.json: what SciPy's Radau takes for problems of the integrators' tests, and how near it comes.

    python3 tests/reference/radau_counts.py      (needs SciPy; written by 1.17.1)

Steps, evaluations of f (those for Jacobians by differences left out: all Jacobians here are exact), Jacobians,
factorizations (SciPy counts a real and a complex one for each) and the largest error at the end, at rtol = 1e-4, 1e-6,
1e-8. The problems are those of tests/core/integrators/problems.ts.
"""

import json
from pathlib import Path

import numpy as np
import scipy
from scipy.integrate import Radau, solve_ivp

def kepler(_t, y):
    r3 = np.hypot(y[0], y[1]) ** 3
    return np.array([y[2], y[3], -y[0] / r3, -y[1] / r3])


def kepler_jacobian(_t, y):
    x, z = y[:2]
    r2 = x * x + z * z
    r5 = r2**2.5
    return np.array(
        [[0, 0, 1, 0], [0, 0, 0, 1], [(3 * x * x - r2) / r5, 3 * x * z / r5, 0, 0], [3 * x * z / r5, (3 * z * z - r2) / r5, 0, 0]]
    )


def robertson(_t, y):
    a, b, c = y
    return np.array([-0.04 * a + 1e4 * b * c, 0.04 * a - 1e4 * b * c - 3e7 * b * b, 3e7 * b * b])


def robertson_jacobian(_t, y):
    _, b, c = y
    return np.array([[-0.04, 1e4 * c, 1e4 * b], [0.04, -1e4 * c - 6e7 * b, -1e4 * b], [0, 6e7 * b, 0]])


def van_der_pol(_t, y):
    return np.array([y[1], ((1 - y[0] ** 2) * y[1] - y[0]) / 1e-6])


def van_der_pol_jacobian(_t, y):
    return np.array([[0, 1], [(-2 * y[0] * y[1] - 1) / 1e-6, (1 - y[0] ** 2) / 1e-6]])


def prothero(t, y):
    return -1000 * (y - np.cos(t)) - np.sin(t)


def prothero_jacobian(_t, _y):
    return np.array([[-1000.0]])


ECCENTRICITY = 0.3
PERICENTRE = [1 - ECCENTRICITY, 0, 0, np.sqrt(1 - ECCENTRICITY**2) / (1 - ECCENTRICITY)]
PROBLEMS = {
    "kepler": (kepler, kepler_jacobian, PERICENTRE, 4 * np.pi, 1),
    "prothero": (prothero, prothero_jacobian, [1], 10, 1),
    "robertson": (robertson, robertson_jacobian, [1, 0, 0], 40, 1e-6),
    "vanDerPol": (van_der_pol, van_der_pol_jacobian, [2, -0.66], 2, 1),
}


def truth(name, f, jacobian, y0, end, atol):
    if name == "kepler":
        return np.array(y0)
    if name == "prothero":
        return np.array([np.cos(end)])
    return solve_ivp(f, (0, end), y0, "Radau", rtol=1e-12, atol=1e-14 * atol, jac=jacobian).y[:, -1]


def row(f, jacobian, y0, end, atol, rtol, exact):
    solver = Radau(f, 0, y0, end, rtol=rtol, atol=rtol * atol, jac=jacobian)
    steps = 0
    while solver.status == "running":
        message = solver.step()
        assert solver.status != "failed", message
        steps += 1
    error = np.max(np.abs(solver.y - exact))
    counts = {"steps": steps, "evaluations": solver.nfev, "jacobians": solver.njev, "factorizations": solver.nlu // 2}
    return {"rtol": rtol, **counts, "error": float(f"{error:.3g}")}


if __name__ == "__main__":
    values = {"scipy": scipy.__version__, "problems": {}}
    for name, (f, jacobian, y0, end, atol) in PROBLEMS.items():
        exact = truth(name, f, jacobian, y0, end, atol)
        rows = [row(f, jacobian, y0, end, atol, rtol, exact) for rtol in (1e-4, 1e-6, 1e-8)]
        values["problems"][name] = {"start": y0, "time": end, "atolPerRtol": atol, "end": exact.tolist(), "rows": rows}
    Path(__file__).with_name("radau-counts.json").write_text(json.dumps(values, indent=1) + "\n")
