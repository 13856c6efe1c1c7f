"""What moves within a body: its mass along an axis through the carrier's origin, and a rotor about that axis.

Both are eliminated before anything else. A mass that is free along the axis takes part in no acceleration along it, but hands
on the force Q of what carries it: the body's force along the axis e is -Q instead of m e (a + g). A free rotor takes part in no
turning about e, but hands on its torque. Whichever is held is rigid with the body. A flag, 1 where held and 0 where free,
chooses between the two, so that one straight line serves all; held, every term is what it is without the elimination.

An axis through the carrier's origin, with the mass on it, leaves everything but the translation of the base alone: what turns
about that origin moves the mass across e.
"""

from dataclasses import dataclass

from .vectors import Vector, dot


@dataclass(frozen=True)
class Inner:
    """body: the tree's, its centre on the axis at what the slide leaves of it and its inertia about the axis without the rotor's.

    axis: of the body's frame. coordinates: indices of the slide (against the axis) and of the rotor's angle; flags: their symbols;
    inertia: the rotor's, about the axis.
    """

    body: object
    axis: str
    coordinates: tuple
    flags: tuple
    inertia: object


class Within:
    def __init__(self, inner: Inner, tree):
        record = tree.record
        self.inner, self.tree, self.coordinates = inner, tree, inner.coordinates
        self.axis = tree.axes.unit(inner.body.frame, inner.axis)
        self.mass, self.inertia = record(inner.body.mass), record(inner.inertia)
        # As held ones they do not move, whatever their mass: 0 / (m + 1).
        self.slides, self.turns = [1 - record(flag) for flag in inner.flags]
        self.light, self.still = [free / (x + record(flag)) for free, x, flag in
                                  zip((self.slides, self.turns), (self.mass, self.inertia), inner.flags)]

    def changes(self, dynamics, forces):
        """Force and moment of the body, of a tree whose bodies are evaluated."""
        tree, name, e = self.tree, self.inner.body.name, self.axis
        cross = tree.axes.cross
        slide, turn = [tree.v[i] for i in self.coordinates]
        slide, turn = tree.record(slide), tree.record(turn)
        self.forces = [forces[i] for i in self.coordinates]
        omega, self.beta = tree.angular(self.inner.body.frame)
        # What slides against e while e turns.
        F = dynamics.force[name] - self.mass * (slide + slide) * cross(omega, e)
        self.along = dot(e, F)
        dynamics.force[name] = F - (self.slides * (self.along + self.forces[0])) * e
        spin = self.inertia * (self.turns * dot(e, omega) + turn)
        torque = dynamics.torque[name] + spin * cross(omega, e) + (self.turns * self.forces[1]) * e
        dynamics.torque[name] = torque
        dynamics.moment[name] = cross(tree.spot(self.inner.body.centre).place, F) + torque

    def lightens(self, M, base):
        """The base's translation, from that entry of M on, does not carry a mass along an axis that it slides on."""
        weighted = (self.slides * self.mass) * self.axis
        for i in range(3):
            for j in range(3):
                M[base + i][base + j] = M[base + i][base + j] - weighted[i] * self.axis[j]

    def accelerations(self, place, of, free=True):
        """{coordinate: acceleration} from that of the base in the carrier's axes and those of all joints' angles."""
        tree, e = self.tree, self.axis
        slide = self.slides * dot(e, Vector(place))
        turned = tree.zero
        for joint in [*tree.joints_of(self.inner.body.frame), *tree.carrying]:
            turned = turned + of[joint] * joint.axis
        turn = self.turns * dot(e, turned)
        if free:
            slide = slide + self.light * (self.along + self.forces[0])
            turn = self.still * self.forces[1] - self.turns * dot(e, self.beta) - turn
        else:
            turn = -turn
        return dict(zip(self.coordinates, (slide, turn)))
