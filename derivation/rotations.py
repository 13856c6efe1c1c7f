"""Elementary rotations and frames that turn on one another.

A frame keeps its rotation matrix R (own axes to world) and the Jacobian W of its angular
velocity in its own axes, omega = W q_dot. Turning a frame about one of its axes by an angle
that depends on q adds one column pattern to W; no trigonometric identity is ever needed,
which is what keeps the later expressions short.
"""

from dataclasses import dataclass

import sympy as sp

AXES = {"x": sp.Matrix([1, 0, 0]), "y": sp.Matrix([0, 1, 0]), "z": sp.Matrix([0, 0, 1])}


def rotation(axis: str, angle: sp.Expr) -> sp.Matrix:
    """Active rotation matrix by `angle` about the named axis."""
    c, s = sp.cos(angle), sp.sin(angle)
    if axis == "x":
        return sp.Matrix([[1, 0, 0], [0, c, -s], [0, s, c]])
    if axis == "y":
        return sp.Matrix([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    return sp.Matrix([[c, -s, 0], [s, c, 0], [0, 0, 1]])


@dataclass(frozen=True)
class Frame:
    """Axes fixed in a body: `R` own axes to world, `W` with omega = W q_dot in own axes (3 x n).

    `parent`, `axis` and `angle` tell how it was turned; the world has none.
    """

    R: sp.Matrix
    W: sp.Matrix
    parent: "Frame | None" = None
    axis: str | None = None
    angle: sp.Expr | None = None

    @staticmethod
    def world(q: sp.Matrix) -> "Frame":
        return Frame(sp.eye(3), sp.zeros(3, len(q)))

    def turned(self, axis: str, angle: sp.Expr, q: sp.Matrix) -> "Frame":
        """This frame turned about its own axis by an angle that may depend on q."""
        step = rotation(axis, angle)
        own = AXES[axis] * sp.Matrix([angle]).jacobian(q)
        return Frame(self.R * step, step.T * self.W + own, self, axis, angle)

    def relative_to(self, other: "Frame") -> sp.Matrix:
        """Own axes to those of a frame that this one was turned from."""
        if self is other:
            return sp.eye(3)
        return self.parent.relative_to(other) * rotation(self.axis, self.angle)
