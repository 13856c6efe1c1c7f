"""The Whipple bicycle: two knife-edge wheels, a rear frame with a rigid rider, a front frame, on level ground.

Parameters are those of Meijaard, Papadopoulos, Ruina and Schwab, "Linearized dynamics equations for the balance and
steer of a bicycle: a benchmark and review", Proc. R. Soc. A 463 (2007), Table 1, in that paper's axes (x forward,
y to the right, z down, origin at the rear contact of the upright bicycle). They are turned into this program's axes (x
forward, y to the left, z up) here, at the door: y and z change sign, and with them the products of inertia I_xz.
"""

import sympy as sp

from . import recursion
from .constraints import Constraints
from .energy import Body, Point, kinetic, potential
from .euler_lagrange import Equations
from .latex import latex
from .model import Model, coordinates, on_level_ground
from .notation import Notation, Row, Term, cross, dot, mark, unit
from .recursion import Names, Tree
from .rotations import Frame, rotation
from .tidy import tidy

q, v = coordinates("x y yaw roll pitch steer rear_spin front_spin")
x, y, yaw, roll, pitch, steer, rear_spin, front_spin = q

PARAMETERS = (
    "wheelbase trail steerAxisTilt gravity "
    "rearRadius rearMass rearIxx rearIyy "
    "frameX frameZ frameMass frameIxx frameIyy frameIzz frameIxz "
    "forkX forkZ forkMass forkIxx forkIyy forkIzz forkIxz "
    "frontRadius frontMass frontIxx frontIyy"
)
p = {name: sp.Symbol(name, real=True) for name in PARAMETERS.split()}

EX, EY, EZ = (sp.Matrix(e) for e in ([1, 0, 0], [0, 1, 0], [0, 0, 1]))


def inertia_up(name: str) -> sp.Matrix:
    """Inertia given with z down, about axes with z up: only I_xz changes sign."""
    xx, yy, zz, xz = (p[f"{name}I{axes}"] for axes in ("xx", "yy", "zz", "xz"))
    return sp.Matrix([[xx, 0, -xz], [0, yy, 0], [-xz, 0, zz]])


def disc(name: str) -> sp.Matrix:
    return sp.diag(p[f"{name}Ixx"], p[f"{name}Iyy"], p[f"{name}Ixx"])


class Bicycle:
    """Frames and bodies. Lean and steer to the right are positive, a wheel that rolls forward spins positively."""

    def __init__(self, q: sp.Matrix = q, v: sp.Matrix = v):
        self.q, self.v = q, v
        self.heading = Frame.world(q).turned("z", yaw, q)
        self.leaned = self.heading.turned("x", roll, q)
        self.frame = self.leaned.turned("y", pitch, q)
        tilted = self.frame.turned("y", -p["steerAxisTilt"], q)
        self.fork = tilted.turned("z", -steer, q)
        self.rear_wheel = self.frame.turned("y", rear_spin, q)
        self.front_wheel = self.fork.turned("y", front_spin, q)

        contact = Point.fixed(on_level_ground(x, y), self.heading, sp.zeros(3, 1))
        self.rear_hub = contact.moved(self.leaned, sp.Matrix([0, 0, p["rearRadius"]]))
        # Where the steering axis meets the ground, under the upright bicycle; it belongs to both frames.
        on_axis = self.rear_hub.moved(self.frame, sp.Matrix([p["wheelbase"] + p["trail"], 0, -p["rearRadius"]]))
        self.front_hub = on_axis.moved(self.fork, self.in_fork([-p["trail"], 0, p["frontRadius"]]))
        frame_centre = self.rear_hub.moved(self.frame, sp.Matrix([p["frameX"], 0, -p["frameZ"] - p["rearRadius"]]))
        fork_centre = on_axis.moved(self.fork, self.in_fork([p["forkX"] - p["wheelbase"] - p["trail"], 0, -p["forkZ"]]))

        turn = rotation("y", p["steerAxisTilt"])
        self.bodies = (
            Body("rear-wheel", self.rear_wheel, self.rear_hub, p["rearMass"], disc("rear")),
            Body("rear-frame", self.frame, frame_centre, p["frameMass"], inertia_up("frame")),
            Body("front-frame", self.fork, fork_centre, p["forkMass"], turn * inertia_up("fork") * turn.T),
            Body("front-wheel", self.front_wheel, self.front_hub, p["frontMass"], disc("front")),
        )

    @staticmethod
    def in_fork(offset) -> sp.Matrix:
        """An offset given in the axes of the upright bicycle, in those of the fork."""
        return rotation("y", p["steerAxisTilt"]) * sp.Matrix(offset)

    def shown(self):
        """Frames that are drawn: the front frame's axes are those of the upright bicycle at zero steer, its origin the hub."""
        upright_fork = self.fork.turned("y", p["steerAxisTilt"], self.q)
        places = ((self.rear_wheel, self.rear_hub), (self.frame, self.rear_hub), (upright_fork, self.front_hub), (self.front_wheel, self.front_hub))
        return tuple(Body(b.name, frame, point, b.mass, b.inertia) for b, (frame, point) in zip(self.bodies, places))


