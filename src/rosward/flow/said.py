# SPDX-License-Identifier: Apache-2.0
"""Which marks of information flow has a function of a library? Of stubs in Python; of headers, and sources, in C++.

rclcpp.Clock.now      [[rosward::source("clock")]] on the function
rclcpp.Time.seconds   [[rosward::holds]] on the class; so it is with a namespace
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Final, final

from rosward.engine.cpp.linked import Linked
from rosward.findings import Finding
from rosward.flow import array_names
from rosward.flow.marked_cpp import NATIVES, STREAMS
from rosward.models.flow_marks import NO_MARK, FlowMark, mark_of, wrong

if TYPE_CHECKING:
    from rosward.engine.interpreter import Interpreter
    from rosward.ir.symbols import Marked


def marks_of(machine: Interpreter) -> Callable[[str], FlowMark]:
    """The marks of all functions that a process may call, by dotted names."""
    linked = machine.linked
    return InHeaders(linked.symbols.marked).of if isinstance(linked, Linked) else machine.library.marks.of


def told_by(machine: Interpreter) -> Callable[[str], bool]:
    """Whether marks, or the models, say something of what has this dotted name, of its parts, or of what it is a part of."""
    linked = machine.linked
    if isinstance(linked, Linked):
        return InHeaders(linked.symbols.marked).tells
    marks, watched = machine.library.marks, machine.budget.watched

    def tells(name: str) -> bool:
        if marks.tells(name) or name.startswith(_FRAMES) or any(released.startswith(name) for released in watched):
            return True
        return array_names.tells(name) and marks.of(name) is not NO_MARK

    return tells


def wrong_marks(machine: Interpreter) -> Iterator[Finding]:
    """What is wrong with the attributes of the declarations of a program."""
    linked = machine.linked
    for said in linked.symbols.marked.values() if isinstance(linked, Linked) else ():
        for mark, words in said.words.items():
            for message in wrong(
                mark, words, None if said.is_scope and mark == "stops" else ("self", *said.parameters)
            ):
                yield Finding("RW214", message, said.place)


_FRAMES: Final = ("types.FrameType.", "inspect.FrameInfo.")
"""What no stub describes, and the walk makes itself."""


@final
class InHeaders:
    """The marks of declarations in C++, and of what has none."""

    def __init__(self, marked: Mapping[str, Marked]) -> None:
        self._marked = marked
        self._known: dict[str, FlowMark] = dict(NATIVES)
        names = [name.split(".") for name in (*marked, *NATIVES, *STREAMS)]
        self._prefixes = {".".join(name[: n + 1]) for name in names for n in range(len(name))}

    def of(self, name: str) -> FlowMark:
        """Those of a function, else of the class or namespace around it."""
        found = self._known.get(name)
        if found is None:
            found = self._known[name] = self._of(name)
        return found

    def tells(self, name: str) -> bool:
        """Whether a mark is about this name, about a part of it, or about what it is a part of."""
        return name in self._prefixes or self.of(name) is not NO_MARK

    def _of(self, name: str) -> FlowMark:
        own = self._marked.get(name)
        scope = name
        while own is None and scope:
            scope = scope.rpartition(".")[0]
            around = self._marked.get(scope)
            own = around if around is not None and around.is_scope else None
        return (mark_of(own.words) if own is not None else None) or NO_MARK
