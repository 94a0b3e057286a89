# SPDX-License-Identifier: Apache-2.0
"""Where do an entity's name, its process and its right come from?

subscription /porter/battery of /porter/battery_monitor
  made of    parameter input = 'battery': its default (battery_monitor.py:19)
  started    delivery_base/battery_monitor, launched at robot.launch.py:33, included at fleet.launch.py:28
  policy     enclave /porter/battery_monitor: <topics subscribe="ALLOW"> <topic>/porter/battery</topic>
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Final, final

from rosward.enclaves.grants import enclaves
from rosward.location import Place
from rosward.network.checks import UnknownNames
from rosward.network.graph import Network
from rosward.network.launch_tree import LaunchEntry, LaunchSystem
from rosward.policies.elements import ELEMENTS
from rosward.records import NamedTuple
from rosward.ros.entities import Entity, Node, Parameter, Resolution

__all__ = ["EntityRules", "NameSource", "PolicyLine", "Start", "Starts", "remap_rules", "remedies", "sources"]

_REMEDIES: Final = (
    (
        "parameter without a value",
        "give the parameter a default, or a value with --params FILE.yaml or in the launch file",
    ),
    ("command-line argument", "give the argument a default, or analyse the launch file that passes it (--launch FILE)"),
    ("launch argument without a value", "--arg NAME:=VALUE"),
    ("environment variable", "--env NAME=VALUE, or set it in the launch file"),
    ("module not among the sources", "add its package to the PATHs, or describe it in a stub file (--models)"),
    ("unmodelled call", "describe the call in a stub file (--models DIR)"),
    ("argument that no caller in the sources passes", "add the code that makes the call to the PATHs"),
)
"""By the cause with which a reason begins."""

_OTHERWISE: Final = "use a constant or a parameter with a default, or accept the wildcard in the policy"


class NameSource(NamedTuple):
    """Something outside of the code that a name was made of. `value` is None where it is no plain value."""

    name: str
    what: str
    value: object
    origin: str
    places: tuple[Place, ...]


class Start(NamedTuple):
    """How a process is started; `includes` are the places that include its launch file, outermost first. `assumed`: nothing starts it."""

    process: str
    package: str | None
    executable: str | None
    launched_by: Place | None
    includes: tuple[Place, ...]
    assumed: bool = False


class PolicyLine(NamedTuple):
    """The rule that an entity causes, or why it has none (`why_not`)."""

    enclave: str
    element: str
    rule: str
    why_not: str


@final
class EntityRules:
    """The rule of each entity of a network."""

    def __init__(self, network: Network, unknown: UnknownNames = "deny") -> None:
        self._lines: dict[int, PolicyLine] = {}
        self.by_enclave: dict[str, list[PolicyLine]] = {}
        for enclave in enclaves(network, unknown):
            lines = self.by_enclave.setdefault(enclave.path, [])
            for profile in enclave.profiles:
                for grant in profile.grants:
                    outer, verb, inner = ELEMENTS[grant.kind]
                    line = PolicyLine(enclave.path, f'<{outer} {verb}="ALLOW">', f"<{inner}>{grant.name}</{inner}>", "")
                    lines.append(line)
                    self._lines.update((id(entity), line) for entity in grant.entities)
                for omission in profile.omissions:
                    line = PolicyLine(enclave.path, "", omission.entity.name, omission.why)
                    lines.append(line)
                    self._lines[id(omission.entity)] = line

    def of(self, entity: Entity) -> PolicyLine | None:
        """The rule of an entity that is one of the network's own records."""
        return self._lines.get(id(entity))


@final
class Starts:
    """What launch files say of the processes of a network."""

    def __init__(self, systems: Iterable[LaunchSystem]) -> None:
        self._entries: dict[tuple[str, int], list[LaunchEntry]] = {}
        for system in systems:
            for entry in system.entries:
                self._entries.setdefault((entry.place.file, entry.place.line), []).append(entry)

    def of(self, node: Node) -> Start:
        """How the process of a node is started; without the includes where several ways lead to it."""
        trails = {entry.trail for entry in self.entries(node)}
        trail = next(iter(trails)) if len(trails) == 1 else ()
        places = tuple(inclusion.place for inclusion in trail)
        return Start(node.process, node.package, node.executable, node.launched_by, places, node.assumed)

    def entries(self, node: Node) -> list[LaunchEntry]:
        """The entries of launch files that may be the start of a node."""
        if node.launched_by is None:
            return []
        found = self._entries.get((node.launched_by.file, node.launched_by.line), [])
        same = [e for e in found if e.package is not None and e.package.text == node.package] or found
        same = [e for e in same if e.executable is not None and e.executable.text == node.executable] or same
        return [e for e in same if e.namespace is not None and e.namespace.text == node.namespace] or same


def sources(node: Node, entity: Entity, entries: Sequence[LaunchEntry]) -> tuple[NameSource, ...]:
    """What a name was made of, each with its value and who set it."""
    parameters = {parameter.name: parameter for parameter in node.parameters}
    alone = len(entity.depends_on) == 1
    bound = entity.resolution is Resolution.BOUND
    return tuple(
        _parameter(parameters[name], entries, given=bound and alone)
        if name in parameters
        else NameSource(
            name, "argument or environment variable", None, "set from outside" if bound and alone else "", ()
        )
        for name in entity.depends_on
    )


def remap_rules(entity: Entity, entries: Sequence[LaunchEntry]) -> tuple[str, ...]:
    """The remap rules of the launch that lead to a name; the code may have the name by itself, too."""
    rules = (rule for entry in entries for rule in entry.remaps)
    return tuple(dict.fromkeys(f"{a.text} → {b.text}" for a, b in rules if b.text == entity.name))


def _parameter(parameter: Parameter, entries: Sequence[LaunchEntry], *, given: bool) -> NameSource:
    value = parameter.value
    if not given and value == parameter.default:
        places = (parameter.declared_at,) if parameter.declared_at else ()
        return NameSource(parameter.name, "parameter", value, "its default" if value is not None else "", places)
    own = [p for e in entries for p in e.parameters if p.kind != "file" and p.name == parameter.name]
    if own:
        at = tuple(dict.fromkeys(p.place for p in own if p.place is not None)) or tuple(
            dict.fromkeys(e.place for e in entries)
        )
        shown = value if value is not None else own[-1].value.text
        same = any(str(shown).lower() == p.value.text.lower() for p in own)  # True is `true` in a launch file
        origin = "set in the launch file" if same else "set from outside, overriding or in addition to the launch file"
        return NameSource(parameter.name, "parameter", shown, origin, at)
    # what the launch passes need not be what decides: a file of --params, too, may set it
    files = list(dict.fromkeys(p.value.text for e in entries for p in e.parameters if p.kind == "file"))
    passed = f"; the launch passes {', '.join(files[:3])}" if files else ""
    return NameSource(parameter.name, "parameter", value, f"set from outside{passed}", ())


def remedies(reasons: Iterable[str]) -> tuple[str, ...]:
    """What supplies the missing part, one for each kind of reason."""
    found = dict.fromkeys(
        next((told for cause, told in _REMEDIES if reason.startswith(cause)), _OTHERWISE) for reason in reasons
    )
    return tuple(found)
