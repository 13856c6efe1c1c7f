"""The examples of docs/python.md, run as written; Dask's on a cluster made for it."""

import contextlib
import io
import json
import re
import tempfile
import unittest
from importlib.util import find_spec
from pathlib import Path

STUDY = {
    "version": 1,
    "scenario": {"version": 1, "system": "ripstik", "initial": {"X_dot": 1}, "duration": 0.1},
    "vary": {"initial.alpha": {"grid": ["-10 deg", "10 deg", 240]}},
    "measures": ["final.X"],
}
PAGE = Path(__file__).resolve().parents[2] / "docs/python.md"


class Example(unittest.TestCase):
    def test_runs_as_written(self):
        code = re.search(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL).group(1)
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(code, str(PAGE), "exec"), {})
        run, near, study = printed.getvalue().splitlines()
        self.assertRegex(run, r"^None wasm -?\d")
        self.assertEqual(near, "20 20 2 2")
        self.assertRegex(study, r"^\[.*0\.2\d*.*\]$")

    @unittest.skipUnless(find_spec("distributed") and find_spec("pandas"), "Dask and pandas are not installed")
    def test_on_a_cluster(self):
        from distributed import LocalCluster, default_client

        blocks = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
        (code,) = [block for block in blocks if "import dask" in block]
        with tempfile.TemporaryDirectory() as folder, LocalCluster(n_workers=2, dashboard_address=None) as cluster:
            study = Path(folder, "study.json")
            study.write_text(json.dumps(STUDY), encoding="utf-8")
            here = {
                "tcp://scheduler:8786": cluster.scheduler_address,
                "study.json": study.as_posix(),
                "shards=200": "shards=4",  # each part starts Node
            }
            for written, found in here.items():
                code = code.replace(written, found)
            names = {}
            exec(compile(code, str(PAGE), "exec"), names)
            default_client().close()
        self.assertEqual(list(names["results"]["index"]), list(range(240)))


if __name__ == "__main__":
    unittest.main()
