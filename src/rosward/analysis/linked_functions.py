# SPDX-License-Identifier: Apache-2.0
"""Which functions of a program in C++ would create an entity? Plain records, which can be kept."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.symbol_file import stands_for
from rosward.ir.cpp import InvokeMember, MakeLambda, Name
from rosward.ir.op import Op, walk
from rosward.ir.program import Code
from rosward.location import Place
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.frontends.cpp.symbol import CppSymbol
    from rosward.frontends.cpp.symbol_file import FileSymbols
    from rosward.frontends.cpp.symbols import CppSymbols

__all__ = ["CREATORS", "NODES", "LinkedCreation", "LinkedFunction", "creating_functions"]


CREATORS: Final = frozenset(
    {
        *("TransformBroadcaster", "StaticTransformBroadcaster", "TransformListener", "Subscriber", "create_server"),
        *("ImageTransport", "SubscriberFilter", "create_camera_publisher", "create_camera_subscription"),
        *(
            "AsyncParametersClient",
            "SyncParametersClient",
            "ParameterEventHandler",
            "InteractiveMarkerServer",
            "Updater",
        ),
        *("CameraInfoManager", "ServiceClient", "SimpleActionServer", "OdomSmoother", "Bond"),
    }
)
_LIBRARIES: Final = frozenset(
    {
        *("tf2_ros", "message_filters", "rclcpp", "rclcpp_action", "image_transport", "interactive_markers"),
        *("diagnostic_updater", "camera_info_manager", "nav2_util", "bond"),
    }
)
"""Classes and functions that create entities on a node that they are given, and the name spaces in which they are."""
NODES: Final = r"Node\s*::\s*make_shared|make_(?:shared|unique)\s*<\s*(?:\w+\s*::\s*)*(?:Lifecycle)?Node\s*>"
"""How the text of a source looks that makes a node."""
_NODES: Final = frozenset({"Node", "LifecycleNode"})
_OF_NODES: Final = frozenset({"rclcpp", "rclcpp_lifecycle"})


class LinkedCreation(NamedTuple):
    """A call of what creates an entity: its operation, by the key of the body and its number there; what is called, and where.

    `made`: it is a class, or a function of a library, that does so; whether that is reached is not known.
    """

    body: str
    number: int
    name: str
    place: Place
    made: bool = False


class LinkedFunction(NamedTuple):
    """A function with such calls. `key` is that of its body; `plugin`: it is of a class that is registered as a plugin."""

    key: str
    shown: str
    plugin: bool
    creations: tuple[LinkedCreation, ...]


def creating_functions(program: CppSymbols, file: FileSymbols, creating: frozenset[str]) -> tuple[LinkedFunction, ...]:
    """Those of one of the files of a program."""
    wanted = re.compile(
        rb"\b(?:" + "|".join(map(re.escape, sorted(creating | CREATORS))).encode() + rb")\b|" + NODES.encode()
    )
    plugins = {
        "::".join(filter(None, (*s.scope, s.name)))
        for name in program.registered  # by this file, or by a header
        for s in program.registered_class(name)
    }
    found: list[LinkedFunction] = []
    for symbol in file.functions(wanted):
        whole = next((s for s in program.at(symbol.scope, symbol.name) if s.key == symbol.key), symbol)
        if whole.code is not None:
            found.append(_function(program, whole, whole.code, plugins, creating))
    return tuple(found)


def _function(
    program: CppSymbols, symbol: CppSymbol, code: Code, plugins: set[str], creating: frozenset[str]
) -> LinkedFunction:
    shown = "::".join((*filter(None, symbol.scope), symbol.name))
    plugin = "::".join(filter(None, symbol.scope)) in plugins
    creations: dict[object, LinkedCreation] = {}
    for body, name, op in _creations(program, symbol, code, creating):
        made = name not in creating  # a type may be named twice where one object of it is made
        key = (op.line, name) if made else (body.key, op.number)
        place = Place(body.file, op.line, op.column)
        creations.setdefault(key, LinkedCreation(body.key, op.number, name, place, made))
    return LinkedFunction(code.key, shown, plugin, tuple(creations.values()))


def _creations(
    program: CppSymbols, symbol: CppSymbol, code: Code, creating: frozenset[str]
) -> Iterator[tuple[Code, str, Op]]:
    """The calls of what creates an entity, in a body and in the lambdas in it."""
    waiting = [code]
    while waiting:
        body = waiting.pop()
        types: dict[int, tuple[str, ...]] = {}  # the nodes of rclcpp that are named as a type, by register
        for op in walk(body.ops):
            if isinstance(op, MakeLambda):
                waiting.append(op.code)
            elif isinstance(op, InvokeMember) and op.name in creating:
                yield body, op.name, op
            elif isinstance(op, Name) and (op.parts[-1].name in creating or _is_creator(op)):
                yield body, op.parts[-1].name, op
            elif isinstance(op, Name) and (path := _node_made(op, types)) and _is_node(program, symbol, path):
                yield body, path[-1], op


def _node_made(op: Name, types: dict[int, tuple[str, ...]]) -> tuple[str, ...]:
    """The name of the node that a name makes where it is called: `rclcpp::Node::make_shared`, `std::make_shared<rclcpp::Node>`."""
    names = tuple([part.name for part in op.parts])
    if names[-1] in _NODES:
        types[op.dst] = names
    if names[-1] not in ("make_shared", "make_unique"):
        return ()
    if names[-2:-1] and names[-2] in _NODES:
        return names[:-1]
    return next((types[a] for a in op.parts[-1].arguments or () if a in types), ())


def _is_node(program: CppSymbols, symbol: CppSymbol, path: tuple[str, ...]) -> bool:
    """Whether a name in a function is that of a node of rclcpp, not of a class of that name (`graph::Node`)."""
    spaces: set[str] = set()
    for length in range(len(symbol.scope), -1, -1):
        around = symbol.scope[:length]
        declared = [s for scope in (around, (*around, "")) for s in program.at(scope, path[0])]
        if declared:
            return any(stands_for(s)[:1] and stands_for(s)[0] in _OF_NODES for s in declared)
        spaces.update(used.target[0] for used in program.used(around) if used.target)
    if len(path) > 1:
        return path[0] in _OF_NODES
    return not spaces - {"std"} or not spaces.isdisjoint(_OF_NODES)  # where nothing tells, a base may be one


def _is_creator(op: Name) -> bool:
    """Whether it names what creates entities, of a library that is known for it."""
    names = [part.name for part in op.parts]
    return names[-1] in CREATORS and len(names) > 1 and names[-2] in _LIBRARIES
