"""How much work a chart on MPI ranks loses to a kill.

    python3 bench/loss.py build/stridor-mpi [--tries 20] [--ranks 3] [--cells 1,10,100] [--by SIGKILL,SIGTERM]

Rank 0 shows its progress on a terminal of this program's, ten times a second: so it is known how many cells had come
in at each moment. After the kill the store is counted. What is lost is the time between the arrival of the last cell
that is kept and the kill. Cells on their way to rank 0 come to that, 0.05 s of them, and the one in hand of each
thread.
A job that ends by SIGTERM is to keep whatever had come in: nothing is lost if as many cells are kept.
"""

from __future__ import annotations

import argparse
import json
import os
import pathlib
import random
import re
import signal
import statistics
import subprocess
import tempfile
import threading
import time

DURATION = {1: 0.06, 10: 0.6, 100: 6.0}  # [ms] of a cell: [s] simulated, by steps of 2 us
FAR = {1: 400, 10: 120, 100: 40}  # [ms]: points along each axis, more than are computed before the kill
WAYS = [("rank 0", signal.SIGKILL), ("another rank", signal.SIGKILL), ("mpirun", signal.SIGKILL),
        ("rank 0", signal.SIGTERM), ("mpirun", signal.SIGTERM)]  # other ranks leave SIGTERM to rank 0


class Progress:
    """What rank 0 has shown: at which time how many cells."""

    def __init__(self) -> None:
        self.parent, self.child = os.openpty()
        self.name = os.ttyname(self.child)
        self.seen: list[tuple[float, int]] = []
        self.said = b""
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        while True:
            try:
                text = os.read(self.parent, 65536)
            except OSError:
                return
            now = time.monotonic()
            self.said += text
            for done in re.findall(rb"(\d+)/\d+ cells", text):
                self.seen.append((now, int(done)))

    def close(self) -> None:
        os.close(self.child)
        os.close(self.parent)


def arrival(seen: list[tuple[float, int]], cells: int) -> float:
    """When so many cells had come in, between two looks in proportion."""
    before = seen[0]
    for now in seen:
        if now[1] >= cells:
            share = (cells - before[1]) / max(now[1] - before[1], 1)
            return before[0] + share * (now[0] - before[0])
        before = now
    return before[0]


def ranks_of(mpirun: int) -> list[int]:
    """The processes that mpirun began, rank 0 first."""
    children = pathlib.Path(f"/proc/{mpirun}/task/{mpirun}/children").read_text().split()
    return sorted(int(child) for child in children)


def one_try(options: argparse.Namespace, cost: int, whom: str, what: signal.Signals) -> float | None:
    """The seconds that one kill costs; nothing if the chart was done, or had not begun, by then."""
    with tempfile.TemporaryDirectory() as folder:
        progress = Progress()
        points = FAR[cost]
        chart = [options.program, "chart", options.chart, "--out", f"{folder}/out", "--threads", "1", "--files", "csv"]
        for setting in (f"chart.x.points={points}", f"chart.y.points={points}", "run.engine=beta_2", "run.step=2e-6",
                        "run.early_ending=never", f"run.duration={DURATION[cost]}", "run.window=0.01"):
            chart += ["--set", setting]
        shell = 'exec "$@" 2>"$0"'
        # of a killed rank mpirun need not wait for the others
        patience = "0" if what == signal.SIGKILL else "5"
        job = subprocess.Popen([options.mpirun, "--oversubscribe", "--bind-to", "none", "-n", str(options.ranks),
                                "--mca", "odls_base_sigkill_timeout", patience,
                                "sh", "-c", shell, progress.name, *chart],
                               stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        begun = time.monotonic()
        while not any(done > 0 for _, done in progress.seen) and time.monotonic() - begun < 30:
            time.sleep(0.01)
        time.sleep(random.uniform(0.7, 2.2))
        ranks = ranks_of(job.pid)
        victim = {"rank 0": ranks[0], "another rank": random.choice(ranks[1:]), "mpirun": job.pid}[whom]
        killed = time.monotonic()
        os.kill(victim, what)
        job.wait()
        # ranks whose mpirun is gone end by themselves
        while any(pathlib.Path(f"/proc/{rank}").exists() for rank in ranks):
            time.sleep(0.02)
        status = subprocess.run([options.stridor, "chart-status", f"{folder}/out", "--json"], capture_output=True)
        kept = json.loads(status.stdout)["cells"]["done"] if status.returncode == 0 else 0
        seen, said = progress.seen, progress.said
        progress.close()
        if what == signal.SIGTERM and b"all of them are kept" in said:
            # it says how many it had, those that came in while it stopped among them
            told = int(re.search(rb"stopped with (\d+) of", said).group(1))
            assert kept == told, f"{kept} cells kept, {told} told"
        if kept >= 2 * points * points:
            return None
        if what == signal.SIGTERM and kept >= max(done for when, done in seen if when <= killed):
            return 0.0
        return max(0.0, killed - arrival([look for look in seen if look[0] <= killed + 0.05], kept))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="stridor-mpi; stridor lies beside it")
    parser.add_argument("--mpirun", default="mpirun")
    parser.add_argument("--ranks", type=int, default=3)
    parser.add_argument("--tries", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--by", default="SIGKILL,SIGTERM")
    parser.add_argument("--cells", default="1,10,100", help="cost of a cell [ms]")
    options = parser.parse_args()
    options.program = os.path.abspath(options.program)
    options.stridor = os.path.join(os.path.dirname(options.program), "stridor")
    os.environ.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    random.seed(options.seed)
    with tempfile.TemporaryDirectory() as folder:
        options.chart = f"{folder}/pair.toml"
        subprocess.run([options.stridor, "init", "noise-chart", "-o", options.chart], check=True)
        print("| a cell takes | killed | by | times | median [s] | worst [s] |")
        print("| --- | --- | --- | --- | --- | --- |", flush=True)
        for cost in map(int, options.cells.split(",")):
            for whom, what in WAYS:
                if what.name not in options.by.split(","):
                    continue
                tries = [one_try(options, cost, whom, what) for _ in range(options.tries)]
                losses = [loss for loss in tries if loss is not None]
                if not losses:
                    continue
                print(f"| {cost} ms | {whom} | {what.name} | {len(losses)} | {statistics.median(losses):.2f} |"
                      f" {max(losses):.2f} |", flush=True)


if __name__ == "__main__":
    main()
