"""Bodies, their points, and kinetic and potential energy (report Eq. 11, 12, 15, 16)."""

from dataclasses import dataclass

import sympy as sp

from .rotations import Frame


@dataclass(frozen=True)
class Point:
    """A point base + carrier.R * offset; the base is linear in q, the offset in carrier axes.

    `arms` are the pieces that the offset is made of, each (frame, offset fixed in it), outwards from the carrier.
    """

    base: sp.Matrix
    carrier: Frame
    offset: sp.Matrix
    arms: tuple = ()

    @staticmethod
    def fixed(base: sp.Matrix, carrier: Frame, offset: sp.Matrix) -> "Point":
        """A point at a constant offset in its carrier."""
        return Point(base, carrier, offset, ((carrier, offset),))

    def position(self) -> sp.Matrix:
        return self.base + self.carrier.R * self.offset

    def relative_jacobian(self, q: sp.Matrix) -> sp.Matrix:
        """W_s with (velocity relative to the base) = R W_s q_dot, in carrier axes (3 x n)."""
        W = self.offset.jacobian(q)
        for k in range(len(q)):
            W[:, k] += self.carrier.W[:, k].cross(self.offset)
        return W

    def jacobian(self, q: sp.Matrix) -> sp.Matrix:
        """d(position)/dq in world axes (3 x n)."""
        return self.base.jacobian(q) + self.carrier.R * self.relative_jacobian(q)

    def moved(self, frame: Frame, offset: sp.Matrix) -> "Point":
        """Another point of the same carrier, further by a constant `offset` in a frame turned from the carrier."""
        step = frame.relative_to(self.carrier) * offset
        return Point(self.base, self.carrier, self.offset + step, (*self.arms, (frame, offset)))


@dataclass(frozen=True)
class Body:
    """A rigid body: mass, principal inertia about its centre in the axes of `frame`, centre."""

    name: str
    frame: Frame
    centre: Point
    mass: sp.Expr
    inertia: sp.Matrix  # 3 x 3


def kinetic(bodies, q: sp.Matrix, v: sp.Matrix) -> sp.Expr:
    """Sum of 1/2 m |r_dot|^2 + 1/2 omega^T I omega."""
    total = sp.Integer(0)
    for body in bodies:
        r_dot = body.centre.jacobian(q) * v
        omega = body.frame.W * v
        total += body.mass * r_dot.dot(r_dot) / 2 + omega.dot(body.inertia * omega) / 2
    return total


def potential(bodies, gravity: sp.Expr) -> sp.Expr:
    """Sum of m g z, z up."""
    return sum((body.mass * gravity * body.centre.position()[2] for body in bodies), sp.Integer(0))
