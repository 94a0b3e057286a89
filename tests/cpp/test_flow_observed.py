# SPDX-License-Identifier: Apache-2.0
"""Promise for C++: an input that really changes what is published is named for it. The ways of `flow/cpp_ways.txt` are compiled, run with other
contents of one input at a time, and compared with what is said of them.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from flow.test_cpp import flows
from flow.test_cpp_ways import WAYS, Way

from .compiled import needs_compiler
from .observed import observe_many

pytestmark = [needs_compiler, pytest.mark.slow]
_INCLUDED = ("array", "atomic", "cstring", "deque", "functional", "optional", "set", "tuple", "typeinfo")
_MORE = "".join(f"#include <{name}>\n" for name in _INCLUDED)
COMPILED = [
    w
    for w in WAYS
    if w.name.startswith(
        (
            "typeid",
            "first value",
            "braces",
            "index of",
            "reference wrapper",
            "array that",
            "comparator",
            "chosen",
            "character",
        )
    )
]


def test_what_changes_an_output_is_named_for_it(tmp_path: Path) -> None:
    observed = observe_many([_MORE + way.program for way in COMPILED], tmp_path)
    wrong = [
        f"{way.name}: {lost}"
        for way, each in zip(COMPILED, observed, strict=True)
        if (lost := _lost(way, each.changes, tmp_path))
    ]
    assert not wrong
    assert sum(map(bool, (each.changes for each in observed))) == len(COMPILED)
    assert all(each.same for each in observed)


def _lost(way: Way, changes: frozenset[tuple[str, str]], folder: Path) -> list[tuple[str, str]]:
    path = folder / "main.cpp"
    path.write_text(way.program)
    said = {
        (str(source), str(sink.sink))
        for each in flows(path)
        for sink in each.sinks
        for source in (*sink.data, *sink.control)
    }
    return sorted(changes - said)
