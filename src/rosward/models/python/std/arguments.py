# SPDX-License-Identifier: Apache-2.0
"""Command lines: what `argparse`, `optparse`, `click` and `getopt` make of declarations, and of known arguments.

    parser.add_argument('--topic-name', default='/scan')    dest 'topic_name', shown as --topic-name
    parser.parse_args(['--topic-name', '/points'])          exact: read by Python's own argparse

What of it plain Python says stands in stubs/argparse.pyi.
"""

from __future__ import annotations

import argparse
from itertools import product
from math import prod
from typing import Any, Final, NoReturn

from rosward.domain.choice import join_all, options, reasons_of
from rosward.domain.compound import Tuple
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Const, Ref, Value
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.containers import dicts
from rosward.models.python.plain import text_of
from rosward.models.python.std.support import exact_list, names_of, place_list
from rosward.records import NamedTuple

_SIMPLE_ACTIONS: Final = frozenset(
    {"store", "store_true", "store_false", "store_const", "append", "append_const", "count", "extend"}
)
_MOST_WORDS: Final = 200
_MOST_LINES: Final = 16
"""So many command lines are read one by one."""
_KINDS: Final = {argparse.REMAINDER: "list", argparse.ZERO_OR_MORE: "list", argparse.ONE_OR_MORE: "list"}


class _Refused(Exception):  # noqa: N818 - a signal inside this module
    """The arguments do not fit the declarations."""


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise _Refused(message)

    def exit(self, status: int = 0, message: str | None = None) -> NoReturn:
        raise _Refused(message or str(status))


def _flags(call: NativeCall, value: Value) -> tuple[str, ...]:
    return names_of(exact_list(call.machine, value) or ())


def _long(flags: tuple[str, ...]) -> str:
    return next((f for f in flags if f.startswith("--")), flags[0] if flags else "")


def _dest(call: NativeCall) -> Value:
    """argparse._dest(flags, prefix): the attribute that an argument is stored in."""
    flags, prefix = _flags(call, call.args[0]), text_of(call.args[1])
    if not flags or not prefix:
        return call.machine.unknown(Cause.OPERATION, "name of an argument", "str")
    if flags[0][:1] not in prefix:
        return Const(flags[0])
    long = next((f for f in flags if len(f) > 1 and f[1] in prefix), flags[0])
    return Const(long.lstrip(prefix).replace("-", "_"))


def _argument_name(call: NativeCall) -> Value:
    """argparse._shown(flags, dest): the name of an argument in reports."""
    return Const(_long(_flags(call, call.args[0])) or text_of(call.args[1]) or "argument")


def _kind(call: NativeCall) -> Value:
    """argparse._kind(nargs): 'list' where several arguments are taken, else 'str'."""
    nargs = call.args[0]
    if isinstance(nargs, Const):
        if isinstance(nargs.value, str):
            return Const(_KINDS.get(nargs.value, "str"))
        return Const("str" if nargs.value is None else "list")
    return Const("")


def _declared(machine: Machine, parser: _Parser, index: int, obj: Obj) -> None:
    attrs = obj.attrs
    flags = names_of(exact_list(machine, attrs["option_strings"]) or ())
    action = text_of(attrs["_action"])
    if action not in _SIMPLE_ACTIONS:
        raise _Refused
    options: dict[str, Any] = {"action": action, "default": argparse.SUPPRESS}
    nargs = attrs["nargs"]
    if not isinstance(nargs, Const) or not isinstance(attrs["required"], Const):
        raise _Refused
    if action in {"store", "append", "extend"}:
        options["nargs"] = nargs.value
    if action in {"store_const", "append_const"} or nargs.value == "?":
        options["const"] = None
    if all(f[:1] in parser.prefix_chars for f in flags):
        options["dest"] = str(index)
        options["required"] = bool(attrs["required"].value)
        parser.add_argument(*flags, **options)
    else:
        parser.add_argument(str(index), **options)


def _converted(machine: Machine, obj: Obj, found: object) -> Value:
    if isinstance(found, list):
        return place_list(machine, [_converted(machine, obj, f) for f in found], obj.attrs["dest"])
    if isinstance(found, str):
        convert = obj.attrs["type"]
        return Const(found) if convert == NONE else machine.call(convert, (Const(found),))
    if found is None:
        return obj.attrs["const"]
    return Const(found) if isinstance(found, (bool, int)) else machine.unknown(Cause.OPERATION, "argparse")


