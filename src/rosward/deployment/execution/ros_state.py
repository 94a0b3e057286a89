# SPDX-License-Identifier: Apache-2.0
"""What PushRosNamespace, SetRemap and SetParameter have set, and where a group forgets it.

push 'a'; group(push 'b'; node) ; node      ->  /a/b, then /a
SetRemap x:=y; group(SetRemap p:=q); node   ->  the node has p:=q too

launch_ros keeps the three as launch configurations, the latter two as lists. A group copies the names, not the lists: what is added
to a list inside stays if the list was there before. `RosState.lists` are those lists; a scope holds positions in it.
"""

from __future__ import annotations

from typing import Final, final

from rosward.domain.choice import is_text
from rosward.domain.compound import Tuple
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Unknown, Value
from rosward.location import Place
from rosward.records import NamedTuple

NO_LIST: Final = -1
NO_PLACE: Final = Place("", 0)
REMAPS: Final = "ros_remaps"
PARAMETERS: Final = "global_params"
LISTS: Final = (REMAPS, PARAMETERS)
"""The names under which launch_ros keeps the lists among the launch configurations."""


class Remap(NamedTuple):
    """One SetRemap."""

    source: Value
    target: Value


class GlobalParameter(NamedTuple):
    """One SetParameter, evaluated."""

    name: Value
    value: Value
    place: Place


class GlobalFile(NamedTuple):
    """One SetParametersFromFile; `node` limits it to nodes of that name."""

    path: Value
    place: Place
    node: Value | None = None


ListedEntry = Remap | GlobalParameter | GlobalFile


class RosScope(NamedTuple):
    """One scope: the pushed namespace (None: none), and which lists of remap rules and parameters it sees."""

    namespace: Value | None = None
    remaps: int = NO_LIST
    parameters: int = NO_LIST


@final
class RosState(NamedTuple):
    """All scopes, the current one last, and the lists that they share. Changed by making a new one."""

    scopes: tuple[RosScope, ...] = (RosScope(),)
    lists: tuple[tuple[ListedEntry, ...], ...] = ()

    @property
    def namespace(self) -> Value | None:
        """The namespace that is pushed now."""
        return self.scopes[-1].namespace

    @property
    def remaps(self) -> tuple[Remap, ...]:
        """The remap rules of SetRemap that hold now."""
        return tuple(e for e in self._list(self.scopes[-1].remaps) if isinstance(e, Remap))

    @property
    def parameters(self) -> tuple[GlobalParameter | GlobalFile, ...]:
        """The parameters and parameter files for all nodes that hold now."""
        return tuple(e for e in self._list(self.scopes[-1].parameters) if not isinstance(e, Remap))

    def _list(self, position: int) -> tuple[ListedEntry, ...]:
        return () if position == NO_LIST else self.lists[position]

    def pushed(self) -> RosState:
        """A new scope that sees what the current one sees."""
        return self._replace(scopes=(*self.scopes, self.scopes[-1]))

    def popped(self) -> RosState:
        """Without the current scope; what it added to lists of outer scopes stays."""
        return self._replace(scopes=self.scopes[:-1]) if len(self.scopes) > 1 else self

    def cleared(self) -> RosState:
        """Nothing is set in the current scope."""
        return self._replace(scopes=(*self.scopes[:-1], RosScope()))

    def with_namespace(self, namespace: Value | None) -> RosState:
        """Another pushed namespace, already joined with what was pushed before."""
        return self._replace(scopes=(*self.scopes[:-1], self.scopes[-1]._replace(namespace=namespace)))

    def added(self, entry: ListedEntry) -> RosState:
        """One more rule or parameter at the end of the list that the current scope sees."""
        scope = self.scopes[-1]
        position = scope.remaps if isinstance(entry, Remap) else scope.parameters
        if position != NO_LIST:
            lists = (*self.lists[:position], (*self.lists[position], entry), *self.lists[position + 1 :])
            return self._replace(lists=lists)
        position = len(self.lists)
        scope = scope._replace(remaps=position) if isinstance(entry, Remap) else scope._replace(parameters=position)
        return RosState((*self.scopes[:-1], scope), (*self.lists, (entry,)))

    def listed(self, name: str) -> Value | None:
        """One of the lists as Python code of a launch file finds it: pairs, and paths of parameter files; None where there is none."""
        position = self._position(name)
        return None if position == NO_LIST else Tuple(tuple(map(_shown, self.lists[position])))

    def with_listed(self, name: str, value: Value | None) -> RosState:
        """Another list in the current scope, as Python code has made it; None: none."""
        position = NO_LIST if value is None else len(self.lists)
        scope = self.scopes[-1]
        scope = scope._replace(remaps=position) if name == REMAPS else scope._replace(parameters=position)
        lists = self.lists if value is None else (*self.lists, self._entries(name, value))
        return RosState((*self.scopes[:-1], scope), lists)

    def rewritten(self, name: str, value: Value) -> RosState:
        """Other items in the list that the current scope sees, in each scope that sees it."""
        position = self._position(name)
        if position == NO_LIST:
            return self.with_listed(name, value)
        return self._replace(lists=(*self.lists[:position], self._entries(name, value), *self.lists[position + 1 :]))

    def _position(self, name: str) -> int:
        scope = self.scopes[-1]
        return scope.remaps if name == REMAPS else scope.parameters

    def _entries(self, name: str, value: Value) -> tuple[ListedEntry, ...]:
        """The entries of a list that Python code made; those that it took from the list before are the same."""
        position = self._position(name)
        known = {} if position == NO_LIST else {_shown(entry): entry for entry in self.lists[position]}
        items = value.items if isinstance(value, Tuple) else (value,)
        return tuple(known.get(item) or read_entry(name, item) for item in items)


def _shown(entry: ListedEntry) -> Value:
    if isinstance(entry, Remap):
        return Tuple((entry.source, entry.target))
    return entry.path if isinstance(entry, GlobalFile) else Tuple((entry.name, entry.value))


def read_entry(name: str, value: Value) -> ListedEntry:
    """An item of one of the lists that Python code made. What cannot be read may be any rule, or any parameters."""
    pair = value.items if isinstance(value, Tuple) and len(value.items) == 2 else None
    if name == REMAPS:
        unknown = Unknown((Reason(Cause.ARGUMENT, name, NO_PLACE),), "str")
        return Remap(*(pair or (unknown, unknown)))
    if pair is not None:
        return GlobalParameter(*pair, NO_PLACE)
    return GlobalFile(value if is_text(value) else Unknown((Reason(Cause.ARGUMENT, name, NO_PLACE),), "str"), NO_PLACE)
