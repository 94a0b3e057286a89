# SPDX-License-Identifier: Apache-2.0
"""From abstract values to the words of ROS: names with their resolution, and interface types.

Text('/robot_', hole, '/cmd')      NameOption('/robot_*/cmd', PATTERN, …)
External('std_msgs.msg.String')    'std_msgs/msg/String'
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Final

from rosward.domain.choice import options, reasons_of
from rosward.domain.compound import External
from rosward.domain.text import common, origins_of, pattern
from rosward.domain.unknown import INSTEAD, Cause, Origins, Reason
from rosward.domain.values import NONE, Class, Const, Text, Unknown, Value
from rosward.holes import HOLE, Holed
from rosward.location import Place
from rosward.records import NamedTuple
from rosward.ros.entities import Resolution
from rosward.source.definitions import PARTS

MAX_NODES: Final = 16
"""Nodes that one call may make, each in its place: more of one beginning are one with a hole in its name."""


class NameOption(NamedTuple):
    """One name that a value may be: its text with `*` for holes, how it was found, from what, and why not wholly."""

    text: Holed
    resolution: Resolution
    depends_on: tuple[str, ...]
    reasons: tuple[Reason, ...]


def together(value: Value) -> Value:
    """One pattern for many alternatives that begin alike, where each would be a node with all that belongs to it."""
    several = options(value)
    if len(several) <= MAX_NODES or not all(isinstance(o, Const) and isinstance(o.value, str) for o in several):
        return value
    pattern_of_all = common(several, (Reason(Cause.MANY, "", Place("", 0)),))
    return pattern_of_all if isinstance(pattern_of_all, Text) else value


def name_options(value: Value, *, filled: bool = False) -> list[NameOption]:
    """The names that a value may be; what is no text at all is an unknown name.

    `filled`: only those made of something, where there are any. A text that has not been written yet is no name: the call fails with it.
    An empty default of a parameter stays: there the call does fail. A namespace may well be empty.
    """
    several = options(value)
    if len(several) > 1:  # None among others is no name: the call fails there
        several = tuple(o for o in several if not (isinstance(o, Const) and o.value is None)) or several
    found = [_name(option) for option in several]
    others = [name for name in found if name.reasons and all(r.cause in INSTEAD for r in name.reasons)]
    known = [name for name in found if name not in others]
    if filled:
        known = _made_of_something(known) or others or known
    if not known or known == others:
        return others
    settable = {d for name in others for d in name.depends_on}
    return [_as_default(name, settable) for name in known]


def _made_of_something(names: list[NameOption]) -> list[NameOption]:
    return [name for name in names if name.depends_on or not (name.text in ("", "/") or name.text.startswith("//"))]


def _as_default(name: NameOption, depends_on: Iterable[str]) -> NameOption:
    """The name that holds unless somebody gives another value."""
    if not depends_on:
        return name
    how = Resolution.DEFAULT if name.resolution in (Resolution.EXACT, Resolution.BOUND) else name.resolution
    return name._replace(resolution=how, depends_on=tuple(sorted({*name.depends_on, *depends_on})))


def _name(value: Value) -> NameOption:
    origins = origins_of(value)
    depends = tuple(sorted({o.name for o in origins}))
    if value.__class__ is Const and isinstance(value.value, str):
        return NameOption(pattern(value), resolution_of(origins), depends, ())
    reasons = reasons_of(value) or (Reason(Cause.ERROR, f"{_told(value)} is no name", Place("", 0)),)
    if value.__class__ is Text:
        return NameOption(pattern(value), Resolution.PATTERN, _depends(depends, reasons), reasons)
    return NameOption(HOLE, Resolution.UNKNOWN, _depends(depends, reasons), reasons)


def _told(value: Value) -> str:
    return repr(value.value)[:40] if value.__class__ is Const else "an object"


_SETTABLE: Final = (*INSTEAD, Cause.ELEMENT, Cause.PARAMETER, Cause.ARGUMENT, Cause.LAUNCH_ARGUMENT, Cause.ENVIRONMENT)


def _depends(known: tuple[str, ...], reasons: tuple[Reason, ...]) -> tuple[str, ...]:
    return tuple(sorted({*known, *(r.subject for r in reasons if r.cause in _SETTABLE and r.subject)}))


def resolution_of(origins: Origins) -> Resolution:
    """How a wholly known text was found."""
    if not origins:
        return Resolution.EXACT
    return Resolution.BOUND if all(o.given for o in origins) else Resolution.DEFAULT


_TYPE: Final = re.compile(
    r"[A-Z][A-Za-z0-9]*(?:_(?:Request|Response|Event|Goal|Result|Feedback|FeedbackMessage|SendGoal|GetResult))*$"
)
"""How rosidl lets a message, service or action be called, and calls those that it makes of a service or action."""

_IMPL: Final = {
    "SendGoalService": "SendGoal",
    "GetResultService": "GetResult",
    "FeedbackMessage": "FeedbackMessage",
}
_OF_ALL_ACTIONS: Final = {
    "CancelGoalService": "action_msgs/srv/CancelGoal",
    "GoalStatusMessage": "action_msgs/msg/GoalStatusArray",
}
"""What the class `Impl` of an action has: types of the action under other names, and those that all actions share."""


def interface_type(value: Value) -> str | None:
    """`package/msg/Name` of an interface type; None where the value is not surely one."""
    if value.__class__ is not External:
        return None
    parts = value.name.split(".")
    if len(parts) >= 3 and parts[1] in PARTS:
        inner = [p for p in parts[2:] if not p.startswith("_")]
        if parts[1] == "action" and inner[1:2] == ["Impl"] and len(inner) > 2:
            if inner[2] in _OF_ALL_ACTIONS:
                return "_".join((_OF_ALL_ACTIONS[inner[2]], *inner[3:]))
            inner[1:3] = [_IMPL.get(inner[2], inner[2])]
        return "/".join((parts[0], parts[1], "_".join(inner))) if inner and _TYPE.match(inner[0]) else None
    return None


def interface_types(value: Value) -> tuple[str | None, ...]:
    """The types that a value may be, each once; without what the client library refuses, where it may be a type as well.

    try: from std_msgs.msg import String
    except ImportError: class String: …         no type
    """
    several = options(value)
    fitting = [o for o in several if not _is_no_type(o)]
    return tuple(dict.fromkeys(interface_type(_type_behind(o)) for o in fitting or several))


def _type_behind(value: Value) -> Value:
    """A subclass of an interface type stands for it: the client library asks for what it inherits."""
    if not isinstance(value, Class):
        return value
    return next((base for base in value.mro if interface_type(base) is not None), value)


def _is_no_type(value: Value) -> bool:
    """Whether a value is surely no interface type: None, or a class of which all is known."""
    if isinstance(value, Class):
        return not any(isinstance(base, (External, Unknown)) for base in value.mro)
    return value == NONE
