# SPDX-License-Identifier: Apache-2.0
"""The `parameters=[…]` of nodes as launch_ros reads them: what is text for YAML, what is a value, what is a path.

[{'rate': 10, 'frame': LaunchConfiguration('frame'), 'a': {'b': 'true'}}, 'params.yaml']
->  ParameterTable(rate: Literal(10), frame: Typed(var frame), a.b: Literal('true')), ParameterFile('params.yaml')
"""

from __future__ import annotations

from typing import Final, final

from rosward.deployment.python.objects import Objects, SequenceItem
from rosward.deployment.python.substitutions import Texts
from rosward.deployment.tree import (
    Literal,
    ParameterArgument,
    ParameterData,
    ParameterFile,
    ParameterSource,
    ParameterTable,
    Several,
    Substitution,
    Template,
    Typed,
)
from rosward.domain.choice import join, options
from rosward.domain.compound import External, Native, Tuple
from rosward.domain.values import NONE, Const, Ref, Text, Unknown, Value
from rosward.location import Place

_VALUE: Final = "launch_ros.parameter_descriptions.ParameterValue"
_RULE: Final = "launch_ros.parameter_descriptions.Parameter"
_LIST: Final = "List[…]"
_FILE: Final = "launch_ros.parameter_descriptions.ParameterFile"
_DEEPEST: Final = 20
_MOST: Final = 5_000


