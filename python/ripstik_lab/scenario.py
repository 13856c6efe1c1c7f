"""Scenarios: the JSON of a scenario file as a dictionary."""

from __future__ import annotations

import copy
import json
import os
from typing import Any, Mapping

from . import command
from .errors import RipstikError


class Scenario(dict):
    """A scenario as its file has it; the core checks it where it is used.

    ``Scenario("ripstik", initial={"X_dot": 1}, duration=2)``; every key of a scenario file may be named.
    """

    def __init__(self, system: Any, **keys: Any) -> None:
        """
        :param system: the id of a system, or ``{"description": text}`` for one of your own
        :param keys: the scenario's other keys
        """
        super().__init__({"version": 1, "system": system, **keys})

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Scenario:
        """The scenario in a file.

        :raises RipstikError: where it can't be read
        """
        try:
            return cls._of(json.loads(command.text_of(os.fspath(path)).lstrip("\ufeff")))
        except ValueError as error:
            raise RipstikError(f"{os.fspath(path)} is no JSON: {error}") from error

    @classmethod
    def case(cls, name: str) -> Scenario:
        """A built-in case by its id; ``cases()`` lists them.

        :raises RipstikError: where there is no such case
        """
        return cls._of(json.loads(command.run(["cases", name]).stdout))

    @staticmethod
    def cases() -> list[str]:
        """The ids of the built-in cases."""
        return [case["id"] for case in json.loads(command.run(["cases"]).stdout)]

    def changed(self, values: Mapping[str, Any]) -> Scenario:
        """A copy with other values.

        :param values: by path, as ``{"initial.alpha": "5 deg", "duration": 3}``
        """
        scenario = copy.deepcopy(self)
        for path, value in values.items():
            *parents, last = path.split(".")
            place: Any = scenario
            for key in parents:
                place = place.setdefault(key, {})
                if not isinstance(place, dict):
                    raise RipstikError(f'{path}: "{key}" holds no further keys')
            place[last] = value
        return scenario

    @classmethod
    def _of(cls, written: Any) -> Scenario:
        if not isinstance(written, dict):
            raise RipstikError("a scenario is a JSON object")
        scenario = cls(None)
        scenario.clear()
        scenario.update(written)
        return scenario

    def __reduce__(self) -> Any:
        return (Scenario._of, (dict(self),))
