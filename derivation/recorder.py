"""From SymPy's expressions to the operations of a tape."""

import sympy as sp

from .tape import FUNCTIONS, Tape, Value


class Recorder:
    """Writes expressions on a tape; inputs {array: its symbols}, definitions [(symbol, expression)] in order."""

    def __init__(self, tape: Tape, inputs: dict, definitions=()):
        self.tape = tape
        self._known = {s: tape.input(array, i) for array, symbols in inputs.items() for i, s in enumerate(symbols)}
        # Symbols that a state changes.
        self.moving = {s for array, symbols in inputs.items() if array != "p" for s in symbols}
        for symbol, expression in definitions:
            self._known[symbol] = self(expression)

    def all(self, expressions: dict) -> dict:
        """{name: value} of {name: expression}; zeros are left out."""
        values = {name: self(e) for name, e in expressions.items()}
        return {name: value for name, value in values.items() if value.number != 0}

    def __call__(self, expression) -> Value:
        e = sp.sympify(expression)
        if e not in self._known:
            self._known[e] = self._record(e)
        return self._known[e]

    def _record(self, e) -> Value:
        if e.is_Rational or e.is_Float:
            return self.tape.const(e.p / e.q if e.is_Rational else float(e))
        if e.is_Add:
            return _sum([self(term) for term in e.args])
        if e.is_Mul:
            return self._product(e)
        if e.is_Pow:
            return self._power(e.base, e.exp)
        name = e.func.__name__
        if name in FUNCTIONS:
            return self.tape.call(name, self(e.args[0]))
        raise ValueError(f"a tape cannot hold {sp.srepr(e)[:80]}")

    def _product(self, e) -> Value:
        """Numbers and parameters first, so that what does not depend on the state is one value."""
        above, below = [], []
        for factor in e.args:
            base, exponent = factor.as_base_exp()
            if exponent.is_Rational and exponent < 0:
                below.append(self._power(base, -exponent))
            else:
                above.append(self(factor))
        top = self._multiplied(above)
        return top / self._multiplied(below) if below else top

    def _multiplied(self, factors) -> Value:
        fixed = self.tape.fixed
        ordered = [f for f in factors if fixed[f.index]] + [f for f in factors if not fixed[f.index]]
        total = self.tape.const(1)
        for factor in ordered:
            total = total * factor
        return total

    def _power(self, base, exponent) -> Value:
        if exponent < 0:
            return 1 / self._power(base, -exponent)
        if not (2 * exponent).is_Integer:
            raise ValueError(f"a tape cannot hold the power {exponent}")
        value, total = self(base), self.tape.const(1)
        for bit in bin(int(exponent))[2:]:
            total = total * total
            total = total * value if bit == "1" else total
        return total if exponent.is_Integer else total * self.tape.call("sqrt", value)


def _sum(terms) -> Value:
    total = terms[0]
    for term in terms[1:]:
        total = total + term
    return total
