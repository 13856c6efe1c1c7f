"""M, h and constraint rows of a tree of frames, by recursion with named intermediate results.

The same equations as `euler_lagrange.from_bodies`, written down in the order in which a person would compute
them by hand: velocities and accelerations outwards from the carrier, frame by frame, then forces projected on the
columns of the Jacobians. Every intermediate vector gets names for its entries, so that no expression is ever
written twice and nothing is differentiated: about half the operations. (Recursive Newton-Euler: Luh, Walker and
Paul, ASME J. Dyn. Syst. Meas. Control 102 (1980); Featherstone, Rigid Body Dynamics Algorithms, Springer 2008,
chapter 5.)

Here a = 0 in all accelerations: `beta` is the rate of the body-axes angular velocity, `bias` the acceleration of a
point, that are left when every q_ddot is zero.
"""

from dataclasses import dataclass

import sympy as sp

from .euler_lagrange import Equations
from .rotations import AXES, Frame, rotation


class Names:
    """Definitions (symbol, expression) in the order in which they can be computed."""

    def __init__(self):
        self.definitions = []

    def let(self, hint: str, value):
        """The same scalar or matrix with a new symbol for every entry that takes work to compute."""
        if isinstance(value, sp.MatrixBase):
            return value.applyfunc(lambda e: self.let(hint, e))
        if value.is_Atom or (-value).is_Atom:
            return value
        symbol = sp.Symbol(f"{hint}_{len(self.definitions)}", real=True)
        self.definitions.append((symbol, value))
        return symbol


@dataclass(frozen=True)
class Rotating:
    """In the frame's own axes: W (omega = W q_dot), omega and beta."""

    W: sp.Matrix
    omega: sp.Matrix
    beta: sp.Matrix

    def bias(self, r):
        """Acceleration of a point that is fixed at r in the frame, relative to the frame's origin."""
        return self.beta.cross(r) + self.omega.cross(self.omega.cross(r))


@dataclass(frozen=True)
class Moving:
    """A point relative to its base, in carrier axes: columns of d(velocity)/d(q_dot), velocity, bias."""

    W: sp.Matrix
    velocity: sp.Matrix
    bias: sp.Matrix


class Tree:
    def __init__(self, q: sp.Matrix, v: sp.Matrix, names: Names):
        self.q, self.v, self.names = q, v, names
        self._frames, self._points, self._carriers = {}, {}, {}

    def carrier(self, frame: Frame) -> sp.Matrix:
        """Its axes to world, named."""
        return self._kept(self._carriers, frame, lambda: self.names.let("R", frame.R))

    def rotating(self, frame: Frame) -> Rotating:
        return self._kept(self._frames, frame, lambda: self._rotating(frame))

    def moving(self, point) -> Moving:
        return self._kept(self._points, point, lambda: self._moving(point))

    def up(self, frame: Frame, x: sp.Matrix) -> sp.Matrix:
        """From the frame's axes to its parent's."""
        return rotation(frame.axis, frame.angle) * x

    def _kept(self, store, key, make):
        if id(key) not in store:
            store[id(key)] = (make(), key)
        return store[id(key)][0]

    def _rotating(self, frame: Frame) -> Rotating:
        n = len(self.q)
        if frame.parent is None:
            return Rotating(sp.zeros(3, n), sp.zeros(3, 1), sp.zeros(3, 1))
        parent, let = self.rotating(frame.parent), self.names.let
        down, axis = rotation(frame.axis, frame.angle).T, AXES[frame.axis]
        own = sp.Matrix([frame.angle]).jacobian(self.q)
        speed = (own * self.v)[0]
        carried = let("w", down * parent.omega)
        beta = let("b", down * parent.beta + carried.cross(axis) * speed)
        return Rotating(let("W", down * parent.W + axis * own), let("w", carried + axis * speed), beta)

    def _moving(self, point) -> Moving:
        """Outwards to inwards along the arms; each joint on the way turns what lies beyond it about its axis."""
        let, n = self.names.let, len(self.q)
        frame = point.arms[-1][0]
        r, bias, W = sp.zeros(3, 1), sp.zeros(3, 1), sp.zeros(3, n)
        while True:
            for _, offset in (arm for arm in point.arms if arm[0] is frame):
                r, bias = let("r", r + offset), let("c", bias + self.rotating(frame).bias(offset))
                slide = offset.jacobian(self.q)
                if slide != sp.zeros(3, n):
                    bias = let("c", bias + 2 * self.rotating(frame).omega.cross(slide * self.v))
                    W = W + slide
            if frame is point.carrier:
                break
            own = sp.Matrix([frame.angle]).jacobian(self.q)
            r, bias, W = let("r", self.up(frame, r)), let("c", self.up(frame, bias)), let("V", self.up(frame, W))
            W = let("V", W + AXES[frame.axis].cross(r) * own)
            frame = frame.parent
        turning = self.rotating(frame).W
        for k in range(n):
            W[:, k] += turning[:, k].cross(r)
        W = let("V", W)
        return Moving(W, let("u", W * self.v), bias)


