# SPDX-License-Identifier: Apache-2.0
"""What Python code of a launch file can ask the launch that it runs in.

def setup(context):                                      # an OpaqueFunction
    robot = context.launch_configurations['robot']       configuration('robot')
    size = LaunchConfiguration('size').perform(context)  perform(the object)
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from collections.abc import Mapping

    from rosward.domain.values import Value


class LaunchSettings(Protocol):
    """What is set at the point that a launch has reached: launch configurations and the environment."""

    def configuration(self, name: str) -> Value | None:
        """A launch configuration, None where it is surely not set."""

    def configurations(self) -> Mapping[str, Value]:
        """All launch configurations that are or may be set."""

    def set_configuration(self, name: str, value: Value | None) -> None:
        """Set a launch configuration; None removes it."""

    def add_to_configuration(self, name: str, value: Value) -> None:
        """Add an item to a launch configuration that is a list, as launch_ros keeps those of SetRemap and SetParameter."""

    def rewrite_configuration(self, name: str, value: Value) -> None:
        """Change a launch configuration that is a list in place: each scope that sees the list sees that."""

    def variable(self, name: str) -> Value | None:
        """An environment variable, None where it is not known or not set."""

    def removed(self, name: str) -> bool:
        """Whether an environment variable is surely not set."""

    def set_variable(self, name: str, value: Value | None) -> None:
        """Set an environment variable; None removes it."""

    def new_path(self) -> Value:
        """A path at which there is no file yet."""

    def write_file(self, path: Value, text: Value) -> None:
        """A file is written by the launch itself: whoever reads it from now on finds this text. Python's None: it is removed."""

    def written(self, path: Value) -> Value | None:
        """What the launch has written into a file; Python's None where it has removed it, no value where it has done neither."""


class LaunchContext(LaunchSettings, Protocol):
    """The launch that is going on, as models of `launch` reach it (`EffectLog.launch`)."""

    def perform(self, pieces: Value) -> Value:
        """The text of a substitution, a str, or a list of them."""

    def evaluate(self, condition: Value) -> Value:
        """Whether a condition holds: a bool."""
