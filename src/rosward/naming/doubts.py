# SPDX-License-Identifier: Apache-2.0
"""How doubts about names are told: what is not known, why, and what settles it."""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import options, reasons_of
from rosward.domain.unknown import OTHERS, OUTSIDE, Cause, Reason, causes_of
from rosward.domain.values import Value
from rosward.findings import Finding, doubtful
from rosward.holes import with_stars
from rosward.location import Place
from rosward.naming.command_line import UNKNOWN_ARGUMENTS
from rosward.naming.options import NameOption, interface_type
from rosward.ros.entities import Entity, Resolution
from rosward.rules import MADE_ANEW

_REMEDY: Final = {
    Cause.PARAMETER: "give the parameter a default",
    Cause.ARGUMENT: "give the argument a default",
    Cause.LAUNCH_ARGUMENT: "give it a value (--arg NAME:=VALUE)",
    Cause.ENVIRONMENT: "give it a value (--env {}=VALUE)",
    Cause.SET: "give it a value (--env {}=VALUE)",
    Cause.MODULE: "add its package to the analysis",
    Cause.CALL: "describe the call in a stub file (--models)",
    Cause.CALLER: "add the code that makes the call to the analysis",
}


_MOST_REASONS: Final = 3


def _doubt(code: str, what: str, reasons: tuple[Reason, ...], place: Place) -> Finding:
    """What is not known, because of what, and the one thing that settles it."""
    remedy = next((_remedy(r) for r in reasons if r.cause in _REMEDY), "")
    doubts = tuple(dict.fromkeys(str(r) for r in reasons[:_MOST_REASONS]))
    return doubtful(code, what, doubts, place, causes_of(reasons, place), remedy=remedy)


def _remedy(reason: Reason) -> str:
    if reason.cause is Cause.PARAMETER and reason.subject == OUTSIDE:
        return "tell what your system sets (--launch, --params)"
    return _REMEDY[reason.cause].format(reason.subject)


def unknown_name(kind: str, entity: Entity, option: NameOption, place: Place) -> Finding:
    """An entity whose name is not completely known."""
    if is_off_by_default(option):
        names = ", ".join(dict.fromkeys(r.subject for r in option.reasons))
        message = f"this {kind} is off by default: it exists, with the name that is given, once another value is given for {names}"
        return Finding("RW108", message, place, causes_of(option.reasons, place))
    if entity.resolution is Resolution.UNKNOWN:
        return _doubt("RW101", f"the name of this {kind} is unknown", option.reasons, place)
    if _made_anew(option):
        return _name_made_anew(f"this {kind}", entity.name, place)
    return _doubt("RW102", f"the name of this {kind} is known only as {entity.name}", option.reasons, place)


def is_off_by_default(option: NameOption) -> bool:
    """Whether a name is one that somebody gives in place of a default for which nothing is created."""
    return (
        option.resolution is Resolution.UNKNOWN
        and bool(option.reasons)
        and all(r.cause in OTHERS for r in option.reasons)
    )


def unknown_node(option: NameOption, place: Place, part: str = "name") -> Finding:
    """A node whose name or namespace is not completely known."""
    if option.resolution is Resolution.UNKNOWN:
        return _doubt("RW105", f"the {part} of this node is unknown", option.reasons, place)
    if _made_anew(option):
        return _name_made_anew("this node", with_stars(option.text), place)
    return _doubt("RW102", f"the {part} of this node is known only as {with_stars(option.text)}", option.reasons, place)


def _made_anew(option: NameOption) -> bool:
    return bool(option.reasons) and all(reason.cause is Cause.ANEW for reason in option.reasons)


def _name_made_anew(what: str, text: str, place: Place) -> Finding:
    """A name of which nobody can know more, in the analysis or before the start; one cause for all that are called so."""
    return Finding(
        "RW107", f"{what} is named {text}, where * is generated at each start", place, (f"{MADE_ANEW}: {text}",)
    )


def invalid_name(kind: str, text: str, why: str, place: Place, depends_on: tuple[str, ...] = ()) -> Finding:
    """A name that rcl rejects; `depends_on`: whose default it is, so that another value may be valid. Such names of one call are one cause."""
    default = f" (the default of {', '.join(depends_on)})" if depends_on else ""
    message = f"{with_stars(text)!r} is not a valid name for a {kind}: {why}{default}"
    return Finding("RW103", message, place, (f"names of the {kind} at {place.file}:{place.line}",))


def unknown_arguments(reasons: tuple[Reason, ...], place: Place) -> Finding:
    """Words of a command line of which nothing is known, as `models/ros/given_words.py` tells it of those that programs give."""
    return _doubt("RW106", UNKNOWN_ARGUMENTS, reasons, place)


def unknown_type(kind: str, name: str, value: Value, place: Place) -> Finding:
    """An entity whose interface type is not known: why, what is a type among the alternatives does not say."""
    others = [option for option in options(value) if interface_type(option) is None]
    reasons = tuple(dict.fromkeys(reason for option in others for reason in reasons_of(option)))
    return _doubt("RW104", f"the type of the {kind} {name} is unknown", reasons or reasons_of(value), place)
