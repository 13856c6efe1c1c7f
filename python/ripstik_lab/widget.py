"""The stage as a widget: needs anywidget (``pip install 'ripstik_lab[widget]'``)."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Optional

import anywidget
import ipywidgets
import traitlets

_SCRIPT = Path(__file__).with_name("stage.js").read_text(encoding="utf-8")


class Page(ipywidgets.Widget):
    """The stage's page, once for all stages of a notebook."""

    packed = traitlets.Bytes().tag(sync=True)


_pages: list[Page] = []


def shared_page(packed: bytes) -> Page:
    """The one page of this kernel; another once its connection was closed."""
    if not _pages or _pages[0].comm is None:
        _pages[:] = [Page(packed=packed)]
    return _pages[0]


class StageWidget(anywidget.AnyWidget):
    """What `Stage` shows."""

    _esm = _SCRIPT
    page = traitlets.Instance(Page).tag(sync=True, **ipywidgets.widget_serialization)
    first = traitlets.Bytes().tag(sync=True)
    theme = traitlets.Unicode().tag(sync=True)
    height = traitlets.Int().tag(sync=True)

    def __init__(self, **traits: Any) -> None:
        super().__init__(**traits)
        self.state: Optional[dict[str, Any]] = None
        self.error: Optional[str] = None
        self.on_msg(self._hear)

    def view(self) -> dict[str, Any]:
        """What a notebook is given to show it."""
        given = self._repr_mimebundle_()
        # anywidget adds metadata, ipywidgets does not.
        return dict(given[0] if isinstance(given, tuple) else given or {})

    def say(self, message: dict[str, Any]) -> None:
        """Sends the stage a message of its protocol."""
        self.error = None
        self.send(message)

    def _hear(self, _: Any, message: dict[str, Any], __: Any) -> None:
        if message.get("type") == "state":
            self.state = {key: value for key, value in message.items() if key not in ("ripstik", "type", "id")}
        elif message.get("type") == "error":
            self.error = str(message.get("message"))
        elif message.get("type") == "ended":
            self.send({"type": "state"})
