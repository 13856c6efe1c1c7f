"""The derivation's own tests: the short way against the definitions, at seeded random points."""

import random
import unittest

import mpmath
import sympy as sp

from . import ripstik
from .angular_velocity import body_angular_velocity, hat, vee
from .energy import potential
from .euler_lagrange import along, from_bodies, from_lagrangian
from .recorder import Recorder
from .rotations import Frame, rotation
from .sharing import FEWEST_OPERATIONS, Unit, share
from .tape import Tape


def values(symbols, seed):
    draw = random.Random(seed)
    return {s: mpmath.mpf(draw.uniform(0.2, 1.1)) for s in symbols}


def point(model, seed):
    """A seeded state and parameters, and every named intermediate result there."""
    at = values(list(model.q) + list(model.v) + list(model.parameters), seed)
    for symbol, expression in model.definitions:
        at[symbol] = number(expression, at)
    return at


def number(expression, at):
    """Value at a point, to some 25 digits."""
    symbols = sorted(sp.sympify(expression).free_symbols, key=lambda s: s.name)
    with mpmath.workdps(30):
        return sp.Float(sp.lambdify(symbols, expression, "mpmath", cse=True)(*(mpmath.mpf(at[s]) for s in symbols)), 30)


class Rotations(unittest.TestCase):
    def test_frames_compose_to_the_definition_of_angular_velocity(self):
        q = sp.Matrix(sp.symbols("a b c"))
        v = sp.Matrix(sp.symbols("a_dot b_dot c_dot"))
        frame = Frame.world(q).turned("z", q[0], q).turned("y", q[1], q).turned("x", q[2] + q[0], q)
        by_definition = body_angular_velocity(frame.R, q, v)
        at = values(list(q) + list(v), 1)
        for i in range(3):
            self.assertLess(abs(number((frame.W * v)[i] - by_definition[i], at)), 1e-20)

    def test_attitude_is_yaw_pitch_roll(self):
        yaw, pitch, roll = sp.symbols("yaw pitch roll")
        q = sp.Matrix([yaw, pitch, roll])
        frame = Frame.world(q).turned("z", yaw, q).turned("y", pitch, q).turned("x", roll, q)
        product = rotation("z", yaw) * rotation("y", pitch) * rotation("x", roll)
        self.assertEqual(sp.simplify(frame.R - product), sp.zeros(3, 3))

    def test_vee_undoes_hat(self):
        w = sp.Matrix(sp.symbols("w1:4"))
        self.assertEqual(vee(hat(w)), w)


class EulerLagrange(unittest.TestCase):
    def test_cart_pendulum_has_the_reports_equations(self):
        X, th, Xd, thd = sp.symbols("X theta X_dot theta_dot")
        m1, m2, L, g = sp.symbols("m1 m2 L g")
        lagrangian = m1 * Xd**2 / 2 + m2 / 2 * (
            2 * g * L * sp.sin(th) + 2 * L**2 * thd**2 - 2 * L * sp.sin(th) * thd * Xd + Xd**2)
        e = from_lagrangian(lagrangian, sp.Matrix([X, th]), sp.Matrix([Xd, thd]))
        Xdd, thdd = sp.symbols("X_ddot theta_ddot")
        left = e.M * sp.Matrix([Xdd, thdd]) - e.h
        # Eq. 18 and 19, which the report writes with the other sign.
        eq18 = L * m2 * sp.cos(th) * thd**2 + L * m2 * sp.sin(th) * thdd - (m1 + m2) * Xdd
        eq19 = L * m2 * (g * sp.cos(th) - 2 * L * thdd + sp.sin(th) * Xdd)
        self.assertEqual(sp.simplify(left[0] + eq18), 0)
        self.assertEqual(sp.simplify(left[1] + eq19), 0)

    def test_board_by_recursion_is_board_from_lagrangian(self):
        """Differentiates L along exact numbers: d/dt dL/dv - dL/dq without expanding L."""
        model = ripstik.model()
        q, v = model.q, model.v
        at = point(model, 7)
        at |= {ripstik.p[name]: 0 for name in ("torsionDamping", "jointDamping", "casterDamping")}
        L = model.kinetic - model.potential
        for i in (3, 4, 6, 8):
            momentum = L.diff(v[i])
            M_row = [number(momentum.diff(v[j]), at) for j in range(10)]
            for j in range(10):
                self.assertLess(abs(M_row[j] - number(model.equations.M[i, j], at)), 1e-15)
            h = number(L.diff(q[i]), at) - number(along(momentum, q, v), at)
            self.assertLess(abs(h - number(model.equations.h[i], at)), 1e-13)

    def test_from_bodies_is_the_recursion(self):
        model = ripstik.model()
        at = point(model, 8)
        at |= {ripstik.p[name]: 0 for name in ("torsionStiffness", "torsionDamping", "jointDamping", "casterDamping")}
        V = potential(model.bodies, ripstik.p["gravity"])
        equations = from_bodies(model.bodies, V, model.q, model.v)
        for i in range(10):
            self.assertLess(abs(number(equations.h[i] - model.equations.h[i], at)), 1e-13)
            for j in range(10):
                self.assertLess(abs(number(equations.M[i, j] - model.equations.M[i, j], at)), 1e-15)


