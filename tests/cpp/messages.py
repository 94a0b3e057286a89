# SPDX-License-Identifier: Apache-2.0
"""Which C++ header has an interface? Those that a program includes are written from the definitions that rosward has.

std_msgs/msg/string.hpp    ->  namespace std_msgs::msg { struct String { std::string data; … }; }
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import cached_property
from pathlib import Path
from typing import Final

from rosward.source.definitions import PARTS, Constant, Definition, Field
from rosward.source.interfaces import InterfaceIndex

_INCLUDE: Final = re.compile(r'^\s*#\s*include\s*[<"]([\w/]+)/(msg|srv|action)/(\w+)\.hpp[>"]', re.MULTILINE)
_TYPES: Final = {
    "bool": "bool",
    "byte": "unsigned char",
    "char": "unsigned char",
    "float32": "float",
    "float64": "double",
    "string": "std::string",
    "wstring": "std::u16string",
    **{f"{sign}int{size}": f"{sign}int{size}_t" for sign in ("", "u") for size in (8, 16, 32, 64)},
}

_LIKE: Final = {("test_msgs", "action", "Fibonacci"): "example_interfaces"}
"""Interfaces of which rosward knows no fields, and the package with one that has the same."""

_OF_ACTIONS: Final = [("action_msgs", "msg", "goal_status_array"), ("action_msgs", "srv", "cancel_goal")]
"""The headers that the header of every action includes; both know what a time and a UUID is."""


def header_name(name: str) -> str:
    """`LaserScan` -> `laser_scan`, as rosidl names the file."""
    step = re.sub(r"(.)([A-Z][a-z]+)", r"\1_\2", name)
    return re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", step).lower()


class Headers:
    """Writes headers of interfaces into a folder, each once."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._index = InterfaceIndex()
        self._written: set[str] = set()

    def write_for(self, source: str) -> None:
        """Write what a source includes, and what that includes."""
        for package, kind, file in _INCLUDE.findall(source):
            self._write(package, kind, file)

    def _write(self, package: str, kind: str, file: str) -> None:
        path = f"{package}/{kind}/{file}.hpp"
        if path in self._written:
            return
        self._written.add(path)
        names = self._index.names(package, kind) or frozenset()
        name = next((each for each in sorted(names) if header_name(each) == file), None)
        target = self._folder / path
        if name is None or target.exists():
            return
        header = _Header(self._index, package, kind, name)
        for needed in header.needed:
            self._write(*needed)
        target.parent.mkdir(parents=True, exist_ok=True)
        beside = target.with_suffix(f".{id(self)}")
        beside.write_text(header.text, encoding="utf-8")
        beside.replace(target)  # whole at once: others may be reading


class _Header:
    def __init__(self, index: InterfaceIndex, package: str, kind: str, name: str) -> None:
        self._package, self._kind, self._name = package, kind, name
        known = _LIKE.get((package, kind, name), package)
        self._parts = {part: index.definition(known, kind, name, part) for part in PARTS[kind]}

    @cached_property
    def needed(self) -> list[tuple[str, str, str]]:
        """The headers that this one includes: package, kind, file."""
        types = [
            f.type for part in self._parts.values() if part is not None for f in part.fields.values() if f.is_message
        ]
        own = {(t.partition("/")[0], "msg", header_name(t.rpartition("/")[2])) for t in types}
        return sorted(own.union(_OF_ACTIONS if self._kind == "action" else ()))

    @property
    def text(self) -> str:
        return "\n".join(self._lines()) + "\n"

    def _lines(self) -> Iterator[str]:
        yield "#pragma once"
        yield '#include "rosward_double/messages.hpp"'
        for package, kind, file in self.needed:
            yield f'#include "{package}/{kind}/{file}.hpp"'
        space = f"{self._package}::{self._kind}"
        yield f"namespace {space} {{"
        for part, definition in self._parts.items():
            yield from _struct(f"{self._name}_{part}" if part else self._name, definition)
        built = [self._name, *(f"{self._name}_{part}" for part in self._parts if part)]
        if self._kind == "action":
            parts = _parts_of_action(self._name)
            for name, fields in parts.items():
                yield from _plain_struct(name, fields)
            built += parts
        if self._kind != "msg":
            own = [f"using {part} = {self._name}_{part};" for part in self._parts]
            yield from _plain_struct(self._name, [*own, *(_action(self._name) if self._kind == "action" else ())])
        yield "}"
        for each in built:
            yield f'ROSWARD_DOUBLE_TYPE({space}::{each}, "{self._package}/{self._kind}/{each}")'


