# SPDX-License-Identifier: Apache-2.0
"""Which parameters does a YAML file describe, from which generate_parameter_library makes a Python module?

    robot:                                   ->  ParameterLibrary("robot", (DescribedParameter("pid.rate", "double", default=0.1, line=3),))
      pid:
        rate: {type: double, default_value: 0.1}

What the generator refuses, and what is not understood here, raises `Malformed`: then there is no module.
"""

from __future__ import annotations

import ast
import keyword
import re
from types import MappingProxyType
from typing import Final

from rosward.location import Place
from rosward.records import NamedTuple
from rosward.source.yaml_nodes import Item, Malformed, read_yaml

MAP: Final = "__map_"
"""Begins the name of a group of which there is one for each text in a list, which is a parameter itself."""

Constant = bool | int | float | str | list["Constant"]

_KEYS: Final = frozenset(
    {"default_value", "description", "read_only", "additional_constraints", "validation", "type"}
)  # fmt: skip
_TYPES: Final = MappingProxyType({"bool": (bool,), "double": (float, int), "int": (int,), "string": (str,)})
_FIXED: Final = re.compile(r"(string|(?:double|int|string)_array)_fixed_(\d{1,9})")
_ARITY: Final = MappingProxyType(
    {
        "lt": 1, "gt": 1, "lt_eq": 1, "gt_eq": 1, "not_empty": 0, "one_of": 1, "unique": 0, "subset_of": 1, "fixed_size": 1, "size_gt": 1,
        "size_lt": 1, "element_bounds": 2, "lower_element_bounds": 1, "upper_element_bounds": 1, "bounds": 2,
    }
)  # fmt: skip
_MOST: Final = 1_500
_LONGEST: Final = 1_000
_LARGEST: Final = 1 << 63
_OWN_NAME: Final = "custom_validators::"


class Check(NamedTuple):
    """One validation: the name of a rule, or, with `own`, of a function of the package; and its arguments."""

    name: str
    arguments: tuple[Constant, ...]
    own: bool = False


class DescribedParameter(NamedTuple):
    """One parameter: its path with dots, its type without what fixes its size, its default (None: it has none)."""

    name: str
    type: str
    default: Constant | None
    read_only: bool
    checks: tuple[Check, ...]
    line: int

    @property
    def parts(self) -> list[str]:
        """The names that its path consists of."""
        return self.name.split(".")


class ParameterLibrary(NamedTuple):
    """What a file describes: the name of the class that is imported, its groups (paths with dots) and its parameters, as they stand in it."""

    name: str
    groups: tuple[tuple[str, int], ...]
    parameters: tuple[DescribedParameter, ...]
    line: int


def read_parameters(text: str, file: str) -> ParameterLibrary:
    """What a file describes. Raises `Malformed`."""
    root = read_yaml(text, file)
    whole = root.mapping()
    if len(whole) != 1:
        raise Malformed("such a file must have exactly one name at the top", root.place)
    ((name, inside),) = whole.items()
    _identifier(name, inside.named)
    groups: list[tuple[str, int]] = []
    found: list[DescribedParameter] = []
    if not _is_group(inside):
        raise Malformed("expected a group of parameters here", inside.place)
    _read(inside, "", groups, found)
    return ParameterLibrary(name, tuple(groups), tuple(found), inside.named.line)


def _is_group(item: Item) -> bool:
    """Whether a mapping is a group, by what stands first in it; else it describes a parameter."""
    inside = item.mapping()
    if not inside:
        raise Malformed("this is empty", item.place)
    return isinstance(next(iter(inside.values())).value, dict)


def _read(item: Item, above: str, groups: list[tuple[str, int]], found: list[DescribedParameter]) -> None:
    for key, inner in item.mapping().items():
        if not isinstance(inner.value, dict):
            continue  # the generator passes over it
        _identifier(key, inner.named)
        name = f"{above}.{key}" if above else key
        if len(name) > _LONGEST or len(found) + len(groups) > _MOST:
            raise Malformed("the file is too large", inner.named)
        if _is_group(inner):
            groups.append((name, inner.named.line))
            _read(inner, name, groups, found)
        else:
            parameter = _parameter(name, inner)
            if parameter is not None:
                found.append(parameter)


def _identifier(name: str, place: Place) -> None:
    hidden = name.startswith("__") and not name.startswith(MAP) and not name.endswith("__")
    if not name.isidentifier() or keyword.iskeyword(name) or hidden:
        raise Malformed(f"{name[:100]!r} cannot be a name in the generated module", place)


def _parameter(name: str, item: Item) -> DescribedParameter | None:
    inside = item.mapping(_KEYS)
    if MAP in name.rpartition(".")[2]:
        raise Malformed(f"parameter {name} is named like a group of entries", item.named)
    if "type" not in inside:
        raise Malformed(f"parameter {name} has no type", item.named)
    declared = inside["type"].text()
    if declared == "none":
        return None
    fixed = _FIXED.fullmatch(declared)
    type_ = fixed[1] if fixed else declared
    base, array, rest = type_.partition("_array")
    if base not in _TYPES or rest:
        raise Malformed(f"parameter {name} has an unknown type: {declared[:100]}", inside["type"].place)
    default = inside.get("default_value")
    value = None if default is None or default.value is None else _default(default, base, array=bool(array))
    flag = inside.get("read_only")
    checks = list(_checks(inside["validation"]) if "validation" in inside else ())
    if fixed:
        checks.append(Check("size_lt", (int(fixed[2]) + 1,)))
    return DescribedParameter(name, type_, value, flag is not None and bool(flag.value), tuple(checks), item.named.line)


def _default(item: Item, base: str, *, array: bool) -> Constant:
    if array:
        return [_default(each, base, array=False) for each in item.items()]
    value = _scalar(item)
    if not isinstance(value, _TYPES[base]) or (base != "bool" and isinstance(value, bool)):
        raise Malformed(f"expected a value of type {base} here", item.place)
    if base == "double":
        return float(value)
    return value


def _scalar(item: Item) -> Constant:
    """A scalar as the generated module has it."""
    value = item.scalar()
    if isinstance(value, int) and not -_LARGEST <= value < _LARGEST:
        raise Malformed("the number is too large for a parameter", item.place)
    return _as_generated(value, item.place) if isinstance(value, str) else value


def _as_generated(text: str, place: Place) -> str:
    """A text as it comes back from the generated module, which has it between quotation marks as it is."""
    if '"' in text or "\n" in text or "\r" in text or "\0" in text:
        raise Malformed("no Python can be generated from a string with line breaks or quotation marks", place)
    if "\\" not in text:
        return text
    try:
        return str(ast.literal_eval(f'"{text}"'))
    except (SyntaxError, ValueError):
        raise Malformed("no Python can be generated from this string", place) from None


def _checks(item: Item) -> list[Check]:
    found = []
    for key, given in item.mapping().items():
        name = key.replace("<>", "")
        listed = given.value if isinstance(given.value, list) else [] if given.value is None else [given]
        arguments = tuple(_argument(each) for each in listed)
        if name.startswith(_OWN_NAME):
            function = name.removeprefix(_OWN_NAME)
            _identifier(function, given.named)
            found.append(Check(function, arguments, own=True))
        elif _ARITY.get(name) == len(arguments):
            found.append(Check(name, arguments))
        else:
            raise Malformed(f"no validation {name[:100]!r} with {len(arguments)} arguments is known", given.named)
    return found


def _argument(item: Item) -> Constant:
    if isinstance(item.value, list):
        return [_argument(each) for each in item.value]
    return _scalar(item)
