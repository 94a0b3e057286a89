# SPDX-License-Identifier: Apache-2.0
"""Hold thousands of random programs against the real rclpy: `python -m tests.live.generate --count 5000`.

    seed 17: uncovered /n pub /left_2 std_msgs/msg/String       rosward lost it
    seed 40: missing /n: sub /a std_msgs/msg/String             rosward says that every execution creates it: none did
    3000 programs, 2 disagreements; exact in 2987 of 2999 …     and how precise the answers are

`--keep DIR` writes each program in which the two disagree, made as small as leaving out lines can make it.
"""

from __future__ import annotations

import argparse
import ast
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import Final, NamedTuple

import rosward

from .agreement import Verdict, judge
from .draft import Seeded
from .generator import Written, write
from .harness import Program, RealRclpy, Seen

PATIENCE: Final = 4.0
"""Seconds for a program to run: what is left of one that is made smaller may run for ever."""
EFFORT: Final = 40.0
"""Seconds to make a program smaller."""


class Outcome(NamedTuple):
    """What came of one program."""

    verdict: Verdict
    seen: Seen
    result: rosward.Result


def compare(real: RealRclpy, files: dict[str, str], *, interrupt: bool = False) -> Outcome:
    """Run a program and analyse it."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for file, text in files.items():
            path = folder / file
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        real.send(Program(folder, "main.py", interrupt=interrupt, patience=PATIENCE))
        result = rosward.extract(folder, distro="kilted")
        seen = real.receive()
        return Outcome(judge(result, [seen]), seen, result)


def smaller(files: dict[str, str], fails: Callable[[dict[str, str]], bool]) -> dict[str, str]:
    """The program without what can be left out while it still fails, as far as a minute goes."""
    changed, end = True, time.monotonic() + EFFORT
    while changed and time.monotonic() < end:
        changed = False
        for file in list(files):
            for candidate in _without_one(files[file]):
                if time.monotonic() > end:
                    return files
                attempt = {**files, file: candidate}
                if fails(attempt):
                    files, changed = attempt, True
                    break
    return files


def _without_one(text: str) -> Iterator[str]:
    """The file without one statement, the largest first; or with a block in the place of its statement."""
    lines = text.split("\n")
    spots = []
    for node in ast.walk(ast.parse(text)):
        for field in ("body", "orelse", "finalbody"):
            body = getattr(node, field, None)
            if isinstance(body, list):
                spots += [
                    (s, len(body), field) for s in body if isinstance(s, ast.stmt) and not isinstance(s, ast.Pass)
                ]
    for statement, count, field in sorted(spots, key=lambda s: _first(s[0]) - (s[0].end_lineno or 0)):
        first, last = _first(statement), statement.end_lineno or statement.lineno
        indent = lines[first - 1][: len(lines[first - 1]) - len(lines[first - 1].lstrip())]
        filler = [indent + "pass"] if count == 1 and not (field == "body" and not indent) else []
        yield "\n".join([*lines[: first - 1], *filler, *lines[last:]])


def _first(statement: ast.stmt) -> int:
    decorators: Sequence[ast.expr] = getattr(statement, "decorator_list", [])
    return min([statement.lineno, *(d.lineno for d in decorators)])


def complaint(verdict: Verdict) -> str:
    """What is wrong, short."""
    if verdict.uncovered and not verdict.told:
        return "uncovered " + "; ".join(verdict.uncovered)
    if verdict.missing:
        return "missing " + "; ".join(verdict.missing)
    return ""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--count", type=int, default=1000, help="how many programs")
    parser.add_argument("--first", type=int, default=0, help="the first seed")
    parser.add_argument("--unknown", action="store_true", help="let conditions depend on what only a run knows")
    parser.add_argument("--settled", action="store_true", help="leave out what stands in constructs/, as the test does")
    parser.add_argument("--keep", type=Path, help="a folder for the programs in which the two disagree")
    parser.add_argument("--vague", action="store_true", help="show what is not exact")
    given = parser.parse_args(arguments)
    seeds = range(given.first, given.first + given.count)
    with RealRclpy() as real:
        return _run(real, seeds, given)


def _run(real: RealRclpy, seeds: Iterable[int], given: argparse.Namespace) -> int:
    ends: Counter[str] = Counter()
    wrong = vague = unseen = told = entities = compared = 0
    for seed in seeds:
        written = write(Seeded(seed), known=not given.unknown, further=not given.settled)
        outcome = compare(real, written.files, interrupt=seed % 10 == 9)
        verdict = outcome.verdict
        ends[outcome.seen.end.split(":")[0]] += 1
        compared += outcome.seen.whole
        entities += sum(1 for n in outcome.result.network.nodes for e in n.entities if not e.system)
        vague += bool(verdict.vague)
        unseen += bool(verdict.unseen and outcome.seen.whole)
        told += verdict.told
        if text := complaint(verdict):
            wrong += 1
            print(f"seed {seed}: {text}", flush=True)
            if given.keep:
                _keep(real, seed, written, text, given.keep, interrupt=seed % 10 == 9)
        elif given.vague and (verdict.vague or verdict.told or (verdict.unseen and outcome.seen.whole)):
            print(
                f"seed {seed}: vague {verdict.vague} unseen {verdict.unseen} findings {_findings(outcome.result)}",
                flush=True,
            )
    total = sum(ends.values())
    print(
        f"{total} programs with {entities} entities, {wrong} disagreements; {compared} ran to their end: {dict(ends)}"
    )
    print(
        f"not exact: {vague} programs with a partially known name, {unseen} with an entity that did not show, {told} that say so"
    )
    return int(wrong > 0)


def _findings(result: rosward.Result) -> list[str]:
    return [f"{f.code} {f.place} {f.message}" for f in result.findings if f.code not in {"RW301", "RW205"}][:4]


def _keep(real: RealRclpy, seed: int, written: Written, text: str, folder: Path, *, interrupt: bool) -> None:
    kind = text.split(maxsplit=1)[0]

    def fails(files: dict[str, str]) -> bool:
        try:
            outcome = compare(real, files, interrupt=interrupt)
        except SyntaxError:
            return False
        same = complaint(outcome.verdict).startswith(kind) and outcome.seen.end in {"normal", "KeyboardInterrupt: "}
        return same and len(outcome.seen.facts) > 0

    files = smaller(written.files, fails) if fails(written.files) else written.files
    outcome = compare(real, files, interrupt=interrupt)
    folder.mkdir(parents=True, exist_ok=True)
    body = "\n".join(f"# {name}\n{content}" for name, content in sorted(files.items()))
    (folder / f"seed{seed}.txt").write_text(
        f"# {complaint(outcome.verdict)}\n# {outcome.seen.end}\n{body}", encoding="utf-8"
    )


if __name__ == "__main__":
    raise SystemExit(main())
