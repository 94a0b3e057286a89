# SPDX-License-Identifier: Apache-2.0
"""Which parameters does a parameter file give to which nodes?

    left:                                ->  Given('left/arm', 'rate', Const(10), line 4)
      arm:                                   Given('left/arm', 'pid.gains', Tuple((Const(1.0), Const(0.5))), line 6)
        ros__parameters:
          rate: 10
          pid:
            gains: [1.0, 0.5]

A file is read as rcl_yaml_param_parser reads it, which is no YAML loader but a machine that goes from event to event: keys are names of
namespaces and nodes until `ros__parameters`, then names of parameters. So an alias is refused wherever it stands, a mapping in the wrong
place ends more than itself, a list within a list replaces it, and a second document goes on where the first one ended. What rcl refuses is
RW317: the process ends when it starts, and nothing is given. Where distros differ (nodes beside `ros__parameters`, which older ones misread or
refuse), it is as in kilted.
"""

from __future__ import annotations

from bisect import insort
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Final, final

import yaml

from rosward.domain.compound import Tuple
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Const, Unknown
from rosward.effects.configuration import Given
from rosward.findings import Finding
from rosward.holes import literal
from rosward.location import Place
from rosward.ros.parameter_values import ParameterValue, effective_value, scalar_value
from rosward.ros.validation import validate_namespace, validate_node_name
from rosward.source import limits

_KEY: Final = "ros__parameters"
_WILDCARDS: Final = ("*", "**")
_VERSIONS: Final = (None, (1, 1))
_LOADER: Final = getattr(yaml, "CSafeLoader", yaml.SafeLoader)  # libyaml is what rcl has


def read_parameter_file(text: str, file: str) -> tuple[tuple[Given, ...], tuple[Finding, ...]]:
    """What the parameter file `file` gives, in rcl's order; with a finding RW317, rcl refuses it and nothing is given.

    The empty list, which sets a parameter to nothing, is an empty `Tuple`. A file beyond our limits may give anything (RW201).
    """
    reader = _Reader(file)
    line = 1
    try:
        for event in yaml.parse(text, Loader=_LOADER):
            mark = event.start_mark
            line = mark.line + 1 if mark is not None else line
            reader.take(event, Place(file, line, mark.column + 1 if mark is not None else 1))
    except _Refused as refused:
        return (), (_finding(str(refused), file, line),)
    except _TooMuch as limit:
        place = Place(file, line)
        anything = Unknown((Reason(Cause.LIMIT, file, place),))
        return (Given("/**", "*", anything, place),), (
            Finding("RW201", f"This parameter file was not read: {limit}.", place),
        )
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        what = getattr(error, "problem", None) or str(error).partition("\n")[0]
        return (), (_finding(f"not YAML ({what})", file, line if mark is None else mark.line + 1),)
    except (ValueError, RecursionError):
        return (), (_finding("not YAML", file, line),)
    return reader.given(), ()


def _finding(why: str, file: str, line: int) -> Finding:
    return Finding("RW317", f"rcl rejects this parameter file: {why}.", Place(file, line))


class _Refused(Exception):  # noqa: N818  it is what rcl does, caught and reported
    """rcl ends with an error here; the message completes "rcl refuses this parameter file: "."""


class _TooMuch(Exception):  # noqa: N818
    """A limit of ours; the message completes "This parameter file is not read: "."""


@final
@dataclass(slots=True)
class _TypedValues:
    """One parameter: rcl keeps a value for each type, whichever of them came last."""

    name: str
    place: Place
    nested: bool = False
    values: dict[str, tuple[list[ParameterValue], Place]] = field(default_factory=dict)

    def given(self, node: str) -> Iterator[Given]:
        """What is read of it: one for each type, since a later file may add another; the empty list leaves no value at all."""
        kinds = list(self.values)
        if self.nested and kinds:  # no later file adds to it
            kinds = [effective_value(ParameterValue(kind, None) for kind in kinds).type or ""]
        for kind in kinds:
            values, place = self.values[kind]
            items = tuple(Const(each.value) for each in values if not isinstance(each.value, tuple))
            value = Tuple(items) if kind.endswith("_array") else items[0]
            yield Given(node, self.name, value, place, nested=self.nested)
        if not kinds:
            yield Given(node, self.name, Tuple(()), self.place, nested=self.nested)


@final
class _ParametersOfNode:
    """The parameters of one node, in rcl's order: one is found by the first entry of its name."""

    def __init__(self) -> None:
        self.entries: list[_TypedValues] = []
        self._positions: dict[str, list[int]] = {}

    def find(self, name: str, place: Place) -> int:
        """The position of the entry of that name, made if there is none."""
        known = self._positions.setdefault(name, [])
        if not known:
            known.append(len(self.entries))
            self.entries.append(_TypedValues(name, place))
        return known[0]

    def rename(self, position: int, name: str, place: Place) -> None:
        """Give an entry another name, even one that an entry before it has."""
        entry = self.entries[position]
        self._positions[entry.name].remove(position)
        insort(self._positions.setdefault(name, []), position)
        entry.name, entry.place, entry.nested = name, place, True


@final
@dataclass(slots=True)
class _KeyPath:
    """The keys above the present one, as one text; `depth` counts keys, although one may hold several names."""

    separator: str
    text: str = ""
    depth: int = 0

    def push(self, name: str) -> None:
        glue = "" if not self.depth or self.text.endswith(self.separator) else self.separator
        self.text = f"{self.text if self.depth else ''}{glue}{name}"
        self.depth += 1
        if len(self.text) > limits.PARAMETER_NAME:
            raise _TooMuch("its keys are too long")

    def pop(self) -> None:
        if self.depth > 1 and self.separator in self.text:
            self.text = self.text.rpartition(self.separator)[0]
        self.depth = max(0, self.depth - 1)


