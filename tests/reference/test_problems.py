"""Writes test-problems.json: solutions of problems for steppers, with more digits than a double has.

    python3 tests/reference/test_problems.py      (needs NumPy with long doubles of 64 bits of mantissa)

Both by extrapolation of the modified midpoint rule (Gragg, Bulirsch, Stoer) in long doubles, at two tolerances.

Pleiades: seven stars in a plane with masses 1 to 7 (Hairer, Norsett and Wanner, Solving ODEs I, section II.10), at t = 3;
close encounters magnify rounding, so its values are good to about twelve digits.

Slider-crank: crank and rod are slender bars, the slider moves along x, gravity pulls along -y. The crank's angle alone
is integrated, by Lagrange's equation of 1/2 I(phi) phi'^2 - V(phi); energy is checked.
"""

import json
from pathlib import Path

import numpy as np

real = np.longdouble
assert np.finfo(real).eps < 2e-19, "long doubles are no longer than doubles here"


def midpoint(f, y, H, n):
    """Modified midpoint rule with n (even) substeps."""
    h = H / n
    before, now = y, y + h * f(y)
    for _ in range(n - 1):
        before, now = now, before + 2 * h * f(now)
    return now


def extrapolated(f, y, t_end, tolerance, columns=9):
    """With the numbers 2, 4, 6, ...; step control by the last two columns."""
    t, H = real(0), real(1) / 20
    counts = [2 * (k + 1) for k in range(columns)]
    while t < t_end:
        H = min(H, t_end - t)
        row = []
        for k, n in enumerate(counts):
            new = [midpoint(f, y, H, n)]
            for j in range(1, k + 1):
                ratio = real(counts[k] ** 2) / counts[k - j] ** 2 - 1
                new.append(new[j - 1] + (new[j - 1] - row[j - 1]) / ratio)
            row = new
        error = max(np.max(np.abs(row[-1] - row[-2]) / np.maximum(1, np.abs(row[-1]))), real(1e-40))
        if error <= tolerance:
            t, y = t + H, row[-1]
        H *= max(real(0.2), min(real(3), real(0.8) * (tolerance / error) ** (real(1) / (2 * columns - 1))))
    return y


def twice(f, start, t_end, agree):
    coarse, fine = (extrapolated(f, start, real(t_end), real(tolerance)) for tolerance in (1e-15, 1e-16))
    difference = np.max(np.abs(coarse - fine))
    assert difference < agree, difference
    return fine


PLEIADES = [3, 3, -1, -3, 2, -2, 2, 3, -3, 2, 0, 0, -4, 4, 0, 0, 0, 0, 0, 1.75, -1.5, 0, 0, 0, -1.25, 1, 0, 0]


def pleiades(y):
    mass = np.arange(1, 8, dtype=real)
    dx, dz = y[:7] - y[:7, None], y[7:14] - y[7:14, None]
    r2 = dx * dx + dz * dz + np.eye(7, dtype=real)
    weight = mass / (r2 * np.sqrt(r2))
    return np.concatenate([y[14:21], y[21:28], np.sum(weight * dx, axis=1), np.sum(weight * dz, axis=1)])


def pleiades_reference():
    end = twice(pleiades, np.array(PLEIADES, dtype=real), 3, 1e-11)
    return {"start": PLEIADES, "time": 3, "end": [float(a) for a in end]}


CRANK = {"m1": 1, "l1": 1, "m2": 1.5, "l2": 2.5, "m3": 2, "g": 9.8125}
CRANK_START = [0.75, 4]


def slider_crank_reference():
    m1, l1, m2, l2, m3, g = (real(CRANK[k]) for k in ("m1", "l1", "m2", "l2", "m3", "g"))

    def rod(phi):
        return np.arcsin(-l1 / l2 * np.sin(phi))

    def inertia(phi):
        """I, I' and V'; b is the rod's angle, slopes are those by the crank's angle."""
        b = rod(phi)
        s, c, sb, cb = np.sin(phi), np.cos(phi), np.sin(b), np.cos(b)
        b1 = -l1 * c / (l2 * cb)
        b2 = (l1 * s / l2 + b1 * b1 * sb) / cb
        x1 = -l1 * s - l2 * sb * b1
        x2 = -l1 * c - l2 * (cb * b1 * b1 + sb * b2)
        cross, cross1 = np.cos(phi - b), -np.sin(phi - b) * (1 - b1)
        I = m1 * l1**2 / 3 + m2 * (l1**2 + l1 * l2 * cross * b1 + l2**2 / 3 * b1**2) + m3 * x1**2
        I1 = m2 * (l1 * l2 * (cross1 * b1 + cross * b2) + 2 * l2**2 / 3 * b1 * b2) + 2 * m3 * x1 * x2
        V1 = g * ((m1 / 2 + m2) * l1 * c + m2 / 2 * l2 * cb * b1)
        return I, I1, V1

    def f(y):
        I, I1, V1 = inertia(y[0])
        return np.array([y[1], -(I1 * y[1] ** 2 / 2 + V1) / I])

    start = np.array(CRANK_START, dtype=real)
    times = [0.5, 1, 1.5, 2]
    states = [twice(f, start, t, 1e-13) for t in times]

    def energy(phi, rate):
        height = g * ((m1 / 2 + m2) * l1 * np.sin(phi) + m2 / 2 * l2 * np.sin(rod(phi)))
        return inertia(phi)[0] * rate**2 / 2 + height

    drift = max(abs(energy(*y) - energy(*start)) for y in states)
    assert drift < 1e-12, drift

    def full(phi, rate):
        b = rod(phi)
        b_dot = -l1 * np.cos(phi) / (l2 * np.cos(b)) * rate
        x = l1 * np.cos(phi) + l2 * np.cos(b)
        x_dot = -l1 * np.sin(phi) * rate - l2 * np.sin(b) * b_dot
        return [float(a) for a in (phi, b, x, rate, b_dot, x_dot)]

    return {
        "parameters": CRANK,
        "start": full(*start),
        "rows": [{"time": t, "state": full(*y)} for t, y in zip(times, states)],
    }


if __name__ == "__main__":
    values = {"pleiades": pleiades_reference(), "sliderCrank": slider_crank_reference()}
    Path(__file__).with_name("test-problems.json").write_text(json.dumps(values, indent=1) + "\n")
