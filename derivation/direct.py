"""The shortest way to constrained accelerations, as functions of their own: see `composite` and `elimination`.

A model that says what its bodies hang on (`Direct`) is derived anew in the axes of that frame; any other keeps its equations
and gains by the elimination alone. Sines and cosines are written out by `trigonometry`.

For each set of constraint rows, over y = [q, v], constants c that `prepare` makes from the parameters once, and factors that
the accelerations leave for what follows at the same state:

    <set>Accelerations(y, c, f, rate, lambda, factors)   rate = [v, a] under generalized forces f from outside
    <set>Shift(factors, g, x)                            adds the smallest change in the mass metric that changes Omega x by g
    <set>Slip(q, v, c, slip, heights)                    Omega v and the heights of the contact points
"""

import json
from dataclasses import dataclass

from .branches import Tree
from .composite import Dynamics
from .elimination import Saddle
from .recorder import Recorder
from .tape import Tape, arguments
from .typescript import HEADER, Writer, module
from .within import Within

# A pivot of S below this share of its diagonal is rounding (`DEPENDENT` in core/mechanics).
DEPENDENT = 1e-13


@dataclass(frozen=True)
class Direct:
    """What the short way is derived from. rows {constraint set: [(direction, point)]}, contacts: points whose heights count."""

    bodies: tuple
    gravity: object
    losses: object  # n x 1
    rows: dict
    contacts: tuple
    within: object = None  # `within.Inner`, what moves in one of the bodies


class InCoordinates:
    """M, h, Omega and gamma as the model has them, the coordinates in an order in which little fills in.

    The next to be eliminated is always the one that is coupled to fewest (Golub and Van Loan, 4th ed., section 11.1.4).
    """

    def __init__(self, record, model, constraints, outside):
        M, h = model.equations.M, model.equations.h
        self.order = self._sparsest_first({(i, j) for i in range(M.rows) for j in range(M.cols) if record(M[i, j]).number != 0}, M.rows)
        self.M = [[record(M[i, j]) for j in self.order] for i in self.order]
        self.h = [record(h[i]) + outside[i] for i in self.order]
        self.Omega = [[record(constraints.Omega[r, i]) for i in self.order] for r in range(constraints.Omega.rows)]
        self.gamma = [record(x) for x in constraints.rate(model.q, model.v)]
        self.slip = [record(x) for x in constraints.Omega * model.v]
        self.unknowns = self

    @staticmethod
    def _sparsest_first(coupled, n):
        left, order = set(range(n)), []
        while left:
            near = {i: {j for j in left if j != i and (i, j) in coupled} for i in left}
            i = min(sorted(left), key=lambda k: len(near[k]))
            coupled = coupled | {(a, b) for a in near[i] for b in near[i]}
            order.append(i)
            left.remove(i)
        return order

    def accelerations(self, x, free=True):
        del free
        return [x[self.order.index(i)] for i in range(len(x))]


class Programs:
    """Values of all functions on one tape, and their texts."""

    def __init__(self, model):
        direct, n = model.direct, len(model.q)
        self.model, self.n, self.tape = model, n, Tape()
        definitions = () if direct else model.definitions
        within = direct.within if direct else None
        flags = list(within.flags) if within else []
        self.parameters = [*model.parameters, *flags]
        self.record = Recorder(self.tape, {"q": list(model.q), "v": list(model.v), "p": self.parameters}, definitions)
        outside = [self.tape.input("f", i) for i in range(n)]
        if direct is None:
            self.sets = {c.id: Set(self, InCoordinates(self.record, model, c, outside), [self.record(x) for x in c.heights])
                         for c in model.constraints}
            return
        tree = Tree(self.record, model.q, model.v, direct.bodies, direct.gravity)
        forces = [self.record(x) + f for x, f in zip(direct.losses, outside)]
        self.sets = {}
        for name, rows in direct.rows.items():
            dynamics = Dynamics(tree, forces, rows, Within(within, tree) if within else None)
            self.sets[name] = Set(self, dynamics, [dynamics.height(point) for point in direct.contacts])

    def fixed(self) -> list:
        """Indices of the values that depend on the parameters alone and that a function reads, in order."""
        found, seen, waiting = set(), set(), [v.index for s in self.sets.values() for v in s.outputs()]
        while waiting:
            i = waiting.pop()
            if i in seen:
                continue
            seen.add(i)
            if self.tape.fixed[i] and self.tape.ops[i][0] != "const":
                found.add(i)
            else:
                waiting += arguments(self.tape.ops[i])
        return sorted(found)

    def text(self, source) -> str:
        n, model = self.n, self.model
        names = {"q": [s.name for s in model.q], "v": [s.name for s in model.v], "p": [s.name for s in self.parameters]}
        writer, of_state = Writer(self.tape, names, own_sines=True), Writer(self.tape, names, {"q": ("y", 0), "v": ("y", n)}, True)
        fixed = self.fixed()
        constants = {i: f"c[{k}]!" for k, i in enumerate(fixed)}
        texts = [HEADER.format(what="Constrained accelerations", title=model.title, source=source),
                 "/** Length of the constants. */", f"export const constantCount = {len(fixed)};\n",
                 *self.holdable(),
                 writer.function("prepare", "Constants of all functions below, from the parameters.", ["p", "c"],
                                 [(f"c[{k}]", self.tape.at(i)) for k, i in enumerate(fixed)])]
        for name, s in self.sets.items():
            texts += s.texts(name, writer, of_state, constants)
        return module(texts)


    def holdable(self) -> list:
        within = self.model.direct.within if self.model.direct else None
        if within is None:
            return []
        about = "Coordinates that may be held here: p ends with a 1 for each that is, a 0 for each that is free."
        return [f"/** {about} */", f"export const holdable = {list(within.coordinates)};\n"]

    def program(self) -> str:
        """The tape itself with what its values are for, so that another writer can walk it: JSON.

        ops: as `Tape.ops`. prepare: the values that c holds. Of each set, the values of every array that its functions write,
        and the pairs of which the first must be larger; a shift reads what `factors` holds, everything else reads c.
        """
        fixed = self.fixed()
        sets = {name: s.arrays() for name, s in self.sets.items()}
        wanted = [self.tape.at(i) for i in fixed] + [value for arrays in sets.values() for values in arrays.values() for value in values]
        order = self.tape.reached(wanted)
        place = {i: k for k, i in enumerate(order)}
        ops = [op if op[0] in ("input", "const") else (op[0], *(place[k] for k in op[1:])) for op in (self.tape.ops[i] for i in order)]
        numbered = {name: {array: [place[v.index] for v in values] for array, values in arrays.items()} for name, arrays in sets.items()}
        lines = [json.dumps(op, separators=(",", ":")) for op in ops]
        parts = {"prepare": [place[i] for i in fixed], "sets": numbered}
        return "{\"ops\":[\n" + ",\n".join(lines) + "\n],\n" + json.dumps(parts, separators=(",", ":"))[1:] + "\n"


