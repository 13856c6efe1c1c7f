"""Between the unknowns of `composite` and the coordinates: accelerations one way, generalized forces the other.

The unknowns: the acceleration of the carrier's origin in the carrier's axes, that of each joint's own angle, and of a rotor the
whole angular acceleration about its axis, in which it is coupled to nothing.
"""

import sympy as sp

from .branches import Tree
from .vectors import AXIS, Vector, dot


class Unknowns:
    """Between the tree's unknowns and the coordinates."""

    def __init__(self, tree: Tree, within=None):
        self.tree, self.within = tree, within
        q = tree.q
        self.turning = [*tree.joints, *tree.carrying, *tree.rotors.values()]
        self.base = [i for i in range(len(q)) if q[i] in tree.base.free_symbols]
        self.angles = [i for i in range(len(q)) if i not in self.base and not (within and i in within.coordinates)]
        P = tree.base.jacobian([q[i] for i in self.base])
        if P != sp.eye(3):
            raise ValueError("a tree's base is a place of three coordinates")
        C = sp.Matrix([joint.frame.angle for joint in self.turning]).jacobian([q[i] for i in self.angles])
        self.inverse = C.inv()

    def _carried(self, x):
        """From the world's axes to the carrier's."""
        vector = Vector(x)
        for joint in self.tree.carrying:
            vector = self.tree.axes.back(joint.frame, vector)
        return vector

    def base_rates(self, v):
        return self._carried([self.tree.record(v[i]) for i in self.base])

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
        return [*(of[j] for j in tree.joints), *self._carried([Q[i] for i in self.base]), *(of[c] for c in tree.carrying)]

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
        if self.within:
            result |= self.within.accelerations(place, of, free)
        for joint in reversed(tree.carrying):
            place = tree.axes.outwards(joint.frame, place)
        return [(result | dict(zip(self.base, place)))[i] for i in range(len(tree.q))]
