"""The RipStik: torsion rod, two plates, two inclined casters that touch the ground like skates."""

from dataclasses import dataclass

import sympy as sp

from . import recursion
from .constraints import Constraints, velocity_row
from .direct import Direct
from .energy import Body, Point, kinetic, potential
from .euler_lagrange import Equations
from .model import Model, coordinates
from .notation import Notation, Row, Term, dot, mark, unit
from .recursion import Names, Tree
from .rotations import Frame

q, v = coordinates("X Y Z alpha psi theta alpha_fp alpha_bp theta_fc theta_bc")
X, Y, Z, alpha, psi, theta, alpha_fp, alpha_bp, theta_fc, theta_bc = q

PARAMETERS = (
    "rodMass rodLength rodRadius plateMass plateLength plateWidth plateThickness plateOffset pivotDrop "
    "casterAngle casterTrail casterDrop casterMass wheelRadius gravity torsionStiffness torsionDamping "
    "jointDamping casterDamping wheelDrag"
)
p = {name: sp.Symbol(name, real=True) for name in PARAMETERS.split()}

COORDINATE_SYMBOLS = "X Y Z α ψ θ α_fp α_bp θ_fc θ_bc"
PARAMETER_SYMBOLS = "m_r L_r R_r m_p L_p W_p T_p d_p d_v φ c d_c m_c R_w g k_t c_t c_j c_c c_w"
SUBSCRIPTS = {"rod": "r", "front-plate": "fp", "back-plate": "bp", "front-caster": "fc", "back-caster": "bc"}


def cylinder_along_x(m, length, radius):
    side = m * (3 * radius**2 + length**2) / 12
    return sp.diag(m * radius**2 / 2, side, side)


def prism(m, length, width, thickness):
    return sp.diag(width**2 + thickness**2, length**2 + thickness**2, length**2 + width**2) * m / 12


def disc_about_y(m, radius):
    return m * radius**2 * sp.diag(sp.Rational(1, 4), sp.Rational(1, 2), sp.Rational(1, 4))


@dataclass(frozen=True)
class Board:
    """The five bodies over coordinates in which each plate has the given roll about the rod's axis."""

    bodies: tuple
    pitched: Frame
    skates: tuple  # (skate point, caster frame), front and back

    def carrying(self, body: Body) -> "Board":
        """The same with one body more."""
        return Board((*self.bodies, body), self.pitched, self.skates)


@dataclass(frozen=True)
class Kind:
    """What a system with this board in it has of its own; its first ten coordinates are the board's."""

    id: str
    title: str
    q: sp.Matrix
    v: sp.Matrix
    parameters: tuple
    symbols: str  # short forms of coordinates and parameters
    board: object  # (q, front roll, back roll) -> Board
    springs: object  # potential of all springs
    losses: sp.Matrix  # n x 1, of springs and dampers
    subscripts: dict
    within: object = None  # Board -> `within.Inner`: what moves in a body that the board carries


def board(q: sp.Matrix, roll_front, roll_back) -> Board:
    """Everything hangs on the pitched frame, which the rod's roll does not turn, so that offsets stay short."""
    origin = sp.Matrix([X, Y, Z])
    pitched = Frame.world(q).turned("z", theta, q).turned("y", psi, q)
    rod = Body("rod", pitched.turned("x", alpha, q), Point.fixed(origin, pitched, sp.zeros(3, 1)),
               p["rodMass"], cylinder_along_x(p["rodMass"], p["rodLength"], p["rodRadius"]))

    def half(name, side, roll, steer):
        """Plate and caster on one side (+1 front, -1 back); `roll` is the plate's own, `steer` the caster's."""
        plate_frame = pitched.turned("x", roll, q)
        caster_frame = plate_frame.turned("y", p["casterAngle"], q).turned("z", steer, q)
        centre = Point.fixed(origin, pitched, sp.Matrix([side * p["plateOffset"], 0, 0]))
        pivot = centre.moved(plate_frame, sp.Matrix([0, 0, -p["pivotDrop"]]))
        skate = pivot.moved(caster_frame, sp.Matrix([-p["casterTrail"], 0, -p["casterDrop"]]))
        plate = Body(f"{name}-plate", plate_frame, centre, p["plateMass"],
                     prism(p["plateMass"], p["plateLength"], p["plateWidth"], p["plateThickness"]))
        caster = Body(f"{name}-caster", caster_frame, skate, p["casterMass"],
                      disc_about_y(p["casterMass"], p["wheelRadius"]))
        return plate, caster

    front_plate, front_caster = half("front", 1, roll_front, theta_fc)
    back_plate, back_caster = half("back", -1, roll_back, theta_bc)
    return Board((rod, front_plate, back_plate, front_caster, back_caster), pitched,
                 tuple((caster.centre, caster.frame) for caster in (front_caster, back_caster)))


