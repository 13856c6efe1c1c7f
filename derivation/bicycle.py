"""The Whipple bicycle: two knife-edge wheels, a rear frame with a rigid rider, a front frame, on level ground.

Parameters are those of Meijaard, Papadopoulos, Ruina and Schwab, "Linearized dynamics equations for the balance and
steer of a bicycle: a benchmark and review", Proc. R. Soc. A 463 (2007), Table 1, in that paper's axes (x forward,
y to the right, z down, origin at the rear contact of the upright bicycle). They are turned into this program's axes (x
forward, y to the left, z up) here, at the door: y and z change sign, and with them the products of inertia I_xz.
"""

import sympy as sp

from . import recursion
from .constraints import Constraints
from .energy import Body, Point, kinetic, potential
from .euler_lagrange import Equations
from .model import Model, coordinates, on_level_ground
from .recursion import Names, Tree
from .rotations import Frame, rotation

q, v = coordinates("x y yaw roll pitch steer rear_spin front_spin")
x, y, yaw, roll, pitch, steer, rear_spin, front_spin = q

PARAMETERS = (
    "wheelbase trail steerAxisTilt gravity "
    "rearRadius rearMass rearIxx rearIyy "
    "frameX frameZ frameMass frameIxx frameIyy frameIzz frameIxz "
    "forkX forkZ forkMass forkIxx forkIyy forkIzz forkIxz "
    "frontRadius frontMass frontIxx frontIyy"
)
p = {name: sp.Symbol(name, real=True) for name in PARAMETERS.split()}

EX, EY, EZ = (sp.Matrix(e) for e in ([1, 0, 0], [0, 1, 0], [0, 0, 1]))


def inertia_up(name: str) -> sp.Matrix:
    """Inertia given with z down, about axes with z up: only I_xz changes sign."""
    xx, yy, zz, xz = (p[f"{name}I{axes}"] for axes in ("xx", "yy", "zz", "xz"))
    return sp.Matrix([[xx, 0, -xz], [0, yy, 0], [-xz, 0, zz]])


def disc(name: str) -> sp.Matrix:
    return sp.diag(p[f"{name}Ixx"], p[f"{name}Iyy"], p[f"{name}Ixx"])


class Bicycle:
    """Frames and bodies. Lean and steer to the right are positive, a wheel that rolls forward spins positively."""

    def __init__(self):
        self.heading = Frame.world(q).turned("z", yaw, q)
        self.leaned = self.heading.turned("x", roll, q)
        self.frame = self.leaned.turned("y", pitch, q)
        tilted = self.frame.turned("y", -p["steerAxisTilt"], q)
        self.fork = tilted.turned("z", -steer, q)
        self.rear_wheel = self.frame.turned("y", rear_spin, q)
        self.front_wheel = self.fork.turned("y", front_spin, q)

        contact = Point.fixed(on_level_ground(x, y), self.heading, sp.zeros(3, 1))
        self.rear_hub = contact.moved(self.leaned, sp.Matrix([0, 0, p["rearRadius"]]))
        # Where the steering axis meets the ground, under the upright bicycle; it belongs to both frames.
        on_axis = self.rear_hub.moved(self.frame, sp.Matrix([p["wheelbase"] + p["trail"], 0, -p["rearRadius"]]))
        self.front_hub = on_axis.moved(self.fork, self.in_fork([-p["trail"], 0, p["frontRadius"]]))
        frame_centre = self.rear_hub.moved(self.frame, sp.Matrix([p["frameX"], 0, -p["frameZ"] - p["rearRadius"]]))
        fork_centre = on_axis.moved(self.fork, self.in_fork([p["forkX"] - p["wheelbase"] - p["trail"], 0, -p["forkZ"]]))

        turn = rotation("y", p["steerAxisTilt"])
        self.bodies = (
            Body("rear-wheel", self.rear_wheel, self.rear_hub, p["rearMass"], disc("rear")),
            Body("rear-frame", self.frame, frame_centre, p["frameMass"], inertia_up("frame")),
            Body("front-frame", self.fork, fork_centre, p["forkMass"], turn * inertia_up("fork") * turn.T),
            Body("front-wheel", self.front_wheel, self.front_hub, p["frontMass"], disc("front")),
        )

    @staticmethod
    def in_fork(offset) -> sp.Matrix:
        """An offset given in the axes of the upright bicycle, in those of the fork."""
        return rotation("y", p["steerAxisTilt"]) * sp.Matrix(offset)

    def shown(self):
        """Frames that are drawn: the front frame's axes are those of the upright bicycle at zero steer, its origin the hub."""
        upright_fork = self.fork.turned("y", p["steerAxisTilt"], q)
        places = ((self.rear_wheel, self.rear_hub), (self.frame, self.rear_hub), (upright_fork, self.front_hub), (self.front_wheel, self.front_hub))
        return tuple(Body(b.name, frame, point, b.mass, b.inertia) for b, (frame, point) in zip(self.bodies, places))


def contact_of(hub: Point, axes: Frame, spin_rate_column: sp.Matrix, radius, heading: Frame):
    """(J, heading of the wheel, height) of the material point at a wheel's lowest point, in heading axes.

    J (3 x n): its velocity relative to the base. `axes` carry the wheel without its spin, axle along y.
    """
    to_heading = axes.relative_to(heading)
    axle = to_heading * EY
    level = sp.sqrt(1 - axle[2] ** 2)
    down = -(EZ - axle[2] * axle) / level * radius
    W = to_heading * axes.W + axle * spin_rate_column
    J = hub.relative_jacobian(q)
    for k in range(len(q)):
        J[:, k] += W[:, k].cross(down)
    forward = sp.Matrix([axle[1], -axle[0], 0]) / level
    return J, forward, hub.position()[2] - radius * level


def rows_of(J, base, forward):
    """Rows: no slip along the wheel's heading, none across it. Directions in heading axes."""
    across = EZ.cross(forward)
    return [direction.T * (base + J) for direction in (forward, across)]


def unit_row(symbol) -> sp.Matrix:
    return sp.Matrix([symbol]).jacobian(q)


def rolling(b: Bicycle) -> Constraints:
    """Four nonholonomic rows, rear then front, along and across; then the height of the front contact."""
    base = b.heading.R.T * b.rear_hub.base.jacobian(q)
    rear, _, _ = contact_of(b.rear_hub, b.frame, unit_row(rear_spin), p["rearRadius"], b.heading)
    front, front_forward, height = contact_of(b.front_hub, b.fork, unit_row(front_spin), p["frontRadius"], b.heading)
    rows = [*rows_of(rear, base, EX), *rows_of(front, base, front_forward), sp.Matrix([height]).jacobian(q)]
    return Constraints("rolling", sp.Matrix.vstack(*rows), sp.Matrix([height]), (4,))


def model() -> Model:
    b = Bicycle()
    names = Names()
    free = recursion.equations(Tree(q, v, names), b.bodies, p["gravity"])
    return Model(
        id="bicycle", title="the Whipple bicycle", q=q, v=v, parameters=tuple(p.values()),
        equations=Equations(free.M, free.h), kinetic=kinetic(b.bodies, q, v), potential=potential(b.bodies, p["gravity"]),
        bodies=b.shown(), constraints=(rolling(b),), definitions=tuple(names.definitions),
    )