class Contact:
    """The lowest material point of a wheel, in heading axes; rates are those of the world.

    `axes` carry the wheel without its spin, axle along y. With e the axle, s = sqrt(1 - e_z^2), u = (z - e_z e) / s points
    from the contact to the hub, f = e x z / s along the wheel's heading.
    """

    def __init__(self, tree: Tree, hub: Point, axes: Frame, spin, radius):
        let, q, v = tree.names.let, tree.q, tree.v
        heading, spin_row = hub.carrier, sp.Matrix([spin]).jacobian(q)
        spin_rate = (spin_row * v)[0]
        own, moving = tree.rotating(axes), tree.moving(hub)
        up = let("A", axes.relative_to(heading))
        e = up * EY
        level = let("s", sp.sqrt(1 - e[2] ** 2))
        u, self.forward = let("u", (EZ - e[2] * e) / level), let("f", e.cross(EZ) / level)
        e_rate = let("e", (up * own.omega).cross(e))
        level_rate = let("s", -e[2] * e_rate[2] / level)
        u_rate = let("u", (-e_rate[2] * e - e[2] * e_rate - level_rate * u) / level)
        self.forward_rate = let("f", (e_rate.cross(EZ) - level_rate * self.forward) / level)

        turning = let("w", up * own.W + e * spin_row)
        omega, beta = let("w", up * own.omega + spin_rate * e), let("b", up * own.beta + spin_rate * e_rate)
        down = -radius * u
        W = moving.W.copy()
        for k in range(len(q)):
            W[:, k] += turning[:, k].cross(down)
        base = tree.carrier(heading).T * hub.base.jacobian(q)
        self.W = let("V", base + W)
        self.velocity = let("u", base * v + moving.velocity + omega.cross(down))
        self.bias = let("c", moving.bias + beta.cross(down) + omega.cross(-radius * u_rate))
        self.height = hub.position()[2] - radius * sp.sqrt(1 - (axes.relative_to(heading) * EY)[2] ** 2)

    def row(self, direction, rate):
        """(row, gamma) of `direction . velocity = 0` for a direction that turns at `rate`."""
        return direction.T * self.W, direction.dot(self.bias) + rate.dot(self.velocity)

    def rows(self):
        """No slip along the wheel's heading, none across it."""
        return [self.row(self.forward, self.forward_rate), self.row(EZ.cross(self.forward), EZ.cross(self.forward_rate))]


def rolling(b: Bicycle, tree: Tree) -> Constraints:
    """Four nonholonomic rows, rear then front, along and across; then the height of the front contact."""
    rear = Contact(tree, b.rear_hub, b.frame, rear_spin, p["rearRadius"])
    front = Contact(tree, b.front_hub, b.fork, front_spin, p["frontRadius"])
    rows = [*rear.rows(), *front.rows(), front.row(EZ, sp.zeros(3, 1))]
    return Constraints("rolling", sp.Matrix.vstack(*[r for r, _ in rows]), sp.Matrix([front.height]), (4,), sp.Matrix([g for _, g in rows]))


