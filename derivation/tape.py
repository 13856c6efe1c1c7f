"""Straight-line programs: a list of operations on numbered values, each written down once.

`Tape.ops` is the whole program, in an order in which it can be computed:

    ("input", array, position)   an entry of a named array
    ("const", number)
    ("add" | "sub" | "mul" | "div", a, b)   a and b are indices of earlier operations
    ("neg" | "sqrt" | "sin" | "cos" | "tan" | "atan", a)

An operation that is already there is not written again (value numbering), and what is known is folded: 0 + x, 1 x, x - x.
`Value` is one of them, with Python's arithmetic. Whoever writes code walks `ops`; the order of every sum is fixed here.

Differentiating the tape instead of the expanded expressions takes seconds instead of minutes, and its cost is a small
multiple of the function's own (Griewank and Walther, Evaluating Derivatives, 2nd ed., SIAM 2008, section 3.1: forward
mode).
"""

import math

ARITHMETIC = ("add", "sub", "mul", "div", "neg")
FUNCTIONS = ("sqrt", "sin", "cos", "tan", "atan")


class Value:
    __slots__ = ("tape", "index")

    def __init__(self, tape, index):
        self.tape, self.index = tape, index

    @property
    def op(self):
        return self.tape.ops[self.index]

    @property
    def number(self):
        """Its value where it is a constant, else None."""
        return self.op[1] if self.op[0] == "const" else None

    def __add__(self, other):
        return self.tape.add(self, self.tape.value(other))

    def __radd__(self, other):
        return self.tape.add(self.tape.value(other), self)

    def __sub__(self, other):
        return self.tape.sub(self, self.tape.value(other))

    def __rsub__(self, other):
        return self.tape.sub(self.tape.value(other), self)

    def __mul__(self, other):
        if not isinstance(other, (Value, int, float)):
            return NotImplemented
        return self.tape.mul(self, self.tape.value(other))

    def __rmul__(self, other):
        return self.tape.mul(self.tape.value(other), self)

    def __truediv__(self, other):
        return self.tape.div(self, self.tape.value(other))

    def __rtruediv__(self, other):
        return self.tape.div(self.tape.value(other), self)

    def __neg__(self):
        return self.tape.neg(self)

    def __repr__(self):
        return f"<{self.index}: {' '.join(map(str, self.op))}>"


