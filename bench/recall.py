# SPDX-License-Identifier: Apache-2.0
"""What was seen when the programs ran, and whether we say so too: one line for each fact that the static result lacks.

    python bench/recall.py CHECKOUTS RECORDING.jsonl [--repo NAME] [--found] [--extra] [--json FILE]

CHECKOUTS holds the repositories as OWNER+NAME; each is analysed whole. Only facts of trust `hard` count. A fact is
found when the file, the line (any within the statement), the kind, the node, the name and the type agree; `*` in our
names stands for anything (found as a pattern), and a type that we do not know for any. Where a repository holds the source of a library that we
have a model of, the call of the library in the program's own file is its place as well. Of what the client library adds
the place does not matter. Of programs in C++, each parameter of a node is a fact as well: its name and its default.
Exit status 1 where a fact is missing.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import asdict, dataclass
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Any

from facts import Entity, Graph, Spot
from measure import extract
from sites import statement

CERTAIN = "certain for us: the run ended before it, or ours to mend"
_KINDS = {"service_server": "service", "service_client": "client"}
"""Words of the recording of C++ that are others elsewhere."""


@dataclass(frozen=True, slots=True, order=True)
class Fact:
    """One thing that a program created when it ran; of a parameter, `type` is the default, as rclcpp writes it."""

    file: str
    line: int
    run: str
    kind: str
    node: str
    name: str
    type: str
    system: bool = False

    def __str__(self) -> str:
        of_type = f" [{self.type}]" if self.type else ""
        return f"{self.file}:{self.line}: {self.kind} {self.name}{of_type} of {self.node}"


@dataclass(frozen=True, slots=True)
class Verdict:
    """Whether a fact was found, `exact` where not as a pattern; if not, in which respect, and what we have instead."""

    repo: str
    fact: Fact
    found: bool
    lacks: str = ""
    instead: str = ""
    exact: bool = False


@dataclass(slots=True)
class Recorded:
    """The facts of a repository: those of trust `hard`, all, and the files whose run did not come to its own end."""

    hard: set[Fact]
    every: set[Fact]
    interrupted: set[str]
    options: list[str]


def main() -> int:
    """Analyse each recorded repository and print what is missing."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("checkouts", type=Path)
    parser.add_argument("recording", type=Path)
    parser.add_argument("--repo", action="append", help="only repositories whose name contains this")
    parser.add_argument("--found", action="store_true", help="list what was found as well")
    parser.add_argument("--extra", action="store_true", help="list what no run of a recorded file showed")
    parser.add_argument(
        "--own", action="store_true", help="only what the programs make themselves, not the client library"
    )
    parser.add_argument("--seconds", type=float, default=60, help="time limit for each repository")
    parser.add_argument("--json", type=Path, help="write all verdicts to this file")
    options = parser.parse_args()
    verdicts: list[Verdict] = []
    beyond: Counter[str] = Counter()
    for repo, recorded in sorted(_read(options.recording).items()):
        folder = options.checkouts / repo.replace("/", "+")
        if options.repo and not any(part in repo for part in options.repo):
            continue
        if not folder.is_dir():
            print(f"{repo}: no checkout")
            continue
        extraction = extract([folder], seconds=options.seconds, options=recorded.options)
        if extraction.trouble or extraction.graph is None:
            print(f"{repo}: {extraction.trouble or extraction.run.output.strip()}")
        graph = extraction.graph or Graph((), (), (), {}, {}, {})
        hard = sorted(fact for fact in recorded.hard if not (options.own and fact.system))
        of_repo = [_judge(repo, graph, fact, statement(folder / fact.file, fact.line)) for fact in hard]
        verdicts += of_repo
        print(f"{repo}: {_counted(of_repo)} in {extraction.run.wall:.1f} s")
        for verdict in of_repo:
            if not verdict.found or options.found:
                print(f"  {'found ' if verdict.found else 'MISSED'} {verdict.fact}" + _why(verdict))
        for entity in _extra(graph, {f for f in recorded.every if f.file not in recorded.interrupted}):
            group = _group(entity)
            beyond[group] += 1
            if options.extra:
                spot = entity.spots[0]
                print(
                    f"  only ours {spot[0]}:{spot[1]}: {entity.kind} {entity.name} [{entity.type}] of {entity.node}: {group}"
                )
        sys.stdout.flush()
    _summary(verdicts)
    print(
        "only ours, in files whose run came to its end: "
        + (", ".join(f"{g} {n}" for g, n in beyond.most_common()) or "nothing")
    )
    if options.json:
        text = json.dumps([asdict(verdict) for verdict in verdicts], indent=2)
        options.json.write_text(text + "\n", encoding="utf-8")
    return 0 if all(verdict.found for verdict in verdicts) else 1


