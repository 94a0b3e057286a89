# SPDX-License-Identifier: Apache-2.0
"""How long does the report take, and how large is it? One line for each system.

    python bench/report.py [--flows] [PATH...]

Each PATH is analysed, with all of its launch files, and its report is made three times; beside them stand made-up systems of 50, 500 and 3,000
nodes (the fleet of the tests). `document` and `page` are seconds of CPU time, the best of three, without the analysis; `page` has the document in it.
With --flows the reports have them: of made-up systems, each output is made of each input of its node.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, Final

import rosward
from rosward.deployment.request import Request
from rosward.engine.budget import Budget
from rosward.network.graph import Network
from rosward.outputs.background import Background
from rosward.outputs.report.document import report_document
from rosward.outputs.report.page import document_text, report_html

ROOT: Final = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "tests"))

from outputs.flowing import all_flowing  # noqa: E402
from outputs.networks import fleet  # noqa: E402

_RUNS: Final = 3


def systems(paths: list[str], *, flows: bool) -> Iterator[tuple[str, Network, Background]]:
    """Name, network and background of each system."""
    for path in paths or [str(ROOT / "examples")]:
        result = rosward.extract(path, request=Request(all_launch=True), budget=Budget(flow=flows))
        yield Path(path).name, result.network, Background(result.root, result.systems, flow=flows)
    for robots in (8, 83, 500):
        network = all_flowing(fleet(robots)) if flows else fleet(robots)
        yield f"fleet of {robots} robots", network, Background(flow=flows)


def seconds(work: Callable[[], Any]) -> float:
    """The best of some runs."""
    found = []
    for _ in range(_RUNS):
        start = time.process_time()
        work()
        found.append(time.process_time() - start)
    return min(found)


def main() -> int:
    """Print the table."""
    parser = argparse.ArgumentParser(description="Seconds and size of the report.")
    parser.add_argument("paths", nargs="*", metavar="PATH")
    parser.add_argument("--flows", action="store_true")
    options = parser.parse_args()
    row = "{:<32} {:>6} {:>9} {:>9} {:>9} {:>10} {:>9}"
    print(row.format("system", "nodes", "entities", "document", "page", "JSON, kB", "page, kB"))
    for name, network, background in systems(options.paths, flows=options.flows):
        document = report_document(network, background)
        made = seconds(lambda n=network, b=background: report_document(n, b))  # type: ignore[misc]
        whole = seconds(lambda n=network, b=background: report_html(n, b))  # type: ignore[misc]
        entities = sum(len(node.entities) for node in network.nodes)
        sizes = len(document_text(document).encode()) // 1000, len(report_html(network, background).encode()) // 1000
        print(row.format(name, len(network.nodes), entities, f"{made:.2f} s", f"{whole:.2f} s", *sizes))
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