def equations(tree: Tree, bodies, gravity) -> Equations:
    """M and h of free rigid bodies under gravity along -z; bodies' bases are linear in q."""
    n, let = len(tree.q), tree.names.let
    M, h = sp.zeros(n, n), sp.zeros(n, 1)
    for carrier, members in _by_carrier(bodies):
        base = members[0].centre.base
        P, R = base.jacobian(tree.q), tree.carrier(carrier)
        up = R.T * sp.Matrix([0, 0, 1])
        mass = sum(body.mass for body in members)
        coupling, force = sp.zeros(3, n), sp.zeros(3, 1)
        for body in members:
            if not _fixed(body.centre):
                moving = tree.moving(body.centre)
                weighted = let("Q", body.mass * moving.W)
                M += moving.W.T * weighted
                h -= weighted.T * let("F", moving.bias + gravity * up)
                coupling += body.mass * world_jacobian(tree, body.centre)
                force += body.mass * moving.bias
        M += mass * P.T * P + P.T * coupling + (P.T * coupling).T
        h -= P.T * (R * let("F", force) + mass * gravity * sp.Matrix([0, 0, 1]))
        for W, inertia, torque in [_fixed_masses(tree, carrier, members), *(_rotation(tree, b) for b in members)]:
            M += W.T * let("L", inertia * W)
            h -= W.T * let("T", torque)
    return Equations(M, h)


def world_jacobian(tree: Tree, point) -> sp.Matrix:
    """Relative Jacobian of a point in world axes, named once."""
    return tree._kept(tree._carriers, point, lambda: tree.names.let("J", tree.carrier(point.carrier) * tree.moving(point).W))


def row(tree: Tree, direction, point, turning=None):
    """(row, gamma) of `direction . v_point = 0`.

    direction: in carrier axes, fixed in the frame `turning`, or in the world if that is left out.
    """
    let = tree.names.let
    R, moving = tree.carrier(point.carrier), tree.moving(point)
    P = point.base.jacobian(tree.q)
    world = let("d", R * direction)
    fixed = all(e.is_number for e in world)
    relative = world.T * world_jacobian(tree, point) if fixed else direction.T * moving.W
    gamma = direction.dot(moving.bias)
    if turning is not None:
        frame, in_frame = turning
        rate = tree.rotating(frame).omega.cross(in_frame)
        while frame is not point.carrier:
            rate = let("e", tree.up(frame, rate))
            frame = frame.parent
        gamma += rate.dot(moving.velocity + R.T * (P * tree.v))
    return world.T * P + relative, gamma


def _fixed(point) -> bool:
    return all(frame is point.carrier for frame, _ in point.arms)


def _by_carrier(bodies):
    """Bodies that hang on the same carrier: [(carrier, bodies)]."""
    groups = {}
    for body in bodies:
        groups.setdefault(id(body.centre.carrier), (body.centre.carrier, []))[1].append(body)
    return list(groups.values())


def _fixed_masses(tree: Tree, carrier, members):
    """Masses fixed in the carrier, as one inertia about its origin, about which they must balance."""
    offsets = [(b.mass, b.centre.offset) for b in members if _fixed(b.centre)]
    if sum((m * o for m, o in offsets), sp.zeros(3, 1)) != sp.zeros(3, 1):
        raise ValueError("bodies fixed in a carrier must balance about its origin")
    inertia = sum((m * (o.dot(o) * sp.eye(3) - o * o.T) for m, o in offsets), sp.zeros(3, 3))
    axes = tree.rotating(carrier)
    return axes.W, inertia, inertia * axes.beta + axes.omega.cross(inertia * axes.omega)


def _rotation(tree: Tree, body):
    """W, inertia and torque of a body in its own axes, or in its parent's where it spins about an axis of symmetry."""
    frame, inertia = body.frame, body.inertia
    axes = tree.rotating(frame)
    first, second = [inertia[i, i] for i in range(3) if AXES[frame.axis][i] == 0]
    if inertia.is_diagonal() and first == second:
        spin = AXES[frame.axis] * sp.Matrix([frame.angle]).jacobian(tree.q)
        parent = tree.rotating(frame.parent)
        momentum = inertia * (parent.omega + spin * tree.v)
        return parent.W + spin, inertia, inertia * parent.beta + parent.omega.cross(momentum)
    return axes.W, inertia, inertia * axes.beta + axes.omega.cross(inertia * axes.omega)
