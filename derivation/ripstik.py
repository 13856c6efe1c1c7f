"""The RipStik: torsion rod, two plates, two inclined casters that touch the ground like skates."""

import sympy as sp

from .constraints import Constraints, velocity_row
from .energy import Body, Point, kinetic, potential
from .euler_lagrange import Equations, from_bodies
from .model import Model, coordinates
from .rotations import Frame, rotation

q, v = coordinates("X Y Z alpha psi theta alpha_fp alpha_bp theta_fc theta_bc")
X, Y, Z, alpha, psi, theta, alpha_fp, alpha_bp, theta_fc, theta_bc = q

PARAMETERS = (
    "rodMass rodLength rodRadius plateMass plateLength plateWidth plateThickness plateOffset pivotDrop "
    "casterAngle casterTrail casterDrop casterMass wheelRadius gravity torsionStiffness torsionDamping "
    "jointDamping casterDamping wheelDrag"
)
p = {name: sp.Symbol(name, real=True) for name in PARAMETERS.split()}


def cylinder_along_x(m, length, radius):
    side = m * (3 * radius**2 + length**2) / 12
    return sp.diag(m * radius**2 / 2, side, side)


def prism(m, length, width, thickness):
    return sp.diag(width**2 + thickness**2, length**2 + thickness**2, length**2 + width**2) * m / 12


def disc_about_y(m, radius):
    return m * radius**2 * sp.diag(sp.Rational(1, 4), sp.Rational(1, 2), sp.Rational(1, 4))


def half(name, side, roll, steer, pitched):
    """Plate and caster on one side (+1 front, -1 back); `roll` is the plate's own, `steer` the caster's.

    Everything hangs on the pitched frame, which the rod's roll does not turn: the plate's own
    roll alpha + alpha_fp appears as one angle, and offsets stay short.
    """
    origin = sp.Matrix([X, Y, Z])
    plate_frame = pitched.turned("x", roll, q)
    caster_frame = plate_frame.turned("y", p["casterAngle"], q).turned("z", steer, q)
    plate_axes = rotation("x", roll)
    caster_axes = plate_axes * rotation("y", p["casterAngle"]) * rotation("z", steer)

    centre = Point(origin, pitched, sp.Matrix([side * p["plateOffset"], 0, 0]))
    pivot = centre.moved(plate_axes, sp.Matrix([0, 0, -p["pivotDrop"]]))
    skate = pivot.moved(caster_axes, sp.Matrix([-p["casterTrail"], 0, -p["casterDrop"]]))
    plate = Body(f"{name}-plate", plate_frame, centre, p["plateMass"],
                 prism(p["plateMass"], p["plateLength"], p["plateWidth"], p["plateThickness"]))
    caster = Body(f"{name}-caster", caster_frame, skate, p["casterMass"],
                  disc_about_y(p["casterMass"], p["wheelRadius"]))
    return plate, caster, caster_axes * sp.Matrix([0, 1, 0])


def model() -> Model:
    pitched = Frame.world(q).turned("z", theta, q).turned("y", psi, q)
    rod = Body("rod", pitched.turned("x", alpha, q), Point(sp.Matrix([X, Y, Z]), pitched, sp.zeros(3, 1)),
               p["rodMass"], cylinder_along_x(p["rodMass"], p["rodLength"], p["rodRadius"]))
    front_plate, front_caster, front_axle = half("front", 1, alpha + alpha_fp, theta_fc, pitched)
    back_plate, back_caster, back_axle = half("back", -1, alpha + alpha_bp, theta_bc, pitched)
    bodies = (rod, front_plate, back_plate, front_caster, back_caster)

    twist, twist_dot = alpha_fp - alpha_bp, v[6] - v[7]
    V = potential(bodies, p["gravity"]) + p["torsionStiffness"] * twist**2 / 2
    equations = from_bodies(bodies, V, q, v)
    losses = sp.zeros(10, 1)
    losses[6] = -p["torsionDamping"] * twist_dot - p["jointDamping"] * v[6]
    losses[7] = p["torsionDamping"] * twist_dot - p["jointDamping"] * v[7]
    losses[8] = -p["casterDamping"] * v[8]
    losses[9] = -p["casterDamping"] * v[9]

    skates = ((front_caster.centre, front_axle), (back_caster.centre, back_axle))
    up = pitched.R.T * sp.Matrix([0, 0, 1])
    across = pitched.R.T * sp.Matrix([0, 1, 0])
    vertical = [velocity_row(up, point, q) for point, _ in skates]
    heights = sp.Matrix([point.position()[2] for point, _ in skates])
    lateral = [velocity_row(axle, point, q) for point, axle in skates]
    world_y = [velocity_row(across, point, q) for point, _ in skates]

    def rows(sideways):
        return sp.Matrix.vstack(sideways[0], vertical[0], sideways[1], vertical[1])

    return Model(
        id="ripstik", title="the RipStik", q=q, v=v, parameters=tuple(p.values()),
        equations=Equations(equations.M, equations.h + losses),
        kinetic=kinetic(bodies, q, v), potential=V, bodies=bodies,
        constraints=(Constraints("rolling", rows(lateral), heights, (1, 3)),
                     Constraints("report", rows(world_y), heights, (1, 3))),
        extra_forces=(("wheelDrag", wheel_drag(skates, pitched)),),
    )


def wheel_drag(skates, pitched) -> sp.Matrix:
    """Viscous drag at each skate along its horizontal heading e_y x z, normalised.

    Kept apart: the heading has no direction where a skate lies flat, and a board without drag
    must not stumble over that.
    """
    force = sp.zeros(10, 1)
    for point, axle in skates:
        e = pitched.R * axle
        heading = sp.Matrix([e[1], -e[0], 0]) / sp.sqrt(e[0] ** 2 + e[1] ** 2)
        row = velocity_row(pitched.R.T * heading, point, q)
        force -= p["wheelDrag"] * row.T * (row * v)
    return force
