# SPDX-License-Identifier: Apache-2.0
"""How does a process begin, and what can a header say that C++ has no word for?

rosward::init(context, argc, argv)              the command line of the process, as `rclcpp::init` gets it
rosward::unknown("live", "nodes of the system") a value that nobody knows, and why
rosward::value                                  a type of which every value is one, as it is
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join_all, options, reasons_of
from rosward.domain.compound import External, Tuple
from rosward.domain.slots import Pointer, Slot
from rosward.domain.text import readable
from rosward.domain.unknown import OTHERS, Cause
from rosward.domain.values import FALSE, NONE, TRUE, UNBOUND, Const, Ref, Unknown, Value
from rosward.models.cpp.iteration.elements import series_of
from rosward.models.cpp.ros.handed import NOTHING, given, target_of
from rosward.models.cpp.values.slots import read
from rosward.models.launch import natives as launch
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.ros import effects
from rosward.models.ros.given_words import keep_line


def _init(call: NativeCall) -> Value:
    """`init(context, argc, argv)`: without arguments, the line is empty."""
    keep_line(call.machine, target_of(call, call.args[0]), _words(call, 1))
    return NONE


def _words(call: NativeCall, index: int) -> Value:
    """The words of `argc, argv`: a pointer to an array of texts."""
    machine = call.machine
    if given(call, index) == Const(0):
        return machine.new_list(())
    found: list[Value] = []
    for option in options(given(call, index + 1)):
        while isinstance(option, Pointer):
            option = option.target  # noqa: PLW2901 - from a pointer to where it leads
        if isinstance(option, Slot):
            option = _from(machine, option) if option.kind == "item" else read(machine, option)  # noqa: PLW2901 - as above
        if option == NONE:
            found.append(machine.new_list(()))
        elif isinstance(option, (Ref, Unknown, Tuple)):
            found.append(option)
        else:
            found.append(machine.unknown(Cause.ARGUMENT, "argv"))
    return join_all(found)


def _from(machine: Machine, place: Slot) -> Value:
    """The words from one of them on: what is left of an array after `++argv`."""
    start = place.key.value if isinstance(place.key, Const) else 0
    if not isinstance(start, int) or start < 1 or not isinstance(place.base, Ref):
        return place.base
    left = series_of(machine, place.base).without(start)
    return machine.new_list(left.head, left.middle, left.tail)


def _remove_ros_arguments(call: NativeCall) -> Value:
    """`remove_ros_arguments(argc, argv)`: the words that are not between --ros-args and --."""
    inner = NativeCall(call.machine, call.name, (_words(call, 0),), {})
    return effects.NATIVES["rclpy.utilities.remove_ros_args"](inner)


def _read_all(name: str) -> NativeFunction:
    """The native of that name of the models of rclpy."""
    native = effects.NATIVES[name]
    return lambda call: native(call._replace(args=tuple(read(call.machine, a) for a in call.args), keywords={}))


def _folder(name: str) -> NativeFunction:
    """The native of that name of the models of launch."""
    native = launch.NATIVES[f"_rosward.launch.{name}"]
    return lambda call: native(call._replace(args=tuple(read(call.machine, a) for a in call.args), keywords={}))


_SET_LATER: Final = OTHERS | {Cause.PARAMETER}


def _plugin_names(call: NativeCall) -> Value:
    """`plugin_names(name)`: the names of classes that a text may be, as if nobody set another one while the program runs; null where there are none.

    Of others that it may be it is told: what these create nobody knows.
    """
    machine = call.machine
    found: list[Value] = []
    for option in options(given(call, 0)):
        if isinstance(option, Const) and isinstance(option.value, str):
            found += [Const(option.value)] if option.value else []
        elif machine.log.configuration is None or not _set_later(option):
            machine.report(
                "RW202",
                f"a plugin is loaded of which the name is not known ({readable(option)}); what it creates is unknown",
            )
    return join_all(found) if found else NONE


def _set_later(value: Value) -> bool:
    reasons = reasons_of(value)
    return bool(reasons) and all(r.cause in _SET_LATER for r in reasons)


def _is_same_plugin(call: NativeCall) -> Value:
    """`is_same_plugin(names, name)`: whether it is one of these; not known where another one may be set."""
    machine, names, name = call.machine, given(call, 0), given(call, 1)
    if names == NONE:
        return FALSE
    return TRUE if names == name else machine.unknown(Cause.PARAMETER, "name of a plugin", "bool")


def _plugin(call: NativeCall) -> Value:
    """`outside_plugin(name)`: an object of a class that is not of the workspace."""
    return call.machine.unknown(Cause.CALL, f"plugin {readable(given(call, len(call.args) - 1))}")


def _no_names(call: NativeCall) -> Value:
    return call.machine.new_list((), call.machine.unknown(Cause.ENVIRONMENT, "plugins that are installed", "str"))


def _value(call: NativeCall) -> Value:
    """`value(x)`: what it is given, whatever that is."""
    return given(call, 0)


def _new_value(call: NativeCall) -> Value:
    """The same, where a variable of the type is made; without a first value, null."""
    found = given(call, 1)
    return found.items[0] if isinstance(found, Tuple) and len(found.items) == 1 else found


def _nothing(_call: NativeCall) -> Value:
    """`nothing()`: what stands for an argument that is not given."""
    return External(NOTHING)


def _throw(call: NativeCall) -> Value:
    """`fail(exception)`: it is thrown here for sure."""
    call.machine.throw(given(call, 0))
    return UNBOUND


def _may_throw(call: NativeCall) -> Value:
    """`may_throw(exception, …)`: a library may throw one of these here, which only who catches it is told."""
    if call.machine.is_tried:
        call.machine.throw(join_all(given(call, number) for number in range(len(call.args))))
    return NONE


NATIVES: Final[dict[str, NativeFunction]] = {
    "pluginlib.names_in_workspace": _no_names,
    "pluginlib.of_workspace": _plugin,
    "rosward.default_of": _read_all("_rosward.default"),
    "rosward.either": _read_all("_rosward.either"),
    "rosward.escape": _read_all("_rosward.escape"),
    "rosward.fail": _throw,
    "rosward.init": _init,
    "rosward.may_throw": _may_throw,
    NOTHING: _nothing,
    "rosward.is_same_plugin": _is_same_plugin,
    "rosward.outside_plugin": _plugin,
    "rosward.plugin_names": _plugin_names,
    "rosward.prefix_folder": _folder("prefix_folder"),
    "rosward.remove_ros_arguments": _remove_ros_arguments,
    "rosward.report": _read_all("_rosward.report"),
    "rosward.share_folder": _folder("share_folder"),
    "rosward.unknown": _read_all("_rosward.unknown"),
    "rosward.value": _value,
    "rosward.value.new": _new_value,
}
