# SPDX-License-Identifier: Apache-2.0
"""The launch context as actions, substitutions and Python code see it: it performs text, and tells what fails.

scene.text((Const('talker_'), Substitution('var', ((Const('id'),),))))   ->   Const('talker_1')
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Final, final

from rosward.deployment.execution.context import Context
from rosward.deployment.execution.findings import FindingLog
from rosward.deployment.execution.generated import GeneratedFiles
from rosward.deployment.execution.launch_files import LaunchFiles
from rosward.deployment.execution.ros_state import LISTS
from rosward.deployment.markup.substitutions import UNKNOWN
from rosward.deployment.performer import PythonCode
from rosward.deployment.tree import Substitution, Template
from rosward.domain.choice import lift, lift2, reasons_of
from rosward.domain.text import concat, parts_of
from rosward.domain.unknown import Cause, Reason, causes_of
from rosward.domain.values import EMPTY, Const, Text, Unknown, Value
from rosward.effects.shell import Shell
from rosward.effects.variables import Variables
from rosward.location import Place
from rosward.ros.distro import Distro

_LONGEST: Final = 500_000

MAX_DEPTH: Final = 60

_LEAST: Final[dict[str, int]] = {
    **dict.fromkeys(
        (
            "holds",
            "dirname",
            "filename",
            "launch-log-dir",
            "any",
            "all",
            "and",
            "or",
            "path-join",
            "python",
            "command",
            "local",
        ),
        0,
    ),
    **dict.fromkeys(("equals", "not-equals", "exec-in-pkg", "if", "has-node-params"), 2),
}
"""How many arguments a substitution needs, where it is not one."""

_LOGICAL: Final = frozenset(("any", "all", "equals", "not-equals", "if", "file-content", "launch-log-dir"))


Performing = Callable[["Scene", Substitution], Value]
"""What a substitution gives at the point of execution."""


@final
class Scene:
    """The point of execution. It is the `Performer` that Python code of launch files asks."""

    def __init__(
        self,
        files: LaunchFiles,
        python: PythonCode,
        findings: FindingLog,
        generated: GeneratedFiles,
        distro: Distro,
        substitutions: Mapping[str, Performing],
        shell: Shell | None = None,
        variables: Variables | None = None,
    ) -> None:
        self.files = files
        self.distro = distro
        self.python = python
        self.findings = findings
        self.generated = generated
        self.shell = shell
        self.variables = variables or Variables()
        self.context = Context(shell)
        self.turn: Mapping[str, Value] = {}
        """The variables of the loop whose body is executed."""
        self.asked: set[str] = set()
        """Names of launch configurations that were declared or read."""
        self.asked_all = False
        """Whether Python code has read them all."""
        self.words: tuple[str, ...] = ()
        """The arguments of the command line."""
        self._substitutions = substitutions
        self._depth = 0

    def fails(self, what: str, place: Place, reasons: tuple[Reason, ...] = ()) -> None:
        """Tell that the real launch raises an exception here; `reasons` are those of what is not known then."""
        self.findings.tell("RW320", f"{what[:1].upper()}{what[1:]}.", place, causes_of(reasons, place))

    # As a Performer

    def text(self, template: Template) -> Value:
        """The text of a template now: its pieces performed, one after the other, and concatenated."""
        result: Value = EMPTY
        for index, piece in enumerate(template):
            part = self._perform(piece) if isinstance(piece, Substitution) else _as_text(piece)
            result = part if index == 0 else lift2(_joined, result, part)
        return result

    def configuration(self, name: str) -> Value | None:
        """The value of a launch configuration, None where it is surely not set."""
        self.asked.add(name)
        if name in LISTS:
            return self.context.listed(name)
        held = self.context.held(name)
        return None if held is None else held.value

    def configurations(self) -> Mapping[str, Value]:
        """All launch configurations that are or may be set."""
        self.asked_all = True
        return self.context.configurations()

    def set_configuration(self, name: str, value: Value | None) -> None:
        """Set a launch configuration; None removes it."""
        self.context.set(name, value)

    def add_to_configuration(self, name: str, value: Value) -> None:
        """Add an item to a launch configuration that is a list."""
        self.context.add_listed(name, value)

    def rewrite_configuration(self, name: str, value: Value) -> None:
        """Change a launch configuration that is a list in place."""
        self.context.rewrite_listed(name, value)

    def variable(self, name: str) -> Value | None:
        """An environment variable, None where it is not known or not set."""
        held = self.context.variable(name)
        return None if held is None else held.value

    def removed(self, name: str) -> bool:
        """Whether an environment variable is surely not set."""
        held = self.context.variable(name)
        return held is not None and held.value is None and held.sure

    def set_variable(self, name: str, value: Value | None) -> None:
        """Set an environment variable; None removes it."""
        self.context.set_variable(name, value)

    def new_path(self) -> Value:
        """A path at which there is no file yet."""
        return self.generated.new_path()

    def write_file(self, path: Value, text: Value) -> None:
        """A file is written by the launch itself."""
        self.generated.put(path, text)

    def written(self, path: Value) -> Value | None:
        """What the launch has written into a file; Python's None where it has removed it, no value where it has done neither."""
        return self.generated.written(path)

    def given(self) -> Sequence[str]:
        """The launch arguments that the user gave, as words `name:=value` of the command line."""
        return self.words

    def _perform(self, substitution: Substitution) -> Value:
        perform = self._substitutions.get(substitution.kind)
        if perform is None or self._depth >= MAX_DEPTH:
            return self._not_performed(substitution)
        if len(substitution.arguments) < _LEAST.get(substitution.kind, 1):
            self.fails(f"the substitution '{substitution.kind}' lacks an argument", substitution.place)
            return Unknown((Reason(Cause.ERROR, substitution.kind, substitution.place),), "str")
        if substitution.kind in _LOGICAL and not self.distro.facts.logical_substitutions:
            self.fails(f"{self.distro.value} has no substitution '{substitution.kind}'", substitution.place)
        self._depth += 1
        try:
            return perform(self, substitution)
        finally:
            self._depth -= 1

    def _not_performed(self, substitution: Substitution) -> Value:
        name = _name_of(substitution)
        if self._depth >= MAX_DEPTH:
            self.findings.tell("RW201", "Substitutions are nested too deeply here.", substitution.place)
        else:
            message = f"The substitution '{name}' is not supported: its text is unknown."
            if substitution.kind == UNKNOWN:  # what launch refuses, as RW320 tells
                message = f"'{name}' cannot be read here: its text is unknown."
            self.findings.tell("RW321", message, substitution.place)
        return Unknown((Reason(Cause.LIMIT, name, substitution.place),), "str")


def _name_of(substitution: Substitution) -> str:
    """What a substitution is called in the launch file."""
    written = substitution.arguments[0] if substitution.kind == UNKNOWN and substitution.arguments else ()
    return "".join(str(part.value) for part in written if isinstance(part, Const)) or substitution.kind


def _as_text(value: Value) -> Value:
    """A piece of a template as text."""

    def one(option: Value) -> Value:
        if isinstance(option, Text):
            return option
        if isinstance(option, Const):
            return option if isinstance(option.value, str) else Const(str(option.value), option.origins)
        return Unknown(reasons_of(option) or (Reason(Cause.OPERATION, "", Place("", 0)),), "str")

    return lift(one, value)


def _joined(left: Value, right: Value) -> Value:
    """Two texts as one, unless it is longer than any that means something: an include may double its argument in each turn."""
    if sum(len(part) for value in (left, right) for part in parts_of(value) if isinstance(part, str)) > _LONGEST:
        return Unknown((Reason(Cause.LIMIT, "a string that is too long", Place("", 0)),), "str")
    return concat((left, right))
