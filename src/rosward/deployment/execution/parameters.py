# SPDX-License-Identifier: Apache-2.0
"""Which parameters is a node given: what `parameters=[…]` and <param> come to, as words of the command line and as content of files.

parameters=[{'rate': LaunchConfiguration('rate')}, 'a.yaml']
->  --params-file /tmp/launch_params_1 --params-file a.yaml,    /tmp/launch_params_1 being (Given('/**', 'rate', Const(10)),)

A dict is written into a file under the full name of the node, or under '/**' where launch does not know it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final, final

from rosward.deployment.execution.content import Content
from rosward.deployment.execution.perform_paths import normal_path
from rosward.deployment.execution.ros_state import GlobalFile, GlobalParameter
from rosward.deployment.execution.yaml_values import (
    Failed,
    as_rcl_reads,
    as_type,
    as_yaml,
    dumped,
    plain_text,
    printed,
    unknown,
)
from rosward.deployment.started import Setting
from rosward.deployment.tree import (
    Literal,
    ParameterArgument,
    ParameterData,
    ParameterFile,
    ParameterSource,
    ParameterTable,
    Several,
)
from rosward.domain.choice import lift, lift2, options, reasons_of
from rosward.domain.compound import Tuple
from rosward.domain.text import concat, readable
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Const, Unknown, Value
from rosward.effects.configuration import Given
from rosward.naming.command_line import type_word

if TYPE_CHECKING:
    from rosward.deployment.execution.scene import Scene
    from rosward.location import Place

_RULE: Final = Const("-p")
_FILE: Final = Const("--params-file")
_SCALARS: Final = (bool, int, float, str)


def evaluate(data: ParameterData, name: Value, scene: Scene, place: Place) -> Value:
    """The value of a parameter: text is read as YAML or as the type that is forced; a literal is used as it is."""

    def failed(why: str) -> None:
        scene.fails(f"the value of the parameter '{readable(name)}' is rejected: {why}", place)

    if isinstance(data, Literal):
        return lift(lambda v: _literal(v, failed), data.value)
    if isinstance(data, Several):
        items = tuple(evaluate(item, name, scene, place) for item in data.items)
        return lift(lambda v: _literal(v, failed), Tuple(items))
    text = scene.text(data.text)
    if data.type in (None, "yaml"):
        return as_yaml(text, failed, described=data.type == "yaml")
    return as_type(text, data.type or "str", failed)


def _literal(value: Value, failed: Failed) -> Value:
    if isinstance(value, Const):
        if not isinstance(value.value, (*_SCALARS, bytes)):
            failed(f"{value.value!r} is not a parameter value")
            return unknown(value)
        return value
    if isinstance(value, Tuple):
        return _list(value, failed)
    return value


def _list(value: Tuple, failed: Failed) -> Value:
    kinds = {item.value.__class__ for item in value.items if isinstance(item, Const)}
    known = all(isinstance(item, Const) for item in value.items)
    if known and kinds == {int, float}:
        items = [
            Const(float(i.value), i.origins)
            for i in value.items
            if isinstance(i, Const) and isinstance(i.value, (int, float))
        ]
        return Tuple(tuple(items))
    if len(kinds) > 1:
        failed("the items of a list must be of one type")
        return unknown(value, "list")
    return value


@final
class LaunchedParameters:
    """The parameters of one node, in the order of the command line."""

    def __init__(self, scene: Scene, scopes: tuple[str, ...], name: Value | None) -> None:
        self._scene = scene
        self._scopes = scopes
        self._name = name
        self.words: list[Value] = []
        self.files: dict[str, tuple[Given, ...] | None] = {}
        self.missing: dict[str, Reason] = {}
        self.settings: list[Setting] = []

    def add_global(self, entries: Sequence[GlobalParameter | GlobalFile]) -> None:
        """What SetParameter and SetParametersFromFile have set."""
        for entry in entries:
            if isinstance(entry, GlobalParameter):
                self.settings.append(Setting("global", readable(entry.name), entry.value, place=entry.place))
                self._rule(entry.name, printed(entry.value))
            elif entry.node is None or self._is_meant(entry.node):
                self._file(entry.path, entry.place, needed=True)

    def _is_meant(self, node: Value) -> bool:
        """Whether a file that is limited to a node may be for this one."""
        if self._name is None:
            return True
        known = plain_text(node), plain_text(self._name)
        return None in known or known[0] == known[1]

    def add(self, sources: Sequence[ParameterSource]) -> None:
        """What the node says itself."""
        for source in sources:
            if isinstance(source, ParameterTable):
                self._table(source)
            elif isinstance(source, ParameterFile):
                self._given_file(source)
            else:
                self._given_rule(source)

    def _table(self, table: ParameterTable) -> None:
        rows: dict[tuple[str, str], Given] = {}
        for key, data in table.entries:
            name = self._scene.text(key)
            value = evaluate(data, name, self._scene, table.place)
            read = self._read(value, name, table.place)
            for scope in self._scopes:
                for option in options(name):
                    shown = plain_text(option) or "*"
                    rows[scope, shown] = Given(scope, shown, read, table.place)
            self.settings.append(Setting("dict", readable(name), value, self._scopes[0], table.place))
        path = self._scene.generated.write(Content(tuple(rows.values())))
        self._pass(path, tuple(rows.values()))

    def _read(self, value: Value, name: Value, place: Place) -> Value:
        """A value as the node reads it from the file that launch writes: of a list [x, y] rcl takes `y` for a bool, and refuses the file."""

        def one(option: Value) -> Value:
            if not isinstance(option, Tuple) or not option.items or type_word(option) is not None:
                return option
            types = {type_word(item) for item in option.items}
            if None in types:
                return option
            why = f"rcl reads the items of the list '{readable(name)}' as {' and '.join(sorted(map(str, types)))}, and rejects that"
            self._scene.findings.tell("RW317", f"{why}: write them so that YAML reads them as one type.", place)
            return Unknown((Reason(Cause.ERROR, f"the parameter '{readable(name)}'", place),), "list")

        return lift(one, as_rcl_reads(value))

    def _given_rule(self, rule: ParameterArgument) -> None:
        name = self._scene.text(rule.name)
        value = evaluate(rule.data, name, self._scene, rule.place)
        self.settings.append(Setting("rule", readable(name), value, place=rule.place))
        self._rule(name, dumped(value))

    def _given_file(self, file: ParameterFile) -> None:
        path = normal_path(self._scene.text(file.path))
        if file.substitutions:
            self.settings.append(Setting("file", "", path, place=file.place))
            path = self._scene.generated.performed(self._scene, path, file.place)
            if all(self._scene.generated.content(o, file.place).absent for o in options(path)):
                return
            self._file(path, file.place, needed=False, told=True)
        else:
            self._file(path, file.place, needed=False)

    def _rule(self, name: Value, text: Value) -> None:
        self.words += [_RULE, lift2(lambda n, t: concat((n, Const(":="), t)), name, text)]

    def _pass(self, path: Value, rows: tuple[Given, ...] | None) -> None:
        self.words += [_FILE, path]
        self.files[readable(path)] = rows

    def _file(self, path: Value, place: Place, *, needed: bool, told: bool = False) -> None:
        """A file by its path. One that is not there is left out (`needed`: launch fails instead)."""
        contents = [(option, self._scene.generated.content(option, place)) for option in options(path)]
        for option, content in contents:
            if content.absent and not self._scene.generated.is_made(option):
                shown = self._scene.files.show(option)
                if needed:
                    self._scene.fails(f"the parameter file {shown} does not exist", place)
                else:
                    self._scene.findings.tell("RW315", f"The parameter file {shown} does not exist.", place)
        if not told:
            self.settings.append(Setting("file", "", path, place=place))
        if all(content.absent for _, content in contents):
            return
        self.words += [_FILE, path]
        for option, content in contents:
            word = readable(option)
            self.files[word] = () if content.absent else content.rows
            if content.rows is None and not content.absent:
                self.missing[word] = content.reason or _reason(option, place)


def _reason(path: Value, place: Place) -> Reason:
    found = reasons_of(path)
    return found[0] if found else Reason(Cause.FILE, readable(path), place)
