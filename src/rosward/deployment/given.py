# SPDX-License-Identifier: Apache-2.0
"""What do parameter files that the user names add to the command line of every process?

--params robot.yaml  ->  Configuration(words=('--params-file', 'robot.yaml'), files={'robot.yaml': (…)})
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import Path

from rosward.domain.values import Const, Value
from rosward.effects.configuration import Configuration
from rosward.findings import Finding, Findings
from rosward.guard import guarded
from rosward.location import Place
from rosward.source.text import read_source

__all__ = ["parameter_files"]


def parameter_files(paths: Sequence[str], root: Path, findings: Findings, *, net: bool = True) -> Configuration:
    """The words to add, without the `--ros-args` before them; none where there are no files."""
    if not paths:
        return Configuration((), {})
    from rosward.deployment.parameter_files import read_parameter_file

    words: list[Value] = []
    files = {}
    for path in paths:
        text = read_source(Path(path).absolute(), root)
        if isinstance(text, Finding):
            findings.add(text)
            continue
        missing = "the parameter file was not read"
        read = guarded(partial(read_parameter_file, text.text, path), Place(path), missing, net=net)
        if isinstance(read, Finding):
            findings.add(read)
            continue
        rows, doubts = read
        findings.update(doubts)
        words += [Const("--params-file"), Const(path)]
        files[path] = rows
    return Configuration(tuple(words), files)
