# SPDX-License-Identifier: Apache-2.0
"""What in a text looks like the endpoints of a node? C++ and Python are searched for calls; nothing is analysed.

    pub_ = create_publisher<sensor_msgs::msg::LaserScan>("scan", 10);   ->  publishers scan sensor_msgs/msg/LaserScan
    pub_ = create_publisher<LaserScan>(topic_, 10);                     ->  a remark: its name is no literal

Such a text does not say what runs, nor which of its branches; so what is found is a draft that a person has to verify.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Final

from rosward.declaring.sketch import SeenEndpoint, Sketch, is_usable
from rosward.records import NamedTuple
from rosward.ros.entities import Qos

__all__ = ["sketch_of_source"]

_CPP_CALL: Final = re.compile(
    r"(?P<action>rclcpp_action::)?\bcreate_(?P<what>publisher|subscription|service|client|server)\s*<\s*(?P<type>[\w:]+)[^<>()]{0,200}>\s*\((?=(?P<rest>[^;{]{0,300}))"
)
_PY_CALL: Final = re.compile(
    r"\b(?:create_(?P<what>publisher|subscription|service|client)\s*\(|Action(?P<action>Server|Client)\s*\(\s*[\w.]+\s*,)"
    r"\s*(?P<type>[\w.]+)\s*,(?=(?P<rest>[^\n]{0,200}(?:\n[^\n]{0,200})?))"
)
_CPP_COMMENT: Final = re.compile(r'("(?:\\.|[^"\\\n])*")|//[^\n]*|/\*.*?\*/', re.DOTALL)
_PY_COMMENT: Final = re.compile(r"""("(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*')|#[^\n]*""")
_CPP_NODE: Final = re.compile(r'\b(?:Lifecycle)?Node\s*(?:>\s*)?(?:\s\w+\s*)?[({]\s*"([A-Za-z_]\w*)"')
_PY_NODE: Final = re.compile(r"""(?:super\([^()]*\)\.__init__|\bcreate_node|\bNode)\(\s*['"]([A-Za-z_]\w*)['"]""")
_PARAMETER: Final = re.compile(
    r"""\bdeclare_parameter\s*(?:<\s*([\w:]+)\s*>)?\s*\(\s*["']([A-Za-z_][\w.]*)["']\s*(?:,\s*([^,;()]{1,80}))?"""
)
_ALIAS: Final = re.compile(r"\busing\s+(\w+)\s*=\s*([\w:]+)\s*;")
_INCLUDE: Final = re.compile(r'#include\s*[<"](\w+)/(msg|srv|action)/(\w+)\.h(?:pp)?[>"]')
_IMPORT: Final = re.compile(r"^\s*from\s+(\w+)\.(msg|srv|action)\s+import\s+([^\n#(]+|\([^)]*\))", re.MULTILINE)
_LITERAL: Final = re.compile(r"""(?P<mark>["'])(?P<text>(?:\\.|(?!(?P=mark))[^\\\n])*)(?P=mark)""")
_LISTS: Final = {
    "publisher": "publishers",
    "subscription": "subscriptions",
    "service": "service_servers",
    "client": "service_clients",
    "server": "action_servers",
}
_PARTS: Final = {"publishers": "msg", "subscriptions": "msg"}
_HELPERS: Final = (
    "image_transport",
    "TransformListener",
    "TransformBroadcaster",
    "diagnostic_updater",
    "message_filters",
    "InteractiveMarkerServer",
)
_MOST: Final = 500


class _Call(NamedTuple):
    """A call that may create an endpoint: which list, the name of the type as it stands, what comes behind, the line."""

    kind: str
    type: str
    rest: str
    line: int


def sketch_of_source(texts: Mapping[str, str]) -> Sketch:
    """What the texts look like together, each by the name of its file."""
    entities: list[SeenEndpoint] = []
    told: list[str] = []
    parameters: dict[str, str] = {}
    node: str | None = None
    python = bool(texts) and all(file.endswith(".py") for file in texts)
    for file, raw in texts.items():
        in_python = file.endswith(".py")
        text = (_PY_COMMENT if in_python else _CPP_COMMENT).sub(_without_comment, raw)
        types = _python_types(text) if in_python else _cpp_types(text)
        for call in _calls(text, in_python=in_python):
            seen = _endpoint(call, types, f"{file}:{call.line}")
            if isinstance(seen, SeenEndpoint):
                entities.append(seen)
            else:
                told.append(seen)
        found = (_PY_NODE if in_python else _CPP_NODE).search(text)
        node = node or (found[1] if found else None)
        parameters |= {m[2]: _parameter_type(m[1], m[3]) for m in _PARAMETER.finditer(text)}
        told += [f"{file} mentions {each}, which creates endpoints of its own" for each in _HELPERS if each in text]
    return Sketch(
        node=node,
        lifecycle=any("LifecycleNode" in text for text in texts.values()),
        client_library="rclpy" if python else "rclcpp",
        entities=tuple(entities[:_MOST]),
        parameters=tuple((name, type_) for name, type_ in list(parameters.items())[:_MOST]),
        told=tuple(told[:_MOST]),
        open=f"found by a text search of {_few(texts)}, not verified",
    )


