"""How a system is set in type: its letters, what its bodies and rows are called, and formulas with what they are worth.

A `Term` carries marked LaTeX and the SymPy value of exactly that text, made together, so that a printed formula can be
evaluated. A `Formula` adds the expression of the model that it must equal; `test_typeset` compares the two for every
formula of every system.
"""

from dataclasses import dataclass, field

import sympy as sp

from .latex import column, latex
from .rotations import AXES, rotation


@dataclass(frozen=True)
class Row:
    """A constraint row: its permanent title, the velocity that vanishes, and the row of Omega by which it is printed."""

    title: str
    vanishes: "Term"
    row: sp.Matrix


@dataclass(frozen=True)
class Notation:
    """symbols: short forms (`α_fp`) of all coordinates, then of all parameters; subscripts: by body.

    frames: [(subscript, Frame)] that carry bodies without being one; letters: [(Symbol, short form, expression)] that
    abbreviate; masses: bodies of the dynamics where those that are drawn are others; rows: {constraint set: rows} where
    Omega itself is not written in q and v; losses: the part of h that no Lagrangian gives.
    """

    symbols: str
    subscripts: dict
    frames: tuple = ()
    letters: tuple = ()
    masses: tuple = ()
    rows: dict = field(default_factory=dict)
    titles: dict = field(default_factory=dict)
    losses: sp.Matrix | None = None
    # Further forces and what they need, and the vectors that constraint rows are written in: (id, left, Term, truth).
    extra: tuple = ()
    contacts: tuple = ()
    # Abbreviations that only those rows use, as letters; further marks {name: LaTeX}.
    defined: tuple = ()
    marks: dict = field(default_factory=dict)
    # What the heights are called, as LaTeX.
    heights: tuple = ()


@dataclass(frozen=True)
class Term:
    """Marked LaTeX and its value (scalar or column). `sum` tells that a factor needs brackets around it."""

    latex: str
    value: object
    sum: bool = False

    def bracketed(self) -> str:
        return f"({self.latex})" if self.sum else self.latex


@dataclass(frozen=True)
class Formula:
    """`left = right`, where right must be worth `truth`, an expression of the model."""

    id: str
    left: str
    right: Term
    truth: object

    @property
    def latex(self) -> str:
        return f"{self.left} = {self.right.latex}"


def mark(name: str) -> str:
    return rf"\s{{{name}}}"


def scalar(expression) -> Term:
    return Term(latex(expression), sp.sympify(expression), sp.sympify(expression).is_Add)


def vector(entries: sp.Matrix) -> Term:
    return Term(column(entries), entries)


def stacked(entries) -> Term:
    """A column of terms."""
    text = r" \\ ".join(e.latex for e in entries)
    return Term(rf"\begin{{pmatrix}} {text} \end{{pmatrix}}", sp.Matrix([e.value for e in entries]))


def total(parts) -> Term:
    """Sum of [(coefficient, factors)], each coefficient before its factors; zero ones are left out."""
    terms = []
    for coefficient, factors in parts:
        if coefficient == 0:
            continue
        behind = " ".join(latex(f) for f in factors)
        value = coefficient * sp.prod(factors)
        if not factors:
            terms.append(scalar(coefficient))
        elif coefficient in (1, -1):
            terms.append(Term(behind if coefficient == 1 else f"- {behind}", value))
        else:
            terms.append(Term(f"{scalar(coefficient).bracketed()}\\, {behind}", value))
    return plus(*terms) if terms else Term("0", sp.Integer(0))


def plus(*terms: Term) -> Term:
    """Their sum; a sign that a term begins with replaces the plus."""
    if len(terms) == 1:
        return terms[0]
    text = terms[0].latex
    for term in terms[1:]:
        text += f" {term.latex}" if term.latex.startswith("-") else f" + {term.latex}"
    value = terms[0].value
    for term in terms[1:]:
        value = value + term.value
    return Term(text, value, True)


def times(a: Term, b: Term) -> Term:
    return Term(f"{a.bracketed()} {b.bracketed()}", a.value * b.value)


def transposed(a: Term) -> Term:
    return Term(f"{a.bracketed()}^{{\\mathsf T}}", a.value.T)


def cross(a: Term, b: Term) -> Term:
    return Term(rf"{a.bracketed()} \times {b.bracketed()}", a.value.cross(b.value), True)


def dot(a: Term, b: Term) -> Term:
    return Term(rf"{a.bracketed()} \cdot {b.bracketed()}", a.value.dot(b.value))


def turn(axis: str, angle) -> Term:
    """The elementary rotation, as `R_z(theta)`."""
    return Term(rf"R_{axis}({latex(angle)})", rotation(axis, angle))


def unit(axis: str) -> Term:
    return Term(rf"\mathbf e_{axis}", AXES[axis])
