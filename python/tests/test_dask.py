"""A sweep on a real cluster of two processes, one of which is killed in the middle: nothing lost, nothing twice."""

import os
import signal
import threading
import time
import unittest
from importlib.util import find_spec

from ripstik_lab import RipstikError, sweep

STUDY = {
    "version": 1,
    "scenario": {"version": 1, "system": "ripstik", "initial": {"X_dot": 1}, "duration": 0.2},
    "vary": {"initial.alpha": {"grid": ["-10 deg", "10 deg", 24]}},
    "measures": ["final.X", "max.alpha"],
}
SHARDS = 12


@unittest.skipUnless(find_spec("distributed"), "Dask is not installed")
class Cluster(unittest.TestCase):
    def test_a_worker_is_killed(self):
        from distributed import Client, LocalCluster

        from ripstik_lab import dask

        expected = sweep(STUDY, workers=1)
        with LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
        ) as cluster, Client(cluster) as client:
            victim = next(iter(client.run(os.getpid).values()))
            killed = []

            def kill():
                # As soon as one part is done: others are under way or kept by the worker that dies.
                while not any(state == "memory" for state in states(client).values()):
                    time.sleep(0.02)
                killed.append(sum(state == "memory" for state in states(client).values()))
                os.kill(victim, signal.SIGKILL)

            killer = threading.Thread(target=kill, daemon=True)
            killer.start()
            results = dask.sweep(STUDY, client, SHARDS)
            killer.join(10)
            self.assertEqual(len(killed), 1, "the sweep ended before a worker was killed")
            self.assertLess(killed[0], SHARDS, "nothing was left to do when the worker was killed")
            with self.assertRaisesRegex(RipstikError, "^measures"):
                dask.sweep({**STUDY, "measures": ["final.nono"]}, client)
        self.assertEqual(list(results["index"]), list(range(24)))
        self.assertEqual(results.names, expected.names)
        for name in results.names:
            self.assertEqual(list(results[name]), list(expected[name]), name)


def states(client):
    """The scheduler's view of the tasks, by key."""
    return client.run_on_scheduler(lambda dask_scheduler: {key: task.state for key, task in dask_scheduler.tasks.items()})


if __name__ == "__main__":
    unittest.main()
