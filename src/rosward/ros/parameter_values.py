# SPDX-License-Identifier: Apache-2.0
"""Which type and value has a parameter that is written as YAML?

    parse_value("010")     -> integer 8
    parse_value("[1, 2]")  -> integer_array (1, 2)

Values are typed as by rcl_yaml_param_parser (parse.c), which is neither YAML 1.1 nor 1.2 nor PyYAML: `010` is octal
8, `08` the double 8.0, `1e400` a string, `null` a string, `y` a bool. PyYAML only splits the text
into events here; unlike libyaml it takes no tab within a plain scalar.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import Final

from rosward.holes import HOLE, Holed, with_stars
from rosward.records import NamedTuple

_TRUE: Final = frozenset(("Y", "y", "yes", "Yes", "YES", "true", "True", "TRUE", "on", "On", "ON"))
_FALSE: Final = frozenset(("N", "n", "no", "No", "NO", "false", "False", "FALSE", "off", "Off", "OFF"))
_INTEGER: Final = re.compile(r"\s*([+-]?)(?:0[xX]([0-9a-fA-F]+)|(0[0-7]*)|([1-9][0-9]*))", re.ASCII)
_DECIMAL: Final = re.compile(r"\s*[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?", re.ASCII)
_HEXADECIMAL: Final = re.compile(
    r"\s*[+-]?0[xX](?:[0-9a-fA-F]+\.?[0-9a-fA-F]*|\.[0-9a-fA-F]+)(?:[pP][+-]?[0-9]+)?", re.ASCII
)
_SPECIAL: Final = re.compile(r"\s*([+-]?)(?:(inf|infinity)|nan(?:\([0-9A-Za-z_]*\))?)", re.ASCII | re.IGNORECASE)
_DOTTED: Final = re.compile(r"(?:[+-]?\.(?:inf|Inf|INF)|\.(?:nan|NaN|NAN))")
_SMALLEST_NORMAL: Final = 2.0**-1022
_STRING_TAG: Final = "tag:yaml.org,2002:str"
_MAX_DIGITS: Final = 4000  # of an integer that is still converted as such, before it becomes a double anyway

# In this order the fields of rcl_variant_t are looked at, whichever was set last (rclpy node.cpp).
_PRECEDENCE: Final = (
    "bool",
    "integer",
    "double",
    "string",
    "byte_array",
    "bool_array",
    "integer_array",
    "double_array",
    "string_array",
)


class InvalidArgument(ValueError):  # noqa: N818 (it is a state of a word, caught and reported, not a crash)
    """A rule or value that rcl rejects; the message says why."""


class ParameterValue(NamedTuple):
    """A typed value. `type` is rcl's word: bool, integer, double, string, one of these with `_array`, or not_set.

    The empty list is not_set.     Arrays are tuples. `type` and `value` are None where a hole leaves both open.
    """

    type: str | None
    value: bool | int | float | str | tuple[bool | int | float | str, ...] | None


def scalar_value(text: str, *, quoted: bool = False, tag: str | None = None) -> ParameterValue:
    """The value of a YAML scalar as rcl types it (rcl_yaml_param_parser parse.c get_value); `quoted` by `'` or `"`.

    Of the tags only `!!str` has a meaning (none at all in humble).
    """
    if quoted or tag == _STRING_TAG:
        return ParameterValue("string", text)
    if text in _TRUE or text in _FALSE:
        return ParameterValue("bool", text in _TRUE)
    integer = _integer(text)
    if integer is not None:
        return ParameterValue("integer", integer)
    double = _double(text)
    return ParameterValue("string", text) if double is None else ParameterValue("double", double)


def _integer(text: str) -> int | None:
    """What C's strtoll with base 0 makes of the whole of `text`, None if it fails."""
    found = _INTEGER.fullmatch(text)
    if not found or len(text) > _MAX_DIGITS:
        return None
    sign, hexadecimal, octal, decimal = found.groups()
    size = int(hexadecimal, 16) if hexadecimal else int(octal, 8) if octal else int(decimal)
    value = -size if sign == "-" else size
    return value if -(2**63) <= value < 2**63 else None


def _double(text: str) -> float | None:
    """What C's strtod makes of the whole of `text`, None if it fails or sets errno (overflow, underflow)."""
    if _DOTTED.fullmatch(text):
        text = text.replace(".", "")
    special = _SPECIAL.fullmatch(text)
    if special:
        return float(f"{special[1]}{'inf' if special[2] else 'nan'}")
    try:
        if _DECIMAL.fullmatch(text):
            value = float(text)
        elif _HEXADECIMAL.fullmatch(text):
            value = float.fromhex(text.strip())
        else:
            return None
    except OverflowError:
        return None
    mantissa = re.split("[pP]" if "x" in text.lower() else "[eE]", text.lower().replace("0x", ""))[0]
    if abs(value) == float("inf") or (abs(value) < _SMALLEST_NORMAL and mantissa.strip("+-0. \t\n") != ""):
        return None
    return value


def effective_value(values: Iterable[ParameterValue]) -> ParameterValue:
    """Which of several values for one parameter and one node key holds: the last of its type, the types in rcl's order.

    rcl keeps one field for each type and looks at them in a fixed order, so `-p x:=1 -p x:=hello` is the integer 1 in
    either order, within one process's arguments and parameter files. `not_set` counts only if there is nothing else;
    an unknown value makes all unknown.
    """
    last = {value.type: value for value in values}
    if None in last:
        return last[None]
    return next((last[kind] for kind in _PRECEDENCE if kind in last), ParameterValue("not_set", None))


def parse_value(text: Holed) -> ParameterValue:
    """The value of `-p name:=text` (rcl_yaml_param_parser parse.c parse_value_events). Raises `InvalidArgument`."""
    try:
        return _parse_value(text)
    except InvalidArgument:
        if HOLE in text:
            return ParameterValue(None, None)
        raise


def _parse_value(text: Holed) -> ParameterValue:
    if not text:
        raise InvalidArgument("no value")
    import yaml  # it takes a while to load, and few programs come here

    known = text.replace(HOLE, "").strip()
    if known != text.strip() and (not known or scalar_value(known).type != "string"):
        return ParameterValue(None, None)  # `*`, `1*`: the hole decides the type
    found: list[ParameterValue] = []
    array: list[ParameterValue] | None = None
    try:
        for event in yaml.parse(text if HOLE in text else with_stars(text), Loader=yaml.SafeLoader):
            if isinstance(event, yaml.SequenceStartEvent):
                array = []
            elif isinstance(event, yaml.SequenceEndEvent):
                found.append(_array(array or []))
                array = None
            elif isinstance(event, yaml.ScalarEvent):
                quoted = event.style in ("'", '"')
                if not quoted and not event.value:
                    raise InvalidArgument("no value")
                value = scalar_value(event.value, quoted=quoted, tag=event.tag)
                (found if array is None else array).append(value)
            elif isinstance(event, (yaml.MappingStartEvent, yaml.AliasEvent)):
                raise InvalidArgument("a parameter must be a scalar or a list of scalars")
    except yaml.YAMLError as error:
        raise InvalidArgument("not YAML") from error
    return effective_value(found)


def _array(values: Sequence[ParameterValue]) -> ParameterValue:
    if not values:
        return ParameterValue("not_set", None)
    if len({value.type for value in values}) > 1:
        raise InvalidArgument("the items of a list must have one type")
    items = tuple(item for _, item in values if item is not None and not isinstance(item, tuple))
    return ParameterValue(f"{values[0].type}_array", items)
