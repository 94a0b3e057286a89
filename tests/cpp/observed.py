# SPDX-License-Identifier: Apache-2.0
"""Which inputs of a C++ program really change which outputs? It is compiled against the double, and run with other contents of one input at a time.

    observe_many([text], folder)    ->  [Observed({"topic:/in"}, {"topic:/out"}, {("topic:/in", "topic:/out")}, True)]

All else is equal: the order of callbacks, and the contents of the other inputs.
"""

from __future__ import annotations

import os
import re
import subprocess
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Final, NamedTuple

from .compiled import PROGRAM, compile_many

_LINE: Final = re.compile(r"^@double (comes|said) (\S+) ?(.*)$", re.MULTILINE)
_SECONDS: Final = 300
VARIANTS: Final = 5
"""So many other contents each input gets."""


class Observed(NamedTuple):
    """The inputs that arrived, the outputs that were sent, which input changed which output; whether two equal runs did the same."""

    inputs: frozenset[str]
    outputs: frozenset[str]
    changes: frozenset[tuple[str, str]]
    same: bool


class _Run(NamedTuple):
    """What one run did: the inputs that arrived, the contents of each output in turn, whether it came to its end."""

    inputs: frozenset[str]
    said: dict[str, list[str]]
    ended: bool

    def changed(self, other: _Run) -> Iterable[str]:
        """The outputs that differ, up to the point where one of the runs ends."""
        for sink in self.said.keys() | other.said.keys():
            mine, theirs = self.said.get(sink, []), other.said.get(sink, [])
            if not (self.ended and other.ended):
                least = min(len(mine), len(theirs))
                mine, theirs = mine[:least], theirs[:least]
            if mine != theirs:
                yield sink


def _read(text: str, status: int) -> _Run:
    inputs: set[str] = set()
    said: dict[str, list[str]] = {}
    for kind, name, content in _LINE.findall(text):
        if kind == "comes":
            inputs.add(name)
        else:
            said.setdefault(name, []).append(content)
    return _Run(frozenset(inputs), said, status == 0)


def _run(program: Path, vary: str) -> list[_Run]:
    done = subprocess.run(
        [program],
        capture_output=True,
        text=True,
        errors="replace",
        check=False,
        timeout=_SECONDS,
        env={**os.environ, "ROSWARD_DOUBLE_VARY": vary},
    )
    return [_read(text, int(status)) for text, status in PROGRAM.findall(done.stdout)]


def observe_many(texts: Sequence[str], folder: Path) -> list[Observed]:
    """Compile programs as one, and run them again and again."""
    program = compile_many(texts, folder)
    first, again = _run(program, ""), _run(program, "")
    assert len(first) == len(texts)
    changes: list[set[tuple[str, str]]] = [set() for _ in texts]
    for source in sorted({name for run in first for name in run.inputs}):
        for variant in range(1, VARIANTS + 1):
            for found, one, other in zip(changes, first, _run(program, f"{source}={variant}"), strict=True):
                found.update((source, sink) for sink in one.changed(other))
    return [
        Observed(one.inputs, frozenset(one.said), frozenset(found), one == other)
        for one, other, found in zip(first, again, changes, strict=True)
    ]