def _parts_of_action(name: str) -> dict[str, list[str]]:
    """What rosidl makes of an action, besides its goal, result and feedback: members by struct (rosidl_parser, definition.py)."""
    goal_id = "unique_identifier_msgs::msg::UUID goal_id;"
    made = {
        "SendGoal_Request": [goal_id, f"{name}_Goal goal;"],
        "SendGoal_Response": ["bool accepted{};", "builtin_interfaces::msg::Time stamp;"],
        "GetResult_Request": [goal_id],
        "GetResult_Response": ["int8_t status{};", f"{name}_Result result;"],
        "FeedbackMessage": [goal_id, f"{name}_Feedback feedback;"],
        **{
            service: [f"using {part} = {name}_{service}_{part};" for part in PARTS["srv"]]
            for service in ("SendGoal", "GetResult")
        },
    }
    return {f"{name}_{part}": members for part, members in made.items()}


def _action(name: str) -> list[str]:
    own = {"SendGoalService": "SendGoal", "GetResultService": "GetResult", "FeedbackMessage": "FeedbackMessage"}
    return [
        "struct Impl {",
        *(f"  using {member} = {name}_{part};" for member, part in own.items()),
        "  using CancelGoalService = action_msgs::srv::CancelGoal;",
        "  using GoalStatusMessage = action_msgs::msg::GoalStatusArray;",
        "};",
    ]


def _plain_struct(name: str, members: Iterable[str]) -> Iterator[str]:
    yield f"struct {name} {{"
    yield f"  ROSWARD_DOUBLE_POINTERS({name})"
    yield from (f"  {member}" for member in members)
    yield "};"


def _struct(name: str, definition: Definition | None) -> Iterator[str]:
    yield f"struct {name} {{"
    yield f"  ROSWARD_DOUBLE_POINTERS({name})"
    yield f"  using Type = {name};"
    yield f"  explicit {name}(rosidl_runtime_cpp::MessageInitialization = rosidl_runtime_cpp::MessageInitialization::ALL) {{}}"
    for field, kept in _fields(definition):
        if kept.type != "*":
            type_ = _type(kept)
            yield f"  using _{field}_type = {type_};"
            yield f"  {type_} {field}{{{'' if kept.default is None else _literal(kept.default)}}};"
    told = "".join(f' f("{field}", self.{field});' for field, kept in _fields(definition) if kept.type != "*")
    yield f"  template<typename S, typename F> static void rosward_double_fields(S & self, F && f) {{{told} }}"
    for constant, value in definition.constants.items() if definition is not None else ():
        if isinstance(value, str):
            yield f"  static inline const std::string {constant} = {_literal(value)};"
        elif value is not None:
            yield f"  static constexpr auto {constant} = {_literal(value)};"
    yield f"  bool operator==(const {name} &) const {{ return true; }}"
    yield f"  bool operator!=(const {name} &) const {{ return false; }}"
    yield "};"


def _fields(definition: Definition | None) -> list[tuple[str, Field]]:
    return list(definition.fields.items()) if definition is not None else []


def _type(field: Field) -> str:
    package, _, name = field.type.rpartition("/")
    plain = f"{package}::msg::{name}" if package else _TYPES[name]
    bound = field.array.strip("[]").removeprefix("<=")
    if not field.array:
        return plain
    if not bound:
        return f"std::vector<{plain}>"
    return (
        f"rosidl_runtime_cpp::BoundedVector<{plain}, {bound}>"
        if "<=" in field.array
        else f"std::array<{plain}, {bound}>"
    )


def _literal(value: Constant) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, bytes):
        return str(value[0])
    if isinstance(value, str):
        return '"' + "".join(c if c.isalnum() else f"\\{ord(c):03o}" for c in value) + '"'
    if isinstance(value, float):
        return repr(value)
    return f"{value}{'u' if value > 2**31 - 1 else ''}"
