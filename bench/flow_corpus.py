# SPDX-License-Identifier: Apache-2.0
"""What flows in real node files, by reading, and whether `rosward flow` says so: what is missing, and what is said beyond it.

    python bench/flow_corpus.py CHECKOUTS TRUTH.json [--repo TEXT] [--keep DIR]

CHECKOUTS holds the repositories as OWNER+NAME; each is analysed whole. TRUTH lists for the outputs of each file the sources by strength:
`explicit` (data), `implicit` (control), `either` of the two, `arrival` and `triggers`. An output is looked up by its line; where the line
only calls a function that sends, by what is said of that call. Names of topics are those in the source: one that is given by a parameter
stands for any one topic.
Exit status 1 where a source is missing.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Any

from measure import measure
from sites import statement

STRENGTHS = ("data", "control", "trigger")
Lists = dict[str, set[str]]
"""The sources of each strength."""


@dataclass(slots=True)
class Totals:
    """What was counted over all outputs."""

    outputs: int = 0
    true: int = 0
    claimed: int = 0
    of_joined: Counter[str] = field(default_factory=Counter)
    found: Counter[str] = field(default_factory=Counter)

    def add(self, how: str, true: int, claimed: int) -> None:
        """One output; `how` it was found."""
        self.outputs += 1
        self.true += true
        self.claimed += claimed
        self.of_joined[f"{how}: outputs"] += 1
        self.of_joined[f"{how}: true"] += true
        self.of_joined[f"{how}: claimed"] += claimed


def main() -> int:
    """Print each difference, and the counts."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("checkouts", type=Path)
    parser.add_argument("truth", type=Path)
    parser.add_argument("--repo", default="", help="only repositories whose name contains this text")
    parser.add_argument("--keep", type=Path, help="keep each flow.json below this folder, and use those that are there")
    parser.add_argument("--seconds", type=float, default=900, help="for each repository (default: 900)")
    options = parser.parse_args()
    files = json.loads(options.truth.read_text(encoding="utf-8"))["files"]
    totals = Totals()
    for repo in dict.fromkeys(f["repo"] for f in files if options.repo in f["repo"]):
        checkout = options.checkouts / repo.replace("/", "+")
        document = _flows(checkout, options)
        for file in (f for f in files if f["repo"] == repo):
            _judge_file(file, checkout, document, totals)
    print(f"\n{totals.outputs} outputs; " + ", ".join(f"{k} {n}" for k, n in sorted(totals.found.items())))
    print(
        f"data sources: {totals.true} true, {totals.claimed} said, {totals.claimed / max(totals.true, 1):.2f} for each"
    )
    for key, count in sorted(totals.of_joined.items()):
        print(f"  {key} {count}")
    return int(any(kind.startswith("missing") or kind == "unknown output" for kind in totals.found))


def _flows(checkout: Path, options: argparse.Namespace) -> dict[str, Any]:
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch) if options.keep is None else options.keep / checkout.name
        written = folder / "flow.json"
        if not written.exists():
            command = [sys.executable, "-m", "rosward", "flow", str(checkout), "--format", "json", "-o", str(folder)]
            run = measure(command, seconds=options.seconds)
            if not written.exists():
                raise SystemExit(f"{checkout.name}: {run.output.strip().rpartition(chr(10))[2] or run.status}")
        document: dict[str, Any] = json.loads(written.read_text(encoding="utf-8"))
        return document


