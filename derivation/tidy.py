"""Shorter trigonometric polynomials, in time that does not surprise: every even power of a sine, or of a cosine, is replaced."""

import sympy as sp


def tidy(expression, letters=()):
    """The shortest found of an expression polynomial in sines and cosines; letters: [(symbol, expression it stands for)]."""
    e = sp.sympify(expression).subs({meaning: symbol for symbol, meaning in letters})
    arguments = sorted({f.args[0] for f in e.atoms(sp.sin, sp.cos)}, key=str)
    if not arguments:
        return sp.factor_terms(sp.expand(e))
    pairs = [(sp.cos(a), sp.sin(a), sp.Dummy("c"), sp.Dummy("s")) for a in arguments]
    short = {f: d for c, s, dc, ds in pairs for f, d in ((c, dc), (s, ds))}
    expanded = sp.expand(e.xreplace(short))
    found = [e, sp.factor_terms(expanded)]
    for keep_cosines in (True, False):
        reduced = expanded
        for _, _, dc, ds in pairs:
            kept, gone = (dc, ds) if keep_cosines else (ds, dc)
            reduced = without_squares(reduced, gone, kept)
        found.append(sp.factor_terms(reduced))
    back = {d: f for f, d in short.items()}
    return min((f.xreplace(back) for f in found), key=lambda f: (sp.count_ops(f), str(f)))


def without_squares(e, gone, kept):
    """gone^2 = 1 - kept^2 wherever it stands."""
    if not e.has(gone):
        return e
    total = sp.Integer(0)
    for term in sp.Add.make_args(e):
        rest, power = term.as_independent(gone)[0], sp.Integer(term.as_powers_dict().get(gone, 0))
        if not (power.is_Integer and power >= 0) or rest * gone**power != term:
            return e
        total += rest * (1 - kept**2) ** (power // 2) * gone ** (power % 2)
    return sp.expand(total)
