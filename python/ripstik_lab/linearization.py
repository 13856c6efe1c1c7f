"""The motion near a steady one."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

from . import command
from .table import matrix


@dataclass(frozen=True, eq=False)
class Linearization:
    """x' = A x + B u about a steady motion, n coordinates, then n rates, and m inputs."""

    states: list[str]
    inputs: list[str]
    #: 2n x 2n.
    A: Any
    #: 2n x m.
    B: Any
    #: Of the motions that the constraints allow, 1/s.
    eigenvalues: list[complex]
    #: The regulator's gain, m x 2n, with u = -K x; None without a controller.
    K: Any
    #: With the regulator, 1/s; None without a controller.
    closed_loop_eigenvalues: Any
    #: All that ``ripstik-lab linearize`` prints.
    report: dict[str, Any]

    def to_statespace(self) -> Any:
        """python-control's ``StateSpace`` with all states as outputs, named.

        :raises ImportError: where python-control is not installed
        """
        import control
        import numpy

        n, m = len(self.states), len(self.inputs)
        B = numpy.array(self.B, dtype=float).reshape(n, m)
        return control.ss(
            self.A, B, numpy.eye(n), numpy.zeros((n, m)), states=self.states, inputs=self.inputs, outputs=self.states
        )


def linearize(scenario: Any) -> Linearization:
    """Linearizes about the scenario's steady motion (``control.at``, or ``at``).

    :param scenario: a `Scenario` or other mapping, JSON text, or the path of a scenario file
    :raises RipstikError: with the path of what is wrong in it, or why there is no steady motion
    """
    report = json.loads(command.run(["linearize", "-"], scenario).stdout)
    states, inputs = report["states"], report["inputs"]
    gain, closed = report.get("K"), report.get("closedLoopEigenvalues")
    return Linearization(
        states,
        inputs,
        matrix(report["A"], len(states)),
        matrix(report["B"], len(inputs)),
        _complex(report["eigenvalues"]),
        None if gain is None else matrix(gain, len(states)),
        None if closed is None else _complex(closed),
        report,
    )


def _complex(pairs: list[list[float]]) -> list[complex]:
    return [complex(re, im) for re, im in pairs]
