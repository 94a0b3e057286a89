# SPDX-License-Identifier: Apache-2.0
"""Which value does a text stand for, where launch reads it as YAML?

'true' -> True      '1' -> 1      '[1, 2]' -> (1, 2)      'robot_*' (a part unknown) -> the text
'10' as float -> 10.0             '1' as bool -> True

Read as PyYAML's safe_load does it, since that is what launch calls; values keep the origins of their text.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

import yaml

from rosward.domain.choice import lift, reasons_of
from rosward.domain.compound import Tuple
from rosward.domain.text import concat, is_path, make, origins_of, parts_of
from rosward.domain.unknown import Cause, Origins, Reason
from rosward.domain.values import Choice, Const, Hole, Text, Unknown, Value
from rosward.holes import literal
from rosward.location import Place
from rosward.records import NamedTuple
from rosward.ros.parameter_values import InvalidArgument, parse_value
from rosward.source import limits

_MOST_ITEMS: Final = 10_000
_MOST_BITS: Final = 4_096
_SCALARS: Final = (bool, int, float, str)
_INDICATORS: Final = frozenset("[]{}#&*!|>%@`'\",")
_NOWHERE: Final = Place("", 0)

Failed = Callable[[str], None]
"""Told once for each text that the real launch refuses, with the reason."""


class Loaded(NamedTuple):
    """What YAML made of a text: a scalar or a list of them; `error` says why neither."""

    value: object
    error: str = ""


def load_yaml(text: str) -> Loaded:
    """`yaml.safe_load`, without exceptions, and bounded: in depth, and in what aliases make of it."""
    if len(text) > limits.YAML_TEXT:
        return Loaded(text)
    try:
        if not _is_flat(text):
            return Loaded(None, "it is nested too deeply")
        found = yaml.safe_load(text)
    except yaml.YAMLError:
        return Loaded(None, "it is not YAML")
    except (ValueError, OverflowError, RecursionError, KeyError, AttributeError, TypeError):
        return Loaded(None, "it is not YAML")
    return Loaded(found) if _is_bounded(found) else Loaded(None, "it is too large")


def _is_flat(text: str) -> bool:
    """Whether collections are nested no deeper than we read: the time that a loader takes for them grows with the square."""
    if (
        text.count("[") + text.count("{") + text.count("- ") + text.count("? ") + text.count("\n")
        <= limits.YAML_TEXT_DEPTH
    ):
        return True
    depth = 0
    for event in yaml.parse(text, Loader=yaml.SafeLoader):
        if isinstance(event, yaml.CollectionStartEvent):
            depth += 1
            if depth > limits.YAML_TEXT_DEPTH:
                return False
        elif isinstance(event, yaml.CollectionEndEvent):
            depth -= 1
    return True


def _is_bounded(found: object) -> bool:
    """Whether a value is small when each alias is written out; one that holds itself is not."""
    work = [found]
    count = 0
    while work:
        count += 1
        each = work.pop()
        if count > _MOST_ITEMS or (isinstance(each, int) and each.bit_length() > _MOST_BITS):
            return False
        if isinstance(each, dict):
            work += each
            work += each.values()
        elif isinstance(each, (list, tuple, set)):
            work += each
    return True


def is_same_path(one: Value, other: Value) -> bool | None:
    """Whether two texts are the same path below the folder of a package or of the sources; None where that is not known."""
    if not is_path(one) or not is_path(other):
        return None
    (first, *rest), (second, *others) = parts_of(one), parts_of(other)
    if not all(isinstance(part, str) for part in (*rest, *others)):
        return None
    roots = [{(r.cause, r.subject) for r in hole.reasons} for hole in (first, second) if isinstance(hole, Hole)]
    return rest == others if len(roots[0]) == 1 and roots[0] == roots[1] else None


def as_yaml(text: Value, failed: Failed, *, described: bool = False) -> Value:
    """The value of a parameter whose text is performed: bool, int, float, str or a list of one of them.

    `described`: by a ParameterValue, as those of markup are, which may be an empty list.
    """

    def one(option: Value) -> Value:
        plain = plain_text(option)
        if plain is None:
            return _with_hole(option)
        loaded = load_yaml(plain) if plain else Loaded("")
        if loaded.error or not (_is_uniform(loaded.value) or (described and loaded.value == [])):
            failed(loaded.error or f"{_quoted(plain)} is neither a scalar nor a list of values of one type")
            return unknown(option)
        return value_of(loaded.value, origins_of(option))

    return lift(one, text)


def as_type(text: Value, kind: str, failed: Failed) -> Value:
    """The value of a text with a forced type: str, int, float, bool, yaml, or `List[…]` of one."""

    def one(option: Value) -> Value:
        if kind == "str":
            return option
        plain = plain_text(option)
        if plain is None:
            return Unknown(reasons_of(option), "" if kind == "yaml" else "list" if kind.startswith("List") else kind)
        try:
            return value_of(_coerced(plain, kind), origins_of(option))
        except ValueError:
            failed(f"{_quoted(plain)} is not of type {kind}")
            return unknown(option)

    return lift(one, text)


def _coerced(text: str, kind: str) -> object:
    """What launch's `coerce_to_type` gives. Raises ValueError."""
    if kind in ("int", "float"):
        return int(text) if kind == "int" else float(text)
    if kind == "bool" and text in ("0", "1"):
        return text == "1"
    loaded = load_yaml(text) if text else Loaded("")
    if loaded.error:
        raise ValueError(loaded.error)
    found = loaded.value
    if kind.startswith("List["):
        inner = {"int": int, "float": float, "bool": bool, "str": str}.get(kind[5:-1])
        if not isinstance(found, list) or (inner and not all(isinstance(x, inner) for x in found)):
            raise ValueError(kind)
    elif kind == "bool" and not isinstance(found, bool):
        raise ValueError(kind)
    if not isinstance(found, (*_SCALARS, list)):
        raise ValueError(kind)
    return found


