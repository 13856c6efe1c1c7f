"""Straight-line programs: common subexpressions, exact forward differentiation, dead code.

Differentiating the tape instead of the expanded expressions takes seconds instead of minutes,
and its cost is a small multiple of the function's own (Griewank and Walther, Evaluating
Derivatives, 2nd ed., SIAM 2008, section 3.1: forward mode).
"""

from dataclasses import dataclass

import sympy as sp


@dataclass
class Tape:
    """`steps` is [(symbol, expression)], each of inputs and earlier symbols; `outputs` {name: expression}."""

    steps: list
    outputs: dict

    def pruned(self) -> "Tape":
        """Only the steps that the outputs need."""
        needed = set()
        for expression in self.outputs.values():
            needed |= expression.free_symbols
        kept = []
        for symbol, expression in reversed(self.steps):
            if symbol in needed:
                kept.append((symbol, expression))
                needed |= expression.free_symbols
        return Tape(kept[::-1], self.outputs)

    def only(self, names) -> "Tape":
        return Tape(self.steps, {name: self.outputs[name] for name in names}).pruned()

    def operations(self) -> int:
        return sum(int(sp.count_ops(e)) for _, e in self.steps) + sum(int(sp.count_ops(e)) for e in self.outputs.values())


def record(outputs: dict, definitions=(), prefix: str = "x") -> Tape:
    """Common-subexpression tape of named scalar expressions; zero outputs are left out.

    definitions: [(symbol, expression)], in order, that the outputs are written in.
    """
    named = {name: sp.sympify(e) for name, e in outputs.items() if sp.sympify(e) != 0}
    given = Tape(list(definitions), named).pruned().steps
    steps, reduced = sp.cse([e for _, e in given] + list(named.values()), symbols=sp.numbered_symbols(prefix), order="canonical")
    defined = [(symbol, e) for (symbol, _), e in zip(given, reduced)]
    return Tape(_ordered([*steps, *defined]), dict(zip(named, reduced[len(given):]))).pruned()


def _ordered(steps):
    """Each step after those it needs; otherwise as given."""
    waiting = dict(steps)
    done = []

    def visit(symbol):
        expression = waiting.pop(symbol)
        for needed in sorted(expression.free_symbols & waiting.keys(), key=lambda s: s.name):
            if needed in waiting:
                visit(needed)
        done.append((symbol, expression))

    for symbol, _ in steps:
        if symbol in waiting:
            visit(symbol)
    return done


class _Dual:
    """Derivative values by symbol in one direction; new steps are appended as they are needed."""

    def __init__(self, steps, direction, prefix):
        self.steps, self.prefix = steps, prefix
        self.dot = {direction: sp.Integer(1)}

    def of(self, partials):
        total = sp.Add(*[partial * self.dot[s] for s, partial in partials if s in self.dot])
        return total

    def store(self, symbol, value):
        if value == 0:
            return
        if not (value.is_Symbol or value.is_Number):
            name = sp.Symbol(f"{self.prefix}{symbol.name}")
            self.steps.append((name, value))
            value = name
        self.dot[symbol] = value


def differentiate(tape: Tape, directions: dict) -> Tape:
    """Exact derivatives of all outputs in the given input symbols.

    directions: {label: input symbol}; the result's outputs are named (output, label).
    """
    partials = [(s, _partials(e)) for s, e in tape.steps]
    ends = {name: _partials(e) for name, e in tape.outputs.items()}
    steps, outputs = list(tape.steps), {}
    for label, symbol in directions.items():
        dual = _Dual(steps, symbol, f"d{label}_")
        for s, ps in partials:
            dual.store(s, dual.of(ps))
        for name, ps in ends.items():
            value = dual.of(ps)
            if value != 0:
                outputs[(name, label)] = value
    return Tape(steps, outputs).pruned()


def _partials(expression):
    return [(s, expression.diff(s)) for s in sorted(expression.free_symbols, key=lambda s: s.name)]
