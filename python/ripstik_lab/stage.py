"""The stage in a notebook: a run or a scenario with its transport and plots."""

from __future__ import annotations

import base64
import functools
import gzip
import html
import json
import os
from pathlib import Path
from typing import Any, Iterable, Mapping, Optional, Sequence, Union

from . import command
from .errors import RipstikError
from .simulation import Run

_FOLDER = Path(__file__).parent
_THEMES = ("light", "dark")

#: Columns over time, or one plot as ``{"x": "X", "y": ["Y"]}``.
Plot = Union[str, Sequence[str], Mapping[str, Any]]


class Stage:
    """A run or a scenario on the stage of the page, with its transport and plots.

    As the last value of a notebook's cell it is shown there, without a network: the page is in this package. A notebook that
    is exported to HTML keeps it, and it plays there without a kernel. With anywidget installed it can be spoken to from
    other cells (``play``, ``seek``, ``set`` …) and tells its ``state``.
    """

    def __init__(
        self,
        subject: Any,
        *,
        plots: Union[bool, Iterable[Plot]] = True,
        title: Optional[str] = None,
        height: int = 460,
        theme: Optional[str] = None,
        live: bool = True,
    ) -> None:
        """
        :param subject: a `Run`, whose rows are played as they are, or a scenario, which the stage computes itself: a mapping,
            JSON text, or the path of its file
        :param plots: those that suit the motion, none (``False``), or a list: ``["alpha", ["beta", "gamma"], {"x": "X", "y": ["Y"]}]``
        :param title: absent: what it is
        :param height: px
        :param theme: ``"light"`` or ``"dark"``; absent: as the notebook, light in an exported page
        :param live: whether other cells may speak to it, where anywidget is installed. Without, a notebook that is executed and
            exported in one go holds the stage as plain HTML, which needs no network
        :raises RipstikError: with what is wrong
        """
        if theme is not None and theme not in _THEMES:
            raise RipstikError(f'theme is "light" or "dark", not {theme!r}')
        if not isinstance(height, int) or isinstance(height, bool) or not 120 <= height <= 4000:
            raise RipstikError(f"height is a whole number of pixels from 120 to 4000, not {height!r}")
        self.height = height
        self.theme = theme or ""
        self._first = [_load(subject, title), *_plots(plots, subject)]
        self._widget = _widget(self) if live else None

    def html(self) -> str:
        """The stage as HTML that needs nothing else: one frame, its page inside."""
        document = _document(_page(), self.packed_first(), self.theme)
        return (
            f'<iframe title="RipStik Lab" sandbox="allow-scripts allow-downloads" allow="fullscreen" '
            f'style="width: 100%; height: {self.height}px; border: 0" srcdoc="{html.escape(document)}"></iframe>'
        )

    def save(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes an HTML file with the stage alone, which plays in any browser without a network.

        :raises RipstikError: where it can't be written
        """
        try:
            Path(path).write_text(_document(_page(), self.packed_first(), self.theme), encoding="utf-8")
        except OSError as error:
            raise RipstikError(f"{os.fspath(path)} can't be written: {error.strerror}") from error

    def packed_first(self) -> bytes:
        """What the stage is told when it begins: JSON, gzipped."""
        return _packed(json.dumps(self._first, allow_nan=False))

    @property
    def state(self) -> Optional[dict[str, Any]]:
        """What the stage told last: ``time``, ``playing``, ``values``, ``scenario`` …; None before its first word."""
        return self._spoken_to().state

    @property
    def error(self) -> Optional[str]:
        """Why the stage refused the last that it was told; None where it did not. It is read under the stage too."""
        return self._spoken_to().error

    def play(self) -> None:
        self._spoken_to().say({"type": "play"})

    def pause(self) -> None:
        self._spoken_to().say({"type": "pause"})

    def seek(self, time: float) -> None:
        """:param time: s"""
        self._spoken_to().say({"type": "seek", "time": float(time)})

    def set(self, path: str, value: Union[float, str]) -> None:
        """Changes one number of the scenario, which then runs again.

        :param path: ``"initial.alpha"``, ``"parameters.wheelDrag"``, ``"duration"``
        :param value: SI and radians, or an expression as text (``"5 deg"``)
        """
        self._spoken_to().say({"type": "set", "path": path, "value": value if isinstance(value, str) else float(value)})

    def load(self, subject: Any, title: Optional[str] = None) -> None:
        """Shows another run or scenario in the same place.

        :raises RipstikError: with what is wrong
        """
        message = _load(subject, title)
        self._first[0] = message
        widget = self._spoken_to()
        widget.first = self.packed_first()
        widget.say(message)

    def _spoken_to(self) -> Any:
        if self._widget is None:
            raise RipstikError(
                "this stage plays by itself; to speak to it from Python install anywidget: pip install 'ripstik_lab[widget]'"
            )
        return self._widget

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, Any]:
        # Where a notebook was saved without its widgets' state, or none is understood, what is shown is the HTML.
        view = {} if self._widget is None else self._widget.view()
        return {**view, "text/plain": "RipStik Lab's stage", "text/html": self.html()}


def _load(subject: Any, title: Optional[str]) -> dict[str, Any]:
    named = {} if title is None else {"title": str(title)}
    if isinstance(subject, Run):
        return {"type": "load", "csv": subject.csv, "title": "Run", **named}
    try:
        scenario = json.loads(command.text_of(subject).lstrip("\ufeff"))
    except ValueError as error:
        raise RipstikError(f"the scenario is no JSON: {error}") from error
    if not isinstance(scenario, dict):
        raise RipstikError(f'a stage shows a run, or a scenario, which is an object with "version" and "system", not {scenario!r}')
    return {"type": "load", "scenario": scenario, "title": "Scenario", **named}


def _plots(plots: Union[bool, Iterable[Plot]], subject: Any) -> list[dict[str, Any]]:
    if plots is False:
        return []
    if plots is True:
        return [{"type": "plots"}]
    try:
        panes = [_pane(plot) for plot in ([plots] if isinstance(plots, (str, Mapping)) else plots)]
        named = [name for pane in panes for name in (pane.get("x", "t"), *pane["y"])]
    except (TypeError, KeyError):
        named = [None]
    if not all(isinstance(name, str) for name in named):
        raise RipstikError(f'plots is True, False or a list such as ["alpha", {{"x": "X", "y": ["Y"]}}], not {plots!r}')
    if isinstance(subject, Run):
        for name in named:
            subject[name]  # says which there are
    return [{"type": "plots", "panes": panes}]


def _pane(plot: Plot) -> dict[str, Any]:
    if isinstance(plot, str):
        return {"y": [plot]}
    return dict(plot) if isinstance(plot, Mapping) else {"y": list(plot)}


def _document(page: bytes, first: bytes, theme: str) -> str:
    """A page with the stage in a frame of its own, as a notebook has it."""
    packed = [f'"{base64.b64encode(part).decode("ascii")}"' for part in (page, first)]
    script = (_FOLDER / "stage.js").read_text(encoding="utf-8").partition("\nexport default")[0]
    look = json.dumps({"theme": theme or "light", "height": "100vh"})
    return (
        '<!doctype html><html lang="en"><meta charset="utf-8"><title>RipStik Lab</title>'
        "<style>body { margin: 0 }</style><body><script>\n"
        f"{script}\nconst bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));\n"
        f"void show(document.body, bytes({packed[0]}), bytes({packed[1]}), {look});\n</script></body></html>"
    )


@functools.lru_cache(maxsize=1)
def _page() -> bytes:
    path = _FOLDER / "stage.html.gz"
    if not path.is_file():
        raise RipstikError(f"the stage is missing ({path}): install the wheel that `npm run wheel` builds")
    return path.read_bytes()


def _packed(text: str) -> bytes:
    # Without a time inside, so that the same notebook is the same file.
    return gzip.compress(text.encode("utf-8"), mtime=0)


def _widget(stage: Stage) -> Any:
    try:
        from .widget import StageWidget, shared_page
    except ImportError:
        return None
    return StageWidget(
        page=shared_page(_page()), first=stage.packed_first(), theme=stage.theme, height=stage.height
    )
