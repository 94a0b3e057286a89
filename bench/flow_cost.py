# SPDX-License-Identifier: Apache-2.0
"""What does it cost to ask for flows? `rosward flow` beside `rosward extract`, whole processes, one line for each repository.

    python bench/flow_cost.py DIR... [--runs 3] [--most 2] [--most-memory 1.5] [--json FILE]

Both write JSON only, and take turns; CPU seconds and peak memory are the medians of their runs. `unfinished` counts the nodes of which each
output may hold every input of the process, because a limit was reached. Exit status 1 where a repository is above one of the limits, or a run
fails.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from dataclasses import asdict, dataclass
from pathlib import Path
from statistics import median
from typing import Final

from measure import Run, measure

_COMMANDS: Final = ("extract", "flow")
_ROW: Final = "{:<46} {:>8} {:>8} {:>6} {:>7} {:>7} {:>6} {:>11}"


@dataclass(frozen=True, slots=True)
class Cost:
    """Of one repository: seconds and megabytes without flows and with them."""

    repository: str
    cpu: tuple[float, float]
    memory: tuple[float, float]
    unfinished: int

    @property
    def ratios(self) -> tuple[float, float]:
        """How many times the CPU time, and the memory."""
        return self.cpu[1] / self.cpu[0], self.memory[1] / self.memory[0]

    def row(self) -> str:
        """One line of the table."""
        cpu, memory = self.ratios
        seconds = [f"{s:.2f}" for s in self.cpu]
        sizes = [f"{m:.0f}" for m in self.memory]
        return _ROW.format(self.repository, *seconds, f"{cpu:.2f}", *sizes, f"{memory:.2f}", self.unfinished or "")


def _run(command: str, path: Path, seconds: float) -> tuple[Run, int]:
    """One run, and of how many nodes it could not finish the walk."""
    with tempfile.TemporaryDirectory() as folder:
        run = measure(
            [sys.executable, "-m", "rosward", command, str(path), "--format", "json", "-o", folder], seconds=seconds
        )
        written = Path(folder, "flow.json")
        if not written.exists():
            return run, 0
        nodes = json.loads(written.read_text())["nodes"]
        return run, sum(not node["complete"] for node in nodes)


def cost_of(path: Path, runs: int, seconds: float) -> Cost | str:
    """The medians of some runs of both commands, in turns; what went wrong, where something did."""
    cpu: dict[str, list[float]] = {c: [] for c in _COMMANDS}
    memory: dict[str, list[float]] = {c: [] for c in _COMMANDS}
    unfinished = 0
    for _ in range(runs):
        for command in _COMMANDS:
            run, lost = _run(command, path, seconds)
            if run.status not in (0, 1, 2) or "Traceback (most recent call last)" in run.output:
                return f"{command} ended with status {run.status}: {run.output.strip().rpartition(chr(10))[2]}"
            cpu[command].append(run.cpu)
            memory[command].append(run.peak_mb)
            unfinished = max(unfinished, lost)
    without, with_flows = _COMMANDS
    return Cost(
        path.name,
        (median(cpu[without]), median(cpu[with_flows])),
        (median(memory[without]), median(memory[with_flows])),
        unfinished,
    )


def main() -> int:
    """Print the table."""
    parser = argparse.ArgumentParser(description="What flows cost beside an extraction.")
    parser.add_argument("folders", nargs="+", type=Path, metavar="DIR")
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--seconds", type=float, default=300.0)
    parser.add_argument("--most", type=float, default=2.0, help="times the CPU time of extract")
    parser.add_argument("--most-memory", type=float, default=1.5, help="times its memory")
    parser.add_argument("--json", type=Path, metavar="FILE")
    options = parser.parse_args()
    print(_ROW.format("repository", "extract", "flow", "times", "MB", "flow", "times", "unfinished"))
    costs = []
    failed = False
    for folder in options.folders:
        cost = cost_of(folder, options.runs, options.seconds)
        if isinstance(cost, str):
            failed = True
            print(f"{folder.name}: {cost}", flush=True)
            continue
        costs.append(cost)
        print(cost.row(), flush=True)
    if not costs:
        return 1
    total = Cost(
        "all",
        (sum(c.cpu[0] for c in costs), sum(c.cpu[1] for c in costs)),
        (max(c.memory[0] for c in costs), max(c.memory[1] for c in costs)),
        sum(c.unfinished for c in costs),
    )
    print(total.row())
    if options.json is not None:
        options.json.write_text(json.dumps([asdict(c) for c in costs], indent=1))
    above = [c for c in costs if c.ratios[0] > options.most or c.ratios[1] > options.most_memory]
    return 1 if above or failed else 0


if __name__ == "__main__":
    raise SystemExit(main())
