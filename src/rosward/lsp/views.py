# SPDX-License-Identifier: Apache-2.0
"""How does the result of an analysis become what an editor is told? Only what the user's own code and launch files say is kept."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Final

from rosward.lsp.records import LAUNCH, SOURCES, End, Given, Seen, Setting, Started, Told, View

if TYPE_CHECKING:
    from rosward.findings import Finding
    from rosward.network.launch_tree import GivenParameter, LaunchEntry, LaunchSystem, Shown
    from rosward.result import Result
    from rosward.ros.entities import Entity, Node, Parameter

__all__ = ["told", "view_of"]

Share = Callable[[str, str], str]
_LONGEST_VALUE: Final = 200
_INSTALLED: Final = re.compile(r"\$\(find-pkg-share ([^()*\s]+)\)/([^*]+)")


def view_of(name: str, result: Result, findings: Iterable[Finding], share: Share) -> View:
    """The view of a result, with the findings that are shown of it. `share` finds what is installed: package and path."""
    systems = result.systems
    return View(
        name,
        LAUNCH if systems else SOURCES,
        tuple(_seen(node) for node in result.network.nodes),
        tuple(_started(entry, share) for system in systems for entry in system.entries),
        tuple(told(finding) for finding in findings),
        tuple(sorted(_files(systems))),
    )


def told(finding: Finding) -> Told:
    """A finding with what its rule says."""
    rule = finding.rule
    help_text = "" if finding.remedy else rule.help
    return Told(finding.code, rule.severity.value, finding.message, help_text, finding.place, finding.path)


def _seen(node: Node) -> Seen:
    return Seen(
        node.display_name,
        node.fqn,
        node.package,
        node.executable,
        node.process,
        node.defined_at,
        node.launched_by,
        tuple(_end(entity) for entity in node.entities if not entity.system),
        tuple(_setting(parameter) for parameter in node.parameters),
        node.conditional,
        node.assumed,
    )


def _end(entity: Entity) -> End:
    qos = entity.qos
    words = () if qos is None else tuple(
        (name, str(value))
        for name, value in (
            ("reliability", qos.reliability), ("durability", qos.durability), ("history", qos.history), ("depth", qos.depth)
        )
        if value is not None
    )  # fmt: skip
    return End(
        entity.kind.value,
        entity.name,
        entity.type,
        entity.created_at,
        words,
        entity.callback,
        entity.resolution.whole,
        entity.conditional,
        entity.reasons,
        entity.via,
    )


def _setting(parameter: Parameter) -> Setting:
    default, value = (
        "" if each is None else _short(str(each).lower() if isinstance(each, bool) else str(each))
        for each in (parameter.default, parameter.value)
    )
    return Setting(parameter.name, parameter.type, default, value, parameter.declared_at)


def _short(text: str) -> str:
    return text if len(text) <= _LONGEST_VALUE else f"{text[:_LONGEST_VALUE]}…"


def _started(entry: LaunchEntry, share: Share) -> Started:
    own = _text(entry.name) or _text(entry.plugin) or _text(entry.executable) or entry.kind
    package = _text(entry.package)
    program = "" if entry.program.startswith(("declared: ", "unknown: ")) else entry.program
    return Started(
        f"{package}/{own}" if package else own,
        program,
        entry.place,
        tuple((a.text, b.text) for a, b in entry.remaps),
        tuple(
            Given(each.kind, each.name, _short(each.value.text), each.place, _file_of(each, share))
            for each in entry.parameters
        ),
    )


def _file_of(given: GivenParameter, share: Share) -> str:
    """The parameter file that is given."""
    named = _INSTALLED.fullmatch(given.value.text) if given.kind == "file" else None
    return share(named[1], named[2]) if named else ""


def _text(shown: Shown | None) -> str:
    return "" if shown is None else shown.text


def _files(systems: Iterable[LaunchSystem]) -> set[str]:
    """The launch files of a system."""
    found: set[str] = set()
    for system in systems:
        found.add(system.file)
        for entry in system.entries:
            found |= {entry.place.file, *(inner.file for inner in entry.trail)}
    return found
