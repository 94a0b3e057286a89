# SPDX-License-Identifier: Apache-2.0
"""A declared program, started with words and parameter files, as plain lines: what the tests of declarations compare."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from rosward.deployment.declared.declarations import Declarations
from rosward.deployment.declared.effects import declared
from rosward.deployment.declared.found import ReadFile
from rosward.domain.compound import Tuple
from rosward.domain.text import pattern
from rosward.domain.values import Const, Value
from rosward.effects.configuration import Configuration, Given
from rosward.effects.log import EffectLog
from rosward.findings import Finding
from rosward.location import Place
from rosward.naming.final_name import final_name
from rosward.naming.options import interface_types, name_options
from rosward.ros.distro import Distro

Rows = Mapping[str, Mapping[str, object]]

HERE = Place("launch/robot.launch.py", 7)
SIGNS = {
    "publisher": "pub",
    "subscription": "sub",
    "service_server": "srv",
    "service_client": "cli",
    "action_server": "act",
    "action_client": "goal",
}


def value(plain: object) -> Value:
    if isinstance(plain, (list, tuple)):
        return Tuple(tuple(value(p) for p in plain))
    assert isinstance(plain, (bool, int, float, str))
    return Const(plain)


def given(rows: Rows) -> tuple[Given, ...]:
    """A parameter file: node key -> parameter -> value."""
    return tuple(Given(key, name, value(v)) for key, params in rows.items() for name, v in params.items())


def start(
    package: str,
    name: str,
    words: Sequence[str | Value] = (),
    *,
    file: Rows | None = None,
    missing: bool = False,
    distro: Distro = Distro.JAZZY,
    folders: Sequence[Path] = (),
    component: bool = False,
    read_file: ReadFile | None = None,
) -> EffectLog:
    """Start a declared program; `file` is a parameter file that is known, with `missing` one that is not."""
    known = Declarations(folders)
    program = known.component(package, name) if component else known.executable(package, name)
    assert program is not None, list(known.findings)
    start_words: list[Value] = [w if isinstance(w, Value) else Const(w) for w in words]
    files: dict[str, tuple[Given, ...] | None] = {}
    if file is not None or missing:
        start_words += [Const("--ros-args"), Const("--params-file"), Const("/params")]
        files["/params"] = None if file is None else given(file)
    configuration = Configuration(tuple(start_words), files)
    if read_file is None:
        return declared(program, configuration, HERE, known, distro)
    return declared(program, configuration, HERE, known, distro, read_file)


def nodes(log: EffectLog) -> list[str]:
    found: list[str] = []
    for effect in log.nodes:
        name, namespace = final_name(log, effect)
        found.append(f"{pattern(namespace).rstrip('/')}/{pattern(name)}")
    return found


def lines(log: EffectLog, address: int = 1) -> list[str]:
    """The endpoints of a node: `pub joint_states JointState`, with `?` before those that only some executions have."""
    found: set[str] = set()
    for effect in log.entities:
        if effect.address == address:
            sure = "" if EffectLog.key(effect) in log.ends[0] else "?"
            types = "|".join((t or "-").rpartition("/")[2] for t in interface_types(effect.type))
            for option in name_options(effect.name):
                found.add(f"{sure}{SIGNS[effect.kind]} {option.text} {types}")
    return sorted(found)


def told(log: EffectLog) -> list[Finding]:
    """The findings of a process, then those of its nodes whose interface is not wholly known."""
    return [*log.findings, *(f for findings in log.open.values() for f in findings)]


def codes(log: EffectLog) -> list[str]:
    return [f.code for f in told(log)]
