"""Equations of motion of a tree of bodies, all in the axes of the frame that carries it.

The unknowns are those in which the equations are short, not the rates of the coordinates: the acceleration of the carrier's
origin in the carrier's axes, the acceleration of each joint's own angle, and, for a rotor (a body that turns about its own
axis of symmetry at the end of a branch), the whole angular acceleration about that axis, in which it is coupled to nothing.
`Unknowns` turns them into accelerations of the coordinates and generalized forces into theirs.

Composite rigid bodies (Featherstone, Rigid Body Dynamics Algorithms, Springer 2008, chapter 6) for the mass matrix, Newton and
Euler's equations for the forces. `bias` is what is left of an acceleration where every unknown is zero. A point's motion is
gathered from its end inwards, joint by joint, relative to the frame that the joint turns on.
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
            for frame in self._outside(body.frame):
                if frame.angle.free_symbols & self.record.moving:
                    joint = by_frame.setdefault(id(frame), Joint(frame, self._rate(frame.angle), self.axes.unit(frame, frame.axis)))
                    joint.bodies.append(body)
        for joint in by_frame.values():
            if self._is_rotor(joint):
                self.rotors[id(joint.bodies[0])] = joint
            else:
                self.joints.append(joint)
        depth = lambda joint: len(self._outside(joint.frame))
        roots = [joint for joint in self.joints if not any(other is not joint and other.frame in self._outside(joint.frame) for other in self.joints)]
        self.joints = [joint for root in roots for joint in sorted((j for j in self.joints if root.frame in self._outside(j.frame)), key=depth, reverse=True)]

    def _outside(self, frame):
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
        own = self._outside(frame)
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
        for frame in [*self._outside(point.arms[-1][0]), self.axes.carrier]:
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
        anchors = {joint: self._sum(own for frame, own in inner if not any(f is joint.frame for f in self._outside(frame))) for joint in arms}
        turning = cross(self.omega, place)
        bias = bias + cross(self.beta, place) + cross(self.omega, turning + (velocity + velocity))
        return Spot(place, turning + velocity, bias, arms, anchors)

    def _sum(self, vectors):
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
        balance = self._sum(mass * place for mass, place in fixed)
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


class Dynamics:
    """M, h, Omega and gamma in the tree's unknowns: joints from the ends of the branches inwards, base, the carrier's own joints.

    forces: generalized forces by coordinate, as values. rows: [(direction, point)] of `direction . velocity = 0`, direction a
    frame's axis as (frame, axis) or an axis of the world by its name.
    """

    def __init__(self, tree: Tree, forces, rows):
        self.tree, self.tape = tree, tree.tape
        self.joints, self.carrying = tree.joints, tree.carrying
        self.count = len(self.joints) + 3 + len(self.carrying)
        self.unknowns = Unknowns(tree)
        self.base_velocity = self.unknowns.base_rates(tree.v)
        self._bodies()
        self.M = self._mass_matrix()
        self.h = [q + h for q, h in zip(self.unknowns.forces(forces), self._bias_forces())]
        self.rows = [self._row(direction, point) for direction, point in rows]
        self.Omega, self.gamma, self.slip = ([row[k] for row in self.rows] for k in range(3))

    def _bodies(self):
        tree = self.tree
        self.mass, self.force, self.moment, self.torque = {}, {}, {}, {}
        for body in tree.bodies:
            self.torque[body.name] = self.moment[body.name] = tree.torque(body)
            if tree.is_fixed(body):
                continue
            self.mass[body.name] = mass = tree.record(body.mass)
            spot = tree.spot(body.centre)
            F = self.force[body.name] = mass * (spot.bias + tree.gravity * tree.up)
            self.moment[body.name] = tree.axes.cross(spot.place, F) + self.torque[body.name]

    def _single(self, joint):
        """The body of a joint that carries no more than one and whose centre moves with it."""
        return joint.bodies[0] if len(joint.bodies) == 1 and not self.tree.is_fixed(joint.bodies[0]) else None

    def _start(self, joint):
        """Velocity, by the joint's unit rate, of what is at the carrier's origin."""
        spots = [self.tree.spot(b.centre) for b in joint.bodies if not self.tree.is_fixed(b)]
        return -self.tree.axes.cross(joint.axis, spots[0].anchors[joint]) if spots else self.tree.zero

    def _composite(self, bodies):
        """(mass, mass times place, J about the origin)."""
        tree = self.tree
        moving = [(self.mass[b.name], tree.spot(b.centre).place) for b in bodies if not tree.is_fixed(b)]
        first = tree._sum(mass * place for mass, place in moving)
        total = self.tape.const(0)
        for mass, _ in moving:
            total = total + mass
        turning = [tree.inertia(b) for b in bodies if not (id(b) in tree.rotors and b.frame.parent is tree.axes.carrier)]
        return total, first, matrix(self.tape, turning, moving)

    def _momentum(self, joint):
        """(momentum, angular momentum about the origin) by the joint's unit rate."""
        tree, cross = self.tree, self.tree.axes.cross
        body = self._single(joint)
        if body is not None:
            spot = tree.spot(body.centre)
            p = self.mass[body.name] * spot.arms[joint]
            c, terms = tree.inertia(body)
            own = c * joint.axis
            for k, axis in terms:
                along = dot(axis, joint.axis)
                own = own if along.number == 0 else own + k * along * axis
            return p, cross(spot.place, p) + own, dot(spot.arms[joint], p) + dot(joint.axis, own)
        mass, first, J = self._composite(joint.bodies)
        start = self._start(joint)
        p, L = cross(joint.axis, first), times(J, joint.axis)
        if not start.is_zero():
            p, L = p + mass * start, L + cross(first, start)
        return p, L, dot(joint.axis, L) + dot(start, p)

    def _mass_matrix(self):
        tree, n, joints = self.tree, self.count, len(self.joints)
        zero = self.tape.const(0)
        M = [[zero] * n for _ in range(n)]

        def put(i, j, value):
            M[i][j] = M[j][i] = value

        for i, joint in enumerate(self.joints):
            p, L, own = self._momentum(joint)
            put(i, i, own)
            for j, other in enumerate(self.joints):
                if other is not joint and other.frame in _frames(tree, joint):
                    put(i, j, dot(other.axis, L) + dot(self._start(other), p))
            for k in range(3):
                put(i, joints + k, p[k])
            for j, carrying in enumerate(self.carrying):
                put(i, joints + 3 + j, dot(carrying.axis, L))
        total, first, J = self._whole()
        for k in range(3):
            put(joints + k, joints + k, total)
        for i, carrying in enumerate(self.carrying):
            p, L = tree.axes.cross(carrying.axis, first), times(J, carrying.axis)
            for k in range(3):
                put(joints + k, joints + 3 + i, p[k])
            for j in range(i, len(self.carrying)):
                put(joints + 3 + i, joints + 3 + j, dot(self.carrying[j].axis, L))
        return M

    def _whole(self):
        """Of all bodies, branch by branch, so that what a branch's own joint has is used again."""
        tree = self.tree
        branches = {}
        for body in tree.bodies:
            root = next((f for f in reversed(tree._outside(body.frame))), None)
            branches.setdefault(id(root), []).append(body)
        J, self.carried_torque = tree.carried()
        total = self.tape.const(0)
        for body in tree.bodies:
            total = total + tree.record(body.mass)
        sums = {at: Sum(self.tape).add(value) for at, value in J.items()}
        first = tree.zero
        for bodies in branches.values():
            _, place, part = self._composite(bodies)
            first = first + place
            for at, value in part.items():
                sums[at].add(value)
        return total, first, {at: s.total for at, s in sums.items()}

    def _bias_forces(self):
        tree = self.tree
        h = []
        for joint in self.joints:
            body = self._single(joint)
            if body is not None:
                arm = tree.spot(body.centre).arms[joint]
                h.append(-(dot(joint.axis, self.torque[body.name]) + dot(arm, self.force[body.name])))
                continue
            moment = tree._sum(self.moment[b.name] for b in joint.bodies)
            force = tree._sum(self.force[b.name] for b in joint.bodies if b.name in self.force)
            h.append(-(dot(joint.axis, moment) + dot(self._start(joint), force)))
        still = self.tape.const(0)
        for body in tree.bodies:
            still = still + tree.record(body.mass) if tree.is_fixed(body) else still
        force = tree._sum(self.force.values()) + still * tree.gravity * tree.up
        moment = tree._sum([tree._sum(self.moment[b.name] for b in bodies) for bodies in self._by_branch()]) + self.carried_torque
        return [*h, *(-f for f in force), *(-dot(c.axis, moment) for c in self.carrying)]

    def _by_branch(self):
        branches = {}
        for body in self.tree.bodies:
            frames = self.tree._outside(body.frame)
            branches.setdefault(id(frames[-1]) if frames else None, []).append(body)
        return branches.values()

    def _row(self, direction, point):
        """(row, gamma, velocity along the direction)."""
        tree, cross = self.tree, self.tree.axes.cross
        spot, rate = tree.spot(point), None
        if isinstance(direction, str):
            along = tree.world[AXIS.index(direction)]
        else:
            frame, axis = direction
            along = tree.axes.unit(frame, axis)
            rate = cross(tree.angular(frame)[0], along)
        moment = cross(spot.place, along)
        row = []
        for joint in self.joints:
            if joint not in spot.arms:
                row.append(self.tape.const(0))
            elif self._single(joint) is not None:
                row.append(dot(along, spot.arms[joint]))
            else:
                row.append(dot(joint.axis, moment) + dot(self._start(joint), along))
        row += list(along)
        row += [self.tape.const(0) if c.axis.same(along) else dot(c.axis, moment) for c in self.carrying]
        velocity = self.base_velocity + spot.velocity
        gamma = dot(along, spot.bias)
        return row, gamma if rate is None else gamma + dot(rate, velocity), dot(along, velocity)

    def height(self, point):
        """Of a point above the ground."""
        return self.unknowns.base_height() + dot(self.tree.up, self.tree.spot(point).place)


