# SPDX-License-Identifier: Apache-2.0
"""Rows and sections of text that is known: `csv`, `configparser`.

csv.reader(['left,/cmd_left'])                            [['left', '/cmd_left']]
configparser.ConfigParser().read_string('[a]\\nt = /x')    ('a', 't', '/x')

The stubs of these modules say what the classes do with it; what is not known stays so, with the reason of its text.
"""

from __future__ import annotations

import configparser
import csv
from typing import Any, Final

from rosward.domain.choice import lift
from rosward.domain.compound import Tuple
from rosward.domain.text import origins_of
from rosward.domain.values import NONE, Const, Value
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.python.plain import text_of
from rosward.models.python.std.support import NotKnown, from_plain, to_plain, unknown_from

_MOST: Final = 10_000
_FORMAT: Final = frozenset(
    {"delimiter", "quotechar", "escapechar", "doublequote", "skipinitialspace", "quoting", "strict"}
)
_DIALECTS: Final = {"excel": ",", "excel-tab": "\t", "unix": ","}


def _rows(call: NativeCall) -> Value:
    """csv._rows(lines, dialect, options): a list of rows."""
    lines, dialect, given = call.exactly(3)
    known, rest = call.machine.iterate(lines)
    texts = [text_of(line) for line in known]
    if rest is not None or None in texts or len(texts) > _MOST:
        row = call.machine.new_list((), unknown_from(call, "str", (*known, *(() if rest is None else (rest,)))))
        return call.machine.new_list((), row)
    origins = frozenset(origin for line in known for origin in origins_of(line))
    try:
        settings = _settings(call, dialect, given)
        rows = list(csv.reader([t for t in texts if t is not None], **settings))
    except (NotKnown, csv.Error, TypeError, ValueError):
        row = call.machine.new_list((), unknown_from(call, "str", (dialect, given)))
        return call.machine.new_list((), row)
    return from_plain(call.machine, rows, origins)


def _settings(call: NativeCall, dialect: Value, given: Value) -> dict[str, Any]:
    """What `csv.reader` is told of the format; a dialect of the program's own is not known."""
    name = text_of(dialect)
    plain, _ = to_plain(call.machine, given)
    if name not in _DIALECTS or not isinstance(plain, dict) or not plain.keys() <= _FORMAT:
        raise NotKnown
    return {"delimiter": _DIALECTS[name], **plain}


def _sections(call: NativeCall) -> Value:
    """configparser._sections(text, allows_no_value): a tuple of (section, option, value) in order; None where the text is not known."""
    text, allows = call.exactly(2)

    def one(option: Value) -> Value:
        plain = text_of(option)
        if plain is None:
            return NONE
        parser = configparser.RawConfigParser(
            strict=False, allow_no_value=isinstance(allows, Const) and allows.value is True
        )
        parser.optionxform = str  # type: ignore[assignment,method-assign]  # the stub asks that of the program
        try:
            parser.read_string(plain)
        except configparser.Error:
            return NONE
        origins = origins_of(option)

        def value(section: str, name: str, held: str | None) -> Value:
            return Tuple((Const(section), Const(name), Const(held, origins)))

        found = [value(parser.default_section, name, held) for name, held in parser.defaults().items()]
        for section in parser.sections():
            found.append(Tuple((Const(section), NONE, NONE)))
            found += [value(section, name, held) for name, held in parser._sections[section].items()]  # type: ignore[attr-defined]  # nothing public leaves out the default section
        return Tuple(tuple(found)) if len(found) <= _MOST else NONE

    return lift(one, text)


NATIVES: Final[dict[str, NativeFunction]] = {"csv._rows": _rows, "configparser._sections": _sections}