class Tapes(unittest.TestCase):
    def taped(self, symbols, expressions):
        tape = Tape()
        return tape, Recorder(tape, {"q": symbols}).all(expressions)

    def test_a_recorded_expression_keeps_its_value(self):
        x, y, z = symbols = sp.symbols("x y z")
        printed = {"powers": (x - y) ** 3 / (2 * z**2) + z**sp.Rational(3, 2) - sp.Rational(1, 3), "angles": sp.atan(sp.tan(x) * sp.sin(y)) * -sp.cos(x - y),
                   "signs": -(x - y) * (y - x) - (-z), "nothing": x * 0 + (y - y)}
        tape, outputs = self.taped(symbols, printed)
        at = values(symbols, 4)
        with mpmath.workdps(30):
            numbers = tape.evaluate(outputs, {"q": [at[s] for s in symbols]}, mpmath)
        self.assertNotIn("nothing", numbers)
        for name, value in numbers.items():
            self.assertLess(abs(value - number(printed[name], at)), 1e-15, name)

    def test_nothing_is_written_twice(self):
        x, y = symbols = sp.symbols("x y")
        tape, outputs = self.taped(symbols, {0: sp.sin(x * y), 1: 2 + sp.sin(y * x), 2: x - y, 3: y - x})
        kinds = [tape.ops[i][0] for i in tape.reached(outputs.values())]
        self.assertEqual([kinds.count(kind) for kind in ("mul", "sin", "sub", "neg")], [1, 1, 1, 1])

    def test_forward_differentiation_is_exact(self):
        x, y = symbols = sp.symbols("x y")
        f = sp.sin(x * y) / (1 + x**2) + sp.sqrt(1 + y**2) * sp.sin(x * y) + sp.atan(sp.tan(x) - sp.cos(x) / y)
        tape, outputs = self.taped(symbols, {"f": f})
        derived = tape.differentiate(outputs, {k: tape.input("q", k) for k in range(2)})
        at = values(symbols, 3)
        with mpmath.workdps(30):
            numbers = tape.evaluate(derived, {"q": [at[s] for s in symbols]}, mpmath)
        for k, symbol in enumerate(symbols):
            self.assertLess(abs(numbers["f", k] - number(f.diff(symbol), at)), 1e-20)

    def test_wheel_drag_by_recursion_is_the_printed_one(self):
        model = ripstik.model()
        at = point(model, 12)
        described = ripstik.board(model.q, model.q[3] + model.q[6], model.q[3] + model.q[7])
        skates = [(place, frame.relative_to(described.pitched) * ripstik.AXLE) for place, frame in described.skates]
        for ours, printed in zip(model.extra_forces[0][1], ripstik.wheel_drag(skates, described.pitched, model.q, model.v)):
            self.assertLess(abs(number(ours, at) - number(printed, at)), 1e-15)


class Sharing(unittest.TestCase):
    def test_what_several_functions_need_is_computed_once_and_before_them(self):
        tape = Tape()
        x = tape.input("q", 0)
        first = [x]
        for _ in range(FEWEST_OPERATIONS + 2):
            first.append(first[-1] * first[-1] + x)
        units = [Unit(name, name, False, [("out[0]", first[-1] + k)], "", {}) for k, name in enumerate("ab")]
        shared, loads = share(tape, units)
        self.assertEqual([s.name for s in shared], ["kinematics"])
        self.assertEqual([unit.needs for unit in units], [["kinematics"]] * 2)
        self.assertEqual(list(loads), [first[-1].index])
        for unit in units:
            self.assertEqual(tape.operations(tape.reached([value for _, value in unit.outputs], loads)), 1 if unit.name == "b" else 0)


class Rows(unittest.TestCase):
    def test_constraint_rows_are_the_velocities_they_name(self):
        model = ripstik.model()
        at = point(model, 11)
        for body, rows in ((model.bodies[3], (0, 1)), (model.bodies[4], (2, 3))):
            velocity = body.centre.jacobian(model.q) * model.v
            axle = body.frame.R * sp.Matrix([0, 1, 0])
            rolling, report = model.constraints
            self.assertLess(abs(number((rolling.Omega * model.v)[rows[0]] - axle.dot(velocity), at)), 1e-20)
            self.assertLess(abs(number((report.Omega * model.v)[rows[0]] - velocity[1], at)), 1e-20)
            for constraints in model.constraints:
                gamma = constraints.rate(model.q, model.v)[rows[0]]
                direction = axle if constraints.id == "rolling" else sp.Matrix([0, 1, 0])
                self.assertLess(abs(number(gamma - along(direction.dot(velocity), model.q, model.v), at)), 1e-13)
                self.assertLess(abs(number((constraints.Omega * model.v)[rows[1]] - velocity[2], at)), 1e-20)


if __name__ == "__main__":
    unittest.main()
