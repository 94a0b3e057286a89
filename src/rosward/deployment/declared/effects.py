# SPDX-License-Identifier: Apache-2.0
"""Which nodes does a program have whose source is not among the analysed, but whose interface is declared?

    declarations = Declarations()
    program = declarations.executable("robot_state_publisher", "robot_state_publisher")
    declared(program, configuration, place, declarations)  ->  EffectLog: a node, publishers robot_description, /tf, /tf_static, …

A declaration has the same effects as the interpretation of a source, so names, remap rules, implicit entities and policies come after it in
the one way. `log.ends` holds what every execution does. The notation is described in docs/declared-nodes.md.
"""

from __future__ import annotations

import enum
from collections.abc import Callable, Sequence
from typing import Final, final

from rosward.deployment.declared.declarations import Declarations
from rosward.deployment.declared.flows import FoundEnd, FoundFlow, process_flows
from rosward.deployment.declared.found import FilesRead, FoundEndpoint, Open, ReadFile
from rosward.deployment.declared.items import ItemLimit, expansions, type_value
from rosward.deployment.declared.programs import READERS
from rosward.deployment.declared.shapes import (
    DeclaredParameter,
    EndpointGroup,
    EndpointTemplate,
    FlowTemplate,
    NodeShape,
    PluginNode,
    Program,
)
from rosward.deployment.declared.text import DeclaredParameters, TemplateScope, as_value, expand
from rosward.domain.choice import lift, lift2, options
from rosward.domain.compound import External
from rosward.domain.series import Series
from rosward.domain.text import pattern, readable
from rosward.domain.unknown import Reason
from rosward.domain.values import NONE, Const, Value
from rosward.effects.configuration import Configuration
from rosward.effects.log import EffectLog, EntityEffect, NodeEffect, ParameterEffect
from rosward.findings import Finding, Findings
from rosward.holes import HOLE, Holed
from rosward.location import Place
from rosward.naming.command_line import given_to, read_words
from rosward.naming.final_name import final_name, full_name, remaps_of
from rosward.ros import names
from rosward.ros.arguments import parse_arguments
from rosward.ros.distro import Distro

_MOST_ENDPOINTS: Final = 2_000
_MOST_STEPS: Final = 50_000
_DEEPEST_INCLUDE: Final = 16
_SIM_TIME: Final = DeclaredParameter("use_sim_time", "bool", False, Place(""))


TakePlugin = Callable[[PluginNode], bool]
"""Whether somebody else says what a node of a class does that is loaded by its name."""


def nobody(node: PluginNode) -> bool:  # noqa: ARG001 (the shape of TakePlugin)
    """No class is known but by its declaration."""
    return False


def no_file(path: Value) -> str | None:  # noqa: ARG001 (the shape of ReadFile)
    """No file is known."""
    return None


def declared(
    program: Program,
    configuration: Configuration,
    place: Place,
    declarations: Declarations,
    distro: Distro = Distro.JAZZY,
    read_file: ReadFile = no_file,
    take: TakePlugin = nobody,
) -> EffectLog:
    """The effects of a process that runs `program`, started at `place`. `read_file` gives the text of a file that an argument names.

    `take` is asked about each node of a class that the program loads: what it takes is not in the effects.
    """
    return _DeclaredProcess(program, configuration, place, declarations, distro, read_file, take).run()


class _Pass(enum.Enum):
    """Conditions ask for parameters that may be declared behind them, so the defaults of all are read first."""

    DEFAULTS = enum.auto()
    ENDPOINTS = enum.auto()


