"""A wheel that rolls in a plane and carries an inverted pendulum at its hub (report 3.5.1, Eq. 27 to 34).

The pendulum is a thin rod of length 2 L: its inertia about its centre is mP L^2 / 3 (Eq. 28).
"""

import sympy as sp

from .cart_pendulum import pendulum
from .constraints import rows_only
from .energy import Body, Point, kinetic, potential
from .euler_lagrange import from_lagrangian
from .model import Model, coordinates, on_level_ground
from .notation import Notation
from .rotations import Frame

q, v = coordinates("X phi psi")
X, phi, psi = q
p = {name: sp.Symbol(name, real=True) for name in "rho m mP Jspin L gravity".split()}


def printed_lagrangian() -> sp.Expr:
    """Eq. 29."""
    rho, m, mP, Jspin, L, g = p.values()
    X_dot, phi_dot, psi_dot = v
    rod = g * L * sp.sin(psi) - g * rho + sp.Rational(2, 3) * L**2 * psi_dot**2 - L * psi_dot * sp.sin(psi) * X_dot + X_dot**2 / 2
    return mP * rod + (Jspin * phi_dot**2 + m * X_dot**2) / 2


def model() -> Model:
    place = on_level_ground(X, 0, p["rho"])
    frame = Frame.world(q).turned("y", phi, q)
    wheel = Body("wheel", frame, Point(place, frame, sp.zeros(3, 1)), p["m"], sp.diag(0, p["Jspin"], 0))
    rod, shown = pendulum(place, psi, q, p["mP"], p["L"], p["mP"] * p["L"]**2 / 3)
    T, V = sp.simplify(kinetic((wheel, rod), q, v)), potential((rod,), p["gravity"])
    return Model(
        id="wheel-pendulum", title="the wheel with a pendulum", q=q, v=v, parameters=tuple(p.values()),
        equations=from_lagrangian(T - V, q, v), kinetic=T, potential=V, bodies=(wheel, shown),
        constraints=(rows_only("rolling", [v[0] - p["rho"] * v[1]], v),),
        notation=Notation("X φ ψ ρ m m_P J_spin L g", {"wheel": "w", "pendulum": "P"}, masses=(wheel, rod), titles={"rolling": ("rolling",)}),
    )