AXLE = sp.Matrix([0, 1, 0])


def model() -> Model:
    return modelled(Kind("ripstik", "the RipStik", q, v, tuple(p.values()), f"{COORDINATE_SYMBOLS} {PARAMETER_SYMBOLS}", board,
                         torsion_spring(), springs_and_losses(q), SUBSCRIPTS))


def modelled(kind: Kind) -> Model:
    q, v = kind.q, kind.v
    described = kind.board(q, alpha + alpha_fp, alpha + alpha_bp)
    V = potential(described.bodies, p["gravity"]) + kind.springs
    names = Names()
    equations, rolling, report, drag = by_recursion(kind, names)
    skates = [(point, frame.relative_to(described.pitched) * AXLE) for point, frame in described.skates]
    heights = sp.Matrix([point.position()[2] for point, _ in skates])
    return Model(
        id=kind.id, title=kind.title, q=q, v=v, parameters=kind.parameters,
        equations=equations, kinetic=kinetic(described.bodies, q, v), potential=V, bodies=described.bodies,
        constraints=(Constraints("rolling", rolling[0], heights, (1, 3), rolling[1]),
                     Constraints("report", report[0], heights, (1, 3), report[1])),
        extra_forces=(("wheelDrag", drag),),
        definitions=tuple(names.definitions), direct=short_way(kind, described), notation=notation(kind, described, skates),
    )


def short_way(kind, described) -> Direct:
    lateral = {"rolling": [(frame, "y") for _, frame in described.skates], "report": ["y", "y"]}
    within, bodies = kind.within and kind.within(described), described.bodies
    if within:
        bodies = (*bodies[:5], within.body)
    return Direct(bodies, p["gravity"], kind.losses,
                  {name: [row for (point, _), across in zip(described.skates, both) for row in ((across, point), ("z", point))]
                   for name, both in lateral.items()}, tuple(point for point, _ in described.skates), within)


def by_recursion(kind, names):
    """M and h, both constraint sets and the wheel drag, derived in plates' own rolls phi = alpha + alpha_fp, alpha + alpha_bp.

    With q' = T q the columns of alpha are sums of others, so that nothing of a plate is computed twice:
    M = T^T M' T, h = T^T h', Omega = Omega' T.
    """
    q, v = kind.q, kind.v
    n = len(q)
    rolls = [names.let("phi", alpha + alpha_fp), names.let("phi", alpha + alpha_bp)]
    rates = [names.let("phi_dot", v[3] + v[6]), names.let("phi_dot", v[3] + v[7])]
    own, own_rates = q.copy(), v.copy()
    own[6:8, 0], own_rates[6:8, 0] = sp.Matrix(rolls), sp.Matrix(rates)
    T = sp.eye(n)
    T[6, 3] = T[7, 3] = 1

    b = kind.board(own, *rolls)
    tree = Tree(own, own_rates, names)
    free = recursion.equations(tree, b.bodies, p["gravity"])
    h = T.T * names.let("h", free.h) + kind.losses
    up, across = (tree.carrier(b.pitched).T * sp.Matrix(e) for e in ([0, 0, 1], [0, 1, 0]))
    vertical = [recursion.row(tree, up, point) for point, _ in b.skates]
    world_y = [recursion.row(tree, across, point) for point, _ in b.skates]
    lateral = [recursion.row(tree, outwards(tree, frame, b.pitched), point, (frame, AXLE)) for point, frame in b.skates]

    def rows(sideways):
        four = (sideways[0], vertical[0], sideways[1], vertical[1])
        return sp.Matrix.vstack(*[names.let("O", r) for r, _ in four]) * T, sp.Matrix([gamma for _, gamma in four])

    drag = sp.zeros(n, 1)
    for point, frame in b.skates:
        heading = level_heading(tree.carrier(b.pitched) * outwards(tree, frame, b.pitched))
        along = names.let("D", heading.T * (point.base.jacobian(own) + recursion.world_jacobian(tree, point))) * T
        drag -= p["wheelDrag"] * along.T * (along * v)
    return Equations(T.T * names.let("M", free.M) * T, h), rows(lateral), rows(world_y), drag


def outwards(tree, frame, carrier):
    """The axle in carrier axes."""
    axle = AXLE
    while frame is not carrier:
        axle, frame = tree.names.let("a", tree.up(frame, axle)), frame.parent
    return axle


