"""Equations of motion M(q) a = h(q, v) in two ways.

`from_lagrangian` is the textbook form (report Eq. 3): differentiate L. It is right and slow, and
serves small systems and as the check on the other.

`from_bodies` projects Newton and Euler's equations of each body with its Jacobians
(d'Alembert; for unconstrained coordinates the same equations term by term). Nothing is expanded:
M = sum(m J^T J + W^T I W), and h holds the accelerations that remain when a = 0.
"""

from dataclasses import dataclass

import sympy as sp


@dataclass(frozen=True)
class Equations:
    """M (n x n) and h (n x 1)."""

    M: sp.Matrix
    h: sp.Matrix


def along(expression, q: sp.Matrix, v: sp.Matrix):
    """Rate of an expression of q alone (or of q and v with v held) while q moves with v."""
    total = expression * 0
    for qi, vi in zip(q, v):
        total += expression.diff(qi) * vi
    return total


def from_lagrangian(L: sp.Expr, q: sp.Matrix, v: sp.Matrix) -> Equations:
    """d/dt dL/dv - dL/dq = 0 written as M a = h."""
    momentum = sp.Matrix([L]).jacobian(v).T
    M = momentum.jacobian(v)
    h = sp.Matrix([L]).jacobian(q).T - momentum.jacobian(q) * v
    return Equations(M, h)


def from_bodies(bodies, potential: sp.Expr, q: sp.Matrix, v: sp.Matrix) -> Equations:
    """M and h of free rigid bodies in a potential, from body Jacobians.

    Per body, with base Jacobian P (constant), carrier axes R, relative Jacobian W_s and body-axes
    angular velocity W q_dot:
        M += m (P^T P + P^T R W_s + W_s^T R^T P + W_s^T W_s) + W^T I W
        h -= m (P^T R + W_s^T) b + W^T (I beta + omega x I omega)
    where b = W_s' v + omega_carrier x (W_s v) and beta = W' v are the accelerations left at a = 0.
    Bodies that share base and carrier share the product with R, so it is taken once.
    """
    n = len(q)
    M, h = sp.zeros(n, n), sp.zeros(n, 1)
    carried = {}
    for body in bodies:
        point = body.centre
        P = point.base.jacobian(q)
        W_s = point.relative_jacobian(q)
        omega_c = point.carrier.W * v
        b = along(W_s * v, q, v) + omega_c.cross(W_s * v)
        M += body.mass * (P.T * P + W_s.T * W_s)
        h -= body.mass * (W_s.T * b)
        key = (sp.ImmutableMatrix(P), sp.ImmutableMatrix(point.carrier.R))
        moment, force = carried.get(key, (sp.zeros(3, n), sp.zeros(3, 1)))
        carried[key] = (moment + body.mass * W_s, force + body.mass * b)

        W = body.frame.W
        omega = W * v
        spin = body.inertia * omega
        M += W.T * body.inertia * W
        h -= W.T * (body.inertia * along(omega, q, v) + omega.cross(spin))
    for (P, R), (moment, force) in carried.items():
        coupling = P.T * (R * moment)
        M += coupling + coupling.T
        h -= P.T * (R * force)
    return Equations(M, h - sp.Matrix([potential]).jacobian(q).T)