def _frames(tree, joint):
    return tree._outside(joint.frame)


class Unknowns:
    """Between the tree's unknowns and the coordinates."""

    def __init__(self, tree: Tree):
        self.tree = tree
        q = tree.q
        self.turning = [*tree.joints, *tree.carrying, *tree.rotors.values()]
        self.base = [i for i in range(len(q)) if q[i] in tree.base.free_symbols]
        self.angles = [i for i in range(len(q)) if i not in self.base]
        P = tree.base.jacobian([q[i] for i in self.base])
        if P != sp.eye(3)[:, :len(self.base)] or not (len(self.base) == 3 or all(c.frame.axis == "z" for c in tree.carrying)):
            raise ValueError("a tree's base is a place (x, y, z), or (x, y) where the carrier only turns about z")
        C = sp.Matrix([joint.frame.angle for joint in self.turning]).jacobian([q[i] for i in self.angles])
        self.inverse = C.inv()

    def _carried(self, x):
        """From the world's axes to the carrier's."""
        vector = Vector(x)
        for joint in self.tree.carrying:
            vector = self.tree.axes.back(joint.frame, vector)
        return vector

    def _padded(self, values):
        return [*values, *[self.tree.tape.const(0)] * (3 - len(values))]

    def base_rates(self, v):
        return self._carried(self._padded([self.tree.record(v[i]) for i in self.base]))

    def base_height(self):
        return self.tree.record(self.tree.base[2])

    def _rotor_parts(self, rotor):
        """[(joint, how much of its rate turns the rotor about the rotor's axis)]."""
        tree = self.tree
        inner = [*tree.joints_of(rotor.frame.parent), *tree.carrying]
        return [(joint, dot(rotor.axis, joint.axis)) for joint in inner]

    def forces(self, Q):
        """Generalized forces of the unknowns, rotors left out."""
        tree = self.tree
        by_angle = self._mixed(self.inverse.T, [Q[i] for i in self.angles])
        of = dict(zip(self.turning, by_angle))
        self.rotor_forces = [of[rotor] for rotor in tree.rotors.values()]
        for rotor in tree.rotors.values():
            for joint, part in self._rotor_parts(rotor):
                of[joint] = of[joint] - part * of[rotor]
        return [*(of[j] for j in tree.joints), *self._carried(self._padded([Q[i] for i in self.base])), *(of[c] for c in tree.carrying)]

    def _mixed(self, matrix, values):
        result = []
        for row in range(matrix.rows):
            total = self.tree.tape.const(0)
            for k, value in enumerate(values):
                total = total + float(matrix[row, k]) * value
            result.append(total)
        return result

    def accelerations(self, x, free=True):
        """Of the coordinates, from those of the unknowns; free: with what the rotors have of their own, else a change alone."""
        tree = self.tree
        joints = len(tree.joints)
        of = dict(zip(tree.joints, x)) | dict(zip(tree.carrying, x[joints + 3:]))
        for rotor, force in zip(tree.rotors.values(), self.rotor_forces):
            axis = AXIS.index(rotor.frame.axis)
            along = tree.record(rotor.bodies[0].inertia[axis, axis])
            total = force * (1 / along) - dot(rotor.axis, tree.angular(rotor.frame.parent)[1]) if free else tree.tape.const(0)
            for joint, part in self._rotor_parts(rotor):
                total = total - part * of[joint]
            of[rotor] = total
        result = dict(zip(self.angles, self._mixed(self.inverse, [of[t] for t in self.turning])))
        place = list(x[joints:joints + 3])
        for joint in reversed(tree.carrying):
            place = tree.axes.outwards(joint.frame, place)
        return [(result | dict(zip(self.base, place)))[i] for i in range(len(tree.q))]
