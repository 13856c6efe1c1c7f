"""The Chaplygin sleigh: a rigid body on a blade that does not slip sideways, its centre of mass `a` ahead of the blade."""

import sympy as sp

from .constraints import rows_only
from .energy import Body, Point, kinetic
from .euler_lagrange import from_lagrangian
from .model import Model, coordinates, on_level_ground
from .notation import Notation
from .rotations import Frame

q, v = coordinates("x y theta")
x, y, theta = q
p = {name: sp.Symbol(name, real=True) for name in "mass a inertia gravity".split()}


def model() -> Model:
    frame = Frame.world(q).turned("z", theta, q)
    blade = Point.fixed(on_level_ground(x, y), frame, sp.zeros(3, 1))
    body = Body("sleigh", frame, blade.moved(frame, sp.Matrix([p["a"], 0, 0])), p["mass"], sp.diag(0, 0, p["inertia"]))
    T, V = sp.simplify(kinetic((body,), q, v)), sp.Integer(0)
    return Model(
        id="chaplygin-sleigh", title="the Chaplygin sleigh", q=q, v=v, parameters=tuple(p.values()),
        equations=from_lagrangian(T - V, q, v), kinetic=T, potential=V,
        bodies=(Body("sleigh", frame, blade, body.mass, body.inertia),),
        constraints=(rows_only("rolling", [sp.cos(theta) * v[1] - sp.sin(theta) * v[0]], v),),
        notation=Notation("x y θ m a I g", {"sleigh": "s"}, masses=(body,), titles={"rolling": ("lateral",)}),
    )