def _few(files: Mapping[str, str]) -> str:
    return next(iter(files)) if len(files) == 1 else f"{len(files)} files"


def _without_comment(found: re.Match[str]) -> str:
    """A literal stays; of a comment its lines do, so that places are right."""
    return found[1] or "\n" * found[0].count("\n")


def _calls(text: str, *, in_python: bool) -> Iterator[_Call]:
    for found in (_PY_CALL if in_python else _CPP_CALL).finditer(text):
        line = text.count("\n", 0, found.start()) + 1
        if in_python:
            kind = _LISTS[found["what"]] if found["what"] else f"action_{found['action'].lower()}s"
        else:
            action = found["action"] or found["what"] == "server" or "::action::" in found["type"]
            kind = f"action_{found['what']}s" if action else _LISTS[found["what"]]
        yield _Call(kind, found["type"], found["rest"], line)


def _endpoint(call: _Call, types: Mapping[str, str], at: str) -> SeenEndpoint | str:
    """The endpoint, or why it is none."""
    part = _PARTS.get(call.kind, "action" if call.kind.startswith("action") else "srv")
    written = call.type.replace("::", ".").strip(".").split(".")
    type_ = "/".join(written[-3:]) if len(written) >= 3 and written[-2] == part else types.get(call.type, "")
    what = f"{at}: {call.kind} of {call.type}"
    if not type_:
        return f"{what}: its package is unknown"
    first = call.rest.split(",")
    where = (
        first[1]
        if call.kind.startswith("action") and len(first) > 1 and '"' not in first[0] and "'" not in first[0]
        else first[0]
    )
    name = _LITERAL.fullmatch(where.strip().rstrip(")").strip())
    if name is None:
        return f"{what}: its name is not a literal ({where.strip()[:60]})"
    seen = SeenEndpoint(call.kind, name["text"], type_, _qos(call.rest) if part == "msg" else None, at)
    return (
        seen
        if is_usable(seen)
        else f"{what}: {name['text'][:60]!r} is not a valid name, or {type_} is not a type of this kind"
    )


def _cpp_types(text: str) -> dict[str, str]:
    """Short names of interface types: those of includes, and of `using`."""
    types = {"".join(word.title() for word in m[3].split("_")): f"{m[1]}/{m[2]}/" for m in _INCLUDE.finditer(text)}
    types = {short: f"{prefix}{short}" for short, prefix in types.items()}
    for m in _ALIAS.finditer(text):
        parts = m[2].strip(":").split("::")
        if len(parts) == 3 and parts[1] in ("msg", "srv", "action"):
            types[m[1]] = "/".join(parts)
    return types


def _python_types(text: str) -> dict[str, str]:
    types: dict[str, str] = {}
    for m in _IMPORT.finditer(text):
        for each in m[3].strip("()").replace("\n", " ").split(","):
            name, _, alias = each.strip().partition(" as ")
            types[(alias or name).strip()] = f"{m[1]}/{m[2]}/{name.strip()}"
    return types


def _qos(rest: str) -> Qos | None:
    if "SensorDataQoS" in rest or "qos_profile_sensor_data" in rest:
        return Qos("best_effort", "volatile", "keep_last", 5)
    depth = re.search(r",\s*(?:rclcpp::QoS\s*[({]\s*(?:rclcpp::KeepLast\s*[({]\s*)?)?(\d{1,6})\b", rest)
    if depth is None:
        return None
    reliability = "best_effort" if "best_effort()" in rest else "reliable"
    return Qos(
        reliability, "transient_local" if "transient_local()" in rest else "volatile", "keep_last", int(depth[1])
    )


def _parameter_type(template: str | None, default: str | None) -> str:
    text = (template or default or "").strip().strip("{}")
    for type_, pattern in (
        ("bool", r"bool|true|false|True|False"),
        ("double", r"double|float|-?\d*\.\d*(?:[eE][+-]?\d+)?f?"),
        ("int", r"(?:u?int(?:\d+_t)?)|-?\d+"),
        ("string", r"""std::string|string|["'].*"""),
    ):
        if re.fullmatch(pattern, text):
            return type_
    return ""
