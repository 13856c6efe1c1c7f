"""Writes expression-derivatives.json: random formulas over the range of doubles, their values and rates at one t each,
from mpmath (forward differentiation in 600 digits, exponents without bound).

`tolerance` is what rounding does to the rate: its largest change over runs in which every part is moved by about two units
in the last place of a double (of its logarithm, for what is beyond doubles). Formulas whose rate has no digit left then, or
which have none, are left out.

    python3 tests/reference/expression_derivatives.py > tests/reference/expression-derivatives.json
"""

import json
import random

from mpmath import mp, mpf

mp.dps = 600
COUNT = 700
NOISES = 8
LARGEST_ARGUMENT = mpf(10) ** 400  # exp of more needs more digits than mp.dps


class Undefined(Exception):
    pass


def number(rng):
    return rng.choice(['1', '2', '3', '0.5', '10', '100', '1e-3', '1e5', '1e-20', '1e20', '1e-150', '1e150', '1e-300', '1e300'])


def formula(rng, depth):
    if depth == 0 or rng.random() < 0.12:
        return ('t',) if rng.random() < 0.7 else ('number', number(rng))
    sub = lambda: formula(rng, depth - 1)
    kind = rng.random()
    if kind < 0.45:
        return (rng.choice('+-**//'), sub(), sub())
    if kind < 0.55:
        return ('^', sub(), ('number', rng.choice(['2', '3', '0.5', '-1', '-2', '10', '200'])))
    return (rng.choice(['exp', 'exp', 'exp', 'tanh', 'log', 'sqrt', 'atan', 'sinh', 'cosh', 'cbrt', 'sin', 'negative', 'log10']), sub())


def text(f):
    op = f[0]
    if op == 't':
        return 't'
    if op == 'number':
        return f'({f[1]})'
    if op == 'negative':
        return f'(-{text(f[1])})'
    if len(f) == 3:
        return f'({text(f[1])}{op}{text(f[2])})'
    return f'{op}({text(f[1])})'


def dual(f, t, noise):
    op = f[0]
    if op == 't':
        return mpf(t), mpf(1)
    if op == 'number':
        return mpf(float(f[1])), mpf(0)
    a, da = dual(f[1], t, noise)
    if len(f) == 3:
        b, db = dual(f[2], t, noise)
        if op == '+':
            v, d = a + b, da + db
        elif op == '-':
            v, d = a - b, da - db
        elif op == '*':
            v, d = a * b, da * b + a * db
        elif op == '/':
            if b == 0:
                raise Undefined
            v = a / b
            d = (da - v * db) / b
        else:
            if a == 0 or (a < 0 and b != int(b)):
                raise Undefined
            v = a ** int(b) if b == int(b) else mp.exp(b * mp.log(a))
            d = b * v / a * da
    elif op == 'negative':
        v, d = -a, -da
    else:
        if op in ('exp', 'sinh', 'cosh', 'tanh') and abs(a) > LARGEST_ARGUMENT:
            raise Undefined
        if op in ('log', 'log10', 'sqrt') and a <= 0 or op == 'cbrt' and a == 0:
            raise Undefined
        if op == 'sin' and abs(a) > 1e6:
            raise Undefined
        if op == 'exp':
            v = mp.exp(a)
            s = v
        elif op in ('sinh', 'cosh'):
            v, s = (mp.sinh(a), mp.cosh(a)) if op == 'sinh' else (mp.cosh(a), mp.sinh(a))
        elif op == 'tanh':
            v = mp.tanh(a)
            s = 1 / mp.cosh(a) ** 2
        elif op == 'log':
            v, s = mp.log(a), 1 / a
        elif op == 'log10':
            v, s = mp.log10(a), 1 / (a * mp.log(10))
        elif op == 'sqrt':
            v = mp.sqrt(a)
            s = 1 / (2 * v)
        elif op == 'cbrt':
            v = mp.sign(a) * mp.exp(mp.log(abs(a)) / 3)
            s = v / a / 3
        elif op == 'atan':
            v, s = mp.atan(a), 1 / (1 + a * a)
        else:
            v, s = mp.sin(a), mp.cos(a)
        d = s * da
    # A part without t is computed once and has to be a double of its own.
    if d == 0 and constant(f) and not mpf(10) ** -300 < abs(v) < mpf(10) ** 300:
        raise Undefined
    return noise(v), noise(d)


def constant(f):
    return f[0] != 't' and all(constant(part) for part in f[1:] if isinstance(part, tuple))


def shaken(rng):
    def noise(x):
        if x == 0:
            return x
        size = max(1, abs(mp.log(abs(x))) / 100)
        return x * (1 + rng.choice([-1, 1]) * mpf(2) ** -51 * size)

    return noise


def main():
    rng = random.Random(20240611)
    entries = []
    while len(entries) < COUNT:
        f = formula(rng, rng.randint(2, 5))
        t = rng.choice([-1, 1, 1]) * rng.choice([rng.uniform(0, 10), 10 ** rng.uniform(-6, 6), 10 ** rng.uniform(-300, 300)])
        if len(text(f)) > 150 or 't' not in text(f).replace('tan', '').replace('sqrt', '').replace('cbrt', ''):
            continue
        try:
            value, rate = dual(f, t, lambda x: x)
            runs = [dual(f, t, shaken(rng)) for _ in range(NOISES)]
        except (Undefined, OverflowError, ZeroDivisionError, ValueError):
            continue
        if isinstance(rate, mp.mpc) or isinstance(value, mp.mpc):
            continue
        tolerance = max(abs(r - rate) for _, r in runs)
        valued = max(abs(v - value) for v, _ in runs)
        if abs(rate) > mpf(10) ** 300 or abs(value) > mpf(10) ** 300 or tolerance > mpf(10) ** 290:
            continue
        if tolerance > abs(rate) / 100 and abs(rate) > mpf(10) ** -250:
            continue
        entries.append([text(f), t] + [float(mp.nstr(x, 17)) for x in (value, valued, rate, tolerance)])
    print('{"origin": "tests/reference/expression_derivatives.py, mpmath ' + '1.3.0, seed 20240611",')
    print(' "columns": ["text", "t", "value", "valueTolerance", "rate", "tolerance"],\n "entries": [')
    print(',\n'.join(json.dumps(e) for e in entries))
    print(']}')


main()
