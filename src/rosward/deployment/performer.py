# SPDX-License-Identifier: Apache-2.0
"""The seam between the execution of launch files and Python in them: each asks the other for what only it can say.

OpaqueFunction(function=setup)       execution -> Python: call setup(context), what actions does it give?
LaunchConfiguration('x').perform(context)   Python -> execution: what is this text now?
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Protocol

from rosward.effects.launch_context import LaunchSettings

if TYPE_CHECKING:
    from rosward.deployment.tree import Description, LaunchAction, Template
    from rosward.domain.values import Value
    from rosward.findings import Finding


class Performer(LaunchSettings, Protocol):
    """The launch at the point of execution: what Python code of a launch file asks of it (`LaunchContext`) is answered by this."""

    def text(self, template: Template) -> Value:
        """The text of a template now; Unknown, a Text with holes or a Choice where it is not completely known."""

    def given(self) -> Sequence[str]:
        """The launch arguments that the user gave, as words `name:=value` of the command line."""


class PythonCode(Protocol):
    """Python of launch files, run by the engine. Every call can ask `performer` in its course."""

    def read(self, file: str, performer: Performer) -> Description:
        """Run a Python launch file (named as in the workspace) and give the entities of its generate_launch_description()."""

    def actions(
        self,
        function: Value,
        args: Sequence[Value],
        kwargs: Mapping[str, Value],
        performer: Performer,
        *,
        context: bool,
    ) -> tuple[LaunchAction, ...]:
        """Call a function and read the entities that it gives; with `context`, the launch context is its first argument."""

    def appended(self, function: Value, performer: Performer) -> Mapping[Value, tuple[LaunchAction, ...]]:
        """The actions that a function, which was called, has added to launch descriptions, by description."""

    def perform(self, substitution: Value, performer: Performer) -> Value:
        """`substitution.perform(context)` of a class of the analysed sources: a text."""

    def test(self, condition: Value, performer: Performer) -> Value:
        """`condition.evaluate(context)` of a class of the analysed sources, or a call of a function: a bool."""

    def evaluate(self, expression: Value, modules: Sequence[str], performer: Performer) -> Value:
        """The str() of a Python expression, as PythonExpression has it: a text. The names of `modules` and of math are there."""

    @property
    def findings(self) -> Sequence[Finding]:
        """What the engine had to tell so far, each once."""
