# SPDX-License-Identifier: Apache-2.0
"""Robots that many use, as their owners launch them: one line a system.

    python bench/robots.py CHECKOUTS [--only TEXT] [--json FILE] [--before FILE] [--markdown]

CHECKOUTS holds the repositories of data/robots.toml as OWNER+NAME, one of which several commits are needed as OWNER+NAME@COMMIT (its first
twelve digits). Per system: nodes by what is known of their interface, processes, names by how they were found, findings by code and per
node, CPU seconds, MB. `--before` sets another run's figures beside them.
"""

from __future__ import annotations

import argparse
import importlib
import json
import subprocess
import sys
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from functools import cache
from pathlib import Path
from typing import Any, Final

from facts import Finding, Graph, Node
from measure import extract

LIST: Final = Path(__file__).parent / "data" / "robots.toml"
INTERFACES: Final = ("analysed", "declared", "partial", "unknown", "absent")
WORDS: Final = ("exact", "default", "bound", "pattern", "unknown")


@dataclass
class Row:
    """The figures of one system; `trouble` where there is no result."""

    nodes: dict[str, int] = field(default_factory=dict)
    processes: int = 0
    names: dict[str, int] = field(default_factory=dict)
    findings: dict[str, int] = field(default_factory=dict)
    cpu: float = 0.0
    mb: float = 0.0
    trouble: str | None = None


def main() -> int:
    """Print a line for each system. Status 1: one of them gave no result."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("checkouts", type=Path)
    parser.add_argument("--only", default="", help="only systems whose name contains this")
    parser.add_argument("--json", type=Path, help="write the figures to this file")
    parser.add_argument("--before", type=Path, help="the figures of another run, set beside these")
    parser.add_argument("--markdown", action="store_true", help="print a table of Markdown")
    options = parser.parse_args()
    toml: Any = importlib.import_module("tomllib" if sys.version_info >= (3, 11) else "tomli")
    systems = toml.loads(LIST.read_text(encoding="utf-8"))["system"]
    rows = {s["name"]: row(s, options.checkouts) for s in systems if options.only.lower() in s["name"].lower()}
    before = _read(options.before) if options.before else {}
    _print(rows, before, markdown=options.markdown)
    if options.json:
        options.json.write_text(json.dumps({n: asdict(r) for n, r in rows.items()}, indent=1) + "\n", encoding="utf-8")
    return 1 if any(r.trouble for r in rows.values()) else 0


def row(system: Mapping[str, Any], checkouts: Path) -> Row:
    """Analyse one system."""
    words = [f"--arg={name}:={value}" for name, value in system.get("arguments", {}).items()]
    if _takes("--env"):
        words += [f"--env={name}={value}" for name, value in system.get("env", {}).items()]
    words += ["--launch", system["launch"], "--distro", system.get("distro", "jazzy")]
    done = extract([_folder(s, checkouts) for s in system["sources"]], seconds=600, options=words)
    if done.graph is None or done.trouble:
        return Row(trouble=done.trouble or done.run.output.strip().rpartition("\n")[2])
    graph = done.graph
    return Row(
        nodes=dict(Counter(interfaces(graph).values())),
        processes=len({n.process for n in graph.nodes}),
        names=dict(Counter(e.resolution for e in graph.entities if not e.system)),
        findings=dict(sorted(Counter(f.code for f in graph.findings).items())),
        cpu=round(done.run.cpu, 1),
        mb=round(done.run.peak_mb),
    )


def _folder(source: str, checkouts: Path) -> Path:
    """Where a source lies: under its commit, if there is such a folder, else under its name."""
    name, _, commit = source.replace("/", "+").partition("@")
    exact = checkouts / f"{name}@{commit[:12]}"
    return exact if exact.is_dir() else checkouts / name


@cache
def _takes(option: str) -> bool:
    """Whether this rosward has an option: the bench runs earlier ones too."""
    told = subprocess.run(
        [sys.executable, "-m", "rosward", "extract", "--help"], check=True, capture_output=True, text=True
    )
    return f"{option} " in told.stdout


def interfaces(graph: Graph) -> dict[tuple[str, str, str], str]:
    """What is known of the interface of each node, by process, program and name."""
    told = [f for f in graph.findings if f.code == "RW314"]
    return {(n.process, n.program, n.name): interface(n, told) for n in graph.nodes}


def interface(node: Node, told: Iterable[Finding]) -> str:
    """What is known of the interface of one node: the result's own word, or what its findings say."""
    said = [f.message for f in told if f.spot == node.launched and f"{node.program}" in f.message]
    if any("is neither among the sources nor declared" in message for message in said):
        return "absent"
    if node.interface is not None:
        return node.interface
    if said:
        return "partial" if all("not wholly known" in message for message in said) else "unknown"
    return "declared" if node.spot == node.launched else "analysed"


def _read(path: Path) -> dict[str, Row]:
    return {name: Row(**values) for name, values in json.loads(path.read_text(encoding="utf-8")).items()}


def _print(rows: Mapping[str, Row], before: Mapping[str, Row], *, markdown: bool) -> None:
    head = ["system", "nodes", *INTERFACES, "processes", *WORDS, "findings", "a node", "CPU s", "MB"]
    lines = [_cells(name, each, before.get(name)) for name, each in rows.items()]
    lines.append(_cells("all", _total(rows.values()), _total(before.values()) if before else None))
    if markdown:
        for line in (head, ["---"] * len(head), *lines):
            print(f"| {' | '.join(line)} |")
    else:
        wide = [max(len(line[n]) for line in (head, *lines)) for n in range(len(head))]
        for line in (head, *lines):
            print(
                "  ".join(c.ljust(w) if n == 0 else c.rjust(w) for n, (c, w) in enumerate(zip(line, wide, strict=True)))
            )
    for name, each in rows.items():
        print(f"{name}: {each.trouble or ', '.join(f'{c}: {n}' for c, n in each.findings.items())}", file=sys.stderr)


def _cells(name: str, now: Row, before: Row | None) -> list[str]:
    mine = _figures(now)
    theirs = _figures(before) if before is not None else mine
    return [name, *(a if a == b else f"{b} → {a}" for a, b in zip(mine, theirs, strict=True))]


def _figures(each: Row) -> Sequence[str]:
    if each.trouble:
        return ["-"] * (len(INTERFACES) + len(WORDS) + 6)
    nodes, findings = sum(each.nodes.values()), sum(each.findings.values())
    counts = [
        nodes,
        *(each.nodes.get(i, 0) for i in INTERFACES),
        each.processes,
        *(each.names.get(w, 0) for w in WORDS),
    ]
    return [*map(str, counts), str(findings), f"{findings / max(nodes, 1):.1f}", f"{each.cpu:.1f}", f"{each.mb:.0f}"]


def _total(rows: Iterable[Row]) -> Row:
    total = Row()
    for each in rows:
        for mine, theirs in ((total.nodes, each.nodes), (total.names, each.names), (total.findings, each.findings)):
            for key, count in theirs.items():
                mine[key] = mine.get(key, 0) + count
        total.processes += each.processes
        total.cpu += each.cpu
        total.mb = max(total.mb, each.mb)
    return total


if __name__ == "__main__":
    sys.exit(main())