@final
class ParameterReader:
    """Reads parameters."""

    def __init__(self, objects: Objects, texts: Texts) -> None:
        self.objects = objects
        self.texts = texts

    def sources(self, value: Value | None, place: Place) -> tuple[ParameterSource, ...]:
        """The value of `parameters` (or `extra_arguments`)."""
        if value is None or value == NONE:
            return ()
        if self.objects.is_dict(value) or self.objects.is_text(value):
            self.objects.tell("RW320", "launch_ros requires a list of parameters here", place)
            return self._source(SequenceItem(value), place)
        return tuple(s for e in self.objects.elements(value) for s in self._source(e, place))

    def _source(self, element: SequenceItem, place: Place) -> tuple[ParameterSource, ...]:
        value = element.value
        if not element.sure:
            return (self._anything(value, place, "parameters that may be set"),)
        if self.objects.is_dict(value):
            assert isinstance(value, Ref)
            return self._table(value, place)
        kind = self.objects.kind(value)
        if kind == _RULE:
            assert isinstance(value, Ref)
            return (self.rule(value, place),)
        if kind == _FILE:
            assert isinstance(value, Ref)
            return (self.file(value),)
        if len(options(value)) > 1 and not self.objects.is_text(value):
            return (self._anything(value, place, "one of several parameter sources"),)
        return (ParameterFile(self.texts.template(value, place), place),)

    def _anything(self, value: Value, place: Place, why: str) -> ParameterFile:
        """Parameters of which nothing is known."""
        return ParameterFile((value if isinstance(value, Unknown) else self.objects.unknown(why, place),), place)

    def file(self, ref: Ref) -> ParameterFile:
        """A ParameterFile object."""
        place = self.objects.place(ref)
        allow = self.objects.field(ref, "allow_substs")
        path = self.texts.template(self.objects.field(ref, "path"), place)
        if isinstance(allow, Const) and isinstance(allow.value, bool):
            return ParameterFile(path, place, allow.value)
        switch = self.texts.template(allow, place)
        return ParameterFile((Substitution("parameter-file", (path, switch), place),), place, True)

    def rule(self, ref: Ref, place: Place) -> ParameterArgument:
        """A Parameter object."""
        made = self.objects.place(ref)
        here = made if made.file else place
        name = self.texts.template(self.objects.field(ref, "name"), here)
        return ParameterArgument(name, self._described(ref, here), here)

    def named(self, name: Template, value: Value, place: Place) -> tuple[ParameterSource, ...]:
        """One parameter, or those of a dict, whose names begin with this one."""
        if self.objects.is_dict(value):
            assert isinstance(value, Ref)
            return self._table(value, place, name)
        return (ParameterTable(((name, self.data(value, place)),), place),)

    def _table(self, ref: Ref, place: Place, prefix: Template = ()) -> tuple[ParameterSource, ...]:
        entries: list[tuple[Template, ParameterData]] = []
        whole = self._flatten(ref, prefix, place, entries, 0)
        table = ParameterTable(tuple(entries), place)
        if whole:
            return (table,)
        return table, self._anything(NONE, place, "entries of a dict")

    def _flatten(
        self, ref: Ref, prefix: Template, place: Place, entries: list[tuple[Template, ParameterData]], depth: int
    ) -> bool:
        """Add the entries of a dict by dotted names; False where there may be more that are not known."""
        obj = self.objects.machine.obj(ref)
        open_ = depth < _DEEPEST and len(entries) < _MOST
        whole = obj.rest is None and open_
        for key, value in obj.entries.items() if open_ else ():
            name = (
                (*prefix, Const("."), *self.texts.template(key, place)) if prefix else self.texts.template(key, place)
            )
            if self.objects.is_dict(value) and key not in obj.maybe:
                assert isinstance(value, Ref)
                whole = self._flatten(value, name, place, entries, depth + 1) and whole
            elif any(self.objects.is_dict(o) for o in options(value)):
                whole = False
            elif key in obj.maybe:
                unknown = self.objects.unknown("parameter that may be set", place, "")
                known = value if _is_plain(value) else unknown
                entries.append((name, Literal(join(known, unknown))))
            else:
                entries.append((name, self.data(value, place)))
        return whole

    def data(self, value: Value, place: Place) -> ParameterData:
        """One value."""
        if _is_plain(value):
            return Literal(value)
        if len(options(value)) > 1:
            if all(self.objects.is_text(o) or self.texts.is_substitution(o) for o in options(value)):
                return Typed(self.texts.template(value, place))
            return Literal(self._joined(value, place))
        if value == NONE:
            self.objects.tell("RW320", "launch_ros does not accept None as a parameter value", place)
            return Literal(self.objects.unknown("None", place, ""))
        if self.objects.kind(value) == _VALUE:
            assert isinstance(value, Ref)
            return self._described(value, place)
        if self.texts.is_substitution(value):
            return Typed(self.texts.template(value, place))
        if self.objects.is_sequence(value) and not self.objects.is_dict(value):
            return self._array(value, place)
        return Literal(self.objects.unknown("value of a parameter", place, ""))

    def _joined(self, value: Value, place: Place) -> Value:
        unknown = self.objects.unknown("one of several values of a parameter", place, "")
        found: Value = unknown
        for option in options(value):
            if _is_plain(option):
                found = join(found, option)
        return found

    def _array(self, value: Value, place: Place, *, described: bool = False) -> ParameterData:
        """A list; only one that a ParameterValue describes may be empty."""
        elements = self.objects.elements(value)
        if not all(e.sure for e in elements):
            return Literal(self.objects.unknown("list of unknown length", place, ""))
        if not elements and not described:
            self.objects.tell("RW320", "launch_ros does not accept an empty list as a parameter value", place)
            return Literal(Tuple(()))
        items = [e.value for e in elements]
        if all(_is_plain(i) for i in items):
            return _plain_array(items)
        if all(self.objects.is_text(i) or self.texts.is_substitution(i) for i in items):
            return Typed(self.texts.template(value, place))
        return Several(tuple(self._element(i, place) for i in items))

    def _element(self, value: Value, place: Place) -> ParameterData:
        """An element of a list that has lists of substitutions in it: each of them is one text."""
        if _is_plain(value):
            return Literal(value)
        return Typed(self.texts.template(value, place))

    def _described(self, ref: Ref, place: Place) -> ParameterData:
        """ParameterValue(value, value_type=…), and the value of a Parameter."""
        made = self.objects.place(ref)
        here = made if made.file else place
        value = self.objects.field(ref, "value") or NONE
        wanted = self._type(self.objects.field(ref, "value_type"))
        if value == NONE:
            return self.data(value, here)
        if self._is_scalar(value):
            if wanted is not None and not all(_is_of(o, wanted) for o in options(value)):
                self.objects.tell("RW320", f"the value is not of the type {wanted} that value_type requires", here)
            return Literal(value)
        if self.objects.is_sequence(value):
            found = self._array(value, here, described=True)
            return found._replace(type=wanted) if isinstance(found, Typed) else found
        return Typed(self.texts.template(value, here), wanted or "yaml")

    def _is_scalar(self, value: Value) -> bool:
        """Whether a value is no substitution: it is used as it is, text is not read as YAML."""
        return _is_plain(value) and not any(isinstance(o, Unknown) for o in options(value))

    def _type(self, value: Value | None) -> str | None:
        """The name of a type: `str`; `List[…]` for `list[int]` and `List[int]`, of which nobody keeps what is in the brackets."""
        if isinstance(value, Native):
            name = value.name.removeprefix("builtins.")
            return _LIST if name == "list" else name
        if isinstance(value, External):
            return value.name.rpartition(".")[2]
        return None


def _is_of(value: Value, wanted: str) -> bool:
    """Whether a scalar is of the type that value_type names."""
    name = type(value.value).__name__ if isinstance(value, Const) else "str"
    return name == wanted or (name, wanted) == ("bool", "int")


def _is_plain(value: Value) -> bool:
    """Whether a value (each alternative of it) is a bool, a number, a text, or unknown."""
    return all(isinstance(o, (Text, Unknown)) or (isinstance(o, Const) and o.value is not None) for o in options(value))


def _plain_array(items: list[Value]) -> ParameterData:
    """A list without substitutions: numbers become float together."""
    kinds = {type(o.value) if isinstance(o, Const) else str for i in items for o in options(i)}
    if kinds == {int, float}:
        items = [
            Const(float(i.value), i.origins) if isinstance(i, Const) and isinstance(i.value, (int, float)) else i
            for i in items
        ]
    return Literal(Tuple(tuple(items)))
