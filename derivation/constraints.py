"""Velocity constraints Omega(q) v = 0 and what follows from them."""

from dataclasses import dataclass

import sympy as sp

from .euler_lagrange import along


@dataclass(frozen=True)
class Constraints:
    """Rows of Omega (m x n), heights kept at zero (k x 1) and the rows of Omega that are their gradients."""

    id: str
    Omega: sp.Matrix
    heights: sp.Matrix
    height_rows: tuple
    # Omega_dot v (m x 1) where it was derived with Omega; else it is found by differentiation.
    gamma: sp.Matrix | None = None

    def rate(self, q: sp.Matrix, v: sp.Matrix) -> sp.Matrix:
        """gamma = Omega_dot v, so that Omega a + gamma = 0."""
        return along(self.Omega * v, q, v) if self.gamma is None else self.gamma


def velocity_row(direction: sp.Matrix, point, q: sp.Matrix) -> sp.Matrix:
    """Row of Omega for `direction . v_point = 0`, direction in the point's carrier axes."""
    base = (point.carrier.R * direction).T * point.base.jacobian(q)
    return base + direction.T * point.relative_jacobian(q)


def rows_only(id: str, rows, v: sp.Matrix) -> Constraints:
    """Constraints given by their velocity expressions, linear in v, without contact heights."""
    return Constraints(id, sp.Matrix(rows).jacobian(v), sp.Matrix([]), ())
