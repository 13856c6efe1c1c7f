"""What a description hands to the code generator."""

from dataclasses import dataclass, field

import sympy as sp

from .euler_lagrange import Equations
from .notation import Notation


@dataclass(frozen=True)
class Model:
    """A system: symbols, equations, energies, poses and constraint sets."""

    id: str
    title: str
    q: sp.Matrix
    v: sp.Matrix
    parameters: tuple
    equations: Equations
    kinetic: sp.Expr
    potential: sp.Expr
    bodies: tuple
    constraints: tuple = field(default_factory=tuple)
    # Forces kept out of h because they have singular points of their own: (name, n x 1).
    extra_forces: tuple = field(default_factory=tuple)
    # f of a system of first order q' = f(q); its equations are then those of the rate, see `of_first_order`.
    rate: sp.Matrix | None = None
    # Named intermediate results (symbol, expression), in order, that equations and constraints are written in.
    definitions: tuple = field(default_factory=tuple)
    # What the shortest way to its accelerations is derived from (`direct.Direct`), where it has one.
    direct: object = None
    # How it is set in type.
    notation: Notation | None = None


def coordinates(names: str):
    """Symbols q and v = q_dot for space-separated coordinate names, as column matrices."""
    split = names.split()
    return sp.Matrix(sp.symbols(split, real=True)), sp.Matrix(sp.symbols([f"{n}_dot" for n in split], real=True))


def of_first_order(f: sp.Matrix, q: sp.Matrix, v: sp.Matrix) -> Equations:
    """q' = f(q) differentiated once, M = 1 and h = df/dq v, so that whoever asks for an acceleration gets the right one."""
    return Equations(sp.eye(len(q)), f.jacobian(q) * v)


def on_level_ground(x: sp.Expr, y: sp.Expr, height: sp.Expr = sp.Integer(0)) -> sp.Matrix:
    """A place (x, y) of the ground plane, raised by a height."""
    return sp.Matrix([x, y, height])
