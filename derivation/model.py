"""What a description hands to the code generator."""

from dataclasses import dataclass, field

import sympy as sp

from .euler_lagrange import Equations


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
    # Named intermediate results (symbol, expression), in order, that equations and constraints are written in.
    definitions: tuple = field(default_factory=tuple)


def coordinates(names: str):
    """Symbols q and v = q_dot for space-separated coordinate names, as column matrices."""
    split = names.split()
    return sp.Matrix(sp.symbols(split, real=True)), sp.Matrix(sp.symbols([f"{n}_dot" for n in split], real=True))
