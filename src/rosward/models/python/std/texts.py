# SPDX-License-Identifier: Apache-2.0
"""Regular expressions on constants, within bounds of time; `textwrap`, `shlex`, `fnmatch`.

re.sub('[^a-z]', '_', 'my robot')   Const('my_robot')
re.sub('(a+)+b', '', 'aaaa…')       unknown: there are too many ways to match this pattern against this text
"""

from __future__ import annotations

import ast
import fnmatch
import itertools
import re
import shlex
import string
import sys
import textwrap
from collections.abc import Callable, Sequence
from typing import Any, Final

from rosward.domain.choice import join_all, options
from rosward.domain.unknown import NO_ORIGINS, Cause, Origins
from rosward.domain.values import NONE, UNBOUND, Const, Ref, Value
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.std.pattern_cost import work
from rosward.models.python.std.support import NotKnown, apply_plain, from_plain, to_plain, unknown_from
from rosward.models.python.strings.formatting import joined

MAX_NAME: Final = 200
MAX_REPLACEMENT: Final = 200
MAX_MATCHES: Final = 1_000
"""How many matches a function is called for."""
_WAYS_A_STEP: Final = 2_000
"""How many ways through a pattern Python tries in the time of one step of the interpreter."""


def compiled(call: NativeCall, pattern: object, flags: object, text: object) -> re.Pattern[str]:
    """The pattern, where matching it against this text takes little time."""
    if not isinstance(pattern, str) or not isinstance(text, str) or not isinstance(flags, int):
        raise NotKnown
    cost = work(pattern, flags, text)
    if cost is None:
        raise NotKnown
    call.machine.spend(cost // _WAYS_A_STEP)
    try:
        return re.compile(pattern, flags)
    except (re.error, OverflowError, RecursionError) as error:
        raise NotKnown from error


def _find(call: NativeCall) -> Value:
    """re._find(how, pattern, flags, text, pos, endpos): None or a dict of groups by number and name; unknown may be either."""

    def run(how: Any, pattern: Any, flags: Any, text: Any, first: Any = 0, last: Any = sys.maxsize) -> object:
        match = getattr(compiled(call, pattern, flags, text), how)(text, first, last)
        return None if match is None else _groups(match)

    found = apply_plain(call, run, call.args)
    if any(option not in (NONE,) and not _is_ref(option) for option in options(found)):
        return join_all((NONE, found))
    return found


def _is_ref(value: Value) -> bool:
    return value.__class__.__name__ == "Ref"


def _groups(match: re.Match[str]) -> dict[object, object]:
    """The groups by number and name; under '' where each stands."""
    names = [*range(len(match.groups()) + 1), *match.groupdict()]
    found: dict[object, object] = {name: match[name] for name in names}
    return {**found, "": {name: list(match.span(name)) for name in names}}


def _find_all(call: NativeCall) -> Value:
    """re._find_all(pattern, flags, text, pos, endpos): a list of dicts of groups."""

    def run(pattern: Any, flags: Any, text: Any, first: Any = 0, last: Any = sys.maxsize) -> object:
        return [_groups(m) for m in compiled(call, pattern, flags, text).finditer(text, first, last)]

    return _list_of(call, run, call.args, "")


def _split(call: NativeCall) -> Value:
    """re._split(pattern, flags, text, maxsplit)."""

    def run(pattern: Any, flags: Any, text: Any, count: Any) -> object:
        return compiled(call, pattern, flags, text).split(text, count)

    return _list_of(call, run, call.args, "str")


def _list_of(call: NativeCall, run: Callable[..., object], values: tuple[Value, ...], hint: str) -> Value:
    found = apply_plain(call, run, values, "list")
    if found is UNBOUND:
        return found
    return join_all(
        option if _is_ref(option) else call.machine.new_list((), unknown_from(call, hint, (option,)))
        for option in options(found)
    )


def _sub(call: NativeCall) -> Value:
    """re._sub(pattern, flags, repl, text, count)."""

    def run(pattern: Any, flags: Any, repl: Any, text: Any, count: Any) -> object:
        if not isinstance(repl, str) or len(repl) > MAX_REPLACEMENT:
            raise NotKnown
        return compiled(call, pattern, flags, text).sub(repl, text, count)

    return apply_plain(call, _guarded(run), call.args, "str")


def _sub_by(call: NativeCall) -> Value:
    """re._sub_by(pattern, function, text, count): what stands for each match is what a function says."""
    machine, (pattern, function, text, count) = call.machine, call.exactly(4)
    rule, flags = machine.load_attr(pattern, "pattern"), machine.load_attr(pattern, "flags")
    make = machine.load_attr(machine.load_module("re"), "Match")
    results: list[Value] = []
    for option in options(text):
        try:
            (source, bits, plain, most), marks = _plain_parts(machine, (rule, flags, option, count))
            if not isinstance(most, int) or not isinstance(plain, str):
                raise NotKnown
            found = list(itertools.islice(compiled(call, source, bits, plain).finditer(plain), most or MAX_MATCHES))
        except NotKnown:
            machine.call(function, (machine.unknown(Cause.CALL, "re.Match"),))
            results.append(unknown_from(call, "str", (text, rule)))
            continue
        at = 0
        written: list[Value] = [Const("", marks)]
        for match in found:
            said = machine.call(
                function, (machine.call(make, (from_plain(machine, _groups(match), marks), pattern, option)),)
            )
            written += [Const(plain[at : match.start()]), said]
            at = match.end()
        if UNBOUND not in written:
            results.append(joined(machine, [*written, Const(plain[at:])]))
    return join_all(results)


def _plain_parts(machine: Machine, values: Sequence[Value]) -> tuple[list[object], Origins]:
    found = [to_plain(machine, value) for value in values]
    return [plain for plain, _ in found], NO_ORIGINS.union(*(marks for _, marks in found))


_IN_TEMPLATE: Final = re.compile(r"\\(?:g<(\w+)>|([1-9]\d?)|(.))", re.DOTALL)


def _is_doubtful(call: NativeCall) -> Value:
    """re._is_doubtful(pattern): whether it may be refused: it is not known, or no pattern."""
    pattern = call.args[0]
    if not isinstance(pattern, Const) or not isinstance(pattern.value, (str, bytes)):
        return Const(not isinstance(pattern, Ref))  # an object was compiled already
    text = pattern.value if isinstance(pattern.value, str) else pattern.value.decode("latin-1")
    return Const(work(text, 0, "") is None)


def _expanded(call: NativeCall) -> Value:
    """re._expanded(template, groups): a template with the groups of a match in it."""

    def run(template: Any, groups: Any) -> object:
        if not isinstance(template, str) or len(template) > MAX_REPLACEMENT:
            raise NotKnown

        def one(match: re.Match[str]) -> str:
            if match[3] is not None:
                if match[3] not in "\\n":
                    raise NotKnown
                return "\n" if match[3] == "n" else "\\"
            name: str = match[1] or match[2]
            return groups[int(name) if name.isdecimal() else name] or ""

        return _IN_TEMPLATE.sub(one, template)

    return apply_plain(call, _guarded(run), call.args, "str")


def _guarded(function: Callable[..., object]) -> Callable[..., object]:
    def run(*values: Any) -> object:
        try:
            return function(*values)
        except (re.error, LookupError, TypeError) as error:
            raise NotKnown from error

    return run


def _pure(function: Callable[..., object], hint: str) -> NativeFunction:
    def run(*values: Any) -> object:
        if any(isinstance(v, str) and len(v) > 100_000 for v in values):
            raise NotKnown
        return function(*values)

    def apply(call: NativeCall) -> Value:
        if call.keywords:
            return unknown_from(call, hint, (*call.args, *call.keywords.values()))
        return apply_plain(call, run, call.args, hint)

    return apply


def _shell_split(call: NativeCall) -> Value:
    def run(text: object, comments: Any, posix: Any) -> object:
        if not isinstance(text, str):  # of None it would read the standard input of this process
            raise AttributeError("shlex.split of something that is not a string")
        return shlex.split(text, bool(comments), bool(posix))

    text = call.arg(0, "s") or call.exactly(1)[0]
    given = (text, call.arg(1, "comments", Const(False)), call.arg(2, "posix", Const(True)))
    return _list_of(call, run, tuple(v for v in given if v is not None), "str")


def _wrapped(call: NativeCall) -> Value:
    """textwrap.wrap(text, width)."""
    if call.keywords.keys() - {"width"} or len(call.args) > 2:
        return call.machine.new_list((), unknown_from(call, "str", (*call.args, *call.keywords.values())))

    def run(text: Any, width: Any) -> object:
        if not isinstance(text, str) or len(text) > 10_000:
            raise NotKnown
        return textwrap.wrap(text, width)

    given = (call.arg(0, "text") or NONE, call.arg(1, "width", Const(70)) or Const(70))
    return _list_of(call, run, given, "str")


def _literal(call: NativeCall) -> Value:
    """ast.literal_eval of a constant."""
    try:
        source, origins = to_plain(call.machine, call.args[0])
        if not isinstance(source, str) or len(source) > 10_000 or source.count("(") + source.count("[") > 100:
            raise NotKnown
        return from_plain(call.machine, ast.literal_eval(source), origins)
    except NotKnown:
        return unknown_from(call, "", call.args)
    except (ValueError, SyntaxError, MemoryError, RecursionError) as error:
        return call.machine.die("ValueError", str(error))


def _escape(text: Any) -> object:
    if not isinstance(text, str):
        raise NotKnown
    return re.escape(text)


def _matches(name: Any, pattern: Any) -> object:
    if not isinstance(name, str) or not isinstance(pattern, str) or len(name) > MAX_NAME or pattern.count("*") > 3:
        raise NotKnown
    return fnmatch.fnmatchcase(name, pattern)


NATIVES: Final[dict[str, NativeFunction]] = {
    "re._find": _find,
    "re._is_doubtful": _is_doubtful,
    "re._find_all": _find_all,
    "re._split": _split,
    "re._sub": _sub,
    "re._sub_by": _sub_by,
    "re._expanded": _expanded,
    "re.escape": _pure(_escape, "str"),
    "string.capwords": _pure(string.capwords, "str"),
    "textwrap.dedent": _pure(textwrap.dedent, "str"),
    "textwrap.indent": _pure(textwrap.indent, "str"),
    "textwrap.wrap": _wrapped,
    "textwrap.fill": _pure(textwrap.fill, "str"),
    "textwrap.shorten": _pure(textwrap.shorten, "str"),
    "shlex.quote": _pure(shlex.quote, "str"),
    "shlex.split": _shell_split,
    "fnmatch.fnmatch": _pure(_matches, "bool"),
    "fnmatch.fnmatchcase": _pure(_matches, "bool"),
    "ast.literal_eval": _literal,
}
