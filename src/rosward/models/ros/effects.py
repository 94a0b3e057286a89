# SPDX-License-Identifier: Apache-2.0
"""Functions of the module `_rosward` that library models import: what a model does where Python cannot say it."""

from __future__ import annotations

from collections import ChainMap
from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

from rosward.domain.certain import text_of
from rosward.domain.choice import join_all, options
from rosward.domain.compound import Tuple
from rosward.domain.heap import Obj
from rosward.domain.text import readable
from rosward.domain.unknown import Cause, Origin
from rosward.domain.values import NONE, Const, Ref, Text, Unknown, Value
from rosward.models.failures import fail
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.ros.given_words import keep_line, words_of_process

if TYPE_CHECKING:
    from rosward.models.native import Machine


def _init(call: NativeCall) -> Value:
    """`init(context, args)`: the context keeps its command line."""
    keep_line(call.machine, call.args[0], call.arg(1, "args"))
    call.machine.log.begun[call.machine.place] = None
    return NONE


def _remove_ros_args(call: NativeCall) -> Value:
    """`rclpy.utilities.remove_ros_args(args)`: the words that are not between --ros-args and --."""
    machine = call.machine
    args = call.arg(0, "args")
    words = machine.series(words_of_process(machine) if args is None or args == NONE else args)
    kept: list[list[Value]] = []
    for_ros = False
    for part in (words.head, words.tail):
        kept.append([])
        for word in part:
            text = text_of(word)
            if text == "--ros-args":
                for_ros = True
            elif for_ros and text == "--":
                for_ros = False
            elif not for_ros:
                kept[-1].append(word)
    return machine.new_list(kept[0], words.middle, tuple(kept[1]))


def _environment(call: NativeCall) -> Value:
    """`_rosward.environment(name)`: a variable that the deployment sets, or that is known of the shell; None where nothing is known."""
    machine = call.machine
    name = text_of(call.args[0])
    return own_variables(machine, name).get(name) or NONE


def _is_unset(call: NativeCall) -> Value:
    """`_rosward.unset(name)`: whether the deployment has removed a variable."""
    name = text_of(call.args[0])
    variables = own_variables(call.machine, name)
    return Const(name in variables and variables[name] is None)


def own_variables(machine: Machine, name: str) -> Mapping[str, Value | None]:
    """What is known of the environment of the process, before the program changes it; `name` is what is asked of it."""
    machine.log.variables.read[name] = None
    configuration = machine.log.configuration
    shell: Mapping[str, Value | None] = machine.environment
    return shell if configuration is None else ChainMap(dict(configuration.environment), dict(shell))


def _schedule(call: NativeCall) -> Value:
    event = text_of(call.keywords.get("event"), "callback")
    if call.args[0] != NONE:
        call.machine.schedule(call.args[0], call.args[1:], event, answered=call.keywords.get("answered"))
    return NONE


def _spin(call: NativeCall) -> Value:
    call.machine.spin()
    return NONE


def _sleep(call: NativeCall) -> Value:
    call.machine.waits()
    return NONE


def _beside(call: NativeCall) -> Value:
    """`_rosward.beside()`: from now on callbacks run beside one another."""
    book = call.machine.schedule_book
    book.parallel = book.threads = True
    return NONE


def _unknown(call: NativeCall) -> Value:
    label = text_of(call.args[0]).upper().replace(" ", "_")
    cause = Cause[label] if label in Cause.__members__ else Cause.CALL
    subject = call.arg(1, "subject")
    name = text_of(subject, "" if subject is None else readable(subject))
    value = call.machine.unknown(cause, name, text_of(call.arg(2, "hint")))
    whole = cause is Cause.ENVIRONMENT and value.hint == "str" and isinstance(subject, Const)
    return Unknown(value.reasons, value.hint, name) if whole else value


def mark(machine: Machine, value: Value, origin: Origin) -> Value:
    """The value, and all that it holds, as computed from an origin."""
    return _marked(machine, value, origin, {})


def _marked(machine: Machine, value: Value, origin: Origin, lists: dict[int, Value]) -> Value:
    """`lists` are those that were met: one may lie in several others, and in itself, where it stays as it is."""
    if isinstance(value, Const):
        return value if value.value is None else Const(value.value, value.origins | {origin})
    if isinstance(value, Text):
        return Text(value.parts, value.origins | {origin})
    if isinstance(value, Tuple):
        return Tuple(tuple(_marked(machine, v, origin, lists) for v in value.items))
    if isinstance(value, Ref) and machine.obj(value).kind in ("list", "set"):
        if value.address in lists:
            return lists[value.address]
        lists[value.address] = value
        obj = machine.obj(value)
        items = None if obj.items is None else [_marked(machine, v, origin, lists) for v in obj.items]
        rest = None if obj.rest is None else _marked(machine, obj.rest, origin, lists)
        lists[value.address] = machine.new_list(items or (), rest)
        return lists[value.address]
    if len(options(value)) > 1:
        return join_all(_marked(machine, v, origin, lists) for v in options(value))
    return value


def _default(call: NativeCall) -> Value:
    kind, name, value = call.exactly(3)
    return mark(call.machine, value, Origin(text_of(kind), text_of(name, readable(name))))


def _either(call: NativeCall) -> Value:
    return join_all(call.args)


def _opaque(call: NativeCall) -> Value:
    return join_all(call.machine.allocate(Obj("instance", c)) for c in options(call.args[0]))


def _escape(call: NativeCall) -> Value:
    call.machine.escape(call.args, "a library")
    return NONE


def _report(call: NativeCall) -> Value:
    call.machine.report(text_of(call.args[0]), readable(call.args[1]))
    return NONE


def _fail_unless(call: NativeCall) -> Value:
    """`_rosward.fail_unless(condition, exception, message)`: the library raises where the condition surely does not hold."""
    machine = call.machine
    condition, exception, message = call.exactly(3)
    if machine.truth(condition) is not False:
        return NONE
    return fail(machine, exception, readable(message), (message,))


NATIVES: Final[dict[str, NativeFunction]] = {
    "_rosward.init": _init,
    "_rosward.environment": _environment,
    "_rosward.unset": _is_unset,
    "rclpy.utilities.remove_ros_args": _remove_ros_args,
    "_rosward.schedule": _schedule,
    "_rosward.beside": _beside,
    "_rosward.spin": _spin,
    "time.sleep": _sleep,
    "_rosward.unknown": _unknown,
    "_rosward.default": _default,
    "_rosward.either": _either,
    "_rosward.opaque": _opaque,
    "_rosward.escape": _escape,
    "_rosward.fail_unless": _fail_unless,
    "_rosward.report": _report,
}
