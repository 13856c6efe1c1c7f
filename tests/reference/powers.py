"""Writes powers.json: e^x, log x and x^y to 40 digits by mpmath, as sums of two doubles.  python3 powers.py > powers.json"""

import json
import random
import struct

from mpmath import exp, log, mp, mpf, power

mp.prec = 200
random.seed(20171208)


def two(value):
    high = float(value)
    return [high, float(value - mpf(high))]


def anywhere():
    """A positive double, its exponent as likely as any other."""
    return struct.unpack("<d", struct.pack("<Q", random.getrandbits(63) % 0x7FF0000000000000))[0]


def powers():
    while True:
        x = anywhere() if random.random() < 0.5 else random.uniform(0.01, 3)
        y = random.uniform(-2, 2) if random.random() < 0.3 else random.uniform(-1, 1) * 700 / abs(float(log(x)))
        if 1e-307 < power(mpf(x), mpf(y)) < mpf(1.7e308):
            yield [x, y, *two(power(mpf(x), mpf(y)))]


print(
    json.dumps(
        {
            "exp": [[x, *two(exp(mpf(x)))] for x in [random.uniform(-700, 709) for _ in range(300)] + [random.uniform(-1, 1) for _ in range(200)]],
            "log": [[x, *two(log(mpf(x)))] for x in [anywhere() for _ in range(300)] + [random.uniform(0.5, 2) for _ in range(200)]],
            "pow": [row for row, _ in zip(powers(), range(600))],
        }
    ).replace("], [", "],\n[")
)
