"""A study on Dask clusters of several worker processes on this machine, beside one process without Dask.

    python python/tools/cluster.py public/studies/hundred-thousand.json --workers 1 2 4

Each cluster's rows are compared with those of the one process, to the bit, ordered by index. In the last cluster a worker is killed
when a third of the parts are done. Prints a Markdown table: runs a second, and the efficiency, which is the time of one worker
over n times that of n workers.
"""

from __future__ import annotations

import argparse
import hashlib
import os
import signal
import threading
import time

from distributed import Client, LocalCluster

from ripstik_lab import dask, sweep


def main() -> None:
    options = argparse.ArgumentParser()
    options.add_argument("study")
    options.add_argument("--workers", type=int, nargs="+", default=[1, 2])
    options.add_argument("--shards", type=int, default=40)
    given = options.parse_args()

    print("| | runs | s | runs a second | efficiency | rows, SHA-256 |\n|---|---|---|---|---|---|")
    began = time.perf_counter()
    expected = sweep(given.study, workers=1)
    line("one process, no Dask", expected, time.perf_counter() - began, None)
    first = None
    for count in given.workers:
        seconds, results, _ = on_cluster(given.study, count, given.shards, kill=False)
        first = first or seconds * count
        line(f"{count} worker{'s' if count > 1 else ''}", results, seconds, first / (count * seconds))
        check(results, expected)
    count = max(2, given.workers[-1])
    seconds, results, done = on_cluster(given.study, count, given.shards, kill=True)
    line(f"{count} workers, one killed after {done} of {given.shards} parts", results, seconds, None)
    check(results, expected)


def on_cluster(study, count, shards, kill):
    """The sweep's seconds, its results, and how many parts were done when a worker was killed."""
    with LocalCluster(n_workers=count, threads_per_worker=1, processes=True, dashboard_address=None) as cluster:
        with Client(cluster) as client:
            done = []
            victim = next(iter(client.run(os.getpid).values()))

            def end_one():
                while True:
                    ready = sum(state == "memory" for state in states(client))
                    if ready >= shards // 3:
                        break
                    time.sleep(0.05)
                os.kill(victim, signal.SIGKILL)
                done.append(ready)

            if kill:
                threading.Thread(target=end_one, daemon=True).start()
            began = time.perf_counter()
            results = dask.sweep(study, client, shards)
            seconds = time.perf_counter() - began
            if kill and not done:
                raise SystemExit("the sweep ended before a worker was killed")
            return seconds, results, done[0] if done else 0


def states(client):
    return client.run_on_scheduler(lambda dask_scheduler: [task.state for task in dask_scheduler.tasks.values()])


def digest(results) -> str:
    """Of every column's bytes, doubles as they are in memory."""
    of = hashlib.sha256()
    for name in results.names:
        column = results[name]
        of.update(name.encode())
        of.update(column.tobytes() if hasattr(column, "tobytes") else "\n".join(map(str, column)).encode())
    return of.hexdigest()[:16]


def check(results, expected) -> None:
    """Nothing lost, nothing twice, the same bits."""
    if list(results["index"]) != list(range(len(expected))):
        raise SystemExit("rows are lost or there twice")
    if digest(results) != digest(expected):
        raise SystemExit("the rows are not those of one process")


def line(name, results, seconds, efficiency) -> None:
    share = "" if efficiency is None else f"{efficiency:.2f}"
    rate = len(results) / seconds
    print(f"| {name} | {len(results):,} | {seconds:.0f} | {rate:.0f} | {share} | `{digest(results)}` |", flush=True)


if __name__ == "__main__":
    main()
