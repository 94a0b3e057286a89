# SPDX-License-Identifier: Apache-2.0
"""Which command lines may a program give to `rclpy.init`, to a context, or to a node?

rclpy.init(args=sys.argv + ['--ros-args', '-r', 'a:=b'])        what somebody types, then these three
Node('n', cli_args=[flag_or_other, 'a:=b'])                     two command lines
"""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all, options
from rosward.domain.series import Series
from rosward.domain.unknown import Reason, causes_of
from rosward.domain.values import NONE, Ref, Unknown, Value
from rosward.models.python.plain import listed
from rosward.naming.command_line import UNKNOWN_ARGUMENTS, read_words

if TYPE_CHECKING:
    from rosward.models.native import Machine

_WORDS: Final = "__words__"
_MOST: Final = 16
"""So many command lines that one call may give are kept apart."""


def words_of_process(machine: Machine) -> Value:
    """`sys.argv` as the program left it."""
    return machine.load_attr(machine.load_module("sys"), "argv")


def lines_of(machine: Machine, value: Value | None) -> tuple[Series, ...]:
    """The command lines that `args` may be; what is wrong with them, or not known, is told here."""
    found: dict[Series, None] = {}
    for option in options(value) if value is not None else (NONE,):
        for line in _apart(Series() if option == NONE else _series(machine, option)):
            found[line] = None
            _tell(machine, line)
    return tuple(found)


def _series(machine: Machine, value: Value) -> Series:
    return Series((), value) if isinstance(value, Unknown) else machine.series(value)


def _apart(line: Series) -> tuple[Series, ...]:
    """One command line for each alternative of its words, where they are few."""
    words = (*line.head, *line.tail)
    count = 1
    for word in words:
        count *= len(options(word))
    if count == 1 or count > _MOST:
        return (line,)
    size = len(line.head)
    several = itertools.product(*map(options, words))
    return tuple(Series(one[:size], line.middle, one[size:]) for one in several)


def _tell(machine: Machine, line: Series) -> None:
    configuration = machine.log.configuration
    read = read_words(line, configuration)
    if not read.errors and not read.open and not read.holes:
        return
    known = read_words(Series(machine.log.words), configuration) if configuration is not None else None
    for error in read.errors:
        if known is None or error not in known.errors:  # else the launch file is told
            machine.report("RW209", f"rcl rejects these arguments: {error}")
    reasons = read.open
    if known is None or read.unreadable != known.unreadable:  # else the launch file is told
        reasons = (*reasons, *read.holes)
    if reasons:
        machine.report("RW106", UNKNOWN_ARGUMENTS + _because(reasons), causes_of(reasons, machine.place))


def _because(reasons: tuple[Reason, ...]) -> str:
    return " because of " + "; ".join(str(r) for r in dict.fromkeys(reasons))


def keep_line(machine: Machine, context: Value, args: Value | None) -> None:
    """`context.init(args)`: the context keeps its command line, that of the process where it is given none."""
    given = join_all(words_of_process(machine) if o == NONE else o for o in options(args or NONE))
    words = join_all(listed(machine, ("words", number), *line) for number, line in enumerate(lines_of(machine, given)))
    for each in options(context):
        if isinstance(each, Ref):
            machine.update(each, machine.obj(each).with_attr(_WORDS, words))


def context_lines(machine: Machine, context: Value | None) -> tuple[Series, ...]:
    """The command lines that a context may have; without init, that of the process."""
    found: dict[Series, None] = {}
    for each in options(context) if context is not None else ():
        words = machine.obj(each).attrs.get(_WORDS) if isinstance(each, Ref) else None
        for option in options(words) if words is not None else ():
            if isinstance(option, Ref):
                found.update(dict.fromkeys(_apart(machine.obj(option).series())))
    if not found:
        found[Series(machine.log.words)] = None
    return tuple(found)
