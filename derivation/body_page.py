"""Frames and bodies of a page: attitudes, places, velocities and energies, each from the frame or body before it."""

import sympy as sp

from .latex import latex, matrix
from .model import Model
from .notation import Formula, Term, cross, mark, plus, scalar, stacked, times, total, transposed, turn, unit, vector
from .tidy import tidy

# Up to this many operations in its entries, an angular velocity is written out.
WRITTEN_OUT = 32


class BodyPage:
    """What the formulas of one model share; `formulas` gathers those that have a value to be checked."""

    def __init__(self, model: Model):
        self.model, self.note = model, model.notation
        self.q, self.v = model.q, model.v
        self.a = sp.Matrix([sp.Symbol(f"{s.name}_ddot", real=True) for s in model.q])
        self.bodies = model.notation.masses or model.bodies
        self.letters = [(symbol, meaning) for symbol, _, meaning in self.note.letters]
        self.names = (*self.note.letters, *self.note.defined)
        self.formulas, self.kept = [], {}
        self.frames = [(f"frame.{sub}", sub, frame) for sub, frame in self.note.frames]
        self.frames += [(body.name, self.note.subscripts[body.name], body.frame) for body in self.bodies]

    def formula(self, id, left, right, truth) -> str:
        made = Formula(id, left, right, truth)
        self.formulas.append(made)
        return made.latex

    def tidy(self, e):
        if e not in self.kept:
            self.kept[e] = tidy(e, self.letters)
        return self.kept[e]

    def named(self, frame):
        """(mark, chain) of the named frame that a frame is, or None."""
        for name, _, other in self.frames:
            if chain(other) == chain(frame) and chain(frame):
                return name
        return None

    def base_of(self, frame):
        """The outermost named frame that a frame was turned from, and the turns after it."""
        turns, walked = [], frame
        while walked.parent is not None:
            turns.insert(0, (walked.axis, walked.angle))
            walked = walked.parent
            if self.named(walked):
                break
        return (walked if walked.parent is not None else None), turns

    def axes(self, frame) -> Term | None:
        """A frame's matrix by its name; None for the world."""
        if not chain(frame):
            return None
        name = self.named(frame)
        if name is None:
            raise ValueError("a frame that formulas need has no name")
        return Term(mark(f"R.{name}"), frame.R)

    def attitude(self, frame) -> Term:
        base, turns = self.base_of(frame)
        if not turns:
            return Term(r"\mathbf 1", sp.eye(3))
        parts = [turn(axis, angle) for axis, angle in turns]
        first = [self.axes(base)] if base is not None else []
        result = (first + parts)[0]
        for part in (first + parts)[1:]:
            result = Term(f"{result.latex}\\, {part.latex}", result.value * part.value)
        return result

    def angular(self, frame) -> Term:
        """Angular velocity in own axes: written out, or from that of the frame it was turned from."""
        entries = [self.by_rates(e) for e in frame.W * self.v]
        if sum(sp.count_ops(e.value) for e in entries) <= WRITTEN_OUT:
            return stacked(entries)
        base, turns = self.base_of(frame)
        result = Term(mark(f"omega.{self.named(base)}"), base.W * self.v)
        for axis, angle in turns:
            rate = (sp.Matrix([angle]).jacobian(self.q) * self.v)[0]
            down = turn(axis, angle)
            result = Term(f"{transposed(down).latex} {result.bracketed()}", down.value.T * result.value)
            if rate != 0:
                result = plus(result, times(scalar(rate), unit(axis)))
        return result

    def by_rates(self, e) -> Term:
        """A polynomial in the rates, coefficients before the rates."""
        parts = sp.Poly(sp.expand(e), *self.v).terms() if e != 0 else []
        return total([(self.tidy(c), [r**k for r, k in zip(self.v, powers) if k]) for powers, c in parts])

    # ── bodies

    def arms(self, body):
        """[(frame, offset)] of a centre, without those that are zero, and the earlier body that it starts from."""
        point, arms = body.centre, reaches(body.centre)
        for other in reversed(self.bodies[: [b.name for b in self.bodies].index(body.name)]):
            theirs = reaches(other.centre)
            if theirs and other.centre.base == point.base and len(theirs) < len(arms) and all(a[0] is b[0] and a[1] == b[1] for a, b in zip(theirs, arms)):
                return other, arms[len(theirs):]
        return None, arms

    def position(self, body) -> Term:
        earlier, arms = self.arms(body)
        if earlier is None:
            start = vector(body.centre.base)
        else:
            start = Term(mark(f"r.{earlier.name}"), earlier.centre.position())
        return plus(start, *(self.carried(frame, vector(offset)) for frame, offset in arms))

    def carried(self, frame, term: Term) -> Term:
        axes = self.axes(frame)
        return term if axes is None else times(axes, term)

    def velocity(self, body) -> Term:
        earlier, arms = self.arms(body)
        if earlier is None:
            start = vector(body.centre.base.jacobian(self.q) * self.v)
        else:
            start = Term(mark(f"v.{earlier.name}"), earlier.centre.jacobian(self.q) * self.v)
        terms = [start]
        for frame, offset in arms:
            if frame.W != sp.zeros(3, len(self.q)):
                omega = Term(mark(f"omega.{self.named(frame)}"), frame.W * self.v)
                terms.append(self.carried(frame, cross(omega, vector(offset))))
            slide = offset.jacobian(self.q) * self.v
            if slide != sp.zeros(3, 1):
                terms.append(self.carried(frame, vector(slide)))
        return plus(*terms)

    def kinetic(self, body) -> Term:
        v = body.centre.jacobian(self.q) * self.v
        omega = body.frame.W * self.v
        parts = []
        if body.mass != 0:
            half = scalar(body.mass)
            parts.append(Term(rf"\tfrac12\, {half.bracketed()}\, |{mark(f'v.{body.name}')}|^2", body.mass * v.dot(v) / 2))
        if not body.inertia.is_zero_matrix and body.frame.W != sp.zeros(3, len(self.q)):
            w, inertia = mark(f"omega.{body.name}"), mark(f"I.{body.name}")
            parts.append(Term(rf"\tfrac12\, {w}^{{\mathsf T}} {inertia}\, {w}", omega.dot(body.inertia * omega) / 2))
        return plus(*parts)

    def body(self, body) -> dict:
        name, n = body.name, len(self.q)
        turning = body.frame.W != sp.zeros(3, n)
        formulas = {
            "attitude": self.formula(f"{name}.attitude", mark(f"R.{name}"), self.attitude(body.frame), body.frame.R),
            "position": self.formula(f"{name}.position", mark(f"r.{name}"), self.position(body), body.centre.position()),
            "velocity": self.formula(f"{name}.velocity", mark(f"v.{name}"), self.velocity(body), body.centre.jacobian(self.q) * self.v),
        }
        if turning:
            formulas["angular"] = self.formula(f"{name}.angular", mark(f"omega.{name}"), self.angular(body.frame), body.frame.W * self.v)
        if body.mass != 0 or not body.inertia.is_zero_matrix:
            formulas["kinetic"] = self.formula(f"{name}.kinetic", mark(f"T.{name}"), self.kinetic(body), None)
        inertia = None
        if turning and not body.inertia.is_zero_matrix:
            printed = body.inertia.applyfunc(self.tidy)
            inertia = self.formula(f"{name}.inertia", mark(f"I.{name}"), Term(matrix(printed), printed), body.inertia)
        return {"id": name, "mass": latex(body.mass), "inertia": inertia, **formulas}

    def carrier(self, name, frame) -> dict:
        return {
            "id": name,
            "attitude": self.formula(f"{name}.attitude", mark(f"R.{name}"), self.attitude(frame), frame.R),
            "angular": self.formula(f"{name}.angular", mark(f"omega.{name}"), self.angular(frame), frame.W * self.v),
        }


def reaches(point) -> list:
    """[(frame, offset)] that a point is made of, without what is zero."""
    arms = point.arms or ((point.carrier, point.offset),)
    return [(frame, offset) for frame, offset in arms if offset != sp.zeros(3, 1)]


def chain(frame) -> tuple:
    return () if frame.parent is None else (*chain(frame.parent), (frame.axis, frame.angle))
