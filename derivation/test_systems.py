"""The small systems against what the report and the papers print, and against one another's ways of solving."""

import math
import random
import unittest

import sympy as sp

from . import cart_pendulum, caster_rotation, casterboard_robot, chaplygin_sleigh, rolling_wheel, stiff_decay, wheel_pendulum
from .test_derivation import number, values

MODULES = (cart_pendulum, caster_rotation, casterboard_robot, chaplygin_sleigh, rolling_wheel, stiff_decay, wheel_pendulum)


class Lagrangians(unittest.TestCase):
    def test_bodies_have_the_reports_lagrangian(self):
        for module in (cart_pendulum, rolling_wheel, wheel_pendulum):
            model = module.model()
            self.assertEqual(sp.simplify(model.kinetic - model.potential - module.printed_lagrangian()), 0, model.id)

    def test_robot_is_the_same_in_every_direction(self):
        model = casterboard_robot.model()
        for M_ij in model.equations.M:
            self.assertNotIn("2*theta", str(sp.simplify(M_ij)))
        self.assertEqual(sp.simplify(model.kinetic.diff(model.q[0])), 0)

    def test_robots_rows_are_the_velocities_of_its_wheels_along_their_axles(self):
        model = casterboard_robot.model()
        at = values(list(model.q) + list(model.v) + list(model.parameters), 5)
        rows = model.constraints[0].Omega * model.v
        for row, wheel in zip(rows, model.bodies[3:]):
            axle = wheel.frame.R * sp.Matrix([0, 1, 0])
            velocity = axle.dot(wheel.centre.jacobian(model.q) * model.v)
            self.assertLess(abs(number(row + velocity, at)), 1e-20)

    def test_mass_matrices_are_symmetric_and_momenta_linear(self):
        for module in MODULES:
            model = module.model()
            self.assertEqual(sp.simplify(model.equations.M - model.equations.M.T), sp.zeros(len(model.q), len(model.q)), model.id)
            self.assertEqual(sp.simplify(sp.hessian(model.kinetic, list(model.v)) - model.equations.M)
                             if model.rate is None else sp.zeros(1), sp.zeros(len(model.q), len(model.q)), model.id)


