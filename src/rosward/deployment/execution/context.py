# SPDX-License-Identifier: Apache-2.0
"""What is set at one point of the execution: launch configurations, environment, ROS state, the current launch file.

let a:=1; group(let a:=2); ...a...      ->  1
let a:=1; if(unknown) let a:=2; ...a... ->  1 or 2

A condition that is not known is executed both ways: `save` before, `join` behind. Configurations and variables are then joined name by
name (`Held.sure` says whether one is surely set); what PushRosNamespace and its like have set is kept apart as whole alternatives, since a
node has one namespace and one list of rules, not parts of two.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Final, final

from rosward.deployment.execution.ros_state import LISTS, RosState, read_entry
from rosward.domain.choice import join, join_all, options
from rosward.domain.text import origins_of
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Unknown, Value
from rosward.location import Place
from rosward.records import NamedTuple

MAX_ALTERNATIVES: Final = 8
ROS_NAMESPACE: Final = "ros_namespace"
"""The name under which launch_ros keeps the pushed namespace among the launch configurations."""


class Held(NamedTuple):
    """What a name holds. `value` None: it is surely not set (an environment variable that launch removed)."""

    value: Value | None
    sure: bool = True


Names = Mapping[str, Held]


class Saved(NamedTuple):
    """The whole state at one point."""

    configurations: tuple[Names, ...]
    environment: tuple[Names, ...]
    alternatives: tuple[RosState, ...]
    files: tuple[Value | None, ...]


@final
class Context:
    """The state that actions change. Names are looked up in the innermost scope, which is a copy of those around it."""

    def __init__(self, shell: Mapping[str, Value] | None = None) -> None:
        self._shell = {name: Held(value) for name, value in (shell or {}).items()}
        self._configurations: list[dict[str, Held]] = [{}]
        self._environment: list[dict[str, Held]] = [dict(self._shell)]
        self.alternatives: tuple[RosState, ...] = (RosState(),)
        self.files: tuple[Value | None, ...] = (None,)
        """The path of the current launch file; several where that depends on something unknown, None outside of any."""
        self.exceeded = False
        """Whether there were more alternatives of the ROS state than are kept apart."""
        self.unread = False
        """Whether an action or a launch file was executed that could not be read: it may have set any configuration."""

    # Launch configurations

    def held(self, name: str) -> Held | None:
        """A launch configuration, None where it is surely not set."""
        if name == ROS_NAMESPACE:
            return self._held_namespace()
        return self._configurations[-1].get(name)

    def _held_namespace(self) -> Held | None:
        found = [s.namespace for s in self.alternatives]
        values = [v for v in found if v is not None]
        return Held(join_all(values), len(values) == len(found)) if values else None

    def listed(self, name: str) -> Value | None:
        """What SetRemap or SetParameter have set, as Python code reads it by the name of its configuration; None where it is surely not set."""
        values = [v for state in self.alternatives if (v := state.listed(name)) is not None]
        return join_all(values) if values else None

    def add_listed(self, name: str, value: Value) -> None:
        """Python code adds an item to the list of SetRemap or SetParameter."""
        self.change_ros(lambda state: state.added(read_entry(name, value)))

    def rewrite_listed(self, name: str, value: Value) -> None:
        """Python code changes the list of SetRemap or SetParameter in place."""
        self.alternatives = self._bounded(
            state.rewritten(name, each) for state in self.alternatives for each in options(value)
        )

    def configurations(self) -> dict[str, Value]:
        """All launch configurations that are or may be set."""
        found = {name: held.value for name, held in self._configurations[-1].items() if held.value is not None}
        namespace = self._held_namespace()
        if namespace is not None and namespace.value is not None:
            found[ROS_NAMESPACE] = namespace.value
        return found | {name: value for name in LISTS if (value := self.listed(name)) is not None}

    def set(self, name: str, value: Value | None) -> None:
        """Set a launch configuration; None removes it."""
        if name in LISTS:
            several = (None,) if value is None else options(value)
            states = (state.with_listed(name, each) for state in self.alternatives for each in several)
            self.alternatives = self._bounded(states)
        elif name == ROS_NAMESPACE:
            self.change_ros(lambda state: state.with_namespace(value))
        elif value is None:
            self._configurations[-1].pop(name, None)
        else:
            self._configurations[-1][name] = Held(value)

    def set_unknown_name(self, value: Value | None) -> None:
        """A configuration of an unknown name was set (or removed): each may hold that value now."""
        inner = self._configurations[-1]
        for name, held in inner.items():
            inner[name] = held._replace(sure=False) if value is None else Held(_joined(held.value, value), held.sure)

    # Environment

    def variable(self, name: str) -> Held | None:
        """An environment variable that is known, or that launch removed; None where it is an unknown one of the shell."""
        return self._environment[-1].get(name)

    def set_variable(self, name: str, value: Value | None) -> None:
        """Set an environment variable; None removes it."""
        self._environment[-1][name] = Held(value)

    def environment(self, place: Place) -> dict[str, Value | None]:
        """The variables that are others than in the shell, as a process started now gets them; None where launch has removed one."""
        found: dict[str, Value | None] = {}
        for name, held in self._environment[-1].items():
            if held == self._shell.get(name):
                continue
            if held.value is None and held.sure:
                found[name] = None
            elif held.value is not None:
                unknown = Unknown((Reason(Cause.ENVIRONMENT, name, place),), "str")
                found[name] = held.value if held.sure else join(held.value, unknown)
        return found

    # ROS state

    def change_ros(self, change: Callable[[RosState], RosState]) -> None:
        """Change the ROS state in each alternative."""
        self.alternatives = self._bounded(change(state) for state in self.alternatives)

    def _bounded(self, states: Iterable[RosState]) -> tuple[RosState, ...]:
        distinct = tuple(dict.fromkeys(states))
        self.exceeded = self.exceeded or len(distinct) > MAX_ALTERNATIVES
        return distinct[:MAX_ALTERNATIVES]

    # Scopes

    def push_configurations(self) -> None:
        """A new scope of launch configurations, with a copy of all."""
        self._configurations.append(dict(self._configurations[-1]))
        self.change_ros(RosState.pushed)

    def pop_configurations(self) -> bool:
        """Back to the scope around; False where there is none (the real launch fails)."""
        if len(self._configurations) == 1:
            return False
        self._configurations.pop()
        self.change_ros(RosState.popped)
        return True

    def reset_configurations(self, kept: Sequence[tuple[str, Value]]) -> None:
        """Nothing is set but what is kept."""
        self._configurations[-1] = {}
        self.change_ros(RosState.cleared)
        for name, value in kept:
            self.set(name, value)

    def push_environment(self) -> None:
        """A new scope of environment variables, with a copy of all."""
        self._environment.append(dict(self._environment[-1]))

    def pop_environment(self) -> bool:
        """Back to the environment around; False where there is none (the real launch fails)."""
        if len(self._environment) == 1:
            return False
        self._environment.pop()
        return True

    def reset_environment(self) -> None:
        """The environment is that of the shell again."""
        self._environment[-1] = dict(self._shell)

    def replaced_environment(self, place: Place) -> dict[str, Value | None]:
        """What is left of it for a process that is given another one: that may be made of the variables of the shell, or not."""
        return {
            name: Unknown((Reason(Cause.ENVIRONMENT, name, place),), "str")
            for name, held in self._shell.items()
            if held.value is not None and any(origin.given for origin in origins_of(held.value))
        }

    # Both ways

    def save(self) -> Saved:
        """The state as it is now."""
        return Saved(
            tuple(dict(names) for names in self._configurations),
            tuple(dict(names) for names in self._environment),
            self.alternatives,
            self.files,
        )

    def restore(self, saved: Saved) -> None:
        """Back to a state that was saved."""
        self._configurations = [dict(names) for names in saved.configurations]
        self._environment = [dict(names) for names in saved.environment]
        self.alternatives, self.files = saved.alternatives, saved.files

    def join(self, other: Saved) -> None:
        """What holds where either this state or the other one is real."""
        self._configurations = _joined_scopes(other.configurations, self._configurations)
        self._environment = _joined_scopes(other.environment, self._environment)
        depth = max(len(s.scopes) for s in (*other.alternatives, *self.alternatives))
        states = (_as_deep(state, depth) for state in (*other.alternatives, *self.alternatives))
        self.alternatives = self._bounded(states)
        self.files = tuple(dict.fromkeys((*other.files, *self.files)))[:MAX_ALTERNATIVES]


def _as_deep(state: RosState, depth: int) -> RosState:
    """The state with as many scopes as another way has, so that both can be popped alike."""
    while len(state.scopes) < depth:
        state = state.pushed()
    return state


def _joined_scopes(one: Sequence[Names], other: Sequence[Names]) -> list[dict[str, Held]]:
    """Scope by scope, from the outermost; where one way has more of them, its innermost are joined with the other's innermost."""
    depth = max(len(one), len(other))
    lefts = [*one, *[one[-1]] * (depth - len(one))]
    rights = [*other, *[other[-1]] * (depth - len(other))]
    return [_joined_names(left, right) for left, right in zip(lefts, rights, strict=True)]


def _joined_names(one: Names, other: Names) -> dict[str, Held]:
    found: dict[str, Held] = {}
    for name in (*one, *(n for n in other if n not in one)):
        left, right = one.get(name), other.get(name)
        if left is None or right is None:
            only = left or right
            assert only is not None
            found[name] = only._replace(sure=False)
        elif left == right:
            found[name] = left
        else:
            both_set = left.value is not None and right.value is not None
            found[name] = Held(_joined(left.value, right.value), left.sure and right.sure and both_set)
    return found


def _joined(left: Value | None, right: Value | None) -> Value | None:
    if left is None or right is None:
        return left or right
    return join(left, right)
