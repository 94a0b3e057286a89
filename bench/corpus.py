# SPDX-License-Identifier: Apache-2.0
"""Analyses whole repositories and prints what was found, what it cost, and every name that stayed unknown.

    python bench/corpus.py DIR... [--paper paper-per-file.csv] [--json FILE] [--seconds N]

A folder OWNER+NAME (or NAME) is the repository NAME of the paper's file list. Exit status 1 after a crash or a timeout.
"""

from __future__ import annotations

import argparse
import csv
import json
import sys
from collections import Counter, defaultdict
from dataclasses import asdict, dataclass, field
from pathlib import Path

from facts import Finding, Graph
from measure import Extraction, extract
from sites import Scan, scan

_RESOLUTIONS = ("exact", "default", "bound", "pattern", "unknown")
_UNKNOWN = {"RW101", "RW105", "RW208"}
"""Findings that say that a name, or the node that a name belongs to, is not known."""


@dataclass(slots=True)
class Repository:
    """What one run over a repository gave; `verdicts` holds the worst name of each file with a node or an entity."""

    name: str
    trouble: str | None
    status: int | None
    wall: float
    cpu: float
    peak_mb: float
    files: int
    processes: int = 0
    nodes: int = 0
    resolutions: dict[str, int] = field(default_factory=dict)
    findings: dict[str, int] = field(default_factory=dict)
    unknown: list[str] = field(default_factory=list)
    verdicts: dict[str, str] = field(default_factory=dict)
    calls: int = 0
    silent: list[str] = field(default_factory=list)

    @property
    def known_files(self) -> int:
        """Files of which every name is known or a pattern."""
        return sum(verdict != "unknown" for verdict in self.verdicts.values())


