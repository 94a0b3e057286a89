# SPDX-License-Identifier: Apache-2.0
"""What the launch files of real repositories start, and how much of it is known: one line a repository.

    python bench/deployed.py CHECKOUTS [--repo NAME] [--unknown] [--json FILE]

CHECKOUTS holds the repositories as OWNER+NAME. Every launch file is a system of its own (`--all-launch`). `python`, `declared`, `C++` and
`unknown` say what is behind each node that is started; `own` are Python executables of the same repository that were looked for, `found` those
that were analysed. The names of the entities are counted before (each executable as `ros2 run` starts it) and after deployment.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

from rosward import extract
from rosward.analysis.deep_stack import with_deep_stack
from rosward.analysis.read import read_sources
from rosward.analysis.systems import Outset, systems_of
from rosward.deployment.launched import Launched
from rosward.deployment.request import Request
from rosward.deployment.started import StartKind
from rosward.pipeline import NothingToReadError, Result
from rosward.ros.distro import Distro
from rosward.source.workspace import Workspace

WORDS: Final = ("exact", "default", "bound", "pattern", "unknown")


@dataclass
class Row:
    """The counts of one repository."""

    launch_files: int = 0
    started: Counter[str] = field(default_factory=Counter)
    own: int = 0
    found: int = 0
    before: Counter[str] = field(default_factory=Counter)
    after: Counter[str] = field(default_factory=Counter)
    seconds: float = 0.0


def main() -> int:
    """Print a row for each repository."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("checkouts", type=Path)
    parser.add_argument("--repo", action="append", help="only repositories whose name contains this")
    parser.add_argument("--unknown", action="store_true", help="list the programs of unknown interface")
    parser.add_argument("--json", type=Path, help="write the counts to this file")
    options = parser.parse_args()
    rows: dict[str, Row] = {}
    for folder in sorted(p for p in options.checkouts.iterdir() if p.is_dir()):
        if not options.repo or any(part in folder.name for part in options.repo):
            rows[folder.name] = row(folder, listed=options.unknown)
    _print(rows)
    if options.json:
        table = {
            n: {**vars(r), "started": dict(r.started), "before": dict(r.before), "after": dict(r.after)}
            for n, r in rows.items()
        }
        options.json.write_text(json.dumps(table, indent=1), encoding="utf-8")
    return 0


def row(folder: Path, *, listed: bool) -> Row:
    """Analyse one repository both ways."""
    found = Row()
    try:
        before = extract(folder)
    except NothingToReadError:
        return found
    found.before = names(before)

    def launched() -> tuple[list[Launched], Workspace]:
        read = read_sources([folder], Distro.JAZZY)
        systems = systems_of(Request(all_launch=True), Outset.of(read)).systems
        return [p for s in systems for p in s.programs], read.workspace

    programs, workspace = with_deep_stack(launched)
    found.launch_files = len(workspace.launch_files)
    packages = {p.name for p in workspace.packages}
    for program in programs:
        found.started[behind(program)] += 1
        if program.package in packages and program.started.kind is not StartKind.COMPONENT and behind(program) != "C++":
            found.own += 1
            found.found += program.entry is not None
        if listed and program.unknown is not None:
            print(f"{folder.name}: {program.package}/{program.executable}: {program.unknown} ({program.started.place})")
    start = time.process_time()
    if found.launch_files:
        found.after = names(extract(folder, request=Request(all_launch=True)))
    found.seconds = time.process_time() - start
    return found


def behind(program: Launched) -> str:
    """What is behind a program."""
    if program.entry is not None:
        return "python"
    if program.program is not None:
        return "declared"
    return "C++" if "C++" in (program.unknown or "") else "unknown"


def names(result: Result) -> Counter[str]:
    """How the names of the entities that the code itself creates were found."""
    return Counter(e.resolution.value for n in result.network.nodes for e in n.entities if not e.system)


def _print(rows: Mapping[str, Row]) -> None:
    words = " ".join(f"{w:>7}" for w in WORDS)
    print(f"{'repository':44} files  python decl.  C++ unkn.  own found   before: {words}   after: {words}    s")
    for name, each in rows.items():
        _line(name, each)
    total = Row()
    for each in rows.values():
        total.launch_files += each.launch_files
        total.own += each.own
        total.found += each.found
        total.seconds += each.seconds
        for counter in ("started", "before", "after"):
            getattr(total, counter).update(getattr(each, counter))
    _line("all", total)


def _line(name: str, each: Row) -> None:
    kinds = " ".join(f"{each.started[k]:5}" for k in ("python", "declared", "C++", "unknown"))
    counts = f"{_counts(each.before)}          {_counts(each.after)}"
    print(
        f"{name:44} {each.launch_files:5}   {kinds} {each.own:5} {each.found:5}           {counts} {each.seconds:5.1f}"
    )


def _counts(counter: Mapping[str, int]) -> str:
    return " ".join(f"{counter.get(w, 0):7}" for w in WORDS)


if __name__ == "__main__":
    sys.exit(main())
