"""The stage in a notebook: what it is given, and that it is whole without anything else."""

import base64
import gzip
import html
import json
import re
import tempfile
import unittest
from importlib.util import find_spec
from pathlib import Path

from ripstik_lab import RipstikError, Scenario, Stage, simulate

PENDULUM = Scenario("cart-pendulum", initial={"theta": 0.4}, duration=0.5)


def parts(document):
    """The page and the first messages, unpacked."""
    page, first = (gzip.decompress(base64.b64decode(text)).decode("utf-8") for text in re.findall(r'bytes\("([^"]+)"\)', document))
    return page, json.loads(first)


class TheStage(unittest.TestCase):
    def test_a_run_is_shown_with_its_own_rows(self):
        run = simulate(PENDULUM)
        frame = Stage(run, plots=["theta", {"x": "X", "y": ["theta"]}], title="Swing", live=False).html()
        document = html.unescape(re.fullmatch(r'<iframe .* srcdoc="(.*)"></iframe>', frame, re.DOTALL).group(1))
        page, first = parts(document)
        self.assertEqual(
            first,
            [
                {"type": "load", "csv": run.csv, "title": "Swing"},
                {"type": "plots", "panes": [{"y": ["theta"]}, {"x": "X", "y": ["theta"]}]},
            ],
        )
        self.assertIn("default-src 'none'", page)
        for text in (page.partition("<script")[0], document):
            self.assertNotRegex(text, r"(src|href)=.?https?:")

    def test_a_scenario_is_a_file_too(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "stage.html"
            Stage(PENDULUM, plots=False).save(path)
            first, again = path.read_bytes(), Path(folder) / "again.html"
            Stage(json.dumps(PENDULUM), plots=False).save(again)
            self.assertEqual(first, again.read_bytes())
            self.assertEqual(parts(first.decode("utf-8"))[1], [{"type": "load", "scenario": PENDULUM, "title": "Scenario"}])

    def test_what_cannot_be_shown(self):
        with self.assertRaisesRegex(RipstikError, 'there is no column "nono"; there are t, '):
            Stage(simulate(PENDULUM), plots=["nono"])
        for plots in (3, [3], [{"x": "X"}], [["theta", 1]]):
            with self.assertRaisesRegex(RipstikError, "plots is True, False or a list such as"):
                Stage(PENDULUM, plots=plots)
        with self.assertRaisesRegex(RipstikError, "not None"):
            Stage(None)
        with self.assertRaisesRegex(RipstikError, "theme is"):
            Stage(PENDULUM, theme="sepia")
        with self.assertRaisesRegex(RipstikError, "from 120 to 4000"):
            Stage(PENDULUM, height=12)
        with self.assertRaisesRegex(RipstikError, "can't be read: No such file"):
            Stage("nowhere.json")
        with self.assertRaisesRegex(RipstikError, "plays by itself; to speak to it"):
            Stage(PENDULUM, live=False).play()


@unittest.skipUnless(find_spec("anywidget"), "anywidget is not installed")
class TheWidget(unittest.TestCase):
    def test_it_speaks_and_hears(self):
        first, second = Stage(PENDULUM), Stage(PENDULUM)
        self.assertIs(first._widget.page, second._widget.page)
        self.assertEqual({"text/plain", "text/html"} - first._repr_mimebundle_().keys(), set())
        said = []
        first._widget.send = lambda message: said.append(message)
        first.seek(1)
        first.set("initial.theta", "5 deg")
        first.load(PENDULUM.changed({"duration": 1}), title="Longer")
        self.assertEqual([message["type"] for message in said], ["seek", "set", "load"])
        self.assertIsNone(first.state)
        first._widget._hear(None, {"ripstik": 1, "type": "state", "time": 1.0, "values": {"theta": 0.1}}, [])
        first._widget._hear(None, {"ripstik": 1, "type": "error", "message": "no"}, [])
        self.assertEqual((first.state, first.error), ({"time": 1.0, "values": {"theta": 0.1}}, "no"))
        self.assertEqual(json.loads(gzip.decompress(first._widget.first))[0]["title"], "Longer")


if __name__ == "__main__":
    unittest.main()