@final
class _DeclaredProcess:
    """One process: walks the groups of its nodes and notes their effects."""

    def __init__(
        self,
        program: Program,
        configuration: Configuration,
        place: Place,
        declarations: Declarations,
        distro: Distro,
        read_file: ReadFile,
        take: TakePlugin,
    ) -> None:
        self._program = program
        self._place = place
        self._declarations = declarations
        self._distro = distro
        self._read_file = read_file
        self._take = take
        self._configuration = configuration
        self._via = f"the declared interface of {program.package}/{program.name}"
        self._flows: list[FoundFlow] = []
        self._log = EffectLog()
        self._log.configuration = configuration
        self._done: set[tuple[object, ...]] = set()
        self._steps = ItemLimit(_MOST_STEPS)
        parsed = parse_arguments([pattern(w) for w in configuration.own])
        self._arguments = tuple(configuration.own[i] for i in parsed.positions.user)

    def run(self) -> EffectLog:
        """The effects of all nodes."""
        scope = TemplateScope(DeclaredParameters({}, ()), self._arguments, {}, Const("/"), lambda name, _: name)
        main: TemplateScope | None = None
        for shape in self._program.nodes:
            for bound, certain in expansions(shape.group, main or scope, self._distro, self._steps):
                if self._is_taken(shape, bound, certain=certain):
                    continue
                inner, address = self._node(shape, bound, first=main is None, certain=certain)
                for pass_ in _Pass:
                    self._contents(shape.group, inner, address, (self._program.package,), pass_, certain=certain)
                if main is None:
                    main = inner
                    self._read(inner, address, certain=certain)
        if self._program.open:
            self._open(self._program.open)
        if not self._program.nodes and self._program.reader:
            self._read(scope, None, certain=False)
        if self._steps.left < 0:
            self._limit(f"requests more than {_MOST_STEPS} groups and items")
        self._log.flows = process_flows(
            self._log, self._flows, self._program, self._declarations.interface, self._place
        )
        self._log.ends.append(frozenset(self._done))
        return self._log

    def _is_taken(self, shape: NodeShape, scope: TemplateScope, *, certain: bool) -> bool:
        """Whether somebody else says what a node does, whichever class it may be of."""
        if shape.plugin is None:
            return False
        words = tuple(expand(a, scope) for a in shape.arguments)
        several = options(expand(shape.plugin, scope))
        sure = certain and len(several) == 1
        taken = [isinstance(c, Const) and self._take(PluginNode(str(c.value), words, sure)) for c in several]
        return all(taken)

    def _node(self, shape: NodeShape, scope: TemplateScope, *, first: bool, certain: bool) -> tuple[TemplateScope, int]:
        address = len(self._log.nodes) + 1
        given = self._configuration
        loaded = (
            first and given.component is not None
        )  # a container makes it with options of its own, without global arguments
        options_: list[tuple[str, Value]] = [(k, Const(v)) for k, v in shape.options]
        options_.append(("client_library", Const(shape.client_library.value)))
        if shape.lifecycle:
            options_.append(("lifecycle", Const(True)))
        effect = NodeEffect(
            address,
            expand(shape.name, scope),
            NONE if shape.namespace is None else expand(shape.namespace, scope),
            tuple(options_),
            Series(
                (*(expand(a, scope) for a in shape.arguments), *(given.component if loaded and given.component else ()))
            ),
            Series(given.words if shape.global_arguments and not loaded else ()),
            External(f"{shape.client_library.value}.node.Node"),
            self._place,
            False,
        )
        self._log.nodes[effect] = None
        if certain:
            self._done.add(("node", address))
        return self._scope(effect, scope, first=first), address

    def _scope(self, effect: NodeEffect, outer: TemplateScope, *, first: bool) -> TemplateScope:
        """What templates of a node see: its parameters and its names."""
        own, space = final_name(self._log, effect)
        name, namespace = pattern(own), pattern(space)
        given: dict[str, Value] = {}
        missing: tuple[Reason, ...] = ()
        for words in (effect.global_words, effect.words):
            line = read_words(words, self._configuration)
            given |= given_to(names.fully_qualified(namespace, name), line.parameters)
            missing += line.missing
        parameters = DeclaredParameters(given, missing)
        rules = tuple(r.rule for r in remaps_of(self._log, effect))

        def resolve(topic: Value, remapped: bool) -> Value:
            return _resolved(topic, rules if remapped else (), name, namespace)

        variables = {**outer.variables, "node": lift2(full_name, space, own), "node_name": own}
        scope = TemplateScope(
            parameters,
            self._arguments,
            variables,
            space if first else outer.namespace,
            resolve,
            None if first else outer.outer or outer.parameters,
        )
        self._declare(_SIM_TIME, effect.address, scope, _Pass.ENDPOINTS)
        return scope

    def _contents(
        self,
        group: EndpointGroup,
        scope: TemplateScope,
        address: int,
        way: tuple[str, ...],
        pass_: _Pass,
        *,
        certain: bool,
    ) -> None:
        """What stands in a group, whose conditions hold (or, where it is not `certain`, may hold).

        `way`: the packages of the groups around it, its own last.
        """
        for parameter in group.parameters:
            if parameter.window.has(self._distro):
                self._declare(parameter, address, scope, pass_)
        if pass_ is _Pass.ENDPOINTS:
            for endpoint in group.endpoints:
                self._endpoint(endpoint, scope, address, certain=certain)
            for flow in group.flows:
                self._flow(flow, scope, address)
            if group.open is not None:
                self._open(group.open, address, scope)
        here = way[-1]
        inner = [(g, scope, certain, here) for g in group.groups]
        for include in group.includes:
            package, _, name = include.name.rpartition("/")
            found = self._declarations.interface(package or here, name)
            if found is None or len(way) > _DEEPEST_INCLUDE:
                self._log.findings.add(
                    Finding("RW324", f"The included interface {include.name} is not declared.", include.place)
                )
                continue
            bound = scope
            for variable, template in include.variables:
                bound = bound.bound(variable, expand(template, scope))
            inner.append((found, bound, certain, package or here))
        inner += [(g, scope, certain and sure, here) for g, sure in self._cases(group, scope)]
        for each, outer, sure, home in inner:
            for bound, holds in expansions(each, outer, self._distro, self._steps):
                self._contents(each, bound, address, (*way, home), pass_, certain=sure and holds)

    @staticmethod
    def _cases(group: EndpointGroup, scope: TemplateScope) -> list[tuple[EndpointGroup, bool]]:
        if group.switch is None:
            return []
        table = dict(group.cases)
        found: list[EndpointGroup] = []
        several = options(expand(group.switch, scope))
        for option in several:
            if isinstance(option, Const):
                chosen = table.get(str(option.value), group.otherwise)
                found += [chosen] if chosen is not None else []
            else:
                found += [*table.values(), *([group.otherwise] if group.otherwise is not None else [])]
        return [(g, len(several) == 1 and len(found) == 1) for g in dict.fromkeys(found)]

    def _declare(self, parameter: DeclaredParameter, address: int, scope: TemplateScope, pass_: _Pass) -> None:
        for name in options(expand(parameter.name, scope)):
            if not isinstance(name, Const):
                continue
            text = str(name.value)
            scope.parameters.declare(parameter, text)
            if pass_ is _Pass.DEFAULTS:
                continue
            default = NONE if parameter.default is None else as_value(parameter.default, text)
            value = scope.parameters.value(text)
            self._log.parameters[ParameterEffect(address, Const(text), default, value, NONE, self._place)] = None

    def _endpoint(self, endpoint: EndpointTemplate, scope: TemplateScope, address: int, *, certain: bool) -> None:
        if not endpoint.window.has(self._distro):
            return
        as_group = EndpointGroup(when=endpoint.when)
        for bound, holds in expansions(as_group, scope, self._distro, self._steps):
            self._add(
                FoundEndpoint(
                    endpoint.kind,
                    expand(endpoint.name, bound),
                    expand(endpoint.type, bound),
                    endpoint.qos,
                    certain and holds,
                ),
                address,
            )

    def _flow(self, flow: FlowTemplate, scope: TemplateScope, address: int) -> None:
        if not flow.window.has(self._distro):
            return
        for bound, _ in expansions(EndpointGroup(when=flow.when), scope, self._distro, self._steps):
            sources = tuple(
                (strength, FoundEnd(end, expand(end.name, bound)))
                for strength, end in flow.sources
                if self._steps.take()
            )
            self._flows.append(FoundFlow(address, FoundEnd(flow.to, expand(flow.to.name, bound)), sources))

    def _read(self, scope: TemplateScope, address: int | None, *, certain: bool) -> None:
        """What the program's reader finds in its arguments and files."""
        if self._program.reader is None:
            return
        reader = READERS.get(self._program.reader)
        if reader is None:
            message = f"Unknown reader {self._program.reader}; available: {', '.join(READERS)}."
            self._log.findings.add(Finding("RW324", message, self._program.place))
            return
        for found in reader(scope, FilesRead(self._read_file, self._declarations.documents)):
            if isinstance(found, Open):
                self._open(found.reason)
            elif address is not None:
                self._add(found._replace(certain=certain and found.certain), address)

    def _add(self, found: FoundEndpoint, address: int) -> None:
        if len(self._log.entities) >= _MOST_ENDPOINTS:
            self._limit(f"has more than {_MOST_ENDPOINTS} endpoints")
            return
        type_ = lift(lambda t: type_value(t, found.kind), found.type)
        effect = EntityEffect(
            found.kind, address, found.name, type_, None, found.qos, True, False, self._place, self._via
        )
        self._log.entities[effect] = None
        if found.certain:
            self._done.add(EffectLog.key(effect))

    def _limit(self, what: str) -> None:
        message = f"The declared interface of {self._program.package}/{self._program.name} {what} here."
        self._log.findings.add(Finding("RW201", message, self._place))

    def _open(self, reason: str, address: int | None = None, scope: TemplateScope | None = None) -> None:
        """The interface has more: that of one node, or of all that the program makes."""
        what = f"interface of {self._program.package}/{self._program.name}"
        told = reason if scope is None else readable(expand(reason, scope))
        finding = Finding("RW314", f"The {what} is not completely known: {told}.", self._place, (what,))
        if address is None:
            self._log.findings.add(finding)
        else:
            self._log.open.setdefault(address, Findings()).add(finding)


def _resolved(topic: Value, rules: Sequence[names.RemapRule], name: Holed, namespace: Holed) -> Value:
    """The full name of a topic behind the remap rules of its node; as it is where that is not known."""
    if not isinstance(topic, Const) or not isinstance(topic.value, str) or HOLE in name + namespace:
        return topic
    try:
        resolved = names.resolve(pattern(topic), names.RemapKind.TOPIC, rules, name, namespace)
    except names.InvalidName:
        return topic
    return Const(resolved[0], topic.origins) if len(resolved) == 1 and HOLE not in resolved[0] else topic
