"""Vectors of tape values, and frames whose axes are written in those of one frame that many bodies share, the carrier.

A vector that is constant in a turned frame keeps its components there: two such vectors are multiplied where they are
constant, and a part along the axis of a joint is moved to what the joint turns on, so that it is never turned at all.
"""

from .rotations import AXES, Frame

AXIS = "xyz"


class Key:
    """A frame by identity: frames of the same axes are not the same frame."""

    def __init__(self, frame):
        self.frame = frame

    def __hash__(self):
        return id(self.frame)

    def __eq__(self, other):
        return self.frame is other.frame


class Vector:
    """Three values in carrier axes; `own` {frame: components} of the frames in which they are constant, from outside in."""

    def __init__(self, entries, own=None):
        self.entries, self.own = list(entries), own or {}

    def __getitem__(self, k):
        return self.entries[k]

    def __iter__(self):
        return iter(self.entries)

    def __add__(self, other):
        return Vector(a + b for a, b in zip(self, other))

    def __sub__(self, other):
        return Vector(a - b for a, b in zip(self, other))

    def __neg__(self):
        return Vector([-a for a in self], {frame: [-a for a in own] for frame, own in self.own.items()})

    def __rmul__(self, factor):
        return Vector([factor * a for a in self], {frame: [factor * a for a in own] for frame, own in self.own.items()})

    def is_zero(self) -> bool:
        return all(a.number == 0 for a in self)

    def same(self, other) -> bool:
        return all(a.index == b.index for a, b in zip(self, other))

    def shared(self, other):
        """The outermost frame in which both are constant, or None."""
        return next((frame for frame in self.own if frame in other.own), None)


def dot(a, b):
    frame = a.shared(b)
    if frame is not None:
        a, b = a.own[frame], b.own[frame]
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


class Axes:
    """Columns of frames in carrier axes. `record` writes SymPy's angles and offsets on the tape."""

    def __init__(self, record, carrier: Frame):
        self.record, self.carrier, self.tape = record, carrier, record.tape
        self._columns, self._joints = {}, {}

    def vector(self, entries) -> Vector:
        return Vector([self.tape.value(a) for a in entries])

    def unit(self, frame, axis) -> Vector:
        return self.constant(frame, [self.tape.const(k == AXIS.index(axis)) for k in range(3)])

    def constant(self, frame, own) -> Vector:
        """A vector with constant components in a frame's axes."""
        known = {Key(f): components for f, components in self.inwards(frame, own)}
        innermost, components = list(known.items())[-1]
        total = self.vector([0, 0, 0])
        for component, column in zip(components, self.columns(innermost.frame)):
            total = total + component * column
        return Vector(total, known)

    def cross(self, a, b) -> Vector:
        shared = a.shared(b)
        return self.constant(shared.frame, _cross(a.own[shared], b.own[shared])) if shared else Vector(_cross(a, b))

    def inwards(self, frame, own) -> list:
        """[(frame, components)] of the frames in which a vector is constant, from the given one inwards."""
        found = [(frame, own)]
        while frame is not self.carrier:
            axis = AXIS.index(frame.axis)
            across = [own[k] for k in range(3) if k != axis]
            if frame.angle.free_symbols & self.record.moving and any(a.number != 0 for a in across):
                break
            own = own if all(a.number == 0 for a in across) else self.outwards(frame, own)
            frame = frame.parent
            found.append((frame, own))
        return found

    def parts(self, frame, own):
        """Constant vectors whose sum is the given one: [(frame, components)], the part along a joint's axis further in."""
        frame, own = self.inwards(frame, own)[-1]
        if frame is self.carrier:
            return [(frame, own)]
        axis, zero = AXIS.index(frame.axis), self.tape.const(0)
        along = [a if k == axis else zero for k, a in enumerate(own)]
        across = [zero if k == axis else a for k, a in enumerate(own)]
        return [(frame, across), *self.parts(frame.parent, along)]

    def columns(self, frame):
        """The frame's three axes."""
        if id(frame) not in self._columns:
            if frame is self.carrier:
                columns = [self.vector(AXES[axis]) for axis in AXIS]
            else:
                x, y, z = self.columns(frame.parent)
                c, s = self.turn(frame)
                columns = {"x": lambda: [x, c * y + s * z, c * z - s * y], "y": lambda: [c * x - s * z, y, s * x + c * z],
                           "z": lambda: [c * x + s * y, c * y - s * x, z]}[frame.axis]()
            self._columns[id(frame)] = (columns, frame)
        return self._columns[id(frame)][0]

    def turn(self, frame):
        """(cosine, sine) of a frame's angle."""
        angle = self.record(frame.angle)
        return self.tape.call("cos", angle), self.tape.call("sin", angle)

    def outwards(self, frame, own):
        """Components in the axes of the frame's parent."""
        c, s = self.turn(frame)
        x, y, z = own
        return {"x": lambda: [x, c * y - s * z, s * y + c * z], "y": lambda: [c * x + s * z, y, c * z - s * x],
                "z": lambda: [c * x - s * y, s * x + c * y, z]}[frame.axis]()

    def back(self, frame, x: Vector) -> Vector:
        """From a frame's parent's axes to its own: for frames that the carrier itself is made of."""
        c, s = self.turn(frame)
        return Vector({"x": lambda: [x[0], c * x[1] + s * x[2], c * x[2] - s * x[1]],
                       "y": lambda: [c * x[0] - s * x[2], x[1], s * x[0] + c * x[2]],
                       "z": lambda: [c * x[0] + s * x[1], c * x[1] - s * x[0], x[2]]}[frame.axis]())
