# SPDX-License-Identifier: Apache-2.0
"""Our numbers beside Table I of the LiSA4ROS2 paper, on the paper's own files, and who is right where they differ.

    python bench/table1.py CHECKOUT_OF_LISA4ROS2

Exit status 1 where a difference has no explanation, or a project gave no result.
"""

from __future__ import annotations

import argparse
import csv
import re
import sys
from collections import defaultdict
from pathlib import Path

from explain import COLUMNS, Cause, Count, Row, count, explain, source_text_names
from measure import extract
from sites import scan

_TABLE = Path(__file__).parent / "data" / "table1.csv"


def main() -> int:
    """Run all 17 projects and print table and differences."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("checkout", type=Path, help="a checkout of lisa-analyzer/lisa4ros2")
    folder = parser.parse_args().checkout / "lisa4ros2" / "ros-tests"
    causes: dict[tuple[str, str | None], list[tuple[str, Cause]]] = defaultdict(list)
    wrong, unequal, cells, texts = 0, 0, 0, 0
    cpu, paper_cpu = 0.0, 0.0
    _print_row("project", "", COLUMNS, "CPU s", "MB")
    for project, paper in _paper().items():
        extraction = extract([folder / project], options=["--tests", "-q"])
        run, graph = extraction.run, extraction.graph
        cpu, paper_cpu = cpu + run.cpu, paper_cpu + float(paper["cpu"])
        expected = _counts(paper)
        if extraction.trouble or graph is None:
            print(f"{project}: {extraction.trouble or run.output.strip()}")
            wrong += 1
            continue
        ours, scanned = count(graph), scan(folder / project)
        _print_row(project, "rosward", [str(ours[c]) for c in COLUMNS], f"{run.cpu:.1f}", f"{run.peak_mb:.0f}")
        _print_row("", "paper", [str(expected[c]) for c in COLUMNS], paper["cpu"], paper["mb"])
        cells += len(COLUMNS)
        unequal += sum(str(ours[c]) != str(expected[c]) for c in COLUMNS)
        texts += len(source_text_names(scanned))
        for cause in explain(graph, scanned, expected):
            causes[cause.text, cause.right].append((project, cause))
    print(f"\nCPU seconds of all projects: rosward {cpu:.1f}, paper's program {paper_cpu:.1f}")
    print(f"\n{unequal} of {cells} numbers differ, for these reasons (column, ours minus the paper's, project):")
    for (text, right), cases in sorted(causes.items(), key=lambda item: (item[0][1] is None, -len(item[1]))):
        _print_cause(text, right, cases)
    unexplained = [case for (_, right), cases in causes.items() if right is None for case in cases]
    print(
        f"\nNot to be seen in the numbers: at {texts} calls the paper's program takes the source text of an f-string "
        "for the name, and it gives /rosout the type rcl_interfaces/msg/ParameterEvent instead of Log."
    )
    return 1 if wrong or unexplained else 0


def _paper() -> dict[str, dict[str, str]]:
    with _TABLE.open(encoding="utf-8", newline="") as file:
        return {row["project"]: row for row in csv.DictReader(line for line in file if not line.startswith("#"))}


def _counts(row: dict[str, str]) -> Row:
    numbers = {column: [int(n) for n in re.findall(r"\d+", row[column])] for column in COLUMNS}
    return {column: Count(*found) for column, found in numbers.items()}


def _print_row(project: str, who: str, cells: tuple[str, ...] | list[str], cpu: str, memory: str) -> None:
    print(f"{project:31}{who:9}" + "".join(f"{cell:>9}" for cell in cells) + f"{cpu:>8}{memory:>7}")


def _print_cause(text: str, right: str | None, cases: list[tuple[str, Cause]]) -> None:
    verdict = {"rosward": "rosward is right", "both": "both are right", None: "UNEXPLAINED"}[right]
    print(f"\n  {verdict}: {text}")
    sums: dict[str, dict[str, int]] = defaultdict(lambda: defaultdict(int))
    for project, cause in cases:
        sums[project][cause.column] += cause.delta
    for project, columns in sums.items():
        places = list(dict.fromkeys(place for p, cause in cases if p == project for place in cause.where))
        shown = ", ".join(places[:6]) + (f" and {len(places) - 6} more" if len(places) > 6 else "")
        print(f"    {', '.join(f'{c} {d:+d}' for c, d in columns.items()):24} {project}{': ' if shown else ''}{shown}")


if __name__ == "__main__":
    sys.exit(main())
