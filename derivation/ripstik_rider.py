"""The RipStik with a rider: a body hinged at the rod's centre, leaning by its own roll beta, that crouches and twists.

The hinge is the x axis of the pitched frame Rz(theta) Ry(psi), which the rod's roll does not turn, so that beta is the
rider's own roll and no plate's. Ankles are springs and dampers between each plate and the rider.

By `crouch` the centre of mass goes down along the body's axis, the moments of inertia about it kept; by `twist` the hips and all
above them turn about that axis against the feet, a rotor of `hipIzz` that is a part of `riderIzz`. The legs carry the body's
weight where crouch is 0, by a constant force beside their spring.
"""

import sympy as sp

from . import ripstik
from .energy import Body, Point
from .model import Model, coordinates
from .ripstik import COORDINATE_SYMBOLS, PARAMETER_SYMBOLS, SUBSCRIPTS, Board, Kind, alpha, alpha_bp, alpha_fp
from .within import Inner

q, v = coordinates("X Y Z alpha psi theta alpha_fp alpha_bp theta_fc theta_bc beta crouch twist")
beta, crouch, twist = q[10:]
CROUCH, TWIST = 11, 12

OWN = ("riderMass riderHeight riderIxx riderIyy riderIzz ankleStiffness ankleDamping hipIzz legStiffness legDamping hipStiffness "
       "hipDamping")
p = ripstik.p | {name: sp.Symbol(name, real=True) for name in OWN.split()}


def ridden(q: sp.Matrix, roll_front, roll_back) -> Board:
    board = ripstik.board(q, roll_front, roll_back)
    frame = board.pitched.turned("x", beta, q)
    hinge = Point.fixed(q[:3, 0], board.pitched, sp.zeros(3, 1))
    centre = hinge.moved(frame, sp.Matrix([0, 0, p["riderHeight"] - crouch]))
    lower = Body("rider", frame, centre, p["riderMass"], sp.diag(p["riderIxx"], p["riderIyy"], p["riderIzz"] - p["hipIzz"]))
    return board.carrying(lower).carrying(Body("torso", frame.turned("z", twist, q), centre, sp.Integer(0), sp.diag(0, 0, p["hipIzz"])))


def inner(described: Board) -> Inner:
    """Crouch and twist for the short way: the hips' inertia goes with the body where the twist is held."""
    flags = sp.symbols("held_crouch held_twist", real=True)
    lower = described.bodies[5]
    along = p["riderIzz"] - p["hipIzz"] * (1 - flags[1])
    body = Body(lower.name, lower.frame, lower.centre, lower.mass, sp.diag(p["riderIxx"], p["riderIyy"], along))
    return Inner(body, "z", (CROUCH, TWIST), flags, p["hipIzz"])


def springs():
    ankles = p["ankleStiffness"] * ((alpha + alpha_fp - beta)**2 + (alpha + alpha_bp - beta)**2) / 2
    legs = p["riderMass"] * p["gravity"] * crouch + p["legStiffness"] * crouch**2 / 2
    return ankles + legs + p["hipStiffness"] * twist**2 / 2


def passive() -> sp.Matrix:
    """Of each ankle: 1 on its plate's own roll (alpha and the plate's angle), -1 on beta; of legs and hips on their own."""
    force = sp.zeros(len(q), 1)
    for i in (6, 7):
        torque = -p["ankleStiffness"] * (alpha + q[i] - beta) - p["ankleDamping"] * (v[3] + v[i] - v[10])
        force[3] += torque
        force[i] += torque
        force[10] -= torque
    force[CROUCH] = -p["riderMass"] * p["gravity"] - p["legStiffness"] * crouch - p["legDamping"] * v[CROUCH]
    force[TWIST] = -p["hipStiffness"] * twist - p["hipDamping"] * v[TWIST]
    return force


def model() -> Model:
    return ripstik.modelled(Kind(
        "ripstik-rider", "the RipStik with a rider", q, v, tuple(p.values()),
        f"{COORDINATE_SYMBOLS} β κ ζ {PARAMETER_SYMBOLS} m_b h_b I_x I_y I_z k_a c_a I_h k_l c_l k_h c_h", ridden,
        ripstik.torsion_spring() + springs(), ripstik.springs_and_losses(q) + passive(), SUBSCRIPTS | {"rider": "b", "torso": "h"},
        inner))
