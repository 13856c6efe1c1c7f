"""One run."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Optional

from . import command
from .table import Table, columns_of, read_sheet


@dataclass(frozen=True, eq=False)
class Run(Table):
    """A finished run: ``t``, coordinates, rates, and what the scenario's ``columns`` asks for; SI, radians."""

    #: Why the run ended before its duration, in a sentence; None where it did not.
    stopped: Optional[str]
    warnings: list[str]
    #: The command line's CSV, with its scenario behind the table.
    csv: str = field(repr=False)


def simulate(scenario: Any) -> Run:
    """Runs a scenario.

    :param scenario: a `Scenario` or other mapping, JSON text, or the path of a scenario file
    :raises RipstikError: with the path of what is wrong in it, or why there is no start
    """
    done = command.run(["simulate", "-"], scenario)
    sheet = read_sheet(done.stdout)
    stopped = None
    if done.returncode == command.STOPPED:
        stopped = (command.sentence(done.stderr) or "").replace("stopped early: ", "", 1)
    warnings = [value for key, value in sheet.comments if key == "warning"]
    return Run(columns_of(sheet), sheet.comment("engine"), stopped, warnings, done.stdout)
