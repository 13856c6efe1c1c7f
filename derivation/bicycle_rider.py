"""The Whipple bicycle with a rider whose upper body leans: one more rigid body, hinged to the rear frame.

The hinge is a fore-and-aft axis, level while the bicycle is upright, at the height of the saddle above the rear contact: the
leaning rider of J. K. Moore, "Human control of a bicycle", dissertation, University of California, Davis, 2012, chapter
"Extensions of the Whipple model". What does not lean (frame, legs) is the rear frame; parameters as in `bicycle.py`, with
z down, and turned at the same door.
"""

import sympy as sp

from . import bicycle
from .bicycle import COORDINATE_SYMBOLS, PARAMETER_SYMBOLS, SUBSCRIPTS, Bicycle
from .energy import Body
from .model import Model, coordinates

q, v = coordinates("x y yaw roll pitch steer rear_spin front_spin lean")
lean, lean_rate = q[8], v[8]

OWN = "hingeZ riderX riderZ riderMass riderIxx riderIyy riderIzz riderIxz leanStiffness leanDamping"
own = {name: sp.Symbol(name, real=True) for name in OWN.split()}


class Ridden(Bicycle):
    def __init__(self):
        super().__init__(q, v)
        self.rider = self.frame.turned("x", lean, q)
        # On the rear hub's vertical: where along its axis a hinge is makes no difference.
        self.hinge = self.rear_hub.moved(self.frame, sp.Matrix([0, 0, -own["hingeZ"] - bicycle.p["rearRadius"]]))
        centre = self.hinge.moved(self.rider, sp.Matrix([own["riderX"], 0, own["hingeZ"] - own["riderZ"]]))
        xx, yy, zz, xz = (own[f"riderI{axes}"] for axes in ("xx", "yy", "zz", "xz"))
        inertia = sp.Matrix([[xx, 0, -xz], [0, yy, 0], [-xz, 0, zz]])
        self.bodies = (*self.bodies, Body("rider", self.rider, centre, own["riderMass"], inertia))

    def shown(self):
        """The rider is drawn from the hinge."""
        body = self.bodies[4]
        return (*super().shown(), Body(body.name, self.rider, self.hinge, body.mass, body.inertia))


def model() -> Model:
    losses = sp.zeros(len(q), 1)
    losses[8] = -own["leanDamping"] * lean_rate
    return bicycle.modelled(
        "bicycle-rider", "the bicycle with a leaning rider", Ridden(), (*bicycle.p.values(), *own.values()),
        f"{COORDINATE_SYMBOLS} β {PARAMETER_SYMBOLS} z_S x_G z_G m_G I_Gxx I_Gyy I_Gzz I_Gxz k_s c_s", SUBSCRIPTS | {"rider": "G"},
        own["leanStiffness"] * lean**2 / 2, losses)
