"""Sweeps on the machines of a Dask cluster."""

from __future__ import annotations

from typing import Any, Optional

from . import command
from .errors import RipstikError
from .studies import Results, results_of, sheet_text

#: Parts for each thread of the cluster: the last ones to end leave little idle, and a lost worker costs little.
PARTS_PER_THREAD = 4


def sweep(study: Any, client: Any, shards: Optional[int] = None) -> Results:
    """Carries a study out on a client's workers, each of which needs this package and Node.

    A part whose worker dies is computed again by another; each part is taken once, and each run follows from the study and
    its index alone, so the results are those of one process, to the bit.

    :param study: a mapping, JSON text, or the path of a study file on this machine
    :param client: a ``distributed.Client``
    :param shards: parts of the study; absent: four for each thread of the cluster
    :raises RipstikError: with the path of what is wrong in the study
    """
    if shards is None:
        shards = PARTS_PER_THREAD * max(1, sum(client.nthreads().values()))
    if shards < 1:
        raise RipstikError(f"shards must be a whole number from 1, not {shards}")
    names = [f"{part}/{shards}" for part in range(1, shards + 1)]
    # Not pure: what an earlier sweep of the same study left is not taken for this one's.
    futures = client.map(sheet_text, names, study=command.text_of(study), threads=1, pure=False)
    try:
        return results_of(client.gather(futures))
    finally:
        client.cancel(futures)
