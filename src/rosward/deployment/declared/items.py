# SPDX-License-Identifier: Apache-2.0
"""For which items does a group of a declared interface exist, and is that certain?

for_each: {as: sensor, family: 'odom{n}'}   with odom0 and odom1 given: sensor = 'odom0', sensor = 'odom1'
the same with a parameter file that is not known: those, and perhaps sensor = 'odom*'
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Final, final

from rosward.deployment.declared.shapes import EndpointGroup, Loop
from rosward.deployment.declared.text import TemplateScope, expand, holds
from rosward.domain.choice import options, reasons_of
from rosward.domain.compound import External, Tuple
from rosward.domain.text import make
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Const, Hole, Unknown, Value
from rosward.location import Place
from rosward.ros.distro import Distro

_MOST_ITEMS: Final = 200
_TYPE: Final = re.compile(r"([A-Za-z]\w*)/(?:(msg|srv|action)/)?([A-Z]\w*)")
_PARTS: Final = {"publisher": "msg", "subscription": "msg", "service": "srv", "action": "action"}


@final
class ItemLimit:
    """How many groups and items are still looked at: files of users can ask for any number."""

    def __init__(self, left: int) -> None:
        self.left = left

    def take(self) -> bool:
        """One more; False where there are none left."""
        self.left -= 1
        return self.left >= 0


def expansions(
    group: EndpointGroup, scope: TemplateScope, distro: Distro, steps: ItemLimit
) -> Iterator[tuple[TemplateScope, bool]]:
    """The scopes in which a group exists, and whether it surely does."""
    if not group.window.has(distro):
        return
    for bound, sure in _bound(group.loops, scope):
        if not steps.take():
            return
        answers = [holds(condition, bound) for condition in group.when]
        if False not in answers:
            yield bound, sure and None not in answers


def _bound(loops: tuple[Loop, ...], scope: TemplateScope) -> Iterator[tuple[TemplateScope, bool]]:
    if not loops:
        yield scope, True
        return
    for item, sure in _items(loops[0], scope):
        for inner, also in _bound(loops[1:], scope.bound(loops[0].variable, item)):
            yield inner, sure and also


def _items(loop: Loop, scope: TemplateScope) -> list[tuple[Value, bool]]:
    if loop.source == "values":
        return [(expand(v, scope), True) for v in loop.values]
    of = expand(loop.of, scope)
    if not isinstance(of, Const):
        return [(Unknown(reasons_of(of), "str"), False)]
    name = str(of.value)
    if loop.source == "family":
        return _family(name, scope)
    if loop.source == "below":
        found, more = scope.parameters.below(name)
        rest = [(_hole(scope, name), False)] if more else []
        return [*((Const(f), True) for f in found[:_MOST_ITEMS]), *rest]
    several = options(scope.parameters.value(name))
    return [(item, sure and len(several) == 1) for each in several for item, sure in _elements(each, loop.source)][
        :_MOST_ITEMS
    ]


def _elements(value: Value, source: str) -> list[tuple[Value, bool]]:
    """The words of a text, or the elements of a list."""
    if source == "words" and isinstance(value, Const):
        return [(Const(word, value.origins), True) for word in str(value.value).split()]
    if source == "list" and isinstance(value, Tuple):
        return [(item, True) for item in value.items]
    if isinstance(value, Const):
        return []  # a parameter of another type: the node ends when it starts
    return [(Unknown(reasons_of(value), "str"), False)]


def _family(name: str, scope: TemplateScope) -> list[tuple[Value, bool]]:
    """`odom0`, `odom1`, … as long as they are given; and any other where what is given is not completely known."""
    before, _, behind = name.partition("{n}")
    found: list[tuple[Value, bool]] = []
    for number in range(_MOST_ITEMS):
        member = f"{before}{number}{behind}"
        known = scope.parameters.is_given(member)
        if known is None:
            reasons = scope.parameters.missing or (Reason(Cause.PARAMETER, member, Place("")),)
            found.append((make((before, Hole(reasons, "digits"), behind)), False))
        if not known:
            break
        found.append((Const(member), True))
    return found


def _hole(scope: TemplateScope, name: str) -> Value:
    return Unknown(scope.parameters.missing or (Reason(Cause.PARAMETER, name, Place("")),), "str")


def type_value(text: Value, kind: str) -> Value:
    """The type that a text names; `std_msgs/String` is one of the kind of its endpoint."""
    if not isinstance(text, Const):
        return Unknown(reasons_of(text))
    found = _TYPE.fullmatch(str(text.value))
    if not found:
        return Unknown((Reason(Cause.INPUT, f"type {text.value!s}", Place("")),))
    return External(f"{found[1]}.{found[2] or _PARTS[kind.partition('_')[0]]}.{found[3]}")