def _read(recording: Path) -> dict[str, Recorded]:
    """The facts by repository; those of C++ were recorded with kilted."""
    facts: dict[str, Recorded] = defaultdict(lambda: Recorded(set(), set(), set(), ["--tests"]))
    with recording.open(encoding="utf-8") as lines:
        for record in map(json.loads, lines):
            repo = facts[record["repo"]]
            fact = _fact(record)
            repo.every.add(fact)
            if record["trust"] == "hard":
                repo.hard |= {fact, *_parameters(record)}
            else:
                repo.interrupted.add(fact.file)
            if "entry" in record:
                repo.options = ["--distro", "kilted"]
    return {repo: found for repo, found in facts.items() if found.hard}


def _fact(record: dict[str, Any]) -> Fact:
    kind = _KINDS.get(record["kind"], record["kind"])
    file, line = record["at"]
    node, name, type_ = (record[key] or "" for key in ("node", "name", "type"))
    system = record.get("system", False) and "entry" in record
    run = record.get("program") or record["file"] or ""
    return Fact(file, line, run, kind, node, name, type_, system)


def _parameters(record: dict[str, Any]) -> Iterator[Fact]:
    for parameter in record.get("parameters", ()) if "entry" in record else ():
        default = "" if parameter["value"] is None else parameter["value"]
        file, line = parameter["at"]
        yield Fact(file, line, record["file"] or "", "parameter", record["node"], parameter["name"], default)


def _judge(repo: str, graph: Graph, fact: Fact, lines: range) -> Verdict:
    """`lines` are those of the statement in which the running program stood."""
    if fact.kind == "node":
        return _judge_node(repo, graph, fact, lines)
    if fact.kind == "parameter":
        return _judge_parameter(repo, graph, fact)
    here = [
        e
        for e in graph.entities
        if e.kind == fact.kind and (fact.system or any(_within(s, fact, lines) for s in e.spots))
    ]
    here = [e for e in here if (fact.file, fact.line) in e.spots] or here
    named = [e for e in here if fnmatchcase(fact.name, e.name)]
    typed = [e for e in named if e.type in (fact.type, None)]
    right = [e for e in typed if fnmatchcase(fact.node, e.node)]
    if right:
        exact = any((e.name, e.node, e.type) == (fact.name, fact.node, fact.type) for e in right)
        return Verdict(repo, fact, found=True, exact=exact)
    if typed:
        return Verdict(repo, fact, False, "node", ", ".join(sorted({e.node for e in typed})))
    if named:
        return Verdict(repo, fact, False, "type", ", ".join(sorted({str(e.type) for e in named})))
    if here and not fact.system:
        return Verdict(repo, fact, False, "name", ", ".join(sorted({e.name for e in here})))
    same = [e for e in graph.entities if e.kind == fact.kind and e.name == fact.name and fnmatchcase(fact.node, e.node)]
    called = [e for e in same if e.type == fact.type and any(file == fact.run for file, _ in e.spots)]
    if called and fact.run != fact.file:
        return Verdict(repo, fact, found=True, exact=any(e.node == fact.node for e in called))
    if same:
        return Verdict(repo, fact, False, "place", ", ".join(f"{f}:{n}" for e in same for f, n in e.spots))
    return Verdict(repo, fact, False, "entity", _said(graph, fact, lines))


def _judge_node(repo: str, graph: Graph, fact: Fact, lines: range) -> Verdict:
    """A node is where its name is: the place of a class, of its `super().__init__` and of its making are all right."""
    files = {fact.file, fact.run}
    is_cpp = not fact.file.endswith(".py")  # a base class in another file, or a header that makes the node
    here = [node for node in graph.nodes if node.spot[0] in files or is_cpp]
    exact = any(fact.name == node.name for node in here)
    if exact or any(fnmatchcase(fact.name, node.name) for node in here):
        return Verdict(repo, fact, found=True, exact=exact)
    if any(node.name == fact.name for node in graph.nodes):
        places = sorted(f"{n.spot[0]}:{n.spot[1]}" for n in graph.nodes if n.name == fact.name)
        return Verdict(repo, fact, False, "place", ", ".join(places))
    if here and not is_cpp:
        return Verdict(repo, fact, False, "name", ", ".join(sorted(node.name for node in here)))
    return Verdict(repo, fact, False, "node", _said(graph, fact, lines))