def _exact(call: NativeCall) -> Value:
    """argparse._exact(actions, arguments, some, prefix): ({dest: value given}, extra arguments); None if not all is known."""
    machine = call.machine
    actions, arguments = exact_list(machine, call.args[0]), exact_list(machine, call.args[1])
    if actions is None or arguments is None or len(arguments) > _MOST_WORDS:
        return NONE
    if prod(len(options(argument)) for argument in arguments) > _MOST_LINES:
        return NONE
    found = [_of_line(call, actions, line) for line in product(*map(options, arguments))]
    if None in found:
        return NONE
    lines = [each for each in found if isinstance(each, _Line)]
    if not lines:
        return machine.die("SystemExit", next(each for each in found if isinstance(each, str)))
    given = machine.new_dict({})
    for dest in dict.fromkeys(dest for line in lines for dest in line.given):
        values = [line.given[dest] for line in lines if dest in line.given]
        dicts.store(machine, given, dest, join_all(values), weak=len(values) < len(lines))
    extra = [place_list(machine, [Const(e) for e in line.extra], ("extra", n)) for n, line in enumerate(lines)]
    return Tuple((given, join_all(extra)))


class _Line(NamedTuple):
    """What one command line gives, and the arguments that are left over."""

    given: dict[Value, Value]
    extra: list[str]


def _of_line(call: NativeCall, actions: tuple[Value, ...], arguments: tuple[Value, ...]) -> _Line | str | None:
    """What the words mean; why they are refused; None where that is not known."""
    machine, tokens, prefix = call.machine, names_of(arguments), text_of(call.args[3])
    if len(tokens) != len(arguments) or any(t.startswith("@") for t in tokens) or not prefix:
        return None
    parser = _Parser(add_help=False, prefix_chars=prefix)
    objs = [machine.obj(a) for a in actions if isinstance(a, Ref)]
    try:
        for index, obj in enumerate(objs):
            _declared(machine, parser, index, obj)
    except (_Refused, argparse.ArgumentError, KeyError, TypeError, ValueError):
        return None
    try:
        namespace, extra = parser.parse_known_args(list(tokens))
    except _Refused as error:
        return str(error)
    except (argparse.ArgumentError, TypeError, ValueError):
        return None
    if extra and machine.truth(call.args[2]) is False:
        return f"unrecognized arguments: {' '.join(extra)}"
    given: dict[Value, Value] = {}
    for key, found in vars(namespace).items():
        obj = objs[int(key)]
        given[obj.attrs["dest"]] = _converted(machine, obj, found)
    return _Line(given, extra)


def _is_typed(call: NativeCall) -> Value:
    """argparse._is_typed(arguments): whether all that is not known of them is what somebody types."""
    series = call.machine.series(call.args[0])
    words = (*series.head, *series.tail, *(() if series.middle is None else (series.middle,)))
    given = (*series.head, *series.tail)
    known = all(len(options(word)) == 1 for word in given) and not any(isinstance(word, Const) for word in given)
    return Const(known and all(r.cause is Cause.ARGUMENT for word in words for r in reasons_of(word)))


def _getopt(call: NativeCall) -> Value:
    """getopt.getopt: any number of any of its options, then any arguments."""
    machine = call.machine
    short, long = text_of(call.arg(1, "shortopts") or NONE) or "", call.arg(2, "longopts")
    names = [f"-{c}" for c in short if c not in ":+-"]
    listed = exact_list(machine, long) if long is not None else ()
    names += [f"--{n.rstrip('=?')}" for n in names_of(listed or ())]
    option = join_all(map(Const, names)) if names else machine.unknown(Cause.ARGUMENT, "getopt", "str")
    value = machine.unknown(Cause.ARGUMENT, " ".join(names), "str")
    return Tuple((machine.new_list((), Tuple((option, value))), place_list(machine, None, "rest", value)))


NATIVES: Final[dict[str, NativeFunction]] = {
    "argparse._dest": _dest,
    "argparse._shown": _argument_name,
    "argparse._kind": _kind,
    "argparse._exact": _exact,
    "argparse._is_typed": _is_typed,
    "getopt.getopt": _getopt,
    "getopt.gnu_getopt": _getopt,
}
