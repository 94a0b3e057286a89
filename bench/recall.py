# SPDX-License-Identifier: Apache-2.0
"""What was seen when the programs ran, and whether we say so too: one line for each fact that the static result lacks.

    python bench/recall.py CHECKOUTS RECORDING.jsonl [--repo NAME] [--found] [--extra] [--json FILE]

CHECKOUTS holds the repositories as OWNER+NAME; each is analysed whole. Only facts of trust `hard` count. A fact is
found when the file, the line (any within the statement), the kind, the node, the name and the type agree; `*` in our
names stands for anything, and a type that we do not know for any.
Exit status 1 where a fact is missing.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections import Counter, defaultdict
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from fnmatch import fnmatchcase
from pathlib import Path

from facts import Entity, Graph, Spot
from measure import extract
from sites import statement

CERTAIN = "certain for us: the run ended before it, or ours to mend"


@dataclass(frozen=True, slots=True, order=True)
class Fact:
    """One thing that a program created when it ran."""

    file: str
    line: int
    run: str
    kind: str
    node: str
    name: str
    type: str

    def __str__(self) -> str:
        of_type = f" [{self.type}]" if self.type else ""
        return f"{self.file}:{self.line}: {self.kind} {self.name}{of_type} of {self.node}"


@dataclass(frozen=True, slots=True)
class Verdict:
    """Whether a fact was found; if not, in which respect, and what we have instead."""

    repo: str
    fact: Fact
    found: bool
    lacks: str = ""
    instead: str = ""


def main() -> int:
    """Analyse each recorded repository and print what is missing."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("checkouts", type=Path)
    parser.add_argument("recording", type=Path)
    parser.add_argument("--repo", action="append", help="only repositories whose name contains this")
    parser.add_argument("--found", action="store_true", help="list what was found as well")
    parser.add_argument("--extra", action="store_true", help="list what no run of a recorded file showed")
    parser.add_argument("--seconds", type=float, default=60, help="time limit for each repository")
    parser.add_argument("--json", type=Path, help="write all verdicts to this file")
    options = parser.parse_args()
    verdicts: list[Verdict] = []
    beyond: Counter[str] = Counter()
    for repo, (hard, recorded, interrupted) in sorted(_read(options.recording).items()):
        folder = options.checkouts / repo.replace("/", "+")
        if options.repo and not any(part in repo for part in options.repo):
            continue
        if not folder.is_dir():
            print(f"{repo}: no checkout")
            continue
        extraction = extract([folder], seconds=options.seconds, options=["--tests"])
        if extraction.trouble or extraction.graph is None:
            print(f"{repo}: {extraction.trouble or extraction.run.output.strip()}")
        graph = extraction.graph or Graph((), (), (), {}, {}, {})
        of_repo = [_judge(repo, graph, fact, statement(folder / fact.file, fact.line)) for fact in sorted(hard)]
        verdicts += of_repo
        found = sum(verdict.found for verdict in of_repo)
        print(f"{repo}: {found} of {len(of_repo)} found ({found / len(of_repo):.1%})")
        for verdict in of_repo:
            if not verdict.found or options.found:
                print(f"  {'found ' if verdict.found else 'MISSED'} {verdict.fact}" + _why(verdict))
        for entity in _extra(graph, {f for f in recorded if f.file not in interrupted}):
            group = _group(entity)
            beyond[group] += 1
            if options.extra:
                spot = entity.spots[0]
                print(
                    f"  only ours {spot[0]}:{spot[1]}: {entity.kind} {entity.name} [{entity.type}] of {entity.node}: {group}"
                )
    _summary(verdicts)
    print(
        "only ours, in files whose run came to its end: "
        + (", ".join(f"{g} {n}" for g, n in beyond.most_common()) or "nothing")
    )
    if options.json:
        text = json.dumps([asdict(verdict) for verdict in verdicts], indent=2)
        options.json.write_text(text + "\n", encoding="utf-8")
    return 0 if all(verdict.found for verdict in verdicts) else 1