class PrintedContact:
    """The rows of one wheel in words of vectors, and entry by entry in the axle's components e1, e2, e3 in heading axes."""

    def __init__(self, b: Bicycle, wheel: Body, axes: Frame, carrier: str, radius: str, letter: str):
        self.side, self.heading = wheel.name.split("-")[0], b.heading
        e = axes.relative_to(b.heading) * EY
        names = sp.symbols([f"e{k}_{letter}" for k in (1, 2, 3)] + [f"s_{letter}"], real=True)
        short = [value.is_Atom or (-value).is_Atom or value.func in (sp.sin, sp.cos) for value in e]
        self.e = sp.Matrix([value if plain else name for name, value, plain in zip(names, e, short)])
        self.s = names[3]
        self.defined = (*((name, f"e_{letter}{k + 1}", value) for k, (name, value, plain) in enumerate(zip(names, e, short)) if not plain),
                        (self.s, f"s_{letter}", sp.sqrt(1 - self.e[2] ** 2)))
        self.marks = {f"axle.{wheel.name}": rf"\mathbf e_{{{letter}}}", f"up.{wheel.name}": rf"\mathbf u_{{{letter}}}",
                      f"heading.{wheel.name}": rf"\mathbf f_{{{letter}}}", f"contact.{wheel.name}": rf"\dot{{\mathbf c}}_{{{letter}}}"}
        self.wheel, self.axes, self.radius, self.q, self.v = wheel, axes, p[radius], b.q, b.v
        self.in_words(carrier)

    def in_words(self, carrier: str):
        name, axle = self.wheel.name, self.axes.R * EY
        s = sp.sqrt(1 - axle[2] ** 2)
        e, u, f, c = (mark(f"{kind}.{name}") for kind in ("axle", "up", "heading", "contact"))
        root = rf"\sqrt{{1 - ({e} \cdot \mathbf e_z)^2}}"
        up, forward = (EZ - axle[2] * axle) / s, axle.cross(EZ) / s
        hub = self.wheel.centre.jacobian(self.q) * self.v
        velocity = hub - self.radius * (self.wheel.frame.R * self.wheel.frame.W * self.v).cross(up)
        made = [
            (e, Term(rf"{mark(f'R.{carrier}')}\, \mathbf e_y", axle), axle),
            (u, Term(rf"\dfrac{{\mathbf e_z - ({e} \cdot \mathbf e_z)\, {e}}}{{{root}}}", up), up),
            (f, Term(rf"\dfrac{{{e} \times \mathbf e_z}}{{{root}}}", forward), forward),
            (c, Term(rf"{mark(f'v.{name}')} - {latex(self.radius)}\, ({mark(f'R.{name}')}\, {mark(f'omega.{name}')}) \times {u}", velocity), velocity),
        ]
        self.formulas = tuple((f"{name}.{kind}", left, right, truth) for kind, (left, right, truth) in zip(("axle", "up", "heading", "contact"), made))
        velocity = Term(c, velocity)
        self.vanishing = (dot(Term(f, forward), velocity), dot(cross(unit("z"), Term(f, forward)), velocity), dot(unit("z"), velocity))

    def rows(self):
        """Entry by entry. With f x e = u, e x u = f and g = z x f, a turning w of the wheel's axes moves the contact by
        f . (w x -r u) = -r e . w, g . (w x -r u) = r (e2 w1 - e1 w2) and z . (w x -r u) = r e3 f . w; spinning, by -r f."""
        hub, spin = self.wheel.centre, sp.Matrix([self.wheel.frame.angle]).jacobian(self.q)
        e, s, r = self.e, self.s, self.radius
        f, g = sp.Matrix([e[1], -e[0], 0]) / s, sp.Matrix([e[0], e[1], 0]) / s
        turning = (self.axes.relative_to(self.heading) * self.axes.W).applyfunc(tidy)
        moving = (self.heading.R.T * hub.base.jacobian(self.q) + hub.relative_jacobian(self.q)).applyfunc(tidy)
        along = (f.T * moving).applyfunc(sp.factor_terms) - r * (e.T * turning + spin)
        across = (g.T * moving).applyfunc(sp.factor_terms) + r * (e[1] * turning.row(0) - e[0] * turning.row(1))
        vertical = moving.row(2) + r * e[2] * (f.T * turning)
        return tuple(Row(f"{self.side}.{title}", vanishes, row) for title, vanishes, row in zip(("along", "across", "vertical"), self.vanishing, (along, across, vertical)))


COORDINATE_SYMBOLS = "x y ψ φ θ δ θ_R θ_F"
PARAMETER_SYMBOLS = "w c λ g r_R m_R I_Rxx I_Ryy x_B z_B m_B I_Bxx I_Byy I_Bzz I_Bxz x_H z_H m_H I_Hxx I_Hyy I_Hzz I_Hxz r_F m_F I_Fxx I_Fyy"
SUBSCRIPTS = {"rear-wheel": "R", "rear-frame": "B", "front-frame": "H", "front-wheel": "F"}


def notation(b: Bicycle, symbols: str, subscripts: dict[str, str], losses) -> Notation:
    rear_wheel, front_wheel = b.bodies[0], b.bodies[3]
    rear = PrintedContact(b, rear_wheel, b.frame, "rear-frame", "rearRadius", "R")
    front = PrintedContact(b, front_wheel, b.fork, "front-frame", "frontRadius", "F")
    return Notation(
        symbols, subscripts, frames=(("h", b.heading), ("l", b.leaned)),
        masses=b.bodies, rows={"rolling": (*rear.rows()[:2], *front.rows())}, contacts=(*rear.formulas, *front.formulas),
        defined=(*rear.defined, *front.defined), marks=rear.marks | front.marks, heights=("z_{F}",), losses=losses,
    )


def modelled(id: str, title: str, b: Bicycle, parameters, symbols: str, subscripts: dict[str, str], springs=sp.Integer(0), losses=None) -> Model:
    """`springs`: an energy beside gravity's; `losses`: forces that no Lagrangian gives, n x 1."""
    names = Names()
    tree = Tree(b.q, b.v, names)
    free = recursion.equations(tree, b.bodies, p["gravity"])
    return Model(
        id=id, title=title, q=b.q, v=b.v, parameters=tuple(parameters),
        equations=Equations(free.M, free.h - sp.Matrix([springs]).jacobian(b.q).T + (sp.zeros(len(b.q), 1) if losses is None else losses)),
        kinetic=kinetic(b.bodies, b.q, b.v), potential=potential(b.bodies, p["gravity"]) + springs,
        bodies=b.shown(), constraints=(rolling(b, tree),), definitions=tuple(names.definitions), notation=notation(b, symbols, subscripts, losses),
    )


def model() -> Model:
    return modelled("bicycle", "the Whipple bicycle", Bicycle(), p.values(), f"{COORDINATE_SYMBOLS} {PARAMETER_SYMBOLS}", SUBSCRIPTS)