def main() -> int:
    """Analyse each folder and print table, totals, unknown names and the comparison with the paper."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("folders", nargs="+", type=Path, metavar="DIR")
    parser.add_argument("--paper", type=Path, help="the paper's verdict on each file (project;file;status)")
    parser.add_argument("--json", type=Path, help="write all numbers to this file")
    parser.add_argument("--seconds", type=float, default=60, help="time limit for each repository")
    options = parser.parse_args()
    repositories = []
    _print_head()
    for folder in options.folders:
        repository = _measure(folder, extract([folder], seconds=options.seconds), scan(folder))
        repositories.append(repository)
        _print_row(repository)
    _print_totals(repositories)
    if options.paper:
        _compare(repositories, _verdicts_of_paper(options.paper))
    if options.json:
        options.json.write_text(json.dumps([asdict(r) for r in repositories], indent=2) + "\n", encoding="utf-8")
    return 1 if any(repository.trouble for repository in repositories) else 0


def _measure(folder: Path, extraction: Extraction, scanned: Scan) -> Repository:
    run, graph = extraction.run, extraction.graph
    repository = Repository(
        name=folder.resolve().name,
        trouble=extraction.trouble,
        status=run.status,
        wall=run.wall,
        cpu=run.cpu,
        peak_mb=run.peak_mb,
        files=len(scanned.files),
        calls=len(scanned.entities),
    )
    if graph is not None:
        _fill(repository, graph, scanned)
    return repository


def _fill(repository: Repository, graph: Graph, scanned: Scan) -> None:
    user = [entity for entity in graph.entities if not entity.system]
    repository.processes = len({node.process for node in graph.nodes})
    repository.nodes = len(graph.nodes)
    repository.resolutions = dict(Counter(entity.resolution for entity in user))
    repository.findings = dict(sorted(Counter(finding.code for finding in graph.findings).items()))
    names = [(node.spot, node.resolution) for node in graph.nodes]
    names += [(spot, entity.resolution) for entity in user for spot in entity.spots]
    names += [(finding.spot, "unknown") for finding in graph.findings if finding.code in _UNKNOWN]
    for (file, _), resolution in names:
        worst = max(repository.verdicts.get(file, "exact"), resolution, key=_RESOLUTIONS.index)
        repository.verdicts[file] = worst
    repository.unknown = _unknown(graph)
    spots = {spot for entity in user for spot in entity.spots} | {finding.spot for finding in graph.findings}
    unread = {finding.spot[0] for finding in graph.findings if finding.code.startswith("RW00")}
    repository.silent = [
        f"{site}: {site.kind} {site.written}"
        for site in scanned.entities
        if site.file not in unread and not any(site.covers(spot) for spot in spots)
    ]


def _unknown(graph: Graph) -> list[str]:
    """Every name that is not known, with its reason; names that no finding speaks of are marked."""
    findings = [finding for finding in graph.findings if finding.code in _UNKNOWN]
    said = {finding.spot for finding in findings}
    lines = [_line(finding) for finding in findings]
    for entity in graph.entities:
        if entity.resolution == "unknown" and not said & set(entity.spots):
            file, line = entity.spots[0] if entity.spots else ("?", 0)
            lines.append(f"{file}:{line}: {entity.kind} {entity.name} of {entity.node} is unknown, without a finding")
    return sorted(lines)


def _line(finding: Finding) -> str:
    return f"{finding.spot[0]}:{finding.spot[1]}: {finding.code} {finding.message}"


def _print_head() -> None:
    columns = ["files", "procs", "nodes", *_RESOLUTIONS, "known", "silent", "wall s", "CPU s", "MB"]
    print(f"{'repository':45}" + "".join(f"{column:>9}" for column in columns) + "  trouble")


def _print_row(repository: Repository) -> None:
    cells = [repository.files, repository.processes, repository.nodes]
    cells += [repository.resolutions.get(resolution, 0) for resolution in _RESOLUTIONS]
    known = f"{repository.known_files}/{len(repository.verdicts)}"
    silent = f"{len(repository.silent)}/{repository.calls}"
    cost = f"{repository.wall:9.1f}{repository.cpu:9.1f}{repository.peak_mb:9.0f}"
    print(
        f"{repository.name[:44]:45}" + "".join(f"{cell:>9}" for cell in cells) + f"{known:>9}{silent:>9}{cost}"
        f"  {repository.trouble or ''}",
        flush=True,
    )


def _print_totals(repositories: list[Repository]) -> None:
    def total(key: str) -> Counter[str]:
        return sum((Counter(getattr(repository, key)) for repository in repositories), Counter())

    _print_row(
        Repository(
            name=f"{len(repositories)} repositories",
            trouble=f"{sum(bool(r.trouble) for r in repositories)} with trouble",
            status=None,
            wall=sum(r.wall for r in repositories),
            cpu=sum(r.cpu for r in repositories),
            peak_mb=max(r.peak_mb for r in repositories),
            files=sum(r.files for r in repositories),
            processes=sum(r.processes for r in repositories),
            nodes=sum(r.nodes for r in repositories),
            resolutions=dict(total("resolutions")),
            verdicts={f"{r.name}/{file}": verdict for r in repositories for file, verdict in r.verdicts.items()},
            calls=sum(r.calls for r in repositories),
            silent=[line for r in repositories for line in r.silent],
        )
    )
    print("\nknown: files with every name known or a pattern, of the files with a node or entity")
    print("silent: calls that look as if they created an entity and at which we have neither one nor a finding")
    print("\nfindings: " + ", ".join(f"{code} {number}" for code, number in sorted(total("findings").items())))
    for title, key in (("unknown names", "unknown"), ("silent calls", "silent")):
        print(f"\n{title}:")
        for repository in repositories:
            for line in getattr(repository, key):
                print(f"  {repository.name}/{line}")


def _verdicts_of_paper(path: Path) -> dict[str, dict[str, str]]:
    """project -> file relative to the project -> OK or ERROR."""
    verdicts: dict[str, dict[str, str]] = defaultdict(dict)
    with path.open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file, delimiter=";"):
            verdicts[row["project"]][row["file"].removeprefix(f"/{row['project']}/")] = row["status"]
    return verdicts


def _compare(repositories: list[Repository], paper: dict[str, dict[str, str]]) -> None:
    """The paper's verdict and ours on the same files."""
    table: Counter[tuple[str, str]] = Counter()
    unseen: list[str] = []
    for repository in repositories:
        project = repository.name.rpartition("+")[2]
        for file, status in paper.get(project, {}).items():
            ours = repository.verdicts.get(file, "no node or entity")
            table[status, ours] += 1
            if ours == "no node or entity":
                unseen.append(f"{repository.name}/{file} (paper: {status})")
    print("\nthe paper's verdict on the same files (down) and the worst name in each of them to us (across):")
    columns = (*_RESOLUTIONS, "no node or entity")
    print(f"  {'':8}" + "".join(f"{column:>20}" for column in columns))
    for status in ("OK", "ERROR"):
        print(f"  {status:8}" + "".join(f"{table[status, column]:>20}" for column in columns))
    files = sum(table.values())
    precise = sum(n for (status, _), n in table.items() if status == "OK")
    known = sum(n for (_, ours), n in table.items() if ours in _RESOLUTIONS[:-1])
    print(f"  of {files} files every name is known: paper {precise} ({precise / max(files, 1):.1%}), ", end="")
    print(f"rosward {known} ({known / max(files, 1):.1%}, patterns among them)")
    print("\nfiles of the paper in which we have nothing:")
    for line in unseen:
        print(f"  {line}")


if __name__ == "__main__":
    sys.exit(main())
