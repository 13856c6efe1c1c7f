"""Sine and cosine written out, so that every engine that a tape is written for gives the same bits, and gives them together.

Range reduction by pi/2 in three parts (Cody and Waite) with the rounding carried along, and the polynomials of fdlibm
(Sun Microsystems 1993, k_sin.c and k_cos.c, for |r| <= pi/4; what the rounding carries is larger here, so that it goes in with
the whole sine and cosine as its factors). Within 1 ulp up to |x| = 2^20 pi/2; beyond that, what
the reduction loses is of the size of x's own last digit.
"""

# Adding and subtracting it rounds to an integer.
ROUNDER = 1.5 * 2.0**52
TWO_OVER_PI = 0.6366197723675814
# pi/2 = the sum; the first two have 33 bits, so that their products with the quadrant's number are exact.
HALF_PI = (1.57079632673412561417, 6.07710050630396597660e-11, 2.02226624879595063154e-21)
SINE = (-1.66666666666666324348e-01, 8.33333333332248946124e-03, -1.98412698298579493134e-04, 2.75573137070700676789e-06,
        -2.50507602534068634195e-08, 1.58969099521155010221e-10)
COSINE = (4.16666666666666019037e-02, -1.38888888888741095749e-03, 2.48015872894767294178e-05, -2.75573143513906633035e-07,
          2.08757232129817482790e-09, -1.13596475577881948265e-11)


def sine_and_cosine(x: float) -> tuple:
    """(sin x, cos x), operation by operation as `block` writes them."""
    k = (x * TWO_OVER_PI + ROUNDER) - ROUNDER
    h = x - k * HALF_PI[0]
    w = k * HALF_PI[1]
    r = h - w
    t = ((h - r) - w) - k * HALF_PI[2]
    z = r * r
    u = 0.5 * z
    o = 1 - u
    q = z * (z * _polynomial(COSINE, z))
    s = r + (z * r * _polynomial(SINE, z) + t * (o + q))
    c = o + (((1 - o) - u) + (q - s * t))
    return ((s, c), (c, -s), (-s, -c), (-c, s))[int(k) & 3]


def _polynomial(coefficients, z):
    total = coefficients[-1]
    for coefficient in coefficients[-2::-1]:
        total = coefficient + z * total
    return total


def _text(coefficients, z):
    first, *rest = coefficients
    return f"({first!r} + {z} * {_text(rest, z)})" if rest else repr(first)


def block(n: int, angle: str) -> list:
    """Statements that make `s<n>`, `c<n>` and the quadrant `n<n>` of an angle."""
    first, second, third = HALF_PI
    lines = [
        f"const g{n} = {angle};",
        f"const k{n} = g{n} * {TWO_OVER_PI!r} + {ROUNDER:.0f} - {ROUNDER:.0f};",
        f"const h{n} = g{n} - k{n} * {first!r};",
        f"const w{n} = k{n} * {second!r};",
        f"const r{n} = h{n} - w{n};",
        f"const t{n} = h{n} - r{n} - w{n} - k{n} * {third!r};",
        f"const z{n} = r{n} * r{n};",
        f"const u{n} = 0.5 * z{n};",
        f"const o{n} = 1 - u{n};",
        f"const q{n} = z{n} * (z{n} * {_text(COSINE, f'z{n}')});",
        f"const s{n} = r{n} + (z{n} * r{n} * {_text(SINE, f'z{n}')} + t{n} * (o{n} + q{n}));",
        f"const c{n} = o{n} + (1 - o{n} - u{n} + (q{n} - s{n} * t{n}));",
        f"const n{n} = k{n} & 3;",
    ]
    return [f"  {line}" for line in lines]


def chosen(name: str, n: int) -> str:
    """The sine or the cosine by the quadrant."""
    a, b = (f"s{n}", f"c{n}") if name == "sin" else (f"c{n}", f"s{n}")
    # Quadrants 0 to 3: s, c, -s, -c for the sine; c, -s, -c, s for the cosine.
    odd = f"n{n} === 1 ? {b} : -{b}" if name == "sin" else f"n{n} === 1 ? -{b} : {b}"
    return f"n{n} === 0 ? {a} : n{n} === 2 ? -{a} : {odd}"
