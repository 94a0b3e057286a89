# SPDX-License-Identifier: Apache-2.0
"""Which action is an element?

    <let name="id" value="1"/>  ->  SetConfiguration(name=(Const('id'),), value=(Const('1'),))
    <my_robot arms="2"/>        ->  Unread(why=…): a tag of a launch extension that is not described here

One table from tag to reader, split by theme into the modules `tags_*`.
"""

from __future__ import annotations

from collections.abc import Iterable
from types import MappingProxyType
from typing import Final

from rosward.deployment.markup.element import Tag
from rosward.deployment.markup.tags_gazebo import READERS as OF_GAZEBO
from rosward.deployment.markup.tags_launch import READERS as OF_LAUNCH
from rosward.deployment.markup.tags_nested import READERS as OF_NESTED
from rosward.deployment.markup.tags_nodes import READERS as OF_NODES
from rosward.deployment.markup.tags_ros import READERS as OF_ROS
from rosward.deployment.tree import LaunchAction, Unread

_SIMPLE: Final = MappingProxyType({**OF_LAUNCH, **OF_ROS, **OF_NODES, **OF_GAZEBO})


def read_description(root: Tag) -> tuple[LaunchAction, ...]:
    """The actions of the element <launch>; its attributes are not checked by launch either."""
    return read_actions(root.children())


def read_actions(elements: Iterable[Tag]) -> tuple[LaunchAction, ...]:
    """One action for each element."""
    return tuple([_read(each) for each in elements])


def _read(element: Tag) -> LaunchAction:
    nested = OF_NESTED.get(element.tag)
    simple = _SIMPLE.get(element.tag)
    if nested is not None:
        action = nested(element, read_actions)
    elif simple is not None:
        action = simple(element)
    else:
        why = f"The tag <{element.tag}> is unknown."
        return Unread(place=element.place, condition=element.condition(), why=why)
    element.finish()
    return action
