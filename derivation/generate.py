"""From a model to the text of one TypeScript module."""

import sympy as sp

from . import typeset
from .constraints import Constraints
from .model import Model
from .tape import Tape, differentiate, record
from .typescript import HEADER, function

# V8's optimising compiler gives a function up above 61,440 bytes of bytecode; about 3,000
# operations are safely below. Jacobians are written in groups of columns that stay under this.
MOST_OPERATIONS = 2200


def modules(model: Model, source: str) -> dict:
    """{file name: text}. Poses stand alone: the page draws with them and needs no dynamics."""
    source = source.replace("-", "_")
    inputs = {"q": list(model.q), "v": list(model.v), "p": list(model.parameters)}
    n = len(model.q)
    header = HEADER.format(title=model.title, source=source)
    equations = [header, *mechanics(model, inputs, n), energy(model, inputs)]
    if model.rate is None:
        equations.append(pose_jacobian(model, inputs))
    if model.rate is not None:
        equations += first_order(model, inputs, n)
    for name, force in model.extra_forces:
        equations += extra_force(name, force, model, inputs, n)
    for constraints in model.constraints:
        equations += constraint_set(constraints, model, inputs, n)
    return {"equations.generated.ts": "\n".join(equations), "poses.generated.ts": "\n".join([header, poses(model, inputs)]),
            "typeset.generated.json": typeset.text(model)}


def symmetric_targets(n):
    return {("M", i, j): sorted({i * n + j, j * n + i}) for i in range(n) for j in range(i + 1)}


def mechanics_outputs(model, n):
    M, h = model.equations.M, model.equations.h
    outputs = {("M", i, j): M[i, j] for i in range(n) for j in range(i + 1)}
    outputs |= {("h", i): h[i] for i in range(n)}
    targets = {k: [("massMatrix", t) for t in ts] for k, ts in symmetric_targets(n).items()}
    targets |= {("h", i): [("h", i)] for i in range(n)}
    return outputs, targets


def mechanics(model, inputs, n):
    M, h = model.equations.M, model.equations.h
    outputs, targets = mechanics_outputs(model, n)
    text = function("mechanics", f"Mass matrix ({n} x {n}) and h ({n}) of M a = h.", ["q", "v", "p", "massMatrix", "h"],
                    inputs, record(outputs, model.definitions), targets, {"massMatrix": n * n, "h": n})
    a = sp.symbols(f"a0:{n}", real=True)
    residual = M * sp.Matrix(a) - h
    tape = record({("r", i): residual[i] for i in range(n)}, model.definitions)
    return [text, *jacobian("jacobians", "M a - h", tape, {"dq": model.q, "dv": model.v}, {"r": ("", n)},
                            ["q", "v", "a", "p"], inputs | {"a": list(a)}, n)]


def extra_force(name, force, model, inputs, n):
    tape = record({("f", i): force[i] for i in range(n)})
    targets = {("f", i): [("force", i)] for i in range(n)}
    text = function(f"{name}Force", f"Generalized force of {name} ({n}).", ["q", "v", "p", "force"], inputs, tape,
                    targets, {"force": n})
    return [text, *jacobian(f"{name}Jacobians", f"the force of {name}", tape, {"dq": model.q, "dv": model.v},
                            {"f": ("", n)}, ["q", "v", "p"], inputs, n)]


def first_order(model, inputs, n):
    slope = model.rate.jacobian(model.q)
    rate = function("rate", f"f ({n}) of q' = f(q).", ["q", "p", "out"], inputs, record({i: e for i, e in enumerate(model.rate)}),
                    {i: [("out", i)] for i in range(n)}, {"out": n})
    return [rate, function("rateJacobian", f"df/dq ({n} x {n}).", ["q", "p", "out"], inputs,
                           record({i: e for i, e in enumerate(slope)}), {i: [("out", i)] for i in range(n * n)},
                           {"out": n * n})]


def energy(model, inputs):
    tape = record({"kinetic": model.kinetic, "potential": model.potential})
    return function("energy", "[kinetic, potential] in J.", ["q", "v", "p", "out"], inputs, tape,
                    {"kinetic": [("out", 0)], "potential": [("out", 1)]}, {"out": 2})


def pose_outputs(model):
    """{position in the array of poses: expression}."""
    entries = [list(body.centre.position()) + list(body.frame.R) for body in model.bodies]
    return {12 * b + i: e for b, body in enumerate(entries) for i, e in enumerate(body)}


def poses(model, inputs):
    outputs = pose_outputs(model)
    return function("poses", "Per body: position, then rotation matrix by rows (body to world).", ["q", "p", "out"],
                    inputs, record(outputs), {i: [("out", i)] for i in outputs}, {"out": len(outputs)})


def pose_jacobian(model, inputs):
    outputs, n = pose_outputs(model), len(model.q)
    derived = differentiate(record(outputs), dict(enumerate(model.q)))
    return function("poseJacobian", f"Derivatives of `poses` by q ({len(outputs)} x {n}).", ["q", "p", "out"], inputs, derived,
                    {(i, k): [("out", i * n + k)] for i, k in derived.outputs}, {"out": len(outputs) * n})