def truth(text: Value, failed: Failed) -> Value:
    """The text coerced to bool, as the boolean substitutions do it: 'true', 'yes', 'on', '1'; Unknown where it is not known."""
    return as_type(text, "bool", failed)


def plain_text(value: Value) -> str | None:
    """The str that a value surely is, else None."""
    return value.value if isinstance(value, Const) and isinstance(value.value, str) else None


def _is_uniform(found: object) -> bool:
    if isinstance(found, (*_SCALARS, bytes)):
        return True
    if not isinstance(found, list) or not found or type(found[0]) not in _SCALARS:
        return False
    return all(isinstance(x, type(found[0])) for x in found)


def value_of(found: object, origins: Origins) -> Value:
    """The abstract value of what YAML gave."""
    if isinstance(found, (list, tuple)):
        return Tuple(tuple(value_of(x, origins) for x in found))
    if found is None or isinstance(found, (*_SCALARS, bytes)):
        return Const(found, origins)
    return Unknown((Reason(Cause.OPERATION, "", _NOWHERE),))


def unknown(value: Value, hint: str = "") -> Unknown:
    """Unknown in place of a value that the real launch does not get."""
    if value.__class__ is Unknown:
        return Unknown(value.reasons, hint)
    return Unknown(reasons_of(value) or (Reason(Cause.ERROR, "", _NOWHERE),), hint)


def _with_hole(value: Value) -> Value:
    """A text of which a part is unknown: it stays one where no filling makes it a number, a bool or a list."""
    if not isinstance(value, Text):
        return Unknown(reasons_of(value), "")
    if is_path(value):
        return value
    known = "".join(p for p in value.parts if isinstance(p, str))
    if _INDICATORS.isdisjoint(known) and any(c.isalpha() or c == "/" for c in known) and _is_word(known):
        return value
    return Unknown(reasons_of(value), "")


def _is_word(text: str) -> bool:
    """Whether a plain scalar that has this text in it can only be a str: it is no number, and no beginning of `true` or `nan`."""
    return ":" not in text and (len(text) > len("false") or "/" in text or "_" in text)


def _quoted(text: str) -> str:
    return repr(text if len(text) <= 40 else text[:37] + "…")


# Written again


def dumped(value: Value) -> Value:
    """`yaml.dump` of a value: the text of a rule that launch writes into the command line."""

    def one(option: Value) -> Value:
        plain = _python(option)
        return Const(yaml.safe_dump(plain.value), origins_of(option)) if plain is not None else concat((option,))

    return lift(one, value)


def printed(value: Value) -> Value:
    """`str()` of a value, as an f-string has it: True, (1, 2)."""

    def one(option: Value) -> Value:
        plain = _python(option)
        if plain is None:
            return concat((option,))
        shown = tuple(plain.value) if isinstance(plain.value, list) else plain.value
        return Const(str(shown), _origins(option))

    return lift(one, value)


class _Plain(NamedTuple):
    value: object


def _python(value: Value) -> _Plain | None:
    if isinstance(value, Const):
        return _Plain(value.value)
    if isinstance(value, Tuple) and all(isinstance(i, Const) for i in value.items):
        return _Plain([i.value for i in value.items if isinstance(i, Const)])
    return None


def _origins(value: Value) -> Origins:
    if isinstance(value, Tuple):
        return frozenset(o for item in value.items for o in origins_of(item))
    return origins_of(value)


def as_rcl_reads(value: Value) -> Value:
    """A value after launch wrote it into a parameter file and rcl read it: the str '1e3' comes out as the double 1000.0."""

    def one(option: Value) -> Value:
        if isinstance(option, Tuple):
            return Tuple(tuple(one(i) for i in option.items))
        text = plain_text(option)
        if text is None or not text or len(text) > 200 or "\n" in text:
            return option
        try:
            read = parse_value(literal(yaml.safe_dump(text))).value
        except InvalidArgument:
            return option
        return option if read is None or isinstance(read, tuple) else Const(read, origins_of(option))

    return lift(one, value)


def as_plain_scalar(value: Value) -> Value:
    """A text as rcl reads it where it stands in a file without quotes."""
    text = plain_text(value)
    if text is None or not text or len(text) > 200 or "\n" in text:
        return value
    try:
        read = parse_value(literal(text)).value
    except InvalidArgument:
        return value
    return value if read is None or isinstance(read, tuple) else Const(read, origins_of(value))


def replaced(value: Value, token: str, by: Value) -> Value:
    """A str value with each `token` in it replaced by another value."""

    def one(option: Value) -> Value:
        plain = plain_text(option)
        if plain is None or token not in plain:
            return option
        pieces = plain.split(token)
        parts: list[str | Hole] = []
        for index, piece in enumerate(pieces):
            parts.extend(parts_of(by) if index else ())
            parts.append(piece)
        return make(parts, origins_of(option) | origins_of(by))

    return one(value) if not isinstance(value, Choice) else lift(one, value)
