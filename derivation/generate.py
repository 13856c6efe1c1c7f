"""From a model to the texts of its TypeScript modules."""

import sympy as sp

from . import typeset
from .direct import Programs
from .model import Model
from .recorder import Recorder
from .sharing import KEPT, Unit, columns, share
from .tape import Tape
from .typescript import HEADER, Writer, caller, module


def modules(model: Model, source: str) -> dict:
    """{file name: text}. Poses stand alone: the page draws with them and needs no dynamics."""
    source = source.replace("-", "_")
    head = lambda what: HEADER.format(what=what, title=model.title, source=source)
    direct, namespace = {}, []
    if model.constraints:
        programs = Programs(model)
        direct = {"accelerations.generated.ts": programs.text(source), "accelerations.generated.json": programs.program()}
        namespace = ["export * as direct from './accelerations.generated.ts';\n"]
    values, slopes = Equations(model).texts()
    return {"equations.generated.ts": module([head("Expressions"), *namespace, *values]),
            "jacobians.generated.ts": module([head("Jacobians"), *slopes]), **direct,
            "poses.generated.ts": module([head("Poses"), poses(model)]),
            "typeset.generated.json": typeset.text(model)}


def poses(model) -> str:
    tape, record, writer = opened(model)
    outputs = record.all(pose_entries(model))
    return writer.function("poses", "Per body: position, then rotation matrix by rows (body to world).", ["q", "p", "out"],
                           assigned("out", outputs), {"out": 12 * len(model.bodies)})


def pose_entries(model) -> dict:
    """{position in the array of poses: expression}."""
    entries = [list(body.centre.position()) + list(body.frame.R) for body in model.bodies]
    return {12 * b + i: e for b, body in enumerate(entries) for i, e in enumerate(body)}


def opened(model, definitions=(), **more):
    """An empty tape over q, v, p and more {array: symbols}, with what writes on it and what writes it down."""
    inputs = {"q": list(model.q), "v": list(model.v), "p": list(model.parameters)} | more
    tape = Tape()
    names = {array: [s.name for s in symbols] for array, symbols in inputs.items()}
    return tape, Recorder(tape, inputs, definitions), Writer(tape, names)


def assigned(array, values: dict) -> list:
    """[(text that is assigned, value)] of values by position."""
    return [(f"{array}[{i}]", values[i]) for i in sorted(values)]


