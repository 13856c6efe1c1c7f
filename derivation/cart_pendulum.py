"""The pendulum on a cart (report 3.3.1, Eq. 17 to 19, Fig. 7), with gravity's sign such that theta = pi/2 is upright.

The pendulum's centre of mass is at a distance L from its pivot and its radius of gyration about that centre is L:
that is what the factor 2 of L^2 theta_dot^2 in Eq. 17 says.
"""

import sympy as sp

from .energy import Body, Point, kinetic, potential
from .euler_lagrange import from_lagrangian
from .model import Model, coordinates, on_level_ground
from .notation import Notation
from .rotations import Frame

q, v = coordinates("X theta")
X, theta = q
p = {name: sp.Symbol(name, real=True) for name in "m1 m2 L gravity".split()}


def pendulum(place: sp.Matrix, turned: sp.Expr, q: sp.Matrix, mass: sp.Expr, centre: sp.Expr, inertia: sp.Expr):
    """A rod that hangs on a pivot in the X-Z plane: its body (origin at the centre of mass) and its pose (at the pivot)."""
    frame = Frame.world(q).turned("y", turned, q)
    pivot = Point(place, frame, sp.zeros(3, 1))
    body = Body("pendulum", frame, pivot.moved(frame, sp.Matrix([centre, 0, 0])), mass, sp.diag(0, inertia, inertia))
    return body, Body("pendulum", frame, pivot, mass, body.inertia)


def printed_lagrangian() -> sp.Expr:
    """As it stands in the report, with gravity's sign changed."""
    m1, m2, L, g = p.values()
    return m1 * v[0]**2 / 2 + m2 / 2 * (
        -2 * g * L * sp.sin(theta) + 2 * L**2 * v[1]**2 - 2 * L * sp.sin(theta) * v[1] * v[0] + v[0]**2)


def model() -> Model:
    place = on_level_ground(X, 0)
    world = Frame.world(q)
    cart = Body("cart", world, Point(place, world, sp.zeros(3, 1)), p["m1"], sp.zeros(3, 3))
    # Turning by -theta about y raises the rod's own x axis to (cos theta, 0, sin theta).
    rod, shown = pendulum(place, -theta, q, p["m2"], p["L"], p["m2"] * p["L"]**2)
    T, V = sp.simplify(kinetic((cart, rod), q, v)), potential((rod,), p["gravity"])
    return Model(
        id="cart-pendulum", title="the pendulum on a cart", q=q, v=v, parameters=tuple(p.values()),
        equations=from_lagrangian(T - V, q, v), kinetic=T, potential=V, bodies=(cart, shown),
        notation=Notation("X θ m_1 m_2 L g", {"cart": "1", "pendulum": "2"}, masses=(cart, rod)),
    )
