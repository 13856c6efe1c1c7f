"""SymPy expressions as LaTeX in which every symbol of the model is marked, `\\s{alpha_fp_dot}`.

A mark is the name under which the model knows the symbol; what it is set as stands in a table beside the formulas. So
the page can say of each letter what it means, and plain LaTeX is one replacement away.
"""

import re

import sympy as sp
from sympy.printing.latex import LatexPrinter

GREEK = {
    "α": r"\alpha", "β": r"\beta", "δ": r"\delta", "ζ": r"\zeta", "θ": r"\theta", "κ": r"\kappa", "λ": r"\lambda", "ρ": r"\rho", "τ": r"\tau", "φ": r"\varphi", "ψ": r"\psi", "ω": r"\omega",
}


# A numerator with more operations than this stands behind its fraction.
LONG = 24


class Printer(LatexPrinter):
    """Functions of one symbol without brackets; brackets that may be broken between lines."""

    def __init__(self):
        super().__init__({"fold_func_brackets": True, "fold_short_frac": False, "mul_symbol": None, "order": None})

    def _print_Symbol(self, expr, style="plain"):
        return rf"\s{{{expr.name}}}"

    def _print_Mul(self, expr):
        """A rational factor stands in front, so that a long sum is not caught in a fraction."""
        above, below = sp.fraction(expr)
        if below != 1 and sp.count_ops(above) > LONG:
            inner = self._print(above)
            return rf"\frac{{1}}{{{self._print(below)}}} " + (f"({inner})" if above.is_Add or above.could_extract_minus_sign() else inner)
        factor, rest = expr.as_coeff_Mul()
        if not (factor.is_Rational and factor.q != 1) or sp.fraction(rest)[1] != 1:
            return super()._print_Mul(expr)
        sign = "- " if factor < 0 else ""
        inner = self._print(rest)
        return rf"{sign}\tfrac{{{abs(factor.p)}}}{{{factor.q}}} " + (f"({inner})" if rest.is_Add else inner)


_printer = Printer()


def latex(expression) -> str:
    """Marked LaTeX of a scalar."""
    text = _printer.doprint(sp.sympify(expression))
    text = text.replace(r"\left(", "(").replace(r"\right)", ")").replace(r"\frac{", r"\dfrac{")
    return re.sub(r" +", " ", text)


def column(entries) -> str:
    return r"\begin{pmatrix} " + r" \\ ".join(latex(e) for e in entries) + r" \end{pmatrix}"


def matrix(m) -> str:
    """A diagonal matrix by its diagonal, another entry by entry."""
    if m.is_zero_matrix:
        return "0"
    if m.is_diagonal():
        return r"\operatorname{diag}(" + r",\ ".join(latex(m[i, i]) for i in range(m.rows)) + ")"
    rows = [" & ".join(latex(e) for e in m.row(i)) for i in range(m.rows)]
    return r"\begin{pmatrix} " + r" \\ ".join(rows) + r" \end{pmatrix}"


def typeset(short: str, over: str = "") -> str:
    """`α_fp` as `\\alpha_{fp}`; `over` is a command for an accent."""
    base, *rest = short.split("_")
    letter, below = GREEK.get(base, base), "_".join(rest)
    if re.fullmatch("[a-z]{3,}", below):
        below = rf"\mathrm{{{below}}}"
    return (rf"{over}{{{letter}}}" if over else letter) + (f"_{{{below}}}" if below else "")


def plain(text: str, symbols: dict) -> str:
    """Marked LaTeX with every mark set."""
    return re.sub(r"\\s\{([^}]+)\}", lambda found: symbols[found[1]], text)
