# SPDX-License-Identifier: Apache-2.0
"""What does the file of a declared interface say? The records that `read.py` makes of it and `effects.py` carries out.

executables: {relay: {node: relay, subscriptions: [{name: '${param:input}', type: std_msgs/msg/String, qos: 10}]}}
->  Program('topic_tools', 'relay', nodes=(NodeShape('relay', …, EndpointGroup(endpoints=(EndpointTemplate('subscription', '${param:input}', …),))),))
"""

from __future__ import annotations

from rosward.domain.values import Value
from rosward.location import Place
from rosward.records import NamedTuple
from rosward.ros.distro import Distro
from rosward.ros.entities import Qos
from rosward.ros.implicit import ClientLibrary

Scalar = bool | int | float | str


class DeclaredCondition(NamedTuple):
    """One condition: the text `subject` (a template, `${param:x}` …) compared by `test`: is, not, in, set, installed.

    `installed` asks for a package of the machine that it runs on, which is never known.
    `values` are what it is compared with; for `set`, the parameter or option `subject` is given at all (or, with False, is not).
    """

    subject: str
    test: str
    values: tuple[Scalar, ...]


class Loop(NamedTuple):
    """`variable` takes each of some items, by `source`.

    They are the parameters of a `family`, the `words` of a parameter, the elements of a `list`, the names `below` a prefix, or `values`.
    """

    variable: str
    source: str
    of: str
    values: tuple[str, ...] = ()


class Window(NamedTuple):
    """The distributions in which something is so."""

    since: Distro | None = None
    until: Distro | None = None

    def has(self, distro: Distro) -> bool:
        """Whether the distribution is one of them."""
        after = self.since is None or distro.has(self.since)
        return after and (self.until is None or self.until.has(distro))


class EndpointTemplate(NamedTuple):
    """One endpoint; `name` and `type` are templates."""

    kind: str
    name: str
    type: str
    qos: Qos | None
    when: tuple[DeclaredCondition, ...]
    window: Window
    place: Place


class DeclaredParameter(NamedTuple):
    """A parameter and its default: None where it has none."""

    name: str
    type: str | None
    default: Scalar | tuple[Scalar, ...] | None
    place: Place
    window: Window = Window()


class IncludedDeclaration(NamedTuple):
    """Another group by its name, `name` or `package/name`, with variables."""

    name: str
    variables: tuple[tuple[str, str], ...]
    place: Place


class EndTemplate(NamedTuple):
    """An input or output of a flow: a kind of `flow.json`, and a template of its name where the kind has names."""

    kind: str
    name: str
    place: Place


class FlowTemplate(NamedTuple):
    """What one output is made of: inputs by their strength. An output may have several such entries."""

    to: EndTemplate
    sources: tuple[tuple[str, EndTemplate], ...]
    when: tuple[DeclaredCondition, ...]
    place: Place
    window: Window = Window()


class EndpointGroup(NamedTuple):
    """Endpoints and parameters that exist together, under conditions or for each of several items.

    `cases`: for the value of `switch` the group of that value, else `otherwise`. `open` says what cannot be said: the interface has more than this.
    """

    when: tuple[DeclaredCondition, ...] = ()
    window: Window = Window()
    loops: tuple[Loop, ...] = ()
    parameters: tuple[DeclaredParameter, ...] = ()
    endpoints: tuple[EndpointTemplate, ...] = ()
    includes: tuple[IncludedDeclaration, ...] = ()
    groups: tuple[EndpointGroup, ...] = ()
    switch: str | None = None
    cases: tuple[tuple[str, EndpointGroup], ...] = ()
    otherwise: EndpointGroup | None = None
    open: str | None = None
    flows: tuple[FlowTemplate, ...] = ()


class NodeShape(NamedTuple):
    """One node. `arguments` are its own command-line words, which its code gives it; `options` those of its constructor.

    `plugin`: the class that it is made of, as pluginlib knows it (a template). Where the sources have that class, they say what it does.
    """

    name: str
    namespace: str | None
    lifecycle: bool
    global_arguments: bool
    options: tuple[tuple[str, bool], ...]
    arguments: tuple[str, ...]
    client_library: ClientLibrary
    group: EndpointGroup
    place: Place
    plugin: str | None = None


class PluginNode(NamedTuple):
    """A node that a declared program makes of a class which it loads by its name; `words` are the node's own command line."""

    plugin: str
    words: tuple[Value, ...]
    certain: bool


class Program(NamedTuple):
    """An executable or component: its nodes, and the program of rosward that reads what no notation can say (`reader`)."""

    package: str
    name: str
    kind: str
    source: str
    nodes: tuple[NodeShape, ...]
    reader: str | None
    open: str | None
    place: Place


class PackageDeclaration(NamedTuple):
    """One file: the programs of a package and its named groups."""

    name: str
    executables: dict[str, Program]
    components: dict[str, Program]
    interfaces: dict[str, EndpointGroup]
