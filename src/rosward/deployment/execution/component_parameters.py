# SPDX-License-Identifier: Apache-2.0
"""Which parameters does launch put into the request that loads a component?

ComposableNode(name='cam', parameters=['a.yaml', {'rate': 10}])    ->    one list of values, in that order; a later one wins

Other than with a process, launch itself reads the files: what stands under the full name of the component or under /** counts, other
wildcards do not. The result is shown as a file for all nodes, since the component is the only one that gets it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final, final

from rosward.deployment.execution.component_files import read_as_launch
from rosward.deployment.execution.content import Content
from rosward.deployment.execution.namespaces import full_name
from rosward.deployment.execution.parameters import evaluate
from rosward.deployment.execution.perform_paths import normal_path
from rosward.deployment.execution.rewrites import key_path
from rosward.deployment.execution.ros_state import GlobalFile, GlobalParameter
from rosward.deployment.execution.yaml_values import plain_text
from rosward.deployment.started import Setting
from rosward.deployment.tree import ParameterFile, ParameterSource, ParameterTable
from rosward.domain.choice import join, options, reasons_of
from rosward.domain.compound import Tuple
from rosward.domain.text import matches, readable
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Const, Unknown, Value
from rosward.effects.configuration import Given
from rosward.location import Place
from rosward.naming.command_line import type_word

if TYPE_CHECKING:
    from rosward.deployment.execution.scene import Scene

_ALL: Final = "/**"
_NOWHERE: Final = Place("", 0)


@final
class ComponentParameters:
    """The parameters of one component, the last value of each name."""

    def __init__(self, scene: Scene, namespace: Value | None, name: Value | None) -> None:
        self._scene = scene
        self._full = full_name(namespace, name) or name
        self._rows: dict[str, Given] = {}
        self.settings: list[Setting] = []

    def add_global(self, entries: Sequence[GlobalParameter | GlobalFile]) -> None:
        """What SetParameter and SetParametersFromFile have set."""
        for entry in entries:
            if isinstance(entry, GlobalParameter):
                self.settings.append(Setting("global", readable(entry.name), entry.value, place=entry.place))
                self._set(entry.name, entry.value, entry.place)
            else:
                self._file(entry.path, entry.place)

    def add(self, sources: Sequence[ParameterSource]) -> None:
        """What the component says itself."""
        for source in sources:
            if isinstance(source, ParameterTable):
                for key, data in source.entries:
                    name = self._scene.text(key)
                    value = evaluate(data, name, self._scene, source.place)
                    self._set(name, value, source.place)
                    self.settings.append(Setting("dict", readable(name), value, _ALL, source.place))
            elif isinstance(source, ParameterFile):
                path = normal_path(self._scene.text(source.path))
                if source.substitutions:
                    path = self._scene.generated.performed(self._scene, path, source.place)
                self._file(path, source.place)
            else:
                self._scene.fails("a component does not accept a Parameter description", source.place)

    def _set(self, name: Value, value: Value, place: Place) -> None:
        several = len(options(name)) > 1
        for option in options(name):
            shown = plain_text(option) or "*"
            old = self._rows.pop(shown, None)
            held = join(old.value, value) if old is not None and (several or shown == "*") else value
            self._rows[shown] = Given(_ALL, shown, held, place)

    def _file(self, path: Value, place: Place) -> None:
        self.settings.append(Setting("file", "", path, place=place))
        several = len(options(path)) > 1
        for option in options(path):
            content = self._content(option, place)
            if content.absent:
                self._scene.fails(f"the parameter file {self._scene.files.show(option)} does not exist", place)
            elif content.rows is None:
                reason = content.reason or Reason(Cause.FILE, readable(option), place)
                self._unknown_rest((*reasons_of(option), reason)[-1])
            else:
                self._from_rows(content.rows, several)

    def _content(self, path: Value, place: Place) -> Content:
        """What is behind a path, as launch reads it where its whole text is known; rcl tells where each value stands."""
        content = self._scene.generated.content(path, place, as_text=True)
        rows = (
            read_as_launch(content.text, content.file)
            if content.text is not None and content.rows is not None
            else None
        )
        if rows is None:
            return self._scene.generated.content(path, place)
        places = {(key_path(row.node), row.name): row.place for row in content.rows or ()}
        placed = (row._replace(place=places.get((key_path(row.node), row.name), row.place)) for row in rows)
        return content._replace(rows=tuple(placed))

    def _checked(self, row: Given) -> Value:
        """A value that launch accepts: a list has items, all of one type."""
        value = row.value
        empty = isinstance(value, Const) and value.value is None
        if not empty and not (
            isinstance(value, Tuple) and len({type_word(i) for i in value.items if isinstance(i, Const)}) != 1
        ):
            return value
        place = row.place or _NOWHERE
        self._scene.fails(
            f"the value of the parameter '{row.name}' is rejected: it is empty, or a list of several types", place
        )
        return Unknown((Reason(Cause.ERROR, f"the parameter '{row.name}'", place),))

    def _unknown_rest(self, reason: Reason) -> None:
        """A file that is not known may set any parameter, also those that were set before."""
        for shown, row in self._rows.items():
            self._rows[shown] = row._replace(value=join(row.value, Unknown((reason,))))
        self._rows.setdefault("*", Given(_ALL, "*", Unknown((reason,)), reason.place))

    def _from_rows(self, rows: Sequence[Given], several: bool) -> None:
        general = [row for row in rows if key_path(row.node) == "**"]
        own = [row for row in rows if key_path(row.node) != "**"]
        for row in (*general, *own):
            sure = True if key_path(row.node) == "**" else self._is_mine(row.node)
            if sure is False:
                continue
            old = self._rows.pop(row.name, None)
            doubtful = several or sure is None
            own_value = self._checked(row)
            value = join(old.value, own_value) if old is not None and doubtful else own_value
            self._rows[row.name] = Given(_ALL, row.name, value, row.place)

    def _is_mine(self, node: str) -> bool | None:
        """Whether a key is the full name of the component; None where that is not known."""
        if self._full is None:
            return False
        path = key_path(node)
        fits = [
            key_path(plain) == path if (plain := plain_text(option)) is not None else None
            for option in options(self._full)
        ]
        if any(fit is None for fit in fits):
            unknown = [o for o in options(self._full) if plain_text(o) is None]
            may = any(matches(o, f"/{path}") or matches(o, path) for o in unknown)
            return None if may or True in fits else False
        if all(fits):
            return True
        return None if any(fits) else False

    def write(self, words: list[Value]) -> dict[str, tuple[Given, ...] | None]:
        """The values as a parameter file behind `words`; nothing where there are none."""
        if not self._rows:
            return {}
        rows = tuple(self._rows.values())
        path = self._scene.generated.write(Content(rows))
        words += [Const("--params-file"), path]
        return {readable(path): rows}