def _judge_file(file: dict[str, Any], checkout: Path, document: dict[str, Any], totals: Totals) -> None:
    nodes = [node for node in document["nodes"] if _mentions(node, file["file"])]
    incomplete = "" if all(node["complete"] for node in nodes) else " (not wholly known)"
    print(f"{file['repo']} {file['file']}{incomplete}")
    for claim in file["sinks"]:
        lines = statement(checkout / file["file"], claim["line"])
        said, how = _said(nodes, claim["sink"], file["file"], lines)
        title = f"  {claim['line']} {claim['sink']}"
        if said is None:
            totals.found["unknown output"] += 1
            totals.add(how, len(claim["explicit"]), 0)
            print(f"{title}: unknown output")
            continue
        right = {*claim["explicit"], *(s for s in claim["either"] if _any(said["data"], s))}
        totals.add(how + incomplete, len(right), len(said["data"]))
        for kind, source in _differences(claim, said):
            totals.found[kind] += 1
            print(f"{title}: {kind}: {source}" + (f"  [{how}]" if how != "line" else ""))


def _mentions(node: dict[str, Any], file: str) -> bool:
    """Whether a node has an output in a file, or information comes through it."""
    return any(
        sink["at"][0] == file
        or any(place[0] == file for path in sink["paths"].values() for place in path)
        or any(place[0] == file for call in sink.get("calls", ()) for place in call["through"])
        for sink in node["sinks"]
    )


def _said(nodes: Iterable[dict[str, Any]], name: str, file: str, lines: range) -> tuple[Lists | None, str]:
    """What is said of an output, and by which way it was found."""
    sinks = [sink for node in nodes for sink in node["sinks"] if fits(sink["sink"], name)]
    here = [sink for sink in sinks if sink["at"][0] == file and sink["at"][1] in lines]
    if here:
        return _joined(here), "line"
    called = [
        call
        for sink in sinks
        for call in sink.get("calls", ())
        if any(place[0] == file and place[1] in lines for place in call["through"])
    ]
    if called:
        return _joined(called), "call"
    if sinks:
        return _joined(sinks), "all calls"
    return None, "unknown"


def _joined(rows: Sequence[dict[str, Any]]) -> Lists:
    data, control, trigger = ({s for row in rows for s in row[strength]} for strength in STRENGTHS)
    return {"data": data, "control": control - data, "trigger": trigger - control - data}


def fits(ours: str, theirs: str) -> bool:
    """Whether a name of ours may be one that stands in the source."""
    kind, _, name = ours.partition(":")
    other, _, written = theirs.partition(":")
    if kind != other:
        return False
    if kind in ("device", "log", "network", "file", "process"):
        return True
    if written.startswith("<") or name == written:
        return True
    plain = written.strip("/")
    pattern = name.strip("/")
    return fnmatchcase(plain, pattern) or pattern.endswith(f"/{plain}") or fnmatchcase(f"x/{plain}", pattern)


def _any(ours: Iterable[str], theirs: str) -> bool:
    return any(fits(each, theirs) for each in ours)


def _differences(claim: dict[str, Any], said: Lists) -> Iterator[tuple[str, str]]:
    strong = said["data"] | said["control"]
    anyhow = strong | said["trigger"]
    for source in claim["explicit"]:
        if not _any(said["data"], source):
            yield ("told as control" if _any(strong, source) else "missing data"), source
    yield from (("missing control", s) for s in (*claim["implicit"], *claim["either"]) if not _any(strong, s))
    yield from (("missing arrival", s) for s in claim["arrival"] if not _any(anyhow, s))
    yield from (("missing trigger", s) for s in claim["triggers"] if not _any(anyhow, s))
    yield from (("surplus data", s) for s in _beyond(said["data"], (*claim["explicit"], *claim["either"])))
    right = (*claim["explicit"], *claim["implicit"], *claim["either"])
    yield from (("surplus control", s) for s in _beyond(said["control"], right))


def _beyond(ours: Iterable[str], right: Sequence[str]) -> list[str]:
    """What is said without need. A name that a parameter gives stands for one of ours that has no other."""
    left = [each for each in sorted(ours) if not any(fits(each, s) for s in right if "<" not in s)]
    for _ in (s for s in right if "<" in s):
        taken = next((each for each in left if each.startswith("topic:")), None)
        if taken is not None:
            left.remove(taken)
    return left


if __name__ == "__main__":
    sys.exit(main())
