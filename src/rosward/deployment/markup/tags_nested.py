# SPDX-License-Identifier: Apache-2.0
"""Which action is a tag that has actions inside?

<group scoped="false"><let …/></group>            ->  Group(actions=(SetConfiguration(…),), scoped=False)
<for len="$(var n)" name="i"><node …/></for>      ->  ForEach(values=…, count=True, body=(StartNode(…),), index_name='i')
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from types import MappingProxyType
from typing import Final

from rosward.deployment.markup.element import Format, Tag
from rosward.deployment.markup.substitutions import plain_text, unknown_text
from rosward.deployment.tree import ForEach, Group, LaunchAction, Template, Timer

Inner = Callable[[Iterable[Tag]], tuple[LaunchAction, ...]]
Reader = Callable[[Tag, Inner], LaunchAction]


def _group(element: Tag, inner: Inner) -> LaunchAction:
    scoped, forwarding = element.flag("scoped"), element.flag("forwarding")
    return Group(
        place=element.place,
        condition=element.condition(),
        actions=inner(each for each in element.children() if each.tag != "keep"),
        scoped=scoped is None or bool(scoped),
        forwarding=forwarding is None or bool(forwarding),
        configurations=_kept_pairs(element),
    )


def _kept_pairs(element: Tag) -> tuple[tuple[Template, Template], ...]:
    return element.pairs("keep", "name", "value")


def _timer(element: Tag, inner: Inner) -> LaunchAction:
    element.switch("cancel_on_shutdown")
    period, attribute = element.number("period"), element.attribute("period")
    if period is None or attribute is None:
        element.refuse(f"<{element.tag}> has no attribute 'period', which launch requires.")
        period = unknown_text("period", element.place)
    elif not _may_be_number(plain_text(period)):
        element.refuse(f"'period' of <{element.tag}> is not a number.")
    elif element.tag == "ros_timer" and element.format is Format.YAML:
        if plain_text(period) is not None and isinstance(attribute.value, str):
            element.refuse("'period' of <ros_timer> is a string, but launch requires a float.")
    actions = inner(element.children())
    return Timer(place=element.place, condition=element.condition(), period=period, actions=actions)


def _may_be_number(text: str | None) -> bool:
    if text is not None:
        try:
            float(text)
        except ValueError:
            return False
    return True


def _for_each(element: Tag, inner: Inner) -> LaunchAction:
    values = element.required("values")
    return ForEach(place=element.place, condition=element.condition(), values=values, body=inner(element.children()))


def _for(element: Tag, inner: Inner) -> LaunchAction:
    length, name = element.required("len"), element.text("name")
    if name is None:
        element.refuse("<for> has no attribute 'name', which launch requires.")
    return ForEach(
        place=element.place,
        condition=element.condition(),
        values=length,
        count=True,
        body=inner(element.children()),
        index_name=name or "",
    )


READERS: Final = MappingProxyType[str, Reader](
    {
        "group": _group,
        "timer": _timer,
        "ros_timer": _timer,
        "for_each": _for_each,
        "for": _for,
    }
)
