"""`python3 -m derivation` writes the generated TypeScript; `--check` compares it byte for byte.

Systems named after it (`python3 -m derivation cart-pendulum`) are done alone.
"""

import sys
import time
from pathlib import Path

from . import (bicycle, bicycle_rider, cart_pendulum, caster_rotation, casterboard_robot, chaplygin_sleigh, generate, ripstik, ripstik_rider, rolling_wheel, stiff_decay,
               wheel_pendulum)

SYSTEMS = {
    "ripstik": ripstik,
    "ripstik-rider": ripstik_rider,
    "stiff-decay": stiff_decay,
    "caster-rotation": caster_rotation,
    "cart-pendulum": cart_pendulum,
    "rolling-wheel": rolling_wheel,
    "wheel-pendulum": wheel_pendulum,
    "casterboard-robot": casterboard_robot,
    "chaplygin-sleigh": chaplygin_sleigh,
    "bicycle": bicycle,
    "bicycle-rider": bicycle_rider,
}
ROOT = Path(__file__).resolve().parent.parent


def main(arguments) -> int:
    check = "--check" in arguments
    wrong = 0
    chosen = [argument for argument in arguments if not argument.startswith("--")]
    for name in chosen or SYSTEMS:
        module = SYSTEMS[name]
        start = time.perf_counter()
        texts = generate.modules(module.model(), name)
        seconds = time.perf_counter() - start
        for file, text in texts.items():
            path = ROOT / "src" / "core" / "systems" / name / file
            shown = path.relative_to(ROOT)
            if not check:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
                print(f"{name}: wrote {shown} ({len(text) / 1000:.0f} kB)")
                continue
            same = path.exists() and path.read_text(encoding="utf-8") == text
            wrong += not same
            print(f"{name}: {shown} {'is what the derivation gives' if same else 'DIFFERS from the derivation'}")
        print(f"{name}: {seconds:.1f} s")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
