# SPDX-License-Identifier: Apache-2.0
"""The launch context as Python code of launch files sees it: it turns heap objects into templates and asks the execution.

LaunchConfiguration('x').perform(context)   ->  performer.text((Substitution('var', ((Const('x'),),)),))
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Final, final

from rosward.domain.choice import lift
from rosward.domain.text import origins_of
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, TRUE, Const, Unknown, Value
from rosward.location import Place

if TYPE_CHECKING:
    from rosward.deployment.performer import Performer
    from rosward.deployment.python.substitutions import Texts
    from rosward.deployment.tree import Condition, Template

_TRUE: Final = ("true", "1")
_FALSE: Final = ("false", "0")

Test = Callable[[Value, "Performer"], Value]


@final
class PerformedContext:
    """Implements `effects.launch_context.LaunchContext` for the performer that asked last. `test` evaluates conditions of the program."""

    def __init__(self, texts: Texts, test: Test) -> None:
        self._texts = texts
        self._test = test
        self.performers: list[Performer] = []

    @property
    def performer(self) -> Performer:
        """The execution that Python code runs for."""
        return self.performers[-1]

    @property
    def _place(self) -> Place:
        return self._texts.objects.machine.place

    def perform(self, pieces: Value) -> Value:
        """The text of a substitution, a str, or a list of them."""
        template = self._texts.template(pieces, self._place)
        return self.performer.text(template) if template else Const("")

    def evaluate(self, condition: Value) -> Value:
        """Whether a condition holds."""
        read = self._texts.condition(condition, self._place)
        if read is None or (read.kind == "python" and read.value == condition):
            return TRUE  # a bare Condition
        return self.holds(read)

    def holds(self, condition: Condition) -> Value:
        """Whether a condition of the tree holds: a bool."""
        if condition.kind in ("if", "unless"):
            negated = condition.kind == "unless"
            return lift(lambda v: self._truth(v, negated, condition.place), self._text(condition.arguments[0]))
        if condition.kind in ("equals", "not-equals"):
            return self._equals(condition)
        assert condition.value is not None
        return self._test(condition.value, self.performer)

    def _text(self, template: Template) -> Value:
        return self.performer.text(template)

    def _truth(self, text: Value, negated: bool, place: Place) -> Value:
        if not isinstance(text, Const) or not isinstance(text.value, str):
            return Unknown(text.reasons if isinstance(text, Unknown) else self._unknown().reasons, "bool")
        word = text.value.strip().lower()
        if word not in _TRUE and word not in _FALSE:
            self._texts.objects.tell(
                "RW320", f"{text.value!r} is not a valid condition: expected true, false, 1 or 0", place
            )
            return self._unknown()
        return Const((word in _TRUE) is not negated, text.origins)

    def _equals(self, condition: Condition) -> Value:
        names, *wanted = (self._text(a) for a in condition.arguments)
        expected = wanted[0] if wanted else NONE
        if not isinstance(names, Const) or not isinstance(expected, Const):
            return self._unknown()
        value = self.performer.configuration(str(names.value)) or NONE
        negated = condition.kind == "not-equals"

        def same(found: Value) -> Value:
            if not isinstance(found, Const):
                return self._unknown()
            return Const((found.value == expected.value) is not negated, origins_of(found) | origins_of(expected))

        return lift(same, value)

    def _unknown(self) -> Unknown:
        return self._texts.objects.machine.unknown(Cause.ARGUMENT, "condition", "bool")

    def configuration(self, name: str) -> Value | None:
        """A launch configuration, None where it is surely not set."""
        return self.performer.configuration(name)

    def configurations(self) -> Mapping[str, Value]:
        """All launch configurations that are or may be set."""
        return self.performer.configurations()

    def set_configuration(self, name: str, value: Value | None) -> None:
        """Set a launch configuration; None removes it."""
        self.performer.set_configuration(name, value)

    def add_to_configuration(self, name: str, value: Value) -> None:
        """Add an item to a launch configuration that is a list."""
        self.performer.add_to_configuration(name, value)

    def rewrite_configuration(self, name: str, value: Value) -> None:
        """Change a launch configuration that is a list in place."""
        self.performer.rewrite_configuration(name, value)

    def variable(self, name: str) -> Value | None:
        """An environment variable, None where it is not known or not set."""
        return self.performer.variable(name)

    def removed(self, name: str) -> bool:
        """Whether an environment variable is surely not set."""
        return self.performer.removed(name)

    def new_path(self) -> Value:
        """A path at which there is no file yet."""
        return self.performer.new_path()

    def write_file(self, path: Value, text: Value) -> None:
        """A file is written by the launch itself."""
        self.performer.write_file(path, text)

    def written(self, path: Value) -> Value | None:
        """What the launch has written into a file; Python's None where it has removed it, no value where it has done neither."""
        return self.performer.written(path)

    def set_variable(self, name: str, value: Value | None) -> None:
        """Set an environment variable; None removes it."""
        self.performer.set_variable(name, value)
