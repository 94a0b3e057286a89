# SPDX-License-Identifier: Apache-2.0
"""What an object on the heap of the interpreter is, as far as launch is concerned: its class, what it was given, its elements.

talker = Talker(name='t')       kind: 'launch_ros.actions.Node', also where Talker is a class of the launch file that derives from it
nodes = [a]; if unknown: nodes.append(b)        elements: a for sure, b perhaps
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Final, final

from rosward.domain.choice import join, options, reasons_of
from rosward.domain.compound import BoundMethod, External, Native, Partial, Tuple
from rosward.domain.heap import Alternatives
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import NONE, Class, Const, Function, Ref, Text, Unknown, Value
from rosward.findings import Finding
from rosward.location import Place
from rosward.models.launch.natives import FIELD, REQUIRED, place_of
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.engine.interpreter import Interpreter

_CALLABLE: Final = (Function, BoundMethod, Partial, Native, External)
_SEQUENCES: Final = ("list", "set", "dict", "generator")


class SequenceItem(NamedTuple):
    """One element of a sequence; where it is not `sure`, it may be absent."""

    value: Value
    sure: bool = True


@final
class Objects:
    """Looks at objects on the heap. What is wrong with them is told as findings."""

    def __init__(self, machine: Interpreter) -> None:
        self.machine = machine

    def kind(self, value: Value) -> str:
        """The dotted name of the class in a library model that an object is of, or derives from; '' where there is none."""
        if not isinstance(value, Ref):
            return ""
        cls = self.machine.obj(value).cls
        if isinstance(cls, Class):
            return next((c.dotted for c in cls.mro if isinstance(c, Class) and c.stub), "")
        return ""

    def kinds(self, ref: Ref) -> tuple[str, ...]:
        """The dotted names of all classes in library models that an object is of, or derives from, the most particular first."""
        cls = self.machine.obj(ref).cls
        return tuple(c.dotted for c in cls.mro if isinstance(c, Class) and c.stub) if isinstance(cls, Class) else ()

    def is_a(self, value: Value, dotted: str) -> bool:
        """Whether an object is of a class (or derives from one) of that dotted name."""
        if not isinstance(value, Ref):
            return False
        cls = self.machine.obj(value).cls
        return isinstance(cls, Class) and any(isinstance(c, Class) and c.dotted == dotted for c in cls.mro)

    def overrides(self, ref: Ref, method: str) -> bool:
        """Whether the class of an object, or one of the analysed sources that it derives from, has a method of its own."""
        cls = self.machine.obj(ref).cls
        if not isinstance(cls, Class):
            return False
        for each in cls.mro:
            if not isinstance(each, Class) or each.stub:
                return False
            if method in self.machine.at(each.address).attrs:
                return True
        return False

    def place(self, ref: Ref) -> Place:
        """Where an object was made."""
        return place_of(self.machine.obj(ref))

    def field(self, ref: Ref, name: str) -> Value | None:
        """What an object was given under a name; None where nothing or None."""
        found = self.machine.obj(ref).attrs.get(FIELD + name, NONE)
        return None if found in (NONE, REQUIRED) else found

    def flag(self, ref: Ref, name: str, default: bool) -> bool:
        """A switch that an object was given: the default where it is not known."""
        found = self.field(ref, name)
        known = None if found is None else self.machine.truth(found)
        return default if known is None else known

    @staticmethod
    def is_callable(value: Value) -> bool:
        """Whether a value is a function or the like."""
        return all(isinstance(o, _CALLABLE) for o in options(value))

    def is_text(self, value: Value) -> bool:
        """Whether a value is a str for sure."""
        return all(
            isinstance(o, Text)
            or (isinstance(o, Const) and isinstance(o.value, str))
            or (isinstance(o, Unknown) and o.hint == "str")
            for o in options(value)
        )

    def is_sequence(self, value: Value) -> bool:
        """Whether a value is a list, a tuple or the like."""
        if isinstance(value, Tuple):
            return True
        return isinstance(value, Ref) and self.machine.obj(value).kind in _SEQUENCES

    def is_dict(self, value: Value) -> bool:
        """Whether a value is a dict."""
        return isinstance(value, Ref) and self.machine.obj(value).kind == "dict"

    def elements(self, value: Value) -> list[SequenceItem]:
        """The elements of a sequence in order; anything else is its own and only element."""
        found = options(value)
        if len(found) > 1:
            return _merged([self.elements(o) for o in found if o != NONE], all_of=NONE not in found)
        if isinstance(value, Tuple):
            return [SequenceItem(v) for v in value.items]
        if not isinstance(value, Ref):
            return [] if value == NONE else [SequenceItem(value, not isinstance(value, Unknown))]
        obj = self.machine.obj(value)
        if obj.kind == "list" and obj.items is None and isinstance(obj.payload, Alternatives):
            return [SequenceItem(v, sure) for v, sure in obj.payload.elements]
        if obj.kind in _SEQUENCES:
            known, rest = self.machine.iterate(value)
            return [
                *(SequenceItem(v) for v in known),
                *([] if rest is None else (SequenceItem(o, False) for o in options(rest))),
            ]
        return [SequenceItem(value)]

    def tell(self, code: str, message: str, place: Place) -> None:
        """A finding."""
        self.machine.log.findings.add(Finding(code, message, place))

    def perhaps(self, value: Value, place: Place) -> Value:
        """A value in place of which any other one may be, since it may not be there."""
        return join(value, self.unknown("what may not be there", place, ""))

    def unknown(self, why: str, place: Place, hint: str = "str") -> Unknown:
        """An unknown value that arises in the launch file."""
        return Unknown((Reason(Cause.OPERATION, why, place),), hint)


def _merged(ways: list[list[SequenceItem]], *, all_of: bool) -> list[SequenceItem]:
    """One sequence of several alternatives: what all have is sure."""
    counts: dict[Value, int] = {}
    sure: dict[Value, bool] = {}
    for way in ways:
        for value in dict.fromkeys(e.value for e in way):
            counts[value] = counts.get(value, 0) + 1
        for element in way:
            sure[element.value] = sure.get(element.value, True) and element.sure
    return [SequenceItem(v, all_of and n == len(ways) and sure[v]) for v, n in counts.items()]


def why_unknown(values: Iterable[Value]) -> str:
    """Why values are not known, in words; '' where they are."""
    return "; ".join(dict.fromkeys(str(r) for v in values for r in reasons_of(v)))