class Multipliers(unittest.TestCase):
    """Three ways of the report's section 3.4, on its own example: the rolling wheel."""

    def setUp(self):
        self.model = rolling_wheel.model()
        rows = self.model.constraints[0]
        self.Omega, self.gamma = rows.Omega, rows.rate(self.model.q, self.model.v)
        torque = sp.symbols("tau_theta tau_phi", real=True)
        self.torque = torque
        self.h = self.model.equations.h + sp.Matrix([0, 0, *torque])

    def by_inverse(self):
        """Eq. 20: Omega a = Omega G^-1 (h + Omega^T lambda) = -gamma."""
        inverse = self.model.equations.M.inv()
        S = self.Omega * inverse * self.Omega.T
        return sp.simplify(S.inv() * (-self.gamma - self.Omega * inverse * self.h))

    def by_linear_system(self):
        """A x = b for accelerations and multipliers at once."""
        m, n = self.Omega.shape
        A = sp.Matrix(sp.BlockMatrix([[self.model.equations.M, -self.Omega.T], [self.Omega, sp.zeros(m, m)]]))
        x = A.LUsolve(sp.Matrix([*self.h, *(-self.gamma)]))
        return sp.simplify(sp.Matrix(x[n:]))

    def at_numbers(self, state, parameters, torque):
        """The same system in floating point, by elimination with pivots; [accelerations, multipliers]."""
        p = dict(zip(self.model.parameters, parameters))
        m, rho, Jroll, Jspin = (p[rolling_wheel.p[name]] for name in ("m", "rho", "Jroll", "Jspin"))
        _, _, theta, _, _, _, theta_dot, phi_dot = state
        c, s = rho * math.cos(theta), rho * math.sin(theta)
        A = [[m, 0, 0, 0, -1, 0], [0, m, 0, 0, 0, -1], [0, 0, Jroll, 0, 0, 0], [0, 0, 0, Jspin, c, s],
             [1, 0, 0, -c, 0, 0], [0, 1, 0, -s, 0, 0]]
        return eliminate(A, [0, 0, torque[0], torque[1], -s * theta_dot * phi_dot, c * theta_dot * phi_dot])

    def test_three_ways_agree(self):
        inverse, linear = self.by_inverse(), self.by_linear_system()
        self.assertEqual(sp.simplify(inverse - linear), sp.zeros(2, 1))
        draw = random.Random(3)
        for _ in range(10):
            state = [draw.uniform(-2, 2) for _ in range(8)]
            parameters = [draw.uniform(0.3, 2) for _ in self.model.parameters]
            torque = [draw.uniform(-3, 3) for _ in range(2)]
            at = dict(zip([*self.model.q, *self.model.v], state)) | dict(zip(self.model.parameters, parameters)) | dict(zip(self.torque, torque))
            numeric = self.at_numbers(state, parameters, torque)[4:]
            for symbolic, computed in zip(inverse, numeric):
                self.assertLess(abs(float(symbolic.subs(at)) - computed), 1e-12)

    def test_integrating_the_numeric_way_rolls_the_circle_and_shows_its_forces(self):
        """Eq. 5 and 6 left as they are and integrated (Runge-Kutta 4): X, Y and multipliers as in closed form."""
        ones = [1.0] * len(self.model.parameters)
        start, spin, turn = 1.2, 3.0, 1.0
        state = [0, 0, start, 0, spin * math.cos(start), spin * math.sin(start), turn, spin]
        steps, duration = 4000, 5.0
        for _ in range(steps):
            state = runge_kutta(lambda y: [*y[4:], *self.at_numbers(y, ones, (0, 0))[:4]], state, duration / steps)
        radius, theta = spin / turn, start + turn * duration
        self.assertLess(abs(state[0] - radius * (math.sin(theta) - math.sin(start))), 1e-9)
        self.assertLess(abs(state[1] + radius * (math.cos(theta) - math.cos(start))), 1e-9)
        for force, direction in zip(self.at_numbers(state, ones, (0, 0))[4:], (-math.sin(theta), math.cos(theta))):
            self.assertLess(abs(force - spin * turn * direction), 1e-9)


class Sleigh(unittest.TestCase):
    def test_reduced_equations(self):
        """With forward speed u and turning rate w: u' = a w^2, (I + m a^2) w' = -m a u w."""
        model = chaplygin_sleigh.model()
        mass, a, inertia, _ = model.parameters
        u, w, F = sp.symbols("u w lambda1", real=True)
        theta = model.q[2]
        moving = {model.v[0]: u * sp.cos(theta), model.v[1]: u * sp.sin(theta), model.v[2]: w}
        u_dot, w_dot = a * w**2, -mass * a * u * w / (inertia + mass * a**2)
        acceleration = sp.Matrix([u_dot * sp.cos(theta) - u * w * sp.sin(theta), u_dot * sp.sin(theta) + u * w * sp.cos(theta), w_dot])
        left = (model.equations.M * acceleration - model.equations.h - model.constraints[0].Omega.T * F).subs(moving)
        force = sp.solve(sp.simplify(left[1]), F)[0]
        self.assertEqual(sp.simplify(left.subs(F, force)), sp.zeros(3, 1))


def eliminate(A, b):
    """x of A x = b, by Gauss's elimination with row pivots."""
    rows = [[*row, right] for row, right in zip(A, b)]
    n = len(rows)
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(n):
            if i != k:
                factor = rows[i][k] / rows[k][k]
                rows[i] = [x - factor * y for x, y in zip(rows[i], rows[k])]
    return [row[n] / row[k] for k, row in enumerate(rows)]


def runge_kutta(f, y, h):
    """One step of the classical method of order 4."""
    k1 = f(y)
    k2 = f([a + h / 2 * b for a, b in zip(y, k1)])
    k3 = f([a + h / 2 * b for a, b in zip(y, k2)])
    k4 = f([a + h * b for a, b in zip(y, k3)])
    return [a + h / 6 * (p + 2 * q + 2 * r + s) for a, p, q, r, s in zip(y, k1, k2, k3, k4)]


if __name__ == "__main__":
    unittest.main()
