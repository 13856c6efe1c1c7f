"""The installed package gives the numbers of the repository's command line, to the bit."""

import csv
import json
import pickle
import re
import subprocess
import tempfile
import unittest
from importlib.util import find_spec
from pathlib import Path

from ripstik_lab import RipstikError, Scenario, linearize, simulate, sweep
from ripstik_lab.command import node

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/own-systems.md"
REGULATED = Scenario(
    "ripstik",
    initial={"X_dot": 1, "alpha": "10 deg"},
    control={"type": "lqr", "inputs": ["tau_fc", "tau_bc"], "at": {"X_dot": 1}},
    columns=["energy"],
    duration=0.3,
)
STUDY = {
    "version": 1,
    "scenario": {"version": 1, "system": "caster-rotation", "duration": 0.5},
    "vary": {"parameters.casterTrail": {"uniform": [0.02, 0.05]}, "method.name": {"list": ["rk4", "dopri5"]}},
    "sample": {"kind": "random", "count": 12, "seed": 3},
    "measures": ["drift", "steps"],
}


def command(*arguments, document):
    """Standard output of the repository's own command line, run from its sources."""
    given = json.dumps(document)
    line = [node(), "--import", "tsx", "src/cli/main.ts", *arguments]
    return subprocess.run(line, cwd=ROOT, input=given, capture_output=True, encoding="utf-8", check=True).stdout


def table(text):
    header, *rows = csv.reader(line for line in text.splitlines() if line and not line.startswith("#"))
    return dict(zip(header, zip(*rows)))


def bits(values):
    return [float(value or "nan").hex() if isinstance(value, str) else float(value).hex() for value in values]


class Numbers(unittest.TestCase):
    def test_a_run(self):
        run = simulate(REGULATED)
        expected = table(command("simulate", "-", document=REGULATED))
        self.assertEqual(run.names, list(expected))
        self.assertEqual(len(run), 31)
        for name, cells in expected.items():
            self.assertEqual(bits(run[name]), bits(cells), name)
        self.assertIsNone(run.stopped)
        self.assertIn(run.engine, ("wasm", "typescript"))

    def test_a_linearization(self):
        near = linearize(REGULATED)
        expected = json.loads(command("linearize", "-", document=REGULATED))
        self.assertEqual(near.report, expected)
        for name in "ABK":
            mine, right = getattr(near, name), expected[name]
            self.assertEqual([bits(row) for row in mine], [bits(row) for row in right], name)
        self.assertEqual([[z.real, z.imag] for z in near.eigenvalues], expected["eigenvalues"])

    def test_a_study(self):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "results.csv"
            command("sweep", "-", "--out", str(out), document=STUDY)
            expected = table(out.read_text(encoding="utf-8"))
        results = sweep(STUDY, workers=2)
        self.assertEqual(results.names, list(expected))
        for name, cells in expected.items():
            mine = results[name]
            self.assertEqual(*((list(mine), list(cells)) if isinstance(mine[0], str) else (bits(mine), bits(cells))), name)
        second = sweep(STUDY, shard="2/5")
        self.assertEqual(list(second["index"]), [1, 6, 11])
        self.assertEqual(bits(second["drift"]), bits(results["drift"][i] for i in (1, 6, 11)))

    def test_more_parts_than_runs(self):
        self.assertEqual(len(sweep(STUDY, shard="20/20")), 0)


class Scenarios(unittest.TestCase):
    def test_a_case_a_file_and_a_change(self):
        self.assertIn("released", Scenario.cases())
        released = Scenario.case("released")
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "s.json"
            path.write_text(json.dumps(released), encoding="utf-8")
            self.assertEqual(Scenario.read(path), released)
            changed = released.changed({"duration": 0.02})
            path.write_text(json.dumps(changed), encoding="utf-8")
            self.assertEqual(bits(simulate(path)["t"]), bits(simulate(changed)["t"]))
        self.assertNotEqual(released["duration"], 0.02)
        self.assertEqual(pickle.loads(pickle.dumps(changed)), changed)

    def test_a_system_of_ones_own(self):
        description = re.search(r"```\n(system \"Pendulum\".*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL).group(1)
        pendulum = Scenario({"description": description}, duration=1, columns=["energy"])
        run = simulate(pendulum)
        self.assertEqual(run["theta"][0], 0.5)
        self.assertAlmostEqual(run["energy"][0], run["energy"][-1], places=6)


class Errors(unittest.TestCase):
    def test_the_commands_own_sentence(self):
        with self.assertRaisesRegex(RipstikError, r'^system: unknown name "nono"; right would be ripstik, '):
            simulate(Scenario("nono"))
        with self.assertRaisesRegex(RipstikError, r"^at: this is no steady motion"):
            linearize(Scenario("stiff-decay"))
        with self.assertRaisesRegex(RipstikError, r"^measures"):
            sweep({**STUDY, "measures": ["final.nono"]})

    def test_a_run_that_stops_keeps_its_rows(self):
        fall = Scenario("ripstik", constraints="rolling", initial={"alpha": "40 deg"}, events={"touchdown": "stop"}, duration=5)
        run = simulate(fall)
        self.assertLess(run["t"][-1], 5)
        self.assertGreater(len(run), 1)
        self.assertRegex(run.stopped, r"\S")
        self.assertNotIn("stopped early", run.stopped)

    def test_what_is_no_scenario(self):
        with self.assertRaisesRegex(RipstikError, "can't be read: No such file"):
            simulate("nowhere.json")
        with self.assertRaisesRegex(RipstikError, "finite numbers only"):
            simulate(Scenario("ripstik", duration=float("inf")))
        with self.assertRaisesRegex(RipstikError, "what JSON can"):
            simulate(Scenario("ripstik", duration=object()))
        with self.assertRaisesRegex(RipstikError, 'there is no column "nono"; there are t, '):
            simulate(REGULATED)["nono"]


@unittest.skipUnless(find_spec("numpy"), "NumPy is not installed")
class Arrays(unittest.TestCase):
    def test_numpy(self):
        import numpy

        run = simulate(REGULATED.changed({"duration": numpy.float64(0.05)}))
        self.assertIsInstance(run["t"], numpy.ndarray)
        self.assertTrue(run["t"].flags.writeable)
        self.assertEqual(linearize(REGULATED).A.shape, (20, 20))
        self.assertEqual(sweep(STUDY, shard="1/6")["index"].dtype.kind, "i")

    @unittest.skipUnless(find_spec("pandas"), "pandas is not installed")
    def test_pandas(self):
        frame = sweep(STUDY).to_pandas()
        self.assertEqual(list(frame["index"]), list(range(12)))
        self.assertEqual(set(frame["method.name"]), {"rk4", "dopri5"})
        self.assertEqual(simulate(REGULATED).to_pandas().shape, (31, 22))

    @unittest.skipUnless(find_spec("control"), "python-control is not installed")
    def test_python_control(self):
        import numpy

        near = linearize(REGULATED)
        board = near.to_statespace()
        self.assertEqual((board.nstates, board.ninputs, board.noutputs), (20, 2, 20))
        self.assertEqual(board.state_labels, near.states)
        numpy.testing.assert_array_equal(board.A, near.A)
        numpy.testing.assert_array_equal(board.B, near.B)


if __name__ == "__main__":
    unittest.main()
