# SPDX-License-Identifier: Apache-2.0
"""What the real launch started, and whether we say so too: one line for each record that we lack or have beyond it.

    python bench/launch.py CHECKOUTS RECORDING.jsonl [--repo NAME] [--verbose] [--soft] [--json FILE]

CHECKOUTS holds the repositories as OWNER+NAME. Every recorded run (launch file and arguments) is executed by rosward; each node, component,
container and process of it is looked for in what we start: the place in the launch file, package, executable or plugin, name, namespace,
remappings and parameters. Where a value of ours is not wholly known it has to cover the recorded one. Exit status 1 where a hard record is
missing. What we start beyond the recording is explained: it depends on a condition, the real run failed before it, or it is ours to mend.
"""

from __future__ import annotations

import argparse
import json
import re
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

from rosward.analysis.deep_stack import with_deep_stack
from rosward.analysis.read import read_sources
from rosward.analysis.systems import Outset, System, systems_of
from rosward.deployment.request import LaunchRequest, Request, UnknownRequestError
from rosward.deployment.shown import shown
from rosward.deployment.started import Setting, Started, StartKind
from rosward.domain.choice import options
from rosward.domain.compound import Tuple
from rosward.domain.text import matches
from rosward.domain.values import Const, Unknown, Value
from rosward.ros.distro import Distro

KINDS: Final = {"composable": StartKind.COMPONENT, **{k.value: k for k in StartKind}}
CUT: Final = re.compile(r"\.\.\.\[\d+ characters, sha1 \w+\]$")

Record = Mapping[str, Any]


@dataclass
class Tally:
    """The counts of one repository."""

    files: set[str] = field(default_factory=set)
    runs: int = 0
    records: Counter[str] = field(default_factory=Counter)
    found: Counter[str] = field(default_factory=Counter)
    extra: Counter[str] = field(default_factory=Counter)
    seconds: float = 0.0


