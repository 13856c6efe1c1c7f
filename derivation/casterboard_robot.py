"""The casterboard robot of Kinugasa, Ishikawa, Sugimoto and Osuka, "Modeling and Control of Casterboard Robot"
(IFAC NOLCOS 2013), the report's reference [19]: a flat model. Weights on both plates swing sideways by l2 phi, and the
roll of a plate steers its caster by psi = atan(tan(a) sin(phi)), the paper's map (2).

Derived from its Lagrangian (3) and constraints (4). Its printed equations of motion hold cos 2 theta terms, which
a Lagrangian that is the same in every direction cannot give.
"""

import sympy as sp

from .constraints import rows_only
from .energy import Body, Point
from .euler_lagrange import Equations, from_lagrangian
from .model import Model, coordinates, on_level_ground
from .notation import Notation, Row, scalar
from .rotations import Frame

q, v = coordinates("x y theta phi_f phi_r")
x, y, theta, phi_f, phi_r = q
p = {name: sp.Symbol(name, real=True) for name in "l1 l2 m1 m2 J a c gravity".split()}
SIDES = (("front", 1, phi_f), ("rear", -1, phi_r))


def weight(s, phi) -> sp.Matrix:
    """Place of the point mass on one side."""
    return sp.Matrix([x + s * p["l1"] * sp.cos(theta) - p["l2"] * phi * sp.sin(theta),
                      y + s * p["l1"] * sp.sin(theta) + p["l2"] * phi * sp.cos(theta)])


def steer(phi) -> sp.Expr:
    return sp.atan(sp.tan(p["a"]) * sp.sin(phi))


# What the page calls the steer of the casters.
STEERS = tuple(sp.symbols("psi_f psi_r", real=True))


def lateral(s, psi) -> sp.Expr:
    """Speed of a caster across its heading."""
    return sp.sin(theta + psi) * v[0] - sp.cos(theta + psi) * v[1] - s * p["l1"] * sp.cos(psi) * v[2]


def shown_bodies() -> tuple:
    """For pictures: the deck's roll axis lies at half of l1; arms roll about it, casters stand on the ground."""
    flat = Frame.world(q).turned("z", theta, q)
    height = p["l1"] / 2
    nothing, none = sp.Integer(0), sp.zeros(3, 3)

    def end(s, z):
        return on_level_ground(x + s * p["l1"] * sp.cos(theta), y + s * p["l1"] * sp.sin(theta), z)

    def body(name, frame, place):
        return Body(name, frame, Point(place, frame, sp.zeros(3, 1)), nothing, none)

    # A weight above the axis moves to the left (+y) with positive phi: a roll by -phi about x.
    arms = [body(f"{name}-arm", flat.turned("x", -phi, q), end(s, height)) for name, s, phi in SIDES]
    wheels = [body(f"{name}-wheel", flat.turned("z", steer(phi), q), end(s, 0)) for name, s, phi in SIDES]
    return (body("body", flat, on_level_ground(x, y, height)), *arms, *wheels)


def masses() -> tuple:
    """Bodies with mass: the board turns about the vertical, the weights are points."""
    world, flat = Frame.world(q), Frame.world(q).turned("z", theta, q)
    board = Body("body", flat, Point.fixed(on_level_ground(x, y), flat, sp.zeros(3, 1)), p["m1"], sp.diag(0, 0, p["J"]))
    points = [Body(f"{name}-weight", world, Point(sp.Matrix([*weight(s, phi), 0]), world, sp.zeros(3, 1)), p["m2"], sp.zeros(3, 3))
              for name, s, phi in SIDES]
    return (board, *points)


def notation(drag) -> Notation:
    rows = [lateral(s, psi) for (_, s, _), psi in zip(SIDES, STEERS)]
    return Notation(
        "x y θ φ_f φ_r l_1 l_2 m_1 m_2 J a c g", {"body": "1", "front-weight": "f", "rear-weight": "r"}, masses=masses(), losses=drag,
        letters=tuple((psi, f"ψ_{side}", steer(phi)) for psi, side, (_, _, phi) in zip(STEERS, "fr", SIDES)),
        rows={"rolling": tuple(Row(f"{name}.lateral", scalar(e), sp.Matrix([e]).jacobian(v)) for e, (name, _, _) in zip(rows, SIDES))},
    )


def model() -> Model:
    T = p["m1"] * (v[0]**2 + v[1]**2) / 2 + p["J"] * v[2]**2 / 2
    for _, s, phi in SIDES:
        rate = weight(s, phi).jacobian(q) * v
        T += p["m2"] * rate.dot(rate) / 2
    T, V = sp.simplify(T), sp.Integer(0)
    equations = from_lagrangian(T - V, q, v)
    drag = sp.Matrix([-p["c"] * v[0], -p["c"] * v[1], -2 * p["c"] * p["l1"]**2 * v[2], 0, 0])
    return Model(
        id="casterboard-robot", title="the casterboard robot", q=q, v=v, parameters=tuple(p.values()),
        equations=Equations(equations.M, equations.h + drag), kinetic=T, potential=V, bodies=shown_bodies(),
        constraints=(rows_only("rolling", [lateral(s, steer(phi)) for _, s, phi in SIDES], v),),
        notation=notation(drag),
    )
