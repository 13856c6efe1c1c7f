"""Tables of named columns, and how the command line's CSV becomes one."""

from __future__ import annotations

import csv
import io
from array import array
from dataclasses import dataclass
from typing import Any, Iterable, Sequence

from .errors import RipstikError


def numbers(values: Iterable[float]) -> Any:
    """Doubles: a NumPy array where NumPy is installed, otherwise ``array('d')``."""
    column = array("d", values)
    try:
        import numpy
    except ImportError:
        return column
    return numpy.frombuffer(column, dtype=float) if column else numpy.empty(0)


def matrix(rows: Sequence[Sequence[float]], width: int) -> Any:
    """Rows of doubles: a NumPy array of shape (rows, width) where NumPy is installed, otherwise lists."""
    try:
        import numpy
    except ImportError:
        return [list(row) for row in rows]
    return numpy.array(rows, dtype=float).reshape(len(rows), width)


@dataclass(frozen=True, eq=False)
class Table:
    """Columns by name, all of one length; ``table["alpha"]`` is one of them."""

    #: In the order of the CSV.
    columns: dict[str, Any]
    #: What computed the numbers: ``wasm``, ``typescript``, or both.
    engine: str

    @property
    def names(self) -> list[str]:
        return list(self.columns)

    def __getitem__(self, name: str) -> Any:
        try:
            return self.columns[name]
        except KeyError:
            raise RipstikError(f'there is no column "{name}"; there are {", ".join(self.columns)}') from None

    def __len__(self) -> int:
        """Rows."""
        return len(next(iter(self.columns.values())))

    def to_pandas(self) -> Any:
        """The same as a pandas ``DataFrame``.

        :raises ImportError: where pandas is not installed
        """
        import pandas

        return pandas.DataFrame({name: list(c) if isinstance(c, array) else c for name, c in self.columns.items()})


@dataclass(frozen=True)
class Sheet:
    """A CSV of the command line as text cells."""

    header: list[str]
    rows: list[list[str]]
    #: The lines behind the table, ``# key: value``, in order.
    comments: list[tuple[str, str]]

    def comment(self, key: str) -> str:
        return next((value for name, value in self.comments if name == key), "")


def read_sheet(text: str) -> Sheet:
    """Takes the table and the comments behind it apart."""
    table, mark, behind = text.partition("\n# ")
    header, *rows = filter(None, csv.reader(io.StringIO(table)))
    comments = [tuple(line.split(": ", 1)) for line in behind.split("\n# ")] if mark else []
    return Sheet(header, rows, [(key, value.rstrip("\n")) for key, value in comments])


def columns_of(sheet: Sheet, texts: Sequence[str] = ()) -> dict[str, Any]:
    """Columns of numbers, an empty cell being NaN; of text for the names in ``texts`` and wherever a cell is no number."""
    cells = list(zip(*sheet.rows)) or [()] * len(sheet.header)
    return {name: list(column) if name in texts else _column(column) for name, column in zip(sheet.header, cells)}


def _column(cells: Sequence[str]) -> Any:
    try:
        return numbers(float(cell) if cell else float("nan") for cell in cells)
    except ValueError:
        return list(cells)
