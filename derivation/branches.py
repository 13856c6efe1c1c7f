"""A tree of bodies in the axes of the frame that carries it: joints, rotors, motions of points, inertias and torques.

`bias` is what is left of an acceleration where every unknown of `composite` is zero. A point's motion is gathered from its end
inwards, joint by joint, relative to the frame that the joint turns on. A rotor is a body that turns about its own axis of
symmetry at the end of a branch.
"""

from dataclasses import dataclass, field

import sympy as sp

from .rotations import AXES
from .vectors import AXIS, Axes, Vector, dot


@dataclass(eq=False)
class Joint:
    """A frame that turns about one of its axes: rate of its angle; bodies further out."""

    frame: object
    rate: object
    axis: Vector
    bodies: list = field(default_factory=list)


@dataclass
class Spot:
    """A point: place, velocity and bias relative to the carrier's origin, and velocity by each joint's unit rate."""

    place: Vector
    velocity: Vector
    bias: Vector
    arms: dict
    anchors: dict  # a place on each joint's axis


class Sum:
    """Adds what depends on parameters alone apart, so that it can be prepared."""

    def __init__(self, tape):
        self.fixed = self.moving = tape.const(0)
        self.tape = tape

    def add(self, x):
        if self.tape.fixed[x.index]:
            self.fixed = self.fixed + x
        else:
            self.moving = self.moving + x
        return self

    @property
    def total(self):
        return self.moving + self.fixed


