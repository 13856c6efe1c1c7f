"""RipStik Lab's core from Python: the numbers of the page and of the command line, to the bit.

>>> from ripstik_lab import Scenario, simulate
>>> run = simulate(Scenario("ripstik", initial={"X_dot": 1, "alpha": "10 deg"}, duration=2))
>>> run["alpha"][-1]

Numbers are SI and radians. Columns and matrices are NumPy arrays where NumPy is installed, otherwise ``array.array`` and lists.
"""

from .errors import RipstikError
from .linearization import Linearization, linearize
from .scenario import Scenario
from .simulation import Run, simulate
from .stage import Stage
from .studies import Results, sweep
from .table import Table

__all__ = ["Linearization", "Results", "RipstikError", "Run", "Scenario", "Stage", "Table", "linearize", "simulate", "sweep"]
