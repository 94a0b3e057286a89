# SPDX-License-Identifier: Apache-2.0
"""The actions that start something: nodes, containers, components, processes.

ComposableNodeContainer(name='c', namespace='', …, composable_node_descriptions=[ComposableNode(package='demo', plugin='demo::Talker')])
->  StartNode(kind=CONTAINER, …, components=(Component(package=(Const('demo'),), …),))
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final, final

from rosward.deployment.python.objects import Objects
from rosward.deployment.python.parameters import ParameterReader
from rosward.deployment.python.substitutions import Texts
from rosward.deployment.tree import (
    Component,
    Condition,
    LaunchAction,
    LoadComponents,
    NodeKind,
    OnEvent,
    StartNode,
    StartProcess,
    Template,
)
from rosward.domain.choice import options
from rosward.domain.values import NONE, Ref, Unknown, Value
from rosward.location import Place
from rosward.records import NamedTuple

_KINDS: Final = {
    "launch_ros.actions.LifecycleNode": NodeKind.LIFECYCLE,
    "launch_ros.actions.ComposableNodeContainer": NodeKind.CONTAINER,
}
_NODE: Final = "launch_ros.actions.Node"
_COMPONENT: Final = "launch_ros.descriptions.ComposableNode"

Entities = Callable[[Value | None, Place], tuple[LaunchAction, ...]]


class _Variables(NamedTuple):
    """The environment of a process, and whether it is the whole of it."""

    pairs: tuple[tuple[Template, Template], ...]
    whole: bool


@final
class Nodes:
    """Reads what is started. `entities` reads a list of actions."""

    def __init__(self, objects: Objects, texts: Texts, parameters: ParameterReader, entities: Entities) -> None:
        self.objects = objects
        self.texts = texts
        self.parameters = parameters
        self.entities = entities

    def node(self, ref: Ref, given: dict[str, Any]) -> StartNode:
        """Node, LifecycleNode, ComposableNodeContainer."""
        place: Place = given["place"]
        field, texts = self.objects.field, self.texts
        environment = self._environment(ref, place)
        return StartNode(
            kind=next((_KINDS[k] for k in self.objects.kinds(ref) if k in _KINDS), NodeKind.NODE),
            package=texts.optional(field(ref, "package"), place),
            executable=texts.template(field(ref, "executable"), place),
            name=texts.optional(field(ref, "name"), place),
            namespace=texts.optional(field(ref, "namespace"), place),
            remappings=texts.rules(field(ref, "remappings"), place),
            parameters=self.parameters.sources(field(ref, "parameters"), place),
            arguments=texts.words(field(ref, "arguments"), place),
            ros_arguments=texts.words(field(ref, "ros_arguments"), place),
            exec_name=texts.optional(field(ref, "process_name"), place),
            prefix=texts.optional(field(ref, "prefix"), place),
            environment=environment.pairs,
            replaces_environment=environment.whole,
            components=self.components(field(ref, "composable_node_descriptions"), place),
            on_exit=self._on_exit(ref, place),
            **given,
        )

    def load(self, ref: Ref, given: dict[str, Any]) -> LoadComponents:
        """LoadComposableNodes."""
        place: Place = given["place"]
        target = self.objects.field(ref, "target")
        container: Template | StartNode
        if isinstance(target, Ref) and self.objects.is_a(target, _NODE):
            made = self.objects.place(target)
            condition = self.texts.condition(self.objects.field(target, "condition"), made)
            container = self.node(target, {"place": made, "condition": condition, "identity": target})
        else:
            container = self.texts.template(target, place)
        found = self.components(self.objects.field(ref, "composable_node_descriptions"), place)
        return LoadComponents(target=container, components=found, **given)

    def components(self, value: Value | None, place: Place) -> tuple[Component, ...]:
        """A list of ComposableNode. One that may be absent has a condition that is not known."""
        found: list[Component] = []
        for element in self.objects.elements(value or NONE):
            alternatives = options(element.value)
            for option in alternatives:
                if isinstance(option, Ref) and self.objects.is_a(option, _COMPONENT):
                    found.append(self._component(option, place, element.sure and len(alternatives) == 1))
                elif isinstance(option, Unknown):
                    found.append(Component(package=(option,), plugin=(option,), place=place))
                elif option != NONE:
                    self.objects.tell("RW320", "launch_ros requires a ComposableNode here", place)
        return tuple(found)

    def _component(self, ref: Ref, place: Place, sure: bool) -> Component:
        made = self.objects.place(ref)
        here = made if made.file else place
        field, texts = self.objects.field, self.texts
        condition = texts.condition(field(ref, "condition"), here)
        if not sure:
            condition = Condition("python", (), here, self.objects.unknown("unknown condition in Python", here, "bool"))
        return Component(
            package=texts.template(field(ref, "package"), here),
            plugin=texts.template(field(ref, "plugin"), here),
            name=texts.optional(field(ref, "name"), here),
            namespace=texts.optional(field(ref, "namespace"), here),
            remappings=texts.rules(field(ref, "remappings"), here),
            parameters=self.parameters.sources(field(ref, "parameters"), here),
            extra_arguments=self.parameters.sources(field(ref, "extra_arguments"), here),
            place=here,
            condition=condition,
        )

    def process(self, ref: Ref, given: dict[str, Any]) -> StartProcess:
        """ExecuteProcess, and ExecuteLocal with an Executable."""
        place: Place = given["place"]
        described = self.objects.field(ref, "process_description")
        source = described if isinstance(described, Ref) else ref
        command = self.texts.words(self.objects.field(source, "cmd"), place)
        arguments = self.texts.words(self.objects.field(source, "arguments"), place)
        environment = self._environment(source, place)
        return StartProcess(
            command=(*command, *arguments),
            shell=self.objects.flag(ref, "shell", False),
            environment=environment.pairs,
            replaces_environment=environment.whole,
            on_exit=self._on_exit(ref, place),
            **given,
        )

    def _environment(self, ref: Ref, place: Place) -> _Variables:
        whole = self.objects.field(ref, "env")
        more = self.texts.pairs(self.objects.field(ref, "additional_env"), place)
        return _Variables((*self.texts.pairs(whole, place), *more), whole is not None)

    def _on_exit(self, ref: Ref, place: Place) -> tuple[LaunchAction, ...]:
        value = self.objects.field(ref, "on_exit")
        if value is not None and self.objects.is_callable(value):
            return (OnEvent(place=place, event="process-exit", function=value, target=ref),)
        return self.entities(value, place)