class Set:
    """Accelerations, shift and slip under one set of rows."""

    def __init__(self, programs: Programs, dynamics: Dynamics, heights):
        self.programs, self.tape = programs, programs.tape
        tape, m = self.tape, len(dynamics.Omega)
        saddle = Saddle(dynamics.M, dynamics.Omega)
        x, self.lam = saddle.solve(dynamics.h, dynamics.gamma)
        self.a = dynamics.unknowns.accelerations(x)
        self.velocity, self.heights = dynamics.slip, heights
        change = [tape.input("g", r) for r in range(m)]
        self.shift = dynamics.unknowns.accelerations(saddle.shift(change, tape.const(0)), free=False)
        self.kept = self._at_hand(change)
        S = saddle.schur
        scale, inverse = S.diagonal[0], S.inverse[0]
        for r in range(1, m):
            scale, inverse = scale * S.diagonal[r], inverse * S.inverse[r]
        self.spread = scale * inverse
        self.positive = [(d, tape.const(0)) for d in saddle.mass.pivots] + [(d, DEPENDENT * D) for d, D in zip(S.pivots, S.diagonal)]

    def _at_hand(self, change):
        """Values that the shift reads and that do not depend on what it changes."""
        depends = {c.index for c in change}
        wanted = set()
        for i in self.tape.reached(self.shift):
            if any(k in depends for k in arguments(self.tape.ops[i])):
                depends.add(i)
                wanted |= {k for k in arguments(self.tape.ops[i])}
        return sorted(k for k in wanted - depends if self.tape.ops[k][0] != "const")

    def arrays(self):
        """{array: values that a function writes there}."""
        v = [self.programs.record(x) for x in self.programs.model.v]
        return {"rate": [*v, *self.a], "lambda": self.lam, "factors": [*(self.tape.at(i) for i in self.kept), self.spread],
                "larger": [a for a, _ in self.positive], "smaller": [b for _, b in self.positive],
                "shift": self.shift, "slip": self.velocity, "heights": self.heights}

    def _written(self, *names):
        arrays = self.arrays()
        return [(f"{name}[{k}]", value) for name in names for k, value in enumerate(arrays[name])]

    def outputs(self):
        """Values that functions with the constants at hand compute."""
        return [value for name, values in self.arrays().items() if name != "shift" for value in values]

    def operations(self) -> int:
        """Of the accelerations and multipliers, without what is prepared."""
        constants = set(self.programs.fixed())
        return self.tape.operations(self.tape.reached([*self.a, *self.lam], constants))

    def texts(self, name, writer, of_state, constants):
        factors = {i: f"factors[{k}]!" for k, i in enumerate(self.kept)}
        shifted = [(f"x[{i}]", x) for i, x in enumerate(self.shift)]
        return [
            f"/** Length of the factors; the last is 1 / det of S scaled to a unit diagonal. */\nexport const {name}FactorCount = {len(self.kept) + 1};\n",
            of_state.function(f"{name}Accelerations", "rate = [v, a], lambda and factors; false where M or S is not positive definite.",
                            ["y", "c", "f", "rate", "lambda", "factors"], self._written("rate", "lambda", "factors"), loads=constants, returns=self.positive),
            writer.function(f"{name}Shift", "Adds to x the smallest change in the mass metric that changes Omega x by g.", ["factors", "g", "x"],
                            shifted, loads=factors, adds=True),
            writer.function(f"{name}Slip", "Omega v and the heights of the contact points.", ["q", "v", "c", "slip", "heights"], self._written("slip", "heights"), loads=constants),
        ]