def notation(kind, described, skates) -> Notation:
    q, v = kind.q, kind.v
    rho_f, rho_b = sp.symbols("rho_f rho_b", real=True)

    def rows(sideways):
        both = []
        for side, (point, axle), body in zip(("front", "back"), skates, described.bodies[3:5]):
            velocity = Term(mark(f"v.{body.name}"), point.jacobian(q) * v)
            direction = axle if sideways is None else described.pitched.R.T * sideways
            across = Term(rf"{mark(f'R.{body.name}')}\, \mathbf e_y", body.frame.R * AXLE) if sideways is None else unit("y")
            up = sp.Matrix([0, 0, 1])
            both.append(Row(f"{side}.lateral", dot(Term(across.latex, across.value, sideways is None), velocity), velocity_row(direction, point, q)))
            both.append(Row(f"{side}.vertical", dot(unit("z"), velocity), velocity_row(described.pitched.R.T * up, point, q)))
        return tuple(both)

    return Notation(
        kind.symbols, kind.subscripts,
        frames=(("c", described.pitched),), letters=((rho_f, "ρ_f", alpha + alpha_fp), (rho_b, "ρ_b", alpha + alpha_bp)),
        rows={"rolling": rows(None), "report": rows(AXLE)}, heights=tuple(rf"\mathbf e_z \cdot {mark(f'r.{b.name}')}" for b in described.bodies[3:5]), losses=kind.losses.subs({k: 0 for k in kind.springs.free_symbols if k in kind.parameters}),
        **printed_drag(kind, described, skates),
    )


def printed_drag(kind, described, skates) -> dict:
    """The wheel drag with its headings, in words of vectors."""
    q, v = kind.q, kind.v
    formulas, texts, total = [], [], sp.zeros(len(q), 1)
    for sub, (point, axle), body in zip(("fc", "bc"), skates, described.bodies[3:5]):
        heading = level_heading(described.pitched.R * axle)
        h, r, J = mark(f"e.{body.name}"), mark(f"v.{body.name}"), point.jacobian(q)
        axle_text = rf"{mark(f'R.{body.name}')}\, \mathbf e_y"
        across = (body.frame.R * AXLE).cross(sp.Matrix([0, 0, 1]))
        formulas.append((f"heading.{sub}", h, Term(rf"\dfrac{{({axle_text}) \times \mathbf e_z}}{{|({axle_text}) \times \mathbf e_z|}}", across / sp.sqrt(across.dot(across))), heading))
        texts.append(rf"\left( \dfrac{{\partial {r}}}{{\partial \dot q}} \right)^{{\mathsf T}} {h} ({h} \cdot {r})")
        total += J.T * heading * heading.dot(J * v)
    drag = Term(rf"- {mark('wheelDrag')} \left[ {' + '.join(texts)} \right]", -p["wheelDrag"] * total)
    formulas.append(("drag", r"Q^{\mathrm{drag}}", drag, wheel_drag(skates, described.pitched, q, v)))
    return {"extra": tuple(formulas), "marks": {f"e.{body.name}": rf"\mathbf e_{{{sub}}}" for sub, body in zip(("fc", "bc"), described.bodies[3:5])}}


def torsion_spring():
    return p["torsionStiffness"] * (alpha_fp - alpha_bp)**2 / 2


def springs_and_losses(q) -> sp.Matrix:
    twist, twist_dot = alpha_fp - alpha_bp, v[6] - v[7]
    torque = p["torsionStiffness"] * twist + p["torsionDamping"] * twist_dot
    force = sp.zeros(len(q), 1)
    force[6] = -torque - p["jointDamping"] * v[6]
    force[7] = torque - p["jointDamping"] * v[7]
    force[8] = -p["casterDamping"] * v[8]
    force[9] = -p["casterDamping"] * v[9]
    return force


def level_heading(axle) -> sp.Matrix:
    """Horizontal direction across an axle given in world axes."""
    return sp.Matrix([axle[1], -axle[0], 0]) / sp.sqrt(axle[0] ** 2 + axle[1] ** 2)


def wheel_drag(skates, pitched, q, v) -> sp.Matrix:
    """Viscous drag at each skate along its horizontal heading e_y x z, normalised.

    Kept apart: the heading has no direction where a skate lies flat, and a board without drag
    must not stumble over that.
    """
    force = sp.zeros(len(q), 1)
    for point, axle in skates:
        row = velocity_row(pitched.R.T * level_heading(pitched.R * axle), point, q)
        force -= p["wheelDrag"] * row.T * (row * v)
    return force
