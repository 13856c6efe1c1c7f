"""The example of docs/python.md, run as written."""

import contextlib
import io
import re
import unittest
from pathlib import Path

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


if __name__ == "__main__":
    unittest.main()
