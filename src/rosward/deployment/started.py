# SPDX-License-Identifier: Apache-2.0
"""What a launch file starts: one record a node or process, with every substitution performed.

    <group><push_ros_namespace namespace="left"/><node pkg="demo" exec="talker" name="t"/></group>
    ->  Started(kind=NODE, package=Const('demo'), executable=Const('talker'), name=Const('t'), namespace=Const('/left'), …)

Values are abstract: what depends on something unknown is a text with holes, or a choice. What came from the default of a launch argument
carries an Origin('launch argument', name, settled=True); what the user gave by name:=value an Origin(…, settled=True, given=True).
"""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import TYPE_CHECKING, final

from rosward.network.launch_tree import Inclusion
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.domain.values import Value
    from rosward.effects.configuration import Configuration
    from rosward.findings import Finding
    from rosward.location import Place


class StartKind(enum.Enum):
    """What is started."""

    NODE = "node"
    LIFECYCLE = "lifecycle"
    CONTAINER = "container"
    COMPONENT = "component"
    PROCESS = "process"


class Setting(NamedTuple):
    """A parameter or a parameter file that a node is given, for the tree that people read and for the comparison with the real launch.

    kind: 'global' (SetParameter), 'rule' (-p of a Parameter description), 'dict' (keyed by `scope`), 'file' (`value` is its path).
    """

    kind: str
    name: str
    value: Value
    scope: str = "/**"
    place: Place | None = None


@final
@dataclass(frozen=True, slots=True, eq=False)
class Started:
    """One node, component, container or process. `name` and `namespace` are None where launch gives none: then the program's own count.

    `namespace` has the pushed namespaces in it. `remaps` has SetRemap's first. `configuration` is the command line that this makes.
    `conditional`: some execution with these arguments does not start it; `why` says what that depends on. `event`: what has to happen first
    ('' : nothing), as 'timer', 'process-exit', … `trail` are the includes that led here, outermost first;
    `container` is the (full, as given) name of a component's container, `plugin` its class. `told` is what is doubtful of this one, which
    the findings of the execution have, too.
    """

    kind: StartKind
    place: Place
    configuration: Configuration
    package: Value | None = None
    executable: Value | None = None
    plugin: Value | None = None
    container: Value | None = None
    name: Value | None = None
    namespace: Value | None = None
    remaps: tuple[tuple[Value, Value], ...] = ()
    settings: tuple[Setting, ...] = ()
    command: tuple[Value, ...] = ()
    conditional: bool = False
    why: tuple[str, ...] = ()
    event: str = ""
    trail: tuple[Inclusion, ...] = ()
    told: tuple[Finding, ...] = ()