def main() -> int:
    """Compare run by run and print what differs."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("checkouts", type=Path)
    parser.add_argument("recording", type=Path)
    parser.add_argument("--repo", action="append", help="only repositories whose name contains this")
    parser.add_argument("--file", help="only launch files whose path contains this")
    parser.add_argument("--soft", action="store_true", help="list missing soft records too")
    parser.add_argument("--verbose", action="store_true", help="list what is beyond the recording")
    parser.add_argument("--json", type=Path, help="write the counts to this file")
    options_ = parser.parse_args()
    tallies: dict[str, Tally] = {}
    for repo, runs in sorted(read_recording(options_.recording).items()):
        if options_.repo and not any(part in repo for part in options_.repo):
            continue
        folder = options_.checkouts / repo.replace("/", "+")
        tallies[repo] = with_deep_stack(lambda f=folder, r=runs: compare(f, r, options_))  # type: ignore[misc]
    _print(tallies)
    if options_.json:
        rows = {
            r: {"found": dict(t.found), "records": dict(t.records), "extra": dict(t.extra)} for r, t in tallies.items()
        }
        options_.json.write_text(json.dumps(rows, indent=1), encoding="utf-8")
    return int(any(t.found["hard"] < t.records["hard"] for t in tallies.values()))


def read_recording(path: Path) -> dict[str, dict[tuple[str, str], tuple[Record, list[Record]]]]:
    """By repository, launch file and variant: the record of the run and those of what it started."""
    found: dict[str, dict[tuple[str, str], tuple[Record, list[Record]]]] = defaultdict(dict)
    with path.open(encoding="utf-8") as lines:
        for line in lines:
            record = json.loads(line)
            if record["record"] == "run":
                found[record["repo"]][record["launch_file"], record["variant"]] = (record, [])
            elif record["record"] == "node":
                key = (record["launch_file"], record["variant"])
                found[record["repo"]].setdefault(key, ({}, []))[1].append(record)
    # node records may stand before the record of their run
    return found


def compare(
    folder: Path, runs: Mapping[tuple[str, str], tuple[Record, list[Record]]], wanted: argparse.Namespace
) -> Tally:
    """All runs of one repository."""
    tally = Tally()
    outset = Outset.of(read_sources([folder], Distro.KILTED, tests=True))
    for (file, variant), (run, records) in sorted(runs.items()):
        if wanted.file and wanted.file not in file:
            continue
        tally.runs += 1
        tally.files.add(file)
        arguments = tuple((name, value) for name, value in run.get("arguments", ()) if isinstance(value, str))
        start = time.process_time()
        try:
            (system,) = systems_of(Request(launches=(LaunchRequest(file, None, arguments),)), outset).systems
        except UnknownRequestError as error:
            print(f"{folder.name} {file}: {error}")
            system = System("", file, (), ())
        tally.seconds += time.process_time() - start
        _compare_run(f"{folder.name} {file} [{variant}]", run, records, system, outset, tally, wanted)
    return tally


def _compare_run(
    title: str,
    run: Record,
    records: list[Record],
    system: System,
    outset: Outset,
    tally: Tally,
    wanted: argparse.Namespace,
) -> None:
    left = list(system.started)
    missing: list[Record] = []
    for record in records:
        tally.records[record["trust"]] += 1
        match = next((s for s in left if not differences(record, s, outset)), None)
        if match is None:
            missing.append(record)
            continue
        tally.found[record["trust"]] += 1
        left.remove(match)
    for record in missing:
        near = min(left, key=lambda s: _distance(record, s, outset), default=None)
        if near is not None and "place" not in differences(record, near, outset):
            left.remove(near)
        if record["trust"] == "hard" or wanted.soft:
            print(f"{title}: lacks {_name(record)} ({record['trust']})")
            if near is not None:
                for field_, (theirs, ours) in differences(record, near, outset).items():
                    print(f"    {field_}: {theirs} / {ours}"[:600])
    for each in left:
        why = _explained(each, run)
        tally.extra[why] += 1
        if wanted.verbose and why == "ours to mend":
            print(
                f"{title}: beyond the recording: {each.kind.value} {_show(each.package)}/{_show(each.executable or each.plugin)} ({each.place})"
            )


def _explained(each: Started, run: Record) -> str:
    if not run.get("ok", True):
        return "real run failed"
    if each.conditional:
        return "condition unknown"
    return "event" if each.event else "ours to mend"


def differences(record: Record, ours: Started, outset: Outset) -> dict[str, tuple[object, object]]:
    """In which fields a record is not covered by what we start."""
    found: dict[str, tuple[object, object]] = {}

    def hold(name: str, theirs: object, value: object, *, same: bool) -> None:
        if not same:
            found[name] = (theirs, value)

    site = (record["site"]["file"], record["site"]["line"] or ours.place.line)  # markup has no line in the recording
    hold(
        "place",
        site,
        (ours.place.file, ours.place.line),
        same=KINDS[record["kind"]] is ours.kind and site == (ours.place.file, ours.place.line),
    )
    if record["kind"] == "process":
        hold(
            "program", record["cmd"], [_show(w) for w in ours.command], same=_covers_words(record["cmd"], ours.command)
        )
        return found
    hold("package", record["package"], _show(ours.package), same=_covers(ours.package, record["package"]))
    program, value = ("plugin", ours.plugin) if record["kind"] == "composable" else ("executable", ours.executable)
    hold("program", record[program], _show(value), same=_covers(value, record[program]))
    hold("name", record["name"], _show(ours.name), same=_covers(ours.name, record["name"]))
    hold("namespace", record["namespace"], _show(ours.namespace), same=_covers(ours.namespace, record["namespace"]))
    theirs = [tuple(r) for r in record["remappings"]]
    same = len(theirs) == len(ours.remaps) and all(
        _covers(a, x) and _covers(b, y) for (a, b), (x, y) in zip(ours.remaps, theirs, strict=True)
    )
    hold("remappings", theirs, [(_show(a), _show(b)) for a, b in ours.remaps], same=same)
    wanted, have = list(_their_parameters(record)), list(ours.settings)
    lacking = [w for w in wanted if not any(_same_setting(w, s, outset) for s in have)]
    beyond = [s for s in have if not any(_same_setting(w, s, outset) for w in wanted) and s.kind != "file"]
    hold(
        "parameters",
        lacking,
        [(s.kind, s.scope, s.name, _show(s.value)) for s in beyond or have],
        same=not lacking and not beyond,
    )
    return found


def _distance(record: Record, ours: Started, outset: Outset) -> tuple[int, int]:
    different = differences(record, ours, outset)
    return ("place" in different, len(different))


def _their_parameters(record: Record) -> Iterator[tuple[str, str | None, str, object]]:
    for given in record.get("parameters") or ():
        if given["kind"] == "dict":
            extra = record.get("extra_arguments") or {}
            yield from (("dict", given["scope"], n, v) for n, v in given["values"].items() if n not in extra)
        elif given["kind"] == "file":
            if not given["missing"]:
                yield ("file", None, "", given["file"])
        else:
            yield (given["kind"], None, given.get("name", ""), given.get("value"))


def _same_setting(theirs: tuple[str, str | None, str, object], ours: Setting, outset: Outset) -> bool:
    kind, scope, name, value = theirs
    if kind == "file":
        return ours.kind == "file" and (
            outset.files.find(ours.value) == value
            or _covers(ours.value, str(value))
            or _show(ours.value).startswith("/tmp/")
        )
    if ours.kind == "file" or ours.name not in (name, "*"):
        return False
    return (scope is None or scope == ours.scope or "*" in ours.scope[1:]) and _covers_plain(ours.value, value)


def _covers_plain(ours: Value, theirs: object) -> bool:
    """Whether a parameter value covers a recorded one."""
    for option in options(ours):
        if isinstance(option, Unknown):
            return True
        if isinstance(option, Tuple) and isinstance(theirs, list):
            if len(option.items) == len(theirs) and all(map(_covers_plain, option.items, theirs)):
                return True
        elif isinstance(theirs, str):
            cut = CUT.search(theirs)  # the recording shortens long text
            if cut is not None and _show(option).startswith(theirs[: cut.start()]):
                return True
            if _covers(option, theirs):
                return True
        elif isinstance(option, Const) and type(option.value) is type(theirs) and option.value == theirs:
            return True
    return False


def _covers(ours: Value | None, theirs: str | None) -> bool:
    if ours is None or theirs is None:
        return ours is None and theirs is None
    return any(_show(o) == theirs or matches(o, theirs) for o in options(ours))


def _covers_words(theirs: list[str], ours: Iterable[Value]) -> bool:
    mine = list(ours)
    return len(mine) == len(theirs) and all(_covers(o, t) for o, t in zip(mine, theirs, strict=True))


def _show(value: Value | None) -> str:
    return "None" if value is None else shown(value).text


def _name(record: Record) -> str:
    program = record.get("executable") or record.get("plugin") or " ".join(record.get("cmd", ()))
    return f"{record['kind']} {record.get('package')}/{program} name={record.get('name')} at {record['site']['file']}:{record['site']['line']}"


def _print(tallies: Mapping[str, Tally]) -> None:
    total = Tally()
    print(f"\n{'repository':44} files runs  hard found  soft found  beyond: condition failed event mend   s")
    for repo, tally in [*tallies.items()]:
        _row(repo, tally)
        total.files |= {f"{repo}/{f}" for f in tally.files}
        total.runs += tally.runs
        total.seconds += tally.seconds
        for counter in ("records", "found", "extra"):
            getattr(total, counter).update(getattr(tally, counter))
    _row("all", total)


def _row(name: str, tally: Tally) -> None:
    extra = tally.extra
    print(
        f"{name:44} {len(tally.files):5} {tally.runs:4} {tally.records['hard']:5} {tally.found['hard']:5}"
        f" {tally.records['soft']:5} {tally.found['soft']:5}          {extra['condition unknown']:9} {extra['real run failed']:6}"
        f" {extra['event']:5} {extra['ours to mend']:4} {tally.seconds:5.1f}"
    )


if __name__ == "__main__":
    sys.exit(main())