class Tree:
    def __init__(self, record, q, v, bodies, gravity):
        self.record, self.tape, self.q, self.v = record, record.tape, q, v
        self.bodies, carrier = bodies, bodies[0].centre.carrier
        self.axes = Axes(record, carrier)
        self.base = bodies[0].centre.base
        if any(b.centre.carrier is not carrier or b.centre.base != self.base for b in bodies):
            raise ValueError("a tree has one carrier")
        self.gravity = record(gravity)
        self.zero = self.axes.vector([0, 0, 0])
        self._carry(carrier)
        self._find_joints()
        self._spots, self._angular = {}, {}

    def _rate(self, angle):
        return self.record((sp.Matrix([angle]).jacobian(self.q) * self.v)[0])

    def _carry(self, carrier):
        """The carrier's own joints, in its axes: omega and beta, world's axes."""
        chain, frame = [], carrier
        while frame.parent is not None:
            chain.insert(0, frame)
            frame = frame.parent
        self.world = [self.axes.vector(AXES[axis]) for axis in AXIS]
        turning = []
        for frame in chain:
            self.world = [self.axes.back(frame, x) for x in self.world]
            turning = [(step, self.axes.back(frame, x)) for step, x in turning]
            turning.append((frame, self.axes.vector(AXES[frame.axis])))
        self.omega, self.beta, self.carrying = self.zero, self.zero, []
        for frame, axis in turning:
            joint = Joint(frame, self._rate(frame.angle), axis)
            turned = joint.rate * axis
            self.beta = self.beta + self.axes.cross(self.omega, turned)
            self.omega = self.omega + turned
            self.carrying.append(joint)
        self.up = self.world[2]

    def _find_joints(self):
        """Branches, each from its end inwards, and rotors apart."""
        self.joints, self.rotors = [], {}
        by_frame = {}
        for body in self.bodies:
            for frame in self.outside(body.frame):
                if frame.angle.free_symbols & self.record.moving:
                    joint = by_frame.setdefault(id(frame), Joint(frame, self._rate(frame.angle), self.axes.unit(frame, frame.axis)))
                    joint.bodies.append(body)
        for joint in by_frame.values():
            if self._is_rotor(joint):
                self.rotors[id(joint.bodies[0])] = joint
            else:
                self.joints.append(joint)
        depth = lambda joint: len(self.outside(joint.frame))
        roots = [joint for joint in self.joints if not any(other is not joint and other.frame in self.outside(joint.frame) for other in self.joints)]
        self.joints = [joint for root in roots for joint in sorted((j for j in self.joints if root.frame in self.outside(j.frame)), key=depth, reverse=True)]

    def outside(self, frame):
        """The frame and those that it hangs on, up to the carrier."""
        frames = []
        while frame is not self.axes.carrier:
            frames.append(frame)
            frame = frame.parent
        return frames

    def _is_rotor(self, joint) -> bool:
        """One body, turning about its axis of symmetry, its centre on it."""
        if len(joint.bodies) != 1:
            return False
        body, axis = joint.bodies[0], AXIS.index(joint.frame.axis)
        others = [body.inertia[k, k] for k in range(3) if k != axis]
        return body.frame is joint.frame and body.inertia.is_diagonal() and others[0] == others[1] and all(f is not joint.frame for f, _ in body.centre.arms)

    def joints_of(self, frame):
        """Joints on the way from a frame inwards."""
        own = self.outside(frame)
        return [joint for joint in self.joints if any(joint.frame is f for f in own)]

    def angular(self, frame):
        """(omega, beta) of a frame."""
        if frame is self.axes.carrier:
            return self.omega, self.beta
        if id(frame) not in self._angular:
            omega, beta = self.angular(frame.parent)
            for joint in self.joints:
                if joint.frame is frame:
                    turned = joint.rate * joint.axis
                    omega, beta = omega + turned, beta + joint.rate * self.axes.cross(omega, joint.axis)
            self._angular[id(frame)] = ((omega, beta), frame)
        return self._angular[id(frame)][0]

    def spot(self, point) -> Spot:
        if id(point) not in self._spots:
            self._spots[id(point)] = (self._spot(point), point)
        return self._spots[id(point)][0]

    def _spot(self, point) -> Spot:
        parts = {}
        for frame, offset in point.arms:
            for inner, own in self.axes.parts(frame, [self.record(x) for x in offset]):
                known = parts.get(id(inner), (inner, self.zero))[1]
                parts[id(inner)] = (inner, [a + b for a, b in zip(known, own)])
        cross = self.axes.cross
        place, velocity, bias, arms, inner = self.zero, self.zero, self.zero, {}, []
        for frame in [*self.outside(point.arms[-1][0]), self.axes.carrier]:
            if id(frame) in parts:
                own = self.axes.constant(*parts[id(frame)])
                place = own if place.is_zero() else place + own
                inner.append((frame, own))
            for joint in self.joints:
                if joint.frame is not frame:
                    continue
                arm = arms[joint] = cross(joint.axis, place)
                turned = joint.rate * arm
                if velocity.is_zero():
                    bias = joint.rate * joint.rate * cross(joint.axis, arm)
                else:
                    bias = bias + joint.rate * cross(joint.axis, velocity + velocity + turned)
                velocity = velocity + turned
        anchors = {joint: self.total(own for frame, own in inner if not any(f is joint.frame for f in self.outside(frame))) for joint in arms}
        turning = cross(self.omega, place)
        bias = bias + cross(self.beta, place) + cross(self.omega, turning + (velocity + velocity))
        return Spot(place, turning + velocity, bias, arms, anchors)

    def total(self, vectors):
        total = self.zero
        for vector in vectors:
            total = total + vector
        return total

    def inertia(self, body):
        """(c, [(k, axis)]): the body's inertia c 1 + sum of k axis axis^T; of a rotor only what is across its axis."""
        moments = [self.record(body.inertia[k, k]) for k in range(3)]
        differ = lambda a, b: self.record(sp.together(body.inertia[a, a] - body.inertia[b, b]))
        if not body.inertia.is_diagonal():
            raise ValueError(f"{body.name}: moments of inertia about principal axes are needed")
        if id(body) in self.rotors:
            axis = AXIS.index(body.frame.axis)
            across = moments[(axis + 1) % 3]
            return across, [(-across, self.axes.unit(body.frame, AXIS[axis]))]
        for axis in range(3):
            a, b = (axis + 1) % 3, (axis + 2) % 3
            if moments[a].index == moments[b].index:
                return moments[a], [(differ(axis, a), self.axes.unit(body.frame, AXIS[axis]))]
        return moments[2], [(differ(k, 2), self.axes.unit(body.frame, AXIS[k])) for k in (0, 1)]

    def torque(self, body):
        """Rate of the body's angular momentum that is left where every unknown is zero; a rotor's, as far as it is across its axis."""
        if id(body) in self.rotors:
            joint = self.rotors[id(body)]
            omega, beta = self.angular(body.frame.parent)
            along = self.record(body.inertia[AXIS.index(body.frame.axis), AXIS.index(body.frame.axis)])
            gyroscopic = along * (dot(joint.axis, omega) + joint.rate) * self.axes.cross(omega, joint.axis)
            return gyroscopic if body.frame.parent is self.axes.carrier else gyroscopic + self._turning(self.inertia(body), omega, beta)
        return self._turning(self.inertia(body), *self.angular(body.frame))

    def _turning(self, inertia, omega, beta):
        """I beta + omega x I omega of I = c 1 + sum of k axis axis^T."""
        cross, (c, terms) = self.axes.cross, inertia
        if len(terms) > 1:
            J = matrix(self.tape, [inertia])
            return times(J, beta) + cross(omega, times(J, omega))
        ((k, axis),) = terms
        changing = dot(axis, beta) * axis + dot(axis, omega) * cross(omega, axis)
        if k.index == c.index:
            return c * (beta + changing)
        return c * (beta - changing) if k.index == (-c).index else c * beta + k * changing

    def carried(self):
        """(J, torque) of what is fixed in the carrier: masses, which must balance, and rotors that hang on it."""
        fixed = [(self.record(b.mass), self.spot(b.centre).place) for b in self.bodies if self.is_fixed(b)]
        balance = self.total(mass * place for mass, place in fixed)
        if not balance.is_zero():
            raise ValueError("masses fixed in a carrier must balance about its origin")
        on_carrier = [self.inertia(b) for b in self.bodies if id(b) in self.rotors and b.frame.parent is self.axes.carrier]
        J = matrix(self.tape, on_carrier, fixed)
        if any(value.number != 0 for (i, j), value in J.items() if i != j):
            return J, times(J, self.beta) + self.axes.cross(self.omega, times(J, self.omega))
        x, y, z = (J[i, i] for i in range(3))
        for k, axis, (a, b) in ((x, "x", (y, z)), (y, "y", (z, x)), (z, "z", (x, y))):
            if a.index == b.index:
                return J, self._turning((a, [(k - a, self.axes.unit(self.axes.carrier, axis))]), self.omega, self.beta)
        return J, times(J, self.beta) + self.axes.cross(self.omega, times(J, self.omega))

    def is_fixed(self, body) -> bool:
        return all(frame is self.axes.carrier for frame, _ in body.centre.arms)


def matrix(tape, inertias, masses=()):
    """Sum of c 1 + k axis axis^T, and of masses (mass, place) about the origin; {(i, j): value} for i <= j."""
    sums = {(i, j): Sum(tape) for i in range(3) for j in range(i, 3)}
    for c, terms in inertias:
        for i in range(3):
            sums[i, i].add(c)
        for k, axis in terms:
            scaled = k * axis
            for i, j in sums:
                sums[i, j].add(scaled[i] * axis[j])
    for mass, place in masses:
        weighted = mass * place
        squares = [weighted[i] * place[i] for i in range(3)]
        for i, j in sums:
            if i == j:
                sums[i, i].add(squares[(i + 1) % 3] + squares[(i + 2) % 3])
            else:
                sums[i, j].add(-(weighted[i] * place[j]))
    return {at: s.total for at, s in sums.items()}


def entry(J, i, j):
    return J[min(i, j), max(i, j)]


def times(J, x) -> Vector:
    return Vector(entry(J, i, 0) * x[0] + entry(J, i, 1) * x[1] + entry(J, i, 2) * x[2] for i in range(3))
