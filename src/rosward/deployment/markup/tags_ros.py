# SPDX-License-Identifier: Apache-2.0
"""Which action is a tag of launch_ros that starts nothing?

    <push_ros_namespace namespace="left"/>      ->  PushNamespace(namespace=(Const('left'),))
    <set_parameter name="rate" value="10"/>     ->  SetParameter(parameter=ParameterTable((((Const('rate'),), Typed(…)),)))

<set_use_sim_time> sets the parameter of launch's own node, of no node that is started: it is inert.
"""

from __future__ import annotations

from types import MappingProxyType
from typing import Final

from rosward.deployment.markup.element import Tag
from rosward.deployment.markup.tags_launch import Reader
from rosward.deployment.tree import (
    Inert,
    LaunchAction,
    ParameterFile,
    ParameterTable,
    PushNamespace,
    SetParameter,
    SetRemap,
    Typed,
)


def _push_namespace(element: Tag) -> LaunchAction:
    return PushNamespace(place=element.place, condition=element.condition(), namespace=element.required("namespace"))


def _set_remap(element: Tag) -> LaunchAction:
    source, target = element.required("from"), element.required("to")
    return SetRemap(place=element.place, condition=element.condition(), source=source, target=target)


def _set_parameter(element: Tag) -> LaunchAction:
    name, value = element.required("name"), element.required("value")
    table = ParameterTable(((name, Typed(value)),), element.place)
    return SetParameter(place=element.place, condition=element.condition(), parameter=table)


def _set_parameters_from_file(element: Tag) -> LaunchAction:
    file = ParameterFile(element.required("filename"), element.place)
    return SetParameter(place=element.place, condition=element.condition(), parameter=file)


def _set_use_sim_time(element: Tag) -> LaunchAction:
    if element.switch("value") is None:
        element.required("value")
    return Inert(place=element.place, condition=element.condition(), kind=element.tag)


def _set_ros_log_dir(element: Tag) -> LaunchAction:
    element.required("new_log_dir")
    return Inert(place=element.place, condition=element.condition(), kind=element.tag)


READERS: Final = MappingProxyType[str, Reader](
    {
        "push_ros_namespace": _push_namespace,
        "push-ros-namespace": _push_namespace,
        "set_remap": _set_remap,
        "set_parameter": _set_parameter,
        "set_parameters_from_file": _set_parameters_from_file,
        "set_use_sim_time": _set_use_sim_time,
        "set_ros_log_dir": _set_ros_log_dir,
    }
)
