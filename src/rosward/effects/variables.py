# SPDX-License-Identifier: Apache-2.0
"""Which environment variables that nobody gave has a run asked for, and what did it compare them with?

if os.environ["LDS_MODEL"] == "LDS-01": …     LDS_MODEL, with 'LDS-01': whoever starts this decides here

A run can take such a variable to be none of some values: then it surely differs from them, wherever it is compared. So several runs, one for each
value and one for all others, tell the uses of a variable apart that one run would mix.
"""

from __future__ import annotations

import shlex
from collections.abc import Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import Final, final

from rosward.domain.unknown import Origins
from rosward.domain.values import Const, Unknown, Value
from rosward.effects.shell import ORIGIN
from rosward.findings import Finding
from rosward.location import Place

__all__ = ["Variables", "listed", "not_given"]

_NONE: Final[Mapping[str, frozenset[str]]] = MappingProxyType({})
_MOST: Final = 16
_SHOWN: Final = 6
_TRUTHS: Final = ("true", "false")


@final
class Variables:
    """What was asked of variables that are not known. `excluded`: values that they do not have in this run."""

    def __init__(self, excluded: Mapping[str, frozenset[str]] = _NONE) -> None:
        self._excluded = dict(excluded)  # a copy, which can be sent
        self.values: dict[str, dict[str, None]] = {}
        """By variable: the values that it was compared with."""
        self.files: dict[str, dict[str, None]] = {}
        """By variable: the values for which there is a file that it names."""
        self.places: dict[str, dict[Place, None]] = {}
        """By variable: where it is read."""
        self.conditions: dict[str, None] = {}
        """The variables that are conditions themselves: true or false."""
        self.read: dict[str, None] = {}
        """The variables that were asked for, known or not."""
        self.required: dict[str, None] = {}
        """The variables that are read without a default."""

    def equal(self, left: Value, right: Value) -> bool | None:
        """left == right, where one of them is an unknown variable: False where it has another value in this run, else None."""
        variable, other = (left, right) if isinstance(left, Unknown) and left.variable else (right, left)
        if not isinstance(variable, Unknown) or not isinstance(other, Const) or not isinstance(other.value, str):
            return None
        name = variable.variable
        self.required[name] = None
        self.compared(name, (other.value,), variable.reasons[0].place if variable.reasons else Place(""))
        return False if other.value in self._excluded.get(name, ()) else None

    def of_default(self, origins: Origins, other: Value, place: Place) -> None:
        """Something made of the default of a variable was compared."""
        if isinstance(other, Const) and isinstance(other.value, str):
            for origin in origins:
                if origin.kind == ORIGIN and not origin.settled:
                    self.compared(origin.name, (other.value,), place)

    def compared(self, name: str, values: Iterable[str], place: Place) -> None:
        """A variable decides something at a place; `values` are those that it is told from there."""
        known = self.values.setdefault(name, {})
        known.update((value, None) for value in values if len(known) < _MOST)
        self.places.setdefault(name, {})[place] = None

    def is_condition(self, name: str) -> None:
        """A variable is a condition of launch."""
        self.conditions[name] = None

    def named(self, name: str, values: Iterable[str], place: Place) -> None:
        """A path is made of a variable; there is a file for each of `values`."""
        known = self.files.setdefault(name, {})
        known.update((value, None) for value in values if len(known) < _MOST)
        self.required[name] = None
        self.compared(name, (), place)

    def candidates(self, name: str) -> tuple[str, ...]:
        """The values for which something is another than for the rest."""
        return tuple(dict.fromkeys((*self.values.get(name, ()), *self.files.get(name, ()))))

    def add(self, other: Variables) -> None:
        """What another run has asked."""
        for name, values in other.files.items():
            self.files.setdefault(name, {}).update(values)
        for name, values in other.values.items():
            for place in other.places[name]:
                self.compared(name, values, place)
        self.required.update(other.required)
        self.conditions.update(other.conditions)


def not_given(variables: Variables) -> list[Finding]:
    """RW325 for each variable: the values that are told apart, and how it is given."""
    return [_not_given(name, variables) for name in sorted(variables.places)]


def _not_given(name: str, variables: Variables) -> Finding:
    places = sorted(variables.places[name])
    truths = _TRUTHS if name in variables.conditions else ()
    told = [
        f"{what} {listed(tuple(values))}"
        for what, values in (
            ("it is compared with", variables.values[name]),
            ("files exist for", variables.files.get(name, ())),
            ("it is used as a condition,", truths),
        )
        if values
    ]
    where = f" (read at {len(places)} places)" if len(places) > 1 else ""
    why = f": {', '.join(told)}" if told else ""
    example = f"{name}={next(iter((*variables.candidates(name), *truths)), 'VALUE')}"
    return Finding(
        "RW325", f"the environment variable {name} has no value{where}{why}: --env {shlex.quote(example)}", places[0]
    )


def listed(values: Sequence[str]) -> str:
    """Some values, and how many more there are."""
    more = f" and {len(values) - _SHOWN} more" if len(values) > _SHOWN else ""
    return ", ".join(map(repr, values[:_SHOWN])) + more