def constraint_set(c: Constraints, model, inputs, n):
    q, v, m = model.q, model.v, c.Omega.rows
    name = c.id
    outputs = {("O", i, j): c.Omega[i, j] for i in range(m) for j in range(n)}
    gamma = c.rate(q, v)
    outputs |= {("g", i): gamma[i] for i in range(m)}
    targets = {("O", i, j): [("omega", i * n + j)] for i in range(m) for j in range(n)}
    targets |= {("g", i): [("gamma", i)] for i in range(m)}
    together_outputs, together_targets = mechanics_outputs(model, n)
    together = function(f"{name}Dynamics", f"`mechanics` and `{name}Constraints` at once, for less than both.",
                        ["q", "v", "p", "massMatrix", "h", "omega", "gamma"], inputs,
                        record(together_outputs | outputs, model.definitions), together_targets | targets,
                        {"massMatrix": n * n, "h": n, "omega": m * n, "gamma": m})
    evaluate = function(f"{name}Constraints", f"Omega ({m} x {n}) and gamma = Omega_dot v ({m}).",
                        ["q", "v", "p", "omega", "gamma"], inputs, record(outputs, model.definitions), targets,
                        {"omega": m * n, "gamma": m})
    heights = [function(f"{name}Heights", "Heights of the contact points above the ground (m).", ["q", "p", "out"],
                       inputs, record({i: h for i, h in enumerate(c.heights)}),
                       {i: [("out", i)] for i in range(len(c.heights))}, {"out": len(c.heights)})]

    a, lam = sp.symbols(f"a0:{n}", real=True), sp.symbols(f"lambda0:{m}", real=True)
    force, rate, velocity = c.Omega.T * sp.Matrix(lam), c.Omega * sp.Matrix(a) + gamma, c.Omega * v
    tape = record({("force", i): force[i] for i in range(n)} | {("velocity", i): velocity[i] for i in range(m)}
                  | {("rate", i): rate[i] for i in range(m)}, model.definitions)
    kinds = {"force": ("force", n), "rate": ("rate", m), "velocity": ("velocity", m)}
    return [evaluate, together, *(heights if len(c.heights) > 0 else []),
            *jacobian(f"{name}Jacobians", "Omega^T lambda, Omega a + gamma and Omega v", tape, {"Q": q, "V": v}, kinds,
                      ["q", "v", "a", "lambda", "p"], inputs | {"a": list(a), "lambda": list(lam)}, n,
                      keep=("forceQ", "rateQ", "rateV", "velocityQ"))]


def jacobian(name, what, tape, wrt, kinds, arguments, inputs, n, keep=None):
    """Exact Jacobians of a tape's outputs, in as many functions as the size asks for, and one that calls them all.

    wrt {suffix: symbols}; kinds {first part of an output's name: (prefix of the array, rows)}.
    """
    directions = {f"{suffix}{i}": s for suffix, symbols in wrt.items() for i, s in enumerate(symbols)}
    derived = differentiate(tape, directions)
    sizes, targets = {}, {}
    for kind, (prefix, rows) in kinds.items():
        for suffix, symbols in wrt.items():
            array = f"{prefix}{suffix}"
            if keep and array not in keep:
                continue
            sizes[array] = rows * n
            for i in range(rows):
                for k in range(len(symbols)):
                    targets[((kind, i), f"{suffix}{k}")] = [(array, i * n + k)]
    derived = derived.only([key for key in derived.outputs if key in targets])
    arrays = list(sizes)
    texts, calls = [], []
    for g, (labels, part_tape) in enumerate(grouped(derived, list(directions))):
        part = f"{name}{g}"
        texts.append(function(part, f"Directions {', '.join(labels)} of `{name}`.", arguments + arrays, inputs,
                              part_tape, targets, sizes, clear=False))
        calls.append(f"  {part}({', '.join(arguments + arrays)});")
    head = "\n".join([f"/** Exact Jacobians of {what} (row-major). */", f"export function {name}(",
                      f"  {', '.join(f'{a}: Float64Array' for a in arguments + arrays)},", "): void {"]
                     + [f"  {a}.fill(0);" for a in arrays] + calls + ["}", ""])
    return texts + [head]


def grouped(tape: Tape, labels):
    """Columns gathered greedily into tapes of at most MOST_OPERATIONS: [(labels, tape)].

    Bytecode grows with operations and with local names, which take longer instructions when there are many.
    """
    by_label = {label: [k for k in tape.outputs if k[1] == label] for label in labels}
    by_label = {label: keys for label, keys in by_label.items() if keys}
    groups, current = [], []
    for label in by_label:
        trial = tape.only([k for each in current + [label] for k in by_label[each]])
        if current and trial.operations() > MOST_OPERATIONS:
            groups.append(current)
            current = []
        current = current + [label]
    if current:
        groups.append(current)
    return [(g, tape.only([k for label in g for k in by_label[label]])) for g in groups]
