"""One caster of the board, turned about its tilted steering axis; its pivot is the world's origin (report 3.2.1)."""

import sympy as sp

from .energy import Body, Point, kinetic, potential
from .euler_lagrange import from_lagrangian
from .model import Model, coordinates
from .notation import Notation
from .ripstik import disc_about_y
from .rotations import Frame

q, v = coordinates("theta_c")
PARAMETERS = "casterAngle casterTrail casterDrop casterMass wheelRadius gravity"
p = {name: sp.Symbol(name, real=True) for name in PARAMETERS.split()}


def model() -> Model:
    frame = Frame.world(q).turned("y", p["casterAngle"], q).turned("z", q[0], q)
    skate = Point(sp.zeros(3, 1), frame, sp.Matrix([-p["casterTrail"], 0, -p["casterDrop"]]))
    caster = Body("caster", frame, skate, p["casterMass"], disc_about_y(p["casterMass"], p["wheelRadius"]))
    T, V = sp.simplify(kinetic((caster,), q, v)), potential((caster,), p["gravity"])
    return Model(
        id="caster-rotation", title="the turned caster", q=q, v=v, parameters=tuple(p.values()),
        equations=from_lagrangian(T - V, q, v), kinetic=T, potential=V, bodies=(caster,),
        notation=Notation("θ_c φ c d_c m_c R_w g", {"caster": "c"}),
    )