@final
class _Reader:
    """rcl's machine in the course of reading one file."""

    def __init__(self, file: str) -> None:
        self._place = Place(file)
        self._nodes: dict[str, _ParametersOfNode] = {}
        self._keys = 0
        self._lists = 0
        self._node = ""
        self._position = 0  # of the parameter at hand; a node that is begun anew does not reset it
        self._node_names = _KeyPath("/")
        self._names = _KeyPath(".")
        self._level = 1  # 1: names of nodes, 2: parameters
        self._depth = 0
        self._is_key = True
        self._is_new_mapping = False
        self._array: list[ParameterValue] | None = None

    def given(self) -> tuple[Given, ...]:
        """All that was read, in rcl's order."""
        return tuple(
            given for node, known in self._nodes.items() for entry in known.entries for given in entry.given(node)
        )

    def take(self, event: yaml.Event, place: Place) -> None:
        """Go one event further."""
        self._place = place
        match event:
            case yaml.ScalarEvent() if self._is_key:
                self._key(event.value)
                self._is_key = False
            case yaml.ScalarEvent():
                self._value(event)
                self._is_key = self._array is None
            case yaml.SequenceStartEvent():
                if self._is_key:
                    raise _Refused("a list is in place of a name")
                if self._level < 2:
                    raise _Refused(f"a list comes before {_KEY}")
                self._lists += 1
                if self._lists > limits.PARAMETER_NESTING:
                    raise _TooMuch("its lists are nested too deeply")
                self._array = []
            case yaml.SequenceEndEvent():
                self._array, self._is_key = None, True
                self._lists -= 1
            case yaml.MappingStartEvent():
                self._depth += 1
                outermost = self._level == 2 and self._depth - self._node_names.depth == 2
                self._is_new_mapping, self._is_key = not outermost, True
            case yaml.MappingEndEvent():
                self._end_mapping()
            case yaml.AliasEvent():
                raise _Refused("it has an alias")
            case yaml.DocumentStartEvent() if event.version not in _VERSIONS:
                raise _Refused(f"rcl does not support YAML {'.'.join(map(str, event.version))}")
            case _:
                pass

    def _end_mapping(self) -> None:
        if self._level == 2 and self._names.depth:
            self._names.pop()
        elif self._level == 2:
            self._level = 1
        elif self._level == 1 and self._depth == self._node_names.depth + 1:
            self._node_names.pop()
        self._depth -= 1

    def _key(self, name: str) -> None:
        if not name:
            raise _Refused("a name is empty")
        if self._level == 2:
            self._parameter(name)
        elif not name.startswith(_KEY):
            self._node_names.push(name)
        else:
            if not self._node_names.depth:
                raise _Refused(f"there is no node name before {_KEY}")
            self._node = self._node_names.text
            why = _wrong_node_key(self._node)
            if why is not None:
                raise _Refused(f"{self._node[:100]!r} is not a valid node name: {why}")
            self._nodes.setdefault(self._node, _ParametersOfNode())
            self._level = 2

    def _parameter(self, name: str) -> None:
        self._keys += 1
        if self._keys > limits.PARAMETER_KEYS:
            raise _TooMuch("it has too many parameters")
        parameters = self._nodes[self._node]
        if self._is_new_mapping:
            if self._position >= len(parameters.entries):
                raise _Refused("a mapping comes where there is no parameter yet")
            # what was taken for a parameter was the first part of the names in this mapping
            self._names.text, self._names.depth = parameters.entries[self._position].name, self._names.depth + 1
            self._is_new_mapping = False
        if not self._names.depth:
            self._position = parameters.find(name, self._place)
            return
        self._position = parameters.find(self._names.text, self._place)
        nested = f"{self._names.text}.{name}"
        if len(nested) > limits.PARAMETER_NAME:
            raise _TooMuch("its names are too long")
        parameters.rename(self._position, nested, self._place)

    def _value(self, event: yaml.ScalarEvent) -> None:
        parameters = self._nodes.get(self._node)
        if self._level < 2 or parameters is None or not parameters.entries:
            raise _Refused(f"a value comes before {_KEY}")
        quoted = event.style in ("'", '"')
        if not quoted and not event.value:
            raise _Refused("a parameter has no value")
        if self._position >= len(parameters.entries):
            raise _Refused("a value comes where there is no parameter yet")
        value = scalar_value(event.value, quoted=quoted, tag=event.tag)
        kind = value.type or ""
        if self._array is not None:
            kind += "_array"
            if self._array and self._array[0].type != value.type:
                raise _Refused("the items of a list must have one type")
            self._array.append(value)
            if len(self._array) > 1:
                return
        parameters.entries[self._position].values[kind] = self._array or [value], self._place


def _wrong_node_key(key: str) -> str | None:
    """Why `key` cannot name nodes; each part may be a wildcard, but hold none."""
    namespace, _, name = key.rpartition("/")
    for part in namespace.removeprefix("/").split("/") if namespace else ():
        if part not in _WILDCARDS:
            why = "it has an empty part" if not part else _with_star(part) or validate_namespace(literal(f"/{part}"))
            if why is not None:
                return why
    return None if name in _WILDCARDS else _with_star(name) or validate_node_name(literal(name))


def _with_star(part: str) -> str | None:
    return "a wildcard must be a whole name" if "*" in part else None
