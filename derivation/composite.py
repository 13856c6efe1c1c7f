"""Equations of motion of a tree of bodies, all in the axes of the frame that carries it.

The unknowns (`unknowns`) are those in which the equations are short, not the rates of the coordinates. Composite rigid bodies
for the mass matrix (Featherstone, Rigid Body Dynamics Algorithms, Springer 2008, chapter 6), Newton and Euler's equations for the
forces.
"""

from .branches import Sum, Tree, matrix, times
from .unknowns import Unknowns
from .vectors import AXIS, dot


class Dynamics:
    """M, h, Omega and gamma in the tree's unknowns: joints from the ends of the branches inwards, base, the carrier's own joints.

    forces: generalized forces by coordinate, as values. rows: [(direction, point)] of `direction . velocity = 0`, direction a
    frame's axis as (frame, axis) or an axis of the world by its name. within: what moves in one of the bodies (`within.Within`).
    """

    def __init__(self, tree: Tree, forces, rows, within=None):
        self.tree, self.tape = tree, tree.tape
        self.joints, self.carrying = tree.joints, tree.carrying
        self.count = len(self.joints) + 3 + len(self.carrying)
        self.unknowns = Unknowns(tree, within)
        self.base_velocity = self.unknowns.base_rates(tree.v)
        self._bodies()
        if within is not None:
            within.changes(self, forces)
        self.M = self._mass_matrix()
        if within is not None:
            within.lightens(self.M, len(self.joints))
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
        first = tree.total(mass * place for mass, place in moving)
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
                if other is not joint and other.frame in tree.outside(joint.frame):
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
            root = next((f for f in reversed(tree.outside(body.frame))), None)
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
            moment = tree.total(self.moment[b.name] for b in joint.bodies)
            force = tree.total(self.force[b.name] for b in joint.bodies if b.name in self.force)
            h.append(-(dot(joint.axis, moment) + dot(self._start(joint), force)))
        still = self.tape.const(0)
        for body in tree.bodies:
            still = still + tree.record(body.mass) if tree.is_fixed(body) else still
        force = tree.total(self.force.values()) + still * tree.gravity * tree.up
        moment = tree.total([tree.total(self.moment[b.name] for b in bodies) for bodies in self._by_branch()]) + self.carried_torque
        return [*h, *(-f for f in force), *(-dot(c.axis, moment) for c in self.carrying)]

    def _by_branch(self):
        branches = {}
        for body in self.tree.bodies:
            frames = self.tree.outside(body.frame)
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
