"""The short way against the equations of motion that everything else is written from, in more digits than doubles have."""

import math
import random
import unittest

import mpmath
import sympy as sp

from . import ripstik
from .branches import Tree
from .composite import Dynamics
from .direct import Programs
from .elimination import Saddle
from .energy import Body, Point, potential
from .euler_lagrange import along, from_bodies
from .model import coordinates
from .recorder import Recorder
from .rotations import Frame
from .tape import Tape
from .test_derivation import number, values
from .trigonometry import sine_and_cosine
from .vectors import Axes, dot

DIGITS = 30


class ShortWay(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.model = ripstik.model()
        cls.programs = Programs(cls.model)

    def at(self, seed):
        """(inputs of the tape, values of symbols and of named intermediate results)."""
        model, n = self.model, len(self.model.q)
        at = values([*model.q, *model.v, *model.parameters], seed)
        draw = random.Random(seed)
        inputs = {"q": [at[s] for s in model.q], "v": [at[s] for s in model.v], "p": [at[s] for s in model.parameters],
                  "f": [mpmath.mpf(draw.uniform(-5, 5)) for _ in range(n)], "g": [mpmath.mpf(draw.uniform(-1, 1)) for _ in range(4)]}
        for symbol, expression in model.definitions:
            at[symbol] = number(expression, at)
        return inputs, at

    def numbers(self, expressions, at):
        return [mpmath.mpf(number(e, at)) for e in expressions]

    def test_accelerations_and_multipliers_solve_the_equations_of_motion(self):
        n = len(self.model.q)
        with mpmath.workdps(DIGITS):
            inputs, at = self.at(21)
            M, h = self.numbers(self.model.equations.M, at), self.numbers(self.model.equations.h, at)
            for constraints in self.model.constraints:
                found = self.programs.sets[constraints.id]
                a = self.evaluated(found.a, inputs)
                lam = self.evaluated(found.lam, inputs)
                Omega, gamma = self.numbers(constraints.Omega, at), self.numbers(constraints.gamma, at)
                for i in range(n):
                    left = sum(M[i * n + k] * a[k] for k in range(n)) - h[i] - inputs["f"][i] - sum(Omega[r * n + i] * lam[r] for r in range(4))
                    self.assertLess(abs(left), 1e-13, (constraints.id, i))
                for r in range(4):
                    self.assertLess(abs(sum(Omega[r * n + k] * a[k] for k in range(n)) + gamma[r]), 1e-13, (constraints.id, r))

    def test_slip_heights_and_shift(self):
        n = len(self.model.q)
        with mpmath.workdps(DIGITS):
            inputs, at = self.at(22)
            for constraints in self.model.constraints:
                found = self.programs.sets[constraints.id]
                Omega = self.numbers(constraints.Omega, at)
                for value, rows in zip(self.evaluated(found.velocity, inputs), range(4)):
                    self.assertLess(abs(value - sum(Omega[rows * n + k] * inputs["v"][k] for k in range(n))), 1e-13)
                for value, height in zip(self.evaluated(found.heights, inputs), constraints.heights):
                    self.assertLess(abs(value - mpmath.mpf(number(height, at))), 1e-13)
                change = self.evaluated(found.shift, inputs)
                for r in range(4):
                    self.assertLess(abs(sum(Omega[r * n + k] * change[k] for k in range(n)) - inputs["g"][r]), 1e-13)

    def evaluated(self, outputs, inputs):
        numbers = self.programs.tape.evaluate(dict(enumerate(outputs)), inputs, mpmath)
        return [numbers[i] for i in range(len(outputs))]

    def test_the_boards_accelerations_stay_cheap(self):
        """Operations, parameters' products left out: what was measured, and a little."""
        for name, most in (("rolling", 1580), ("report", 1560)):
            self.assertLessEqual(self.programs.sets[name].operations(), most, name)


class AnyTree(unittest.TestCase):
    def test_a_branch_of_two_joints_away_from_the_origin_with_a_rotor_at_its_end(self):
        """Free on (x, y, z), yaw and pitch; an arm, on it a second one of three unequal moments, on that a wheel."""
        q, v = coordinates("x y z yaw pitch first second spin")
        g = sp.Symbol("g", real=True)
        carrier = Frame.world(q).turned("z", q[3], q).turned("y", q[4], q)
        arm = carrier.turned("y", q[5], q)
        hand = arm.turned("z", sp.Rational(1, 5), q).turned("x", q[6], q)
        wheel = hand.turned("y", q[7], q)
        numbers = lambda *x: sp.Matrix([sp.Rational(str(a)) for a in x])
        origin = Point.fixed(q[:3, 0], carrier, sp.zeros(3, 1))
        elbow = origin.moved(carrier, numbers(0.3, 0.1, -0.2)).moved(arm, numbers(0.4, 0, 0.1))
        hub = elbow.moved(hand, numbers(0.1, 0.2, 0.3))
        bodies = (Body("trunk", carrier, origin, sp.Integer(3), sp.diag(2, 3, 4)), Body("arm", arm, elbow, sp.Integer(1), sp.diag(1, 2, 2) / 5),
                  Body("hand", hand, elbow.moved(hand, numbers(-0.1, 0.05, 0)), sp.Integer(2), sp.diag(1, 2, 3) / 10), Body("wheel", wheel, hub, sp.Integer(1), sp.diag(1, 2, 1) / 7))
        equations = from_bodies(bodies, potential(bodies, g), q, v)
        tape = Tape()
        record = Recorder(tape, {"q": list(q), "v": list(v), "p": [g]})
        dynamics = Dynamics(Tree(record, q, v, bodies, g), [tape.input("f", i) for i in range(8)], [("z", hub)])
        a, lam = Saddle(dynamics.M, dynamics.Omega).solve(dynamics.h, dynamics.gamma)
        a = dynamics.unknowns.accelerations(a)
        at = values([*q, *v, g], 31)
        with mpmath.workdps(DIGITS):
            f = [mpmath.mpf(k) / 3 for k in range(8)]
            found = tape.evaluate(dict(enumerate([*a, *lam])), {"q": [at[s] for s in q], "v": [at[s] for s in v], "p": [at[g]], "f": f}, mpmath)
            row = hub.jacobian(q)[2, :]
            for i in range(8):
                left = sum(mpmath.mpf(number(equations.M[i, k], at)) * found[k] for k in range(8)) - mpmath.mpf(number(equations.h[i], at))
                self.assertLess(abs(left - f[i] - mpmath.mpf(number(row[i], at)) * found[8]), 1e-12, str(q[i]))
            rate = sum(mpmath.mpf(number(row[k], at)) * found[k] for k in range(8)) + mpmath.mpf(number(along((row * v)[0], q, v), at))
            self.assertLess(abs(rate), 1e-12)


class Trigonometry(unittest.TestCase):
    def test_within_one_ulp(self):
        """At seeded angles of every size, around multiples of pi/2 too, against thirty digits."""
        draw = random.Random(9)
        angles = [draw.uniform(-size, size) for size in (1e-9, 0.7, 4, 100, 1e6) for _ in range(1500)]
        angles += [(k * math.pi / 2) * (1 + draw.uniform(-4, 4) * 2.0**-52) for k in range(-500, 1500)] + [0.0, 2.0**20 * 1.57]
        worst = 0.0
        with mpmath.workdps(40):
            for x in angles:
                for found, exact in zip(sine_and_cosine(x), (mpmath.sin(mpmath.mpf(x)), mpmath.cos(mpmath.mpf(x)))):
                    worst = max(worst, abs(mpmath.mpf(found) - exact) / mpmath.mpf(math.ulp(float(exact))))
        self.assertLess(worst, 1.0)


class Elimination(unittest.TestCase):
    def test_a_sparse_saddle_system_is_solved_and_does_not_fill_in(self):
        """Two branches that share the last two unknowns; floats, against numbers multiplied out."""
        draw = random.Random(5)
        n, m = 6, 2
        full = [[0.0] * n for _ in range(n)]
        for i in range(n):
            for j in range(i):
                if not (i in (2, 3) and j in (0, 1)):
                    full[i][j] = full[j][i] = draw.uniform(-1, 1)
            full[i][i] = 8.0
        Omega = [[draw.uniform(-1, 1) for _ in range(n)] for _ in range(m)]
        tape = Tape()
        entry = lambda array, value, at: tape.input(array, at) if value else tape.const(0)
        M = [[entry("M", full[i][j], max(i, j) * n + min(i, j)) for j in range(n)] for i in range(n)]
        rows = [[tape.input("O", r * n + k) for k in range(n)] for r in range(m)]
        saddle = Saddle(M, rows)
        self.assertTrue(all(saddle.mass.L[i][j].number == 0 for i in (2, 3) for j in (0, 1)))
        h, gamma = [tape.input("h", i) for i in range(n)], [tape.input("c", r) for r in range(m)]
        a, lam = saddle.solve(h, gamma)
        inputs = {"M": [x for row in full for x in row], "O": [x for row in Omega for x in row], "h": [draw.uniform(-1, 1) for _ in range(n)],
                  "c": [draw.uniform(-1, 1) for _ in range(m)]}
        x = tape.evaluate(dict(enumerate([*a, *lam])), inputs)
        for i in range(n):
            self.assertAlmostEqual(sum(full[i][k] * x[k] for k in range(n)) - sum(Omega[r][i] * x[n + r] for r in range(m)), inputs["h"][i], 13)
        for r in range(m):
            self.assertAlmostEqual(sum(Omega[r][k] * x[k] for k in range(n)), -inputs["c"][r], 13)


class Vectors(unittest.TestCase):
    def test_vectors_are_turned_and_multiplied_where_they_are_constant(self):
        q = sp.Matrix(sp.symbols("a b", real=True))
        tilt = sp.Symbol("tilt", real=True)
        tape = Tape()
        record = Recorder(tape, {"q": list(q), "p": [tilt]})
        carrier = Frame.world(q)
        frame = carrier.turned("x", q[0], q).turned("y", tilt, q).turned("z", q[1], q)
        axes = Axes(record, carrier)
        own = [[tape.const(x) for x in (0.3, -0.2, 0.7)], [tape.const(x) for x in (-1.1, 0.4, 0.5)]]
        first, second = (axes.constant(frame, x) for x in own)
        self.assertAlmostEqual(dot(first, second).number, -0.3 * 1.1 - 0.2 * 0.4 + 0.7 * 0.5, 15)
        axis = axes.unit(frame, "z")
        self.assertEqual(dot(axis, axes.unit(frame, "y")).number, 0)
        at = {q[0]: 0.4, q[1]: -0.9, tilt: 0.3}
        inputs = {"q": [0.4, -0.9], "p": [0.3]}
        R = frame.R.subs(at)
        for vector, components in ((first, (0.3, -0.2, 0.7)), (axes.cross(first, second), sp.Matrix([0.3, -0.2, 0.7]).cross(sp.Matrix([-1.1, 0.4, 0.5]))), (axis, (0, 0, 1))):
            found = tape.evaluate(dict(enumerate(vector)), inputs)
            for k, expected in enumerate(R * sp.Matrix(components)):
                self.assertAlmostEqual(found[k], float(expected), 14)


if __name__ == "__main__":
    unittest.main()