def _judge_parameter(repo: str, graph: Graph, fact: Fact) -> Verdict:
    nodes = [node for node in graph.nodes if fnmatchcase(fact.node, node.name)]
    named = [(node, p) for node in nodes for p in node.parameters if fnmatchcase(fact.name, p.name)]
    if not named:
        return Verdict(repo, fact, False, "parameter", "" if nodes else f"no node {fact.node}")
    if any(_same_default(p.default, fact.type) and p.name == fact.name for _, p in named):
        return Verdict(repo, fact, found=True, exact=True)
    if any(p.default is None for _, p in named) or any(p.name != fact.name for _, p in named):
        return Verdict(repo, fact, found=True)
    return Verdict(repo, fact, False, "default", ", ".join(str(p.default) for _, p in named))


def _same_default(ours: object, written: str) -> bool:
    """Whether a default is what rclcpp wrote: `true`, `6.000000`, `[a, b]`."""
    if ours is None:
        return not written
    if isinstance(ours, bool):
        return written == str(ours).lower()
    if isinstance(ours, (int, float)):
        try:
            return abs(float(written) - ours) <= 1e-5 * max(1.0, abs(ours))
        except ValueError:
            return False
    if isinstance(ours, list):
        inner = written.removeprefix("[").removesuffix("]")
        parts = inner.split(", ") if inner else []
        return len(parts) == len(ours) and all(_same_default(a, b) for a, b in zip(ours, parts, strict=True))
    return ours == written


def _said(graph: Graph, fact: Fact, lines: range) -> str:
    """What the findings say of the place of a fact, or of its whole file."""
    of_file = [finding for finding in graph.findings if finding.spot[0] == fact.file]
    at_line = [finding for finding in of_file if _within(finding.spot, fact, lines)]
    said = at_line or [finding for finding in of_file if finding.severity == "error"]
    return "; ".join(dict.fromkeys(f"{finding.code} {finding.message}" for finding in said))


def _within(spot: Spot, fact: Fact, lines: range) -> bool:
    return spot[0] == fact.file and spot[1] in lines


def _extra(graph: Graph, recorded: set[Fact]) -> Iterator[Entity]:
    """Our entities in the recorded files whose kind and name no run showed there: conditional ones, or wrong ones."""
    shown: dict[str, set[tuple[str, str]]] = defaultdict(set)
    for fact in recorded:
        shown[fact.file].add((fact.kind, fact.name))
    for entity in graph.entities:
        files = {file for file, _ in entity.spots} & shown.keys()
        seen = any(
            kind == entity.kind and fnmatchcase(name, entity.name) for file in files for kind, name in shown[file]
        )
        if files and not seen and not entity.system:
            yield entity


def _group(entity: Entity) -> str:
    """Why no run may have shown an entity of ours."""
    if "*" in entity.name or "*" in entity.node:
        return "a name that is not known"
    if entity.conditional:
        return "conditional: an event, or a branch that the run did not take"
    return CERTAIN


def _why(verdict: Verdict) -> str:
    if verdict.found:
        return "" if verdict.exact else " (as a pattern)"
    if verdict.lacks in ("entity", "node") and not verdict.instead:
        return "  <- nothing there, and no finding"
    return f"  <- {verdict.lacks}: {verdict.instead}"


def _counted(verdicts: Iterable[Verdict]) -> str:
    counts = Counter("exact" if v.exact else "pattern" if v.found else "missing" for v in verdicts)
    found, number = counts["exact"] + counts["pattern"], counts.total()
    return f"{found} of {number} found ({found / max(number, 1):.1%}), {counts['pattern']} of them as a pattern"


def _summary(verdicts: list[Verdict]) -> None:
    print(f"\nall: {_counted(verdicts)}")
    for kind in sorted({verdict.fact.kind for verdict in verdicts}):
        print(f"  {kind:15}{_counted([v for v in verdicts if v.fact.kind == kind])}")
    own = [verdict for verdict in verdicts if not verdict.fact.system]
    if len(own) < len(verdicts):
        print(f"  without what the client library adds: {_counted(own)}")
    missed = Counter(verdict.lacks for verdict in verdicts if not verdict.found)
    print("missed by what is wrong: " + (", ".join(f"{what} {n}" for what, n in missed.most_common()) or "nothing"))


if __name__ == "__main__":
    sys.exit(main())