class Tape:
    """`fixed[i]` tells whether value i depends on no input but those of the arrays named `constant`."""

    def __init__(self, constant=("p",)):
        self.ops, self.fixed, self._index = [], [], {}
        self._constant = frozenset(constant)

    def input(self, array, position) -> Value:
        return self._put(("input", array, position))

    def const(self, number) -> Value:
        return self._put(("const", float(number) + 0.0))

    def value(self, x) -> Value:
        return x if isinstance(x, Value) else self.const(x)

    def add(self, a, b):
        if a.number == 0:
            return b
        if b.number == 0:
            return a
        if a.number is not None and b.number is not None:
            return self.const(a.number + b.number)
        if b.op[0] == "neg":
            return self.sub(a, self.at(b.op[1]))
        if a.op[0] == "neg":
            return self.sub(b, self.at(a.op[1]))
        return self._put(("add", *sorted((a.index, b.index))))

    def sub(self, a, b):
        if b.number == 0:
            return a
        if a.number == 0:
            return self.neg(b)
        if a.index == b.index:
            return self.const(0)
        if a.number is not None and b.number is not None:
            return self.const(a.number - b.number)
        if b.op[0] == "neg":
            return self.add(a, self.at(b.op[1]))
        if a.op[0] == "neg":
            return self.neg(self.add(self.at(a.op[1]), b))
        if ("sub", b.index, a.index) in self._index:
            return self.neg(self.sub(b, a))
        return self._put(("sub", a.index, b.index))

    def mul(self, a, b):
        for x, y in ((a, b), (b, a)):
            if x.number == 0:
                return self.const(0)
            if x.number == 1:
                return y
            if x.number == -1:
                return self.neg(y)
        if a.number is not None and b.number is not None:
            return self.const(a.number * b.number)
        if a.op[0] == "neg":
            return self.neg(self.mul(self.at(a.op[1]), b))
        if b.op[0] == "neg":
            return self.neg(self.mul(a, self.at(b.op[1])))
        return self._put(("mul", *sorted((a.index, b.index))))

    def div(self, a, b):
        if a.number == 0:
            return a
        if b.number == 1:
            return a
        if a.number is not None and b.number is not None:
            return self.const(a.number / b.number)
        if a.op[0] == "neg":
            return self.neg(self.div(self.at(a.op[1]), b))
        return self._put(("div", a.index, b.index))

    def neg(self, a):
        if a.number is not None:
            return self.const(-a.number)
        if a.op[0] == "neg":
            return self.at(a.op[1])
        return self._put(("neg", a.index))

    def call(self, name, a):
        if a.number is not None:
            return self.const(getattr(math, name)(a.number))
        return self._put((name, a.index))

    def reached(self, outputs, known=()) -> list:
        """Indices of what the outputs are computed from, in order, not looking behind those that are known."""
        seen, waiting = set(), [value.index for value in outputs]
        while waiting:
            i = waiting.pop()
            if i in seen or i in known:
                continue
            seen.add(i)
            waiting += arguments(self.ops[i])
        return sorted(seen)

    def operations(self, indices) -> int:
        return sum(self.ops[i][0] not in ("input", "const") for i in indices)

    def differentiate(self, outputs: dict, directions: dict) -> dict:
        """Exact derivatives: {(output, label): value} of outputs {name: value} in directions {label: input}; zeros left out."""
        order = self.reached(outputs.values())
        derived = {}
        for label, direction in directions.items():
            dot = {direction.index: self.const(1)}
            for i in order:
                change = self._change(i, dot)
                if change is not None and change.number != 0:
                    dot[i] = change
            derived |= {(name, label): dot[value.index] for name, value in outputs.items() if value.index in dot}
        return derived

    def _change(self, i, dot):
        """d(value i) from those of what it is made of; None where none of them changes."""
        kind, *rest = self.ops[i]
        if kind in ("input", "const") or not any(k in dot for k in rest):
            return None
        y, zero = self.at(i), self.const(0)
        a, da = self.at(rest[0]), dot.get(rest[0], zero)
        if len(rest) == 2:
            b, db = self.at(rest[1]), dot.get(rest[1], zero)
            return {"add": lambda: da + db, "sub": lambda: da - db, "mul": lambda: da * b + a * db,
                    "div": lambda: (da - y * db) / b}[kind]()
        return {"neg": lambda: -da, "sqrt": lambda: da * (0.5 / y), "sin": lambda: da * self.call("cos", a),
                "cos": lambda: -(da * self.call("sin", a)), "tan": lambda: da * (1 + y * y),
                "atan": lambda: da / (1 + a * a)}[kind]()

    def evaluate(self, outputs: dict, inputs: dict, functions=math) -> dict:
        """Numbers of outputs {name: value} at inputs {array: numbers}, with `functions.sin` and so on."""
        number = {}
        for i in self.reached(outputs.values()):
            kind, *rest = self.ops[i]
            if kind == "input":
                number[i] = inputs[rest[0]][rest[1]]
            elif kind == "const":
                number[i] = rest[0]
            elif kind in FUNCTIONS:
                number[i] = getattr(functions, kind)(number[rest[0]])
            else:
                a, b = number[rest[0]], number[rest[-1]]
                number[i] = -a if kind == "neg" else a + b if kind == "add" else a - b if kind == "sub" else a * b if kind == "mul" else a / b
        return {name: number[value.index] for name, value in outputs.items()}

    def at(self, index) -> Value:
        return Value(self, index)

    def _put(self, op) -> Value:
        if op not in self._index:
            self._index[op] = len(self.ops)
            self.ops.append(op)
            self.fixed.append(op[1] in self._constant if op[0] == "input" else all(self.fixed[k] for k in arguments(op)))
        return Value(self, self._index[op])


def arguments(op) -> tuple:
    """Indices of the values that an operation reads."""
    return () if op[0] in ("input", "const") else op[1:]
