# SPDX-License-Identifier: Apache-2.0
"""Which nodes does a tag of launch_ros start?

<node pkg="demo" exec="talker" args="--loud"><remap from="a" to="b"/></node>
->  StartNode(package=…, executable=…, arguments=((Const('--loud'),),), remappings=(((Const('a'),), (Const('b'),)),))
"""

from __future__ import annotations

from types import MappingProxyType
from typing import Final

from rosward.deployment.markup.element import Tag
from rosward.deployment.markup.tags_launch import Reader, command_words, process_attributes
from rosward.deployment.markup.tags_parameters import read_parameters
from rosward.deployment.tree import (
    Component,
    LaunchAction,
    LoadComponents,
    NodeKind,
    ParameterSource,
    ParameterTable,
    StartNode,
    Template,
    Typed,
)

_COMPONENTS: Final = ("composable_node", "composable_lifecycle_node")


def _node(element: Tag) -> LaunchAction:
    return _started(element, NodeKind.NODE, ())


def _lifecycle_node(element: Tag) -> LaunchAction:
    element.switch("autostart")
    node = _started(element, NodeKind.LIFECYCLE, ())
    if node.name is None or node.namespace is None:
        element.refuse("<lifecycle_node> needs both 'name' and 'namespace'.")
    return node


def _node_container(element: Tag) -> LaunchAction:
    node = _started(element, NodeKind.CONTAINER, _components(element))
    if node.name is None or node.namespace is None:
        element.refuse("<node_container> needs both 'name' and 'namespace'.")
    return node


def _started(element: Tag, kind: NodeKind, components: tuple[Component, ...]) -> StartNode:
    return StartNode(
        place=element.place,
        condition=element.condition(),
        kind=kind,
        package=element.template("pkg"),
        executable=element.required("exec"),
        name=element.template("name"),
        namespace=element.template("namespace"),
        remappings=element.pairs("remap", "from", "to"),
        parameters=read_parameters(element),
        arguments=_words(element, "args"),
        ros_arguments=_words(element, "ros_args"),
        exec_name=element.template("exec_name"),
        prefix=element.template("launch-prefix"),
        environment=element.pairs("env", "name", "value"),
        components=components,
        on_exit=process_attributes(element),
    )


def _words(element: Tag, name: str) -> tuple[Template, ...]:
    text = element.text(name)
    return () if text is None else command_words(element, text)


def _load(element: Tag) -> LaunchAction:
    components = _components(element)
    if not components:
        element.refuse(f"<{element.tag}> has no <composable_node>, which launch requires.")
    target = element.required("target")
    return LoadComponents(place=element.place, condition=element.condition(), target=target, components=components)


def _components(element: Tag) -> tuple[Component, ...]:
    return tuple([_component(each) for tag in _COMPONENTS for each in element.elements(tag)])


def _component(element: Tag) -> Component:
    if element.tag == "composable_lifecycle_node":
        element.switch("autostart")
    name = element.template("name")
    if name is None:
        element.refuse(f"<{element.tag}> has no attribute 'name', which launch requires.")
    component = Component(
        place=element.place,
        condition=element.condition(),
        package=element.required("pkg"),
        plugin=element.required("plugin"),
        name=name,
        namespace=element.template("namespace"),
        remappings=element.pairs("remap", "from", "to"),
        parameters=read_parameters(element),
        extra_arguments=_extra(element),
    )
    element.finish()
    return component


def _extra(element: Tag) -> tuple[ParameterSource, ...]:
    pairs = element.pairs("extra_arg", "name", "value")
    return tuple(ParameterTable(((name, Typed(value)),), element.place) for name, value in pairs)


READERS: Final = MappingProxyType[str, Reader](
    {
        "node": _node,
        "lifecycle_node": _lifecycle_node,
        "node_container": _node_container,
        "load_composable_node": _load,
    }
)