class Equations:
    """Every function of one system but the poses, on one tape, so that nothing is written twice."""

    def __init__(self, model: Model):
        self.model, self.n = model, len(model.q)
        m = max((c.Omega.rows for c in model.constraints), default=0)
        self.a, self.lam = (list(sp.symbols(f"{letter}0:{size}", real=True)) for letter, size in (("a", self.n), ("lambda", m)))
        self.tape, self.record, self.writer = opened(model, model.definitions, a=self.a, **{"lambda": self.lam})
        self.units = []
        # Functions that others call: (name, doc, its arrays, units that it runs, arrays that it empties first).
        self.public = []
        # Functions that share nothing: values, then slopes.
        self.alone = ([], [])
        self.heights = []

    def texts(self):
        """(texts of the values, texts of their Jacobians), each a module."""
        model = self.model
        self.mechanics()
        self.function("energy", "[kinetic, potential] in J.", ["q", "v", "p"], {"out": (2, self.record.all({0: model.kinetic, 1: model.potential}))})
        if model.rate is None:
            self.pose_jacobian()
        else:
            self.first_order()
        for name, force in model.extra_forces:
            self.extra_force(name, force)
        for constraints in model.constraints:
            self.constraint_set(constraints)
        return self.written()

    def function(self, name, doc, reads, writes, family=None, slope=False):
        """A function of one unit, which shares with others if it has a family; writes {array: (size, values by position)}."""
        outputs = [pair for array, (_, values) in writes.items() for pair in assigned(array, values)]
        sizes = {array: size for array, (size, _) in writes.items()}
        if family is None:
            self.alone[slope].append(self.writer.function(name, doc, [*reads, *writes], outputs, sizes))
            return None
        unit = self.unit(f"{name}Rest", family, f"What `{name}` does not share.", outputs, sizes)
        self.public.append((name, doc, [*reads, *writes], [unit], ()))
        return unit

    def unit(self, name, family, doc, outputs, sizes, slope=False) -> Unit:
        unit = Unit(name, family, slope, outputs, doc, sizes)
        self.units.append(unit)
        return unit

    def jacobian(self, name, family, doc, reads, outputs, wrt, arrays):
        """Exact Jacobians of outputs {(kind, row): value}; wrt {suffix: inputs}; arrays {kind + suffix: (name, rows)}."""
        directions = {(suffix, k): value for suffix, values in wrt.items() for k, value in enumerate(values)}
        derived = self.tape.differentiate(outputs, directions)
        kept = {key: value for key, value in derived.items() if key[0][0] + key[1][0] in arrays and value.number != 0}
        sizes = {array: rows * self.n for array, rows in arrays.values()}
        groups = columns(self.tape, kept, directions) or [[]]
        parts = []
        for g, group in enumerate(groups):
            written = [(f"{arrays[kind + suffix][0]}[{row * self.n + k}]", value) for ((kind, row), (suffix, k)), value in group]
            parts.append(self.unit(f"{name}{g}", family, f"Columns of `{name}`.", written, sizes if len(groups) == 1 else {}, slope=True))
        self.public.append((name, doc, [*reads, *sizes], parts, list(sizes) if len(groups) > 1 else ()))

    def mechanics(self):
        n, e = self.n, self.model.equations
        M = self.record.all({(i, j): e.M[i, j] for i in range(n) for j in range(i + 1)})
        h = self.record.all({i: e.h[i] for i in range(n)})
        entries = {at: value for (i, j), value in M.items() for at in {i * n + j, j * n + i}}
        self.mass = self.function("mechanics", f"Mass matrix ({n} x {n}) and h ({n}) of M a = h.", ["q", "v", "p"],
                                  {"massMatrix": (n * n, entries), "h": (n, h)}, "mechanics")
        residual = self.record.all({("", i): x for i, x in enumerate(e.M * sp.Matrix(self.a) - e.h)})
        self.jacobian("jacobians", "mechanics", "Exact Jacobians of M a - h (row-major).", ["q", "v", "a", "p"], residual,
                      self.by("q", "v"), {"q": ("dq", n), "v": ("dv", n)})

    def by(self, *arrays):
        return {array: [self.tape.input(array, k) for k in range(self.n)] for array in arrays}

    def pose_jacobian(self):
        outputs = self.record.all(pose_entries(self.model))
        derived = self.tape.differentiate(outputs, dict(enumerate(self.by("q")["q"])))
        size = 12 * len(self.model.bodies) * self.n
        self.function("poseJacobian", f"Derivatives of `poses` by q ({12 * len(self.model.bodies)} x {self.n}).", ["q", "p"],
                      {"out": (size, {i * self.n + k: value for (i, k), value in derived.items() if value.number != 0})}, slope=True)

    def first_order(self):
        n, rate = self.n, self.model.rate
        self.function("rate", f"f ({n}) of q' = f(q).", ["q", "p"], {"out": (n, self.record.all(dict(enumerate(rate))))})
        self.function("rateJacobian", f"df/dq ({n} x {n}).", ["q", "p"],
                      {"out": (n * n, self.record.all(dict(enumerate(rate.jacobian(self.model.q)))))})

    def extra_force(self, name, force):
        values, n = self.record.all(dict(enumerate(force))), self.n
        self.function(f"{name}Force", f"Generalized force of {name} ({n}).", ["q", "v", "p"], {"force": (n, values)})
        self.jacobian(f"{name}Jacobians", name, f"Exact Jacobians of the force of {name} (row-major).", ["q", "v", "p"],
                      {("", i): value for i, value in values.items()}, self.by("q", "v"), {"q": ("dq", n), "v": ("dv", n)})

    def constraint_set(self, c):
        model, n, m, name = self.model, self.n, c.Omega.rows, c.id
        gamma = c.rate(model.q, model.v)
        rows = self.function(f"{name}Constraints", f"Omega ({m} x {n}) and gamma = Omega_dot v ({m}).", ["q", "v", "p"],
                             {"omega": (m * n, self.record.all(dict(enumerate(c.Omega)))), "gamma": (m, self.record.all(dict(enumerate(gamma))))}, name)
        self.public.append((f"{name}Dynamics", f"`mechanics` and `{name}Constraints` at once, for less than both.",
                            ["q", "v", "p", "massMatrix", "h", "omega", "gamma"], [self.mass, rows], ()))
        if len(c.heights) > 0:
            self.contact_heights(f"{name}Heights", c.heights)
        a, lam = sp.Matrix(self.a), sp.Matrix(self.lam[:m])
        kinds = {"force": c.Omega.T * lam, "rate": c.Omega * a + gamma, "velocity": c.Omega * model.v}
        outputs = self.record.all({(kind, i): x for kind, column in kinds.items() for i, x in enumerate(column)})
        self.jacobian(f"{name}Jacobians", name, "Exact Jacobians of Omega^T lambda, Omega a + gamma and Omega v (row-major).",
                      ["q", "v", "a", "lambda", "p"], outputs, self.by("q", "v"),
                      {"forceq": ("forceQ", n), "rateq": ("rateQ", m), "ratev": ("rateV", m), "velocityq": ("velocityQ", m)})

    def contact_heights(self, name, heights):
        """Written once where constraint sets keep the same ones."""
        if heights in self.heights:
            return
        self.heights.append(heights)
        self.function(name, "Heights of the contact points above the ground (m).", ["q", "p"],
                      {"out": (len(heights), self.record.all(dict(enumerate(heights))))})

    def written(self):
        """Shared functions first, then the units, then the functions that others call; Jacobians in a module of their own."""
        shared, loads = share(self.tape, self.units)
        arrays = {}
        whole = {units[0].name: (name, doc, given) for name, doc, given, units, _ in self.public if len(units) == 1 and not units[0].needs}
        public, lent = ([], []), set()
        for name, doc, given, units, emptied in self.public:
            slope = units[0].slope
            needed = {n for unit in units for n in unit.needs}
            if slope:
                lent |= {s.name for s in shared if s.name in needed and not s.slope}
            if not (units[0].name in whole and len(units) == 1):
                called = [*(s.name for s in shared if s.name in needed), *(unit.name for unit in units)]
                public[slope].append((name, doc, given, called, emptied))
        parts = ([], [])
        for part, doc, own in [*((s, "Kept for several functions.", s.loads) for s in shared), *((u, u.doc, loads) for u in self.units)]:
            name, doc, arrays[part.name] = whole.get(part.name, (part.name, doc, self.arrays(part, own)))
            parts[part.slope].append(self.writer.function(name, doc, arrays[part.name], part.outputs, part.sizes, own,
                                                          exported=part.name in whole or part.name in lent))
        callers = [[caller(name, doc, given, [(whole[part][0] if part in whole else part, arrays[part]) for part in called], emptied)
                    for name, doc, given, called, emptied in those] for those in public]
        kept = [f"/** What several functions need, from one to the next. */\nexport const {KEPT} = new Float64Array({len(loads)});\n"] if loads else []
        borrowed = sorted({KEPT, *lent} if loads and parts[True] else lent)
        imported = [f"import {{ {', '.join(borrowed)} }} from './equations.generated.ts';\n"] if borrowed else []
        return ([*kept, *parts[False], *self.alone[False], *callers[False]], [*imported, *parts[True], *self.alone[True], *callers[True]])

    def arrays(self, part, loads) -> list:
        """Those that a part reads, then those that it writes, by name."""
        ops = self.tape.ops
        read = {ops[i][1] for i in self.tape.reached([value for _, value in part.outputs], loads) if ops[i][0] == "input"}
        written = dict.fromkeys([*(target.split("[")[0] for target, _ in part.outputs), *part.sizes])
        return [*(array for array in self.writer.names if array in read), *(array for array in written if array != KEPT)]
