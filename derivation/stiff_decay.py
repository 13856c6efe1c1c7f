"""The stiff example of the report's Fig. 13: y' = -rate y, of first order, with its exact solution exp(-rate t)."""

import sympy as sp

from .energy import Body, Point
from .model import Model, coordinates, of_first_order, on_level_ground
from .notation import Notation
from .rotations import Frame

q, v = coordinates("y")
rate = sp.Symbol("rate", real=True)


def model() -> Model:
    f = sp.Matrix([-rate * q[0]])
    marker = Body("marker", Frame.world(q), Point(on_level_ground(0, 0, q[0]), Frame.world(q), sp.zeros(3, 1)),
                  sp.Integer(0), sp.zeros(3, 3))
    return Model(
        id="stiff-decay", title="the stiff decay", q=q, v=v, parameters=(rate,), equations=of_first_order(f, q, v),
        kinetic=sp.Integer(0), potential=sp.Integer(0), bodies=(marker,), rate=f,
        notation=Notation("y k", {"marker": ""}),
    )
