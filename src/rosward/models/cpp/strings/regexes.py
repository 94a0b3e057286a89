# SPDX-License-Identifier: Apache-2.0
"""Regular expressions of `<regex>`: what Python says of those that mean the same in both languages.

std::regex_replace(name, std::regex("[^a-z]"), "_")         'my_robot'
std::smatch m; std::regex_match(s, m, std::regex("(.*)_(\\d+)")); m[2].str()
"""

from __future__ import annotations

import re
from typing import Final

from rosward.domain.choice import join, options
from rosward.domain.compound import External, Partial
from rosward.domain.series import Series
from rosward.domain.slots import TypeOf
from rosward.domain.values import EMPTY, FALSE, NONE, TRUE, Const, Ref, Value
from rosward.models.cpp.iteration.contained import place_of
from rosward.models.cpp.iteration.iterators import iterator
from rosward.models.cpp.strings.string_parts import STRING, text_from
from rosward.models.cpp.values.conversions import convert, new_container
from rosward.models.cpp.values.slots import read
from rosward.models.native import Machine, NativeCall, NativeFunction, perform
from rosward.models.python.containers.dicts import look_up
from rosward.models.python.containers.lists import write_series
from rosward.models.python.plain import spread, text_of, unknown_from
from rosward.models.python.std.texts import NATIVES as PYTHON

__all__ = ["NATIVES"]

_MADE: Final = External("std.regex.made")
_MATCH: Final = TypeOf("std.smatch", ())
_ICASE: Final = 2
_ASCII: Final = 256
_OTHERWISE: Final = re.compile(r"\[\[[:.=]|\\c|\(\?[^:=!]|\(\?P|\\[AZ]|\[\^?\]")
"""What means something else, or nothing, in one of the languages."""
_GROUP: Final = re.compile(r"\$(\d{1,2}|&|\$)")


def _new(call: NativeCall) -> Value:
    """std::regex(pattern, flags): the type comes first."""
    pattern = text_from(call.machine, call.args[1:2])
    flags = [getattr(read(call.machine, arg), "name", "") for arg in call.args[2:3]]
    known = all(flag.rpartition(".")[2] in ("icase", "ECMAScript", "optimize") for flag in flags)
    ignoring = any(flag.endswith("icase") for flag in flags)
    if not known:
        pattern = unknown_from(call.machine, "regex", "str")
    return Partial(_MADE, (pattern, Const(_ASCII | (_ICASE if ignoring else 0))), ())


def _pattern(machine: Machine, value: Value) -> tuple[Value, Value]:
    """The pattern of a regex, and its flags; not known where it means another thing in Python."""
    held = read(machine, value)
    if isinstance(held, Partial) and held.function == _MADE:
        pattern, flags = held.arguments
    else:
        pattern, flags = convert(machine, held, STRING), Const(_ASCII)

    def one(option: Value) -> Value:
        text = text_of(option)
        return unknown_from(machine, "regex", "str", option) if text is None or _OTHERWISE.search(text) else option

    return spread(one, pattern), flags


def _subject(machine: Machine, value: Value) -> Value:
    """What is searched; where a line ends Python has another end of the text."""

    def one(option: Value) -> Value:
        text = text_of(option)
        return unknown_from(machine, "regex", "str", option) if text is not None and "\n" in text else option

    return spread(one, convert(machine, value, STRING))


def _found(call: NativeCall) -> Value:
    """regex_match, regex_search: whether there is a match, and its groups in the `smatch` that is given."""
    machine = call.machine
    how = "fullmatch" if call.name.endswith("regex_match") else "search"
    matches = read(machine, call.args[1])
    into = matches if isinstance(matches, Ref) else None
    pattern, flags = _pattern(machine, call.args[2 if into is not None else 1])
    subject = _subject(machine, call.args[0])
    given = (Const(how), pattern, flags, subject)
    result = perform(PYTHON["re._find"], NativeCall(machine, "re._find", given, {}))
    if into is not None:
        write_series(machine, into, _groups(machine, result, subject))
    answers = {option != NONE if option == NONE or isinstance(option, Ref) else None for option in options(result)}
    if answers == {True}:
        return TRUE
    return FALSE if answers == {False} else unknown_from(machine, call.name, "bool", pattern, subject)


def _groups(machine: Machine, result: Value, subject: Value) -> Series:
    """The whole match and its groups; an empty text for one that has no part in it."""
    several = [option for option in options(result) if isinstance(option, Ref)]
    if len(several) == 1 == len(options(result)):
        obj = machine.obj(several[0])
        count = sum(1 for key in obj.entries if isinstance(key, Const) and isinstance(key.value, int))
        found = [look_up(machine, obj, Const(number)).value for number in range(count)]
        return Series(tuple(EMPTY if value == NONE else value for value in found))
    if result == NONE:
        return Series()
    return Series((), unknown_from(machine, "match", "str", subject))


def _replace(call: NativeCall) -> Value:
    """regex_replace(text, regex, format)."""
    machine = call.machine
    pattern, flags = _pattern(machine, call.args[1])

    def one(option: Value) -> Value:
        text = text_of(option)
        if text is None:
            return option
        written = _GROUP.sub(lambda m: {"&": "\\g<0>", "$": "$"}.get(m[1], f"\\g<{m[1]}>"), text.replace("\\", "\\\\"))
        return Const(written, option.origins if isinstance(option, Const) else frozenset())

    given = (
        pattern,
        flags,
        spread(one, convert(machine, call.args[2], STRING)),
        _subject(machine, call.args[0]),
        Const(0),
    )
    return perform(PYTHON["re._sub"], NativeCall(machine, "re._sub", given, {}))


def _new_match(call: NativeCall) -> Value:
    return new_container(call.machine, _MATCH, Series(), "match")


def _group(call: NativeCall) -> Value:
    """match.str(n)."""
    machine, held = call.machine, read(call.machine, call.args[0])
    number = call.args[1] if len(call.args) > 1 else Const(0)
    return (
        read(machine, place_of(machine, held, number))
        if isinstance(held, Ref)
        else unknown_from(machine, "str", "str", held)
    )


def _part(call: NativeCall) -> Value:
    """match.prefix(), match.position()."""
    hint = "int" if call.name.endswith(("position", "length")) else "str"
    return unknown_from(call.machine, call.name, hint, read(call.machine, call.args[0]))


def _text(call: NativeCall) -> Value:
    return read(call.machine, call.args[0])


def _each(call: NativeCall) -> Value:
    """std::sregex_iterator(first, last, regex): matches, of which no more is known."""
    machine = call.machine
    if len(call.args) < 3:
        return iterator(new_container(machine, _MATCH, Series(), "end"), NONE)
    match = new_container(machine, _MATCH, Series((), unknown_from(machine, "match", "str")), "each")
    matches = new_container(machine, TypeOf("std.vector", (_MATCH,)), Series((), match), "matches")
    place = iterator(matches, unknown_from(machine, "match", "int"))
    return join(place, iterator(matches, NONE))


_MATCHES: Final = ("smatch", "cmatch", "match_results")

NATIVES: Final[dict[str, NativeFunction]] = {
    "std.regex.new": _new,
    "std.basic_regex.new": _new,
    "std.regex_match": _found,
    "std.regex_search": _found,
    "std.regex_replace": _replace,
    **{f"std.{name}.new": _new_match for name in _MATCHES},
    "std.smatch.str": _group,
    **{f"std.smatch.{name}": _part for name in ("prefix", "suffix", "position", "length")},
    "std.string.str": _text,
    "std.sregex_iterator.new": _each,
    "std.sregex_token_iterator.new": _each,
}
