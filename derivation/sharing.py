"""Which function computes a value that several need: the narrowest that all of them call.

Each `Unit` is what one function writes. A unit of a `family` (the mechanics, a set of constraints) gives values or their
slopes (Jacobians). What several units need is computed before them, in one of four places, and kept in an array:

    kinematics        needed in more than one family, and not only by slopes
    <family>          needed in one family, by its values and its slopes, or by several of its values
    slopes            needed by slopes alone, in more than one family; apart, those of given accelerations and multipliers
    <family>Slopes    needed by several slopes of one family
"""

from dataclasses import dataclass, field

from .tape import Tape, arguments

# V8's optimising compiler gives a function up above 61,440 bytes of bytecode; about 3,000 operations are safely below.
MOST_OPERATIONS = 2200
# Fewer are computed again by each: calling and storing would cost as much.
FEWEST_OPERATIONS = 24
KEPT = "kept"
# The places that only Jacobians need come last.
SLOPES = 2
# Accelerations and multipliers, which only some Jacobians are taken at.
GIVEN = ("a", "lambda")


@dataclass
class Unit:
    name: str
    family: str
    slope: bool
    outputs: list  # [(text that is assigned, value)]
    doc: str
    sizes: dict  # {array: size} of those that it empties where it does not fill them
    needs: list = field(default_factory=list)  # names of functions that must have run


@dataclass
class Shared:
    """A function that keeps values for others: [(text that is assigned, value)]; loads {index: text} that it reads itself."""

    name: str
    outputs: list
    loads: dict
    slope: bool  # only Jacobians need it
    sizes: dict = field(default_factory=dict)


def share(tape: Tape, units: list):
    """(shared functions in the order in which they run, {index: text} of the values that they keep)."""
    users = _users(tape, units)
    given = _given(tape, users)
    places = {}
    for i, using in users.items():
        place = _place([units[k] for k in using], given[i])
        if place is not None and tape.ops[i][0] not in ("input", "const"):
            places.setdefault(place, []).append(i)
    groups = []
    for place in sorted(places):
        pieces = _pieces(sorted(places[place])) if len(places[place]) >= FEWEST_OPERATIONS else []
        groups += [(f"{place[1]}{k if len(pieces) > 1 else ''}", set(piece), place[0] >= SLOPES) for k, piece in enumerate(pieces)]
    home = {i: name for name, piece, _ in groups for i in piece}
    wanted = {value.index for unit in units for _, value in unit.outputs if value.index in home}
    for i in users:
        wanted |= {k for k in arguments(tape.ops[i]) if k in home and home.get(i) != home[k]}
    loads = {i: f"{KEPT}[{slot}]!" for slot, i in enumerate(sorted(wanted))}
    shared = [Shared(name, [(loads[i].rstrip("!"), tape.at(i)) for i in sorted(piece & wanted)], {i: loads[i] for i in wanted - piece}, slope)
              for name, piece, slope in groups]
    direct = {s.name: _reads(tape, s.outputs, s.loads, home) for s in shared}
    for unit in units:
        needed = _reads(tape, unit.outputs, loads, home)
        for s in reversed(shared):
            needed |= direct[s.name] if s.name in needed else set()
        unit.needs = [s.name for s in shared if s.name in needed]
    return shared, loads


def _users(tape, units):
    users = {}
    for k, unit in enumerate(units):
        for i in tape.reached([value for _, value in unit.outputs]):
            users.setdefault(i, []).append(k)
    return users


def _given(tape, users):
    """For each value the arrays of `GIVEN` that it depends on, which not every function has."""
    given = {}
    for i in sorted(users):
        op = tape.ops[i]
        own = {op[1]} & set(GIVEN) if op[0] == "input" else set()
        given[i] = own.union(*(given[k] for k in arguments(op)))
    return given


def _place(using, given):
    """(order in which it runs, name), or None for what one unit needs alone."""
    if len(using) == 1:
        return None
    several = len({unit.family for unit in using}) > 1
    family = using[0].family
    if all(unit.slope for unit in using):
        most = max((GIVEN.index(array) + 1 for array in given), default=0)
        return (SLOPES + most / 10, f"slopes{('', 'WithA', 'WithLambda')[most]}") if several else (SLOPES + 1, f"{family}Slopes")
    return (0, "kinematics") if several else (1, f"{family}Kinematics")


def _pieces(indices):
    count = -(-len(indices) // MOST_OPERATIONS)
    size = -(-len(indices) // count)
    return [indices[k * size:(k + 1) * size] for k in range(count)]


def _reads(tape, outputs, loads, home):
    """Functions whose kept values these outputs read."""
    values = [value for _, value in outputs]
    read = {value.index for value in values if value.index in loads}
    for i in tape.reached(values, loads):
        read |= {k for k in arguments(tape.ops[i]) if k in loads}
    return {home[i] for i in read}


def columns(tape: Tape, derived: dict, labels) -> list:
    """Columns of a Jacobian {(output, label): value} gathered into groups of at most MOST_OPERATIONS of their own."""
    parts = [[(key, value) for key, value in derived.items() if key[1] == label] for label in labels]
    reached = [set(tape.reached([value for _, value in part])) for part in parts]
    often = {}
    for indices in reached:
        for i in indices:
            often[i] = often.get(i, 0) + 1
    groups, size = [], 0
    for part, indices in zip(parts, reached):
        own = tape.operations(i for i in indices if often[i] == 1)
        if not part:
            continue
        if not groups or size + own > MOST_OPERATIONS:
            groups.append([])
            size = 0
        groups[-1] += part
        size += own
    return groups
