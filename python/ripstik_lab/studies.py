"""Many runs of one scenario, one row each."""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Iterable, Optional

from . import command
from .errors import RipstikError
from .table import Sheet, Table, columns_of, read_sheet


@dataclass(frozen=True, eq=False)
class Results(Table):
    """``index``, the varied values, the measures, ``reason`` and ``time`` of each run, ordered by index."""


def sweep(study: Any, *, shard: str = "1/1", workers: Optional[int] = None) -> Results:
    """Carries a study out on this machine's cores.

    :param study: a mapping, JSON text, or the path of a study file
    :param shard: ``"2/8"``: the second of eight parts
    :param workers: threads; absent: one a core
    :raises RipstikError: with the path of what is wrong in it
    """
    return results_of([sheet_text(shard, study, workers)])


def sheet_text(shard: str, study: Any, threads: Optional[int]) -> str:
    """The command line's CSV of a part of a study."""
    with tempfile.TemporaryDirectory(prefix="ripstik-") as folder:
        out = Path(folder) / "results.csv"
        given = [] if threads is None else ["--workers", str(threads)]
        command.run(["sweep", "-", "--out", str(out), "--shard", shard, *given], study)
        return out.read_text(encoding="utf-8")


def results_of(parts: Iterable[str]) -> Results:
    """Puts the parts of a study together, ordered by index.

    :raises RipstikError: where a run is there twice
    """
    sheets = [read_sheet(text) for text in parts]
    header = sheets[0].header
    rows = sorted((row for sheet in sheets for row in sheet.rows), key=lambda row: int(row[0]))
    for before, after in zip(rows, rows[1:]):
        if before[0] == after[0]:
            raise RipstikError(f"run {after[0]} is there twice")
    engines = {name for sheet in sheets for name in sheet.comment("ripstik-engine").split(", ") if name}
    columns = columns_of(Sheet(header, rows, []), texts=("reason",))
    columns["index"] = _whole(columns["index"])
    return Results(columns, ", ".join(sorted(engines)))


def _whole(column: Any) -> Any:
    return column.astype(int) if hasattr(column, "astype") else [int(value) for value in column]
