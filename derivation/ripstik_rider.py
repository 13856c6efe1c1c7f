"""The RipStik with a rider: one rigid body hinged at the rod's centre, leaning by its own roll beta.

The hinge is the x axis of the pitched frame Rz(theta) Ry(psi), which the rod's roll does not turn, so that beta is the
rider's own roll and no plate's. Ankles are springs and dampers between each plate and the rider.
"""

import sympy as sp

from . import ripstik
from .energy import Body, Point
from .model import Model, coordinates
from .ripstik import COORDINATE_SYMBOLS, PARAMETER_SYMBOLS, SUBSCRIPTS, Board, Kind, alpha, alpha_bp, alpha_fp

q, v = coordinates("X Y Z alpha psi theta alpha_fp alpha_bp theta_fc theta_bc beta")
beta = q[10]

p = ripstik.p | {name: sp.Symbol(name, real=True)
                 for name in "riderMass riderHeight riderIxx riderIyy riderIzz ankleStiffness ankleDamping".split()}


def ridden(q: sp.Matrix, roll_front, roll_back) -> Board:
    board = ripstik.board(q, roll_front, roll_back)
    frame = board.pitched.turned("x", beta, q)
    hinge = Point.fixed(q[:3, 0], board.pitched, sp.zeros(3, 1))
    centre = hinge.moved(frame, sp.Matrix([0, 0, p["riderHeight"]]))
    return board.carrying(Body("rider", frame, centre, p["riderMass"], sp.diag(p["riderIxx"], p["riderIyy"], p["riderIzz"])))


def ankle_springs():
    return p["ankleStiffness"] * ((alpha + alpha_fp - beta)**2 + (alpha + alpha_bp - beta)**2) / 2


def ankles() -> sp.Matrix:
    """Passive torque of each ankle: 1 on its plate's own roll (alpha and the plate's angle), -1 on beta."""
    force = sp.zeros(len(q), 1)
    for i in (6, 7):
        torque = -p["ankleStiffness"] * (alpha + q[i] - beta) - p["ankleDamping"] * (v[3] + v[i] - v[10])
        force[3] += torque
        force[i] += torque
        force[10] -= torque
    return force


def model() -> Model:
    return ripstik.modelled(Kind(
        "ripstik-rider", "the RipStik with a rider", q, v, tuple(p.values()),
        f"{COORDINATE_SYMBOLS} β {PARAMETER_SYMBOLS} m_b h_b I_x I_y I_z k_a c_a", ridden,
        ripstik.torsion_spring() + ankle_springs(), ripstik.springs_and_losses(q) + ankles(), SUBSCRIPTS | {"rider": "b"}))
