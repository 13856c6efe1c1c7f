"""Every printed formula against the model that the TypeScript is generated from, at seeded states."""

import json
import re
import unittest

import mpmath
import sympy as sp

from . import typeset
from .__main__ import SYSTEMS
from .euler_lagrange import along
from .latex import latex, plain
from .notation import mark
from .test_derivation import number, values
from .tidy import tidy

TOLERANCE = 1e-13


def numbers(entries, at):
    """Values of expressions at a point, computed together."""
    entries = [sp.sympify(e) for e in entries]
    symbols = sorted(set().union(*(e.free_symbols for e in entries)), key=lambda s: s.name)
    with mpmath.workdps(30):
        return sp.lambdify(symbols, entries, "mpmath", cse=True)(*(mpmath.mpf(at[s]) for s in symbols))


def entries_of(value):
    return list(value) if isinstance(value, sp.MatrixBase) else [value]


class EveryPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.models = {name: module.model() for name, module in SYSTEMS.items()}
        cls.pages = {name: typeset.page(model) for name, model in cls.models.items()}

    def point(self, name, seed):
        """State, parameters, accelerations, multipliers; named results of the model and letters of the page after them."""
        model = self.models[name]
        symbols = [*model.q, *model.v, *model.parameters]
        symbols += [sp.Symbol(f"{s.name}_ddot", real=True) for s in model.q] + [sp.Symbol(f"lambda_{k}", real=True) for k in range(1, 6)]
        at = values(symbols, seed)
        for symbol, expression in model.definitions:
            at[symbol] = number(expression, at)
        for symbol, _, meaning in (*model.notation.letters, *model.notation.defined):
            at[symbol] = number(meaning, at)
        return at

    def test_what_is_printed_is_worth_what_the_model_is(self):
        for name, (_, formulas) in self.pages.items():
            self.assertEqual(len({f.id for f in formulas}), len(formulas), name)
            for seed in (21, 22):
                at = self.point(name, seed)
                checked = [f for f in formulas if f.truth is not None]
                printed = [entries_of(f.right.value) for f in checked]
                true = [entries_of(f.truth) for f in checked]
                for f, a, b in zip(checked, printed, true):
                    self.assertEqual(len(a), len(b), f"{name}: {f.id}")
                ids = [f.id for f, a in zip(checked, printed) for _ in a]
                flat = [e for side in (printed, true) for entries in side for e in entries]
                found = numbers(flat, at)
                for id, a, b in zip(ids, found, found[len(ids):]):
                    self.assertLess(abs(a - b), TOLERANCE, f"{name}: {id}")

    def test_only_parts_that_a_checked_sum_adds_up_go_without_a_truth(self):
        for name, (_, formulas) in self.pages.items():
            without = [f for f in formulas if f.truth is None]
            self.assertTrue(all(f.id.endswith(".kinetic") for f in without), name)
            if without:
                whole = next(f for f in formulas if f.id == "kinetic")
                at = self.point(name, 23)
                parts = numbers([f.right.value for f in without] + [whole.truth], at)
                self.assertLess(abs(sum(parts[:-1]) - parts[-1]), TOLERANCE, name)

    def test_the_structure_gives_mass_matrix_and_h(self):
        """M, h by the printed sums over bodies, whatever way the model took to them."""
        for name, model in self.models.items():
            if model.rate is not None:
                continue
            q, v = model.q, model.v
            at = self.point(name, 24)
            bodies = model.notation.masses or model.bodies
            M, h = sp.zeros(len(q), len(q)), -sp.Matrix([model.potential]).jacobian(q).T
            for body in bodies:
                R, s = body.centre.carrier.R, body.centre.relative_jacobian(q)
                J, W = body.centre.base.jacobian(q) + R * s, body.frame.W
                omega = W * v
                M += body.mass * J.T * J + W.T * body.inertia * W
                h -= body.mass * J.T * along(J * v, q, v) + W.T * (body.inertia * along(omega, q, v) + omega.cross(body.inertia * omega))
            if model.notation.losses is not None:
                h += model.notation.losses
            n = len(q)
            found = numbers([*M, *h, *model.equations.M, *model.equations.h], at)
            size = n * n + n
            for k in range(size):
                self.assertLess(abs(found[k] - found[size + k]), 1e-12, f"{name}: {k}")

    def test_gamma_is_the_rate_of_omega(self):
        for name, model in self.models.items():
            at = self.point(name, 25)
            for constraints, page in zip(model.constraints, self.pages[name][0]["constraints"]):
                rows = typeset.Page(model).rows_of(constraints)
                self.assertEqual(len(rows), len(page["rows"]))
                letters = [(s, meaning) for s, _, meaning in (*model.notation.letters, *model.notation.defined)]
                for k, row in enumerate(rows):
                    velocity = (row.row * model.v)[0]
                    for symbol, meaning in reversed(letters):
                        velocity = velocity.xreplace({symbol: meaning})
                    pair = numbers([along(velocity, model.q, model.v), constraints.rate(model.q, model.v)[k]], at)
                    self.assertLess(abs(pair[0] - pair[1]), 1e-12, f"{name}: {constraints.id} {k}")

    def test_every_mark_has_a_letter_and_every_coordinate_and_parameter_is_there(self):
        for name, (document, _) in self.pages.items():
            used = set(typeset.marks_in(json.dumps(document)))
            self.assertLessEqual(used, set(document["symbols"]), name)
            for symbol in [*self.models[name].q, *self.models[name].parameters]:
                self.assertIn(symbol.name, document["symbols"], name)
            for text in document["symbols"].values():
                self.assertNotRegex(text, r"[^\x00-\x7f]", name)


class Typesetting(unittest.TestCase):
    def test_latex_is_marked_and_becomes_plain(self):
        a, b = sp.symbols("alpha_fp m", real=True)
        text = latex(b * sp.sin(a) ** 2 / 2)
        self.assertEqual(text, rf"\tfrac{{1}}{{2}} {mark('m')} \sin^{{2}} {{{mark('alpha_fp')}}}")
        self.assertEqual(plain(text, {"alpha_fp": r"\alpha_{fp}", "m": "m"}), r"\tfrac{1}{2} m \sin^{2} {\alpha_{fp}}")

    def test_brackets_balance(self):
        for name in ("casterboard-robot", "wheel-pendulum"):
            for formula in typeset.page(SYSTEMS[name].model())[1]:
                text = re.sub(r"\\s\{[^}]*\}", "x", formula.latex)
                for left, right in ("()", "{}", "[]"):
                    self.assertEqual(text.count(left), text.count(right), f"{name}: {formula.id}")

    def test_tidy_changes_no_value(self):
        a, b, m = sp.symbols("a b m", real=True)
        for e in (sp.sin(a) ** 2 * m + sp.cos(a) ** 2 * m, sp.sin(a + b) ** 3 * sp.cos(b), (sp.sin(a) + sp.cos(b)) ** 4 / (1 + m), sp.sqrt(1 - sp.sin(a) ** 2) * m):
            at = values([a, b, m], 26)
            self.assertLess(abs(number(e, at) - number(tidy(e), at)), 1e-20)
        self.assertEqual(tidy(sp.sin(a) ** 2 * m + sp.cos(a) ** 2 * m), m)


if __name__ == "__main__":
    unittest.main()
