"""The SymPy scripts that the command line exports, run as they are: they derive the equations again and compare."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
SYSTEMS = ["bicycle", "cart-pendulum", "rolling-wheel", "stiff-decay"]
TYPED = """coordinate x, lambda [m] = 0.3
coordinate a [rad]
parameter w1 [kg] = 2
frame arm = world turned y a
body b mass w1 inertia (1, 2, 3, 0.1, 0.2, 0.3) at (x, 0, lambda) + arm(0.3, 0, 0.1) in arm
potential abs(x) + tanh(a) + log10(1 + x^2) + (x < a ? x^2 : a^2)
damper 0.3 on x - a
force atan2(x, 2) on lambda
drive lambda = 0.1 sin(3 t)
velocity x' = 0.2 cos(a)
"""


def run(scenario):
    with tempfile.TemporaryDirectory() as folder:
        file, script = pathlib.Path(folder, "scenario.json"), pathlib.Path(folder, "system.py")
        file.write_text(json.dumps({"version": 1, **scenario}), encoding="utf-8")
        export = ["node", "--import", "tsx", "src/cli/main.ts", "export", str(file), "--as", "sympy", "--out", str(script)]
        subprocess.run(export, cwd=ROOT, check=True, capture_output=True)
        return subprocess.run([sys.executable, str(script)], capture_output=True, text=True, check=False)


class Scripts(unittest.TestCase):
    def test_agree(self):
        held = {"system": "ripstik", "hold": ["alpha_fp"], "initial": {"alpha_fp": 0.2}, "parameters": {"wheelDrag": 0.3}}
        scenarios = [{"system": system} for system in SYSTEMS] + [held, {"system": {"description": TYPED}}]
        for scenario in scenarios:
            with self.subTest(scenario=scenario):
                done = run(scenario)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.assertIn("largest relative difference", done.stdout)


if __name__ == "__main__":
    unittest.main()