def _read(recording: Path) -> dict[str, tuple[set[Fact], set[Fact], set[str]]]:
    """For each repository the facts of trust `hard`, all facts, and the files whose run did not come to its own end."""
    facts: dict[str, tuple[set[Fact], set[Fact], set[str]]] = defaultdict(lambda: (set(), set(), set()))
    with recording.open(encoding="utf-8") as lines:
        for record in map(json.loads, lines):
            fact = Fact(*record["at"], *(record[key] or "" for key in ("file", "kind", "node", "name", "type")))
            facts[record["repo"]][1].add(fact)
            if record["trust"] == "hard":
                facts[record["repo"]][0].add(fact)
            else:
                facts[record["repo"]][2].add(fact.file)
    return {repo: found for repo, found in facts.items() if found[0]}


def _judge(repo: str, graph: Graph, fact: Fact, lines: range) -> Verdict:
    """`lines` are those of the statement in which the running Python stood."""
    if fact.kind == "node":
        return _judge_node(repo, graph, fact, lines)
    here = [e for e in graph.entities if e.kind == fact.kind and any(_within(spot, fact, lines) for spot in e.spots)]
    here = [e for e in here if (fact.file, fact.line) in e.spots] or here
    named = [e for e in here if fnmatchcase(fact.name, e.name)]
    typed = [e for e in named if e.type in (fact.type, None)]
    if any(fnmatchcase(fact.node, e.node) for e in typed):
        return Verdict(repo, fact, found=True)
    if typed:
        return Verdict(repo, fact, False, "node", ", ".join(sorted({e.node for e in typed})))
    if named:
        return Verdict(repo, fact, False, "type", ", ".join(sorted({str(e.type) for e in named})))
    if here:
        return Verdict(repo, fact, False, "name", ", ".join(sorted({e.name for e in here})))
    same = [e for e in graph.entities if e.kind == fact.kind and e.name == fact.name and fnmatchcase(fact.node, e.node)]
    if same:
        return Verdict(repo, fact, False, "place", ", ".join(f"{f}:{n}" for e in same for f, n in e.spots))
    return Verdict(repo, fact, False, "entity", _said(graph, fact, lines))


def _judge_node(repo: str, graph: Graph, fact: Fact, lines: range) -> Verdict:
    """A node is where its name is: the place of a class, of its `super().__init__` and of its making are all right."""
    files = {fact.file, fact.run}
    here = [node for node in graph.nodes if node.spot[0] in files]
    if any(fnmatchcase(fact.name, node.name) for node in here):
        return Verdict(repo, fact, found=True)
    if any(node.name == fact.name for node in graph.nodes):
        places = sorted(f"{n.spot[0]}:{n.spot[1]}" for n in graph.nodes if n.name == fact.name)
        return Verdict(repo, fact, False, "place", ", ".join(places))
    if here:
        return Verdict(repo, fact, False, "name", ", ".join(sorted(node.name for node in here)))
    return Verdict(repo, fact, False, "node", _said(graph, fact, lines))


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
        return ""
    if verdict.lacks in ("entity", "node") and not verdict.instead:
        return "  <- nothing there, and no finding"
    return f"  <- {verdict.lacks}: {verdict.instead}"


def _summary(verdicts: list[Verdict]) -> None:
    found = sum(verdict.found for verdict in verdicts)
    print(f"\n{found} of {len(verdicts)} facts found ({found / max(len(verdicts), 1):.2%})")
    for kind, number in sorted(Counter(verdict.fact.kind for verdict in verdicts).items()):
        print(f"  {kind:15}{sum(v.found for v in verdicts if v.fact.kind == kind):6} of {number}")
    missed = Counter(verdict.lacks for verdict in verdicts if not verdict.found)
    print("missed by what is wrong: " + (", ".join(f"{what} {n}" for what, n in missed.most_common()) or "nothing"))


if __name__ == "__main__":
    sys.exit(main())
