"""The wheel that rolls upright without slipping (report 3.4.1, Eq. 21 to 25, Fig. 11 and 12)."""

import sympy as sp

from .constraints import rows_only
from .energy import Body, Point, kinetic
from .euler_lagrange import from_lagrangian
from .model import Model, coordinates, on_level_ground
from .notation import Notation
from .rotations import Frame

q, v = coordinates("X Y theta phi")
X, Y, theta, phi = q
p = {name: sp.Symbol(name, real=True) for name in "m rho Jroll Jspin gravity".split()}


def printed_lagrangian() -> sp.Expr:
    """Eq. 21."""
    return (p["m"] * (v[0]**2 + v[1]**2) + p["Jroll"] * v[2]**2 + p["Jspin"] * v[3]**2) / 2


def model() -> Model:
    frame = Frame.world(q).turned("z", theta, q).turned("y", phi, q)
    hub = Point(on_level_ground(X, Y, p["rho"]), frame, sp.zeros(3, 1))
    wheel = Body("wheel", frame, hub, p["m"], sp.diag(p["Jroll"], p["Jspin"], p["Jroll"]))
    T, V = sp.simplify(kinetic((wheel,), q, v)), sp.Integer(0)
    rolling = rows_only("rolling", [v[0] - p["rho"] * v[3] * sp.cos(theta), v[1] - p["rho"] * v[3] * sp.sin(theta)], v)
    return Model(
        id="rolling-wheel", title="the rolling wheel", q=q, v=v, parameters=tuple(p.values()),
        equations=from_lagrangian(T - V, q, v), kinetic=T, potential=V, bodies=(wheel,), constraints=(rolling,),
        notation=Notation("X Y θ φ m ρ J_roll J_spin g", {"wheel": "w"}, titles={"rolling": ("slip.x", "slip.y")}),
    )
