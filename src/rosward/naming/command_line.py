# SPDX-License-Identifier: Apache-2.0
"""What do the words of a process's command line mean, where the words are abstract values?

    ('--ros-args', '-r', '__ns:=/' + <launch argument robot>, '--params-file', '/tmp/params')
    ->  remaps: __ns:=/* with the target Text('/', hole) and its reason; parameters: what stands in that file

`ros/arguments.py` knows the grammar; here its answers get back the values, origins and reasons of the words that they were made of.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Final

from rosward.domain.choice import lift, options, reasons_of
from rosward.domain.compound import Tuple
from rosward.domain.series import Series
from rosward.domain.text import is_path, make, origins_of, parts_of, pattern
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Choice, Const, Text, Unknown, Value
from rosward.effects.configuration import Configuration, Given
from rosward.holes import HOLE, Holed, with_stars
from rosward.location import Place
from rosward.records import NamedTuple
from rosward.ros import arguments, names
from rosward.ros.parameter_values import ParameterValue, effective_value

UNKNOWN_ARGUMENTS: Final = "unknown ROS arguments may rename what the process creates"

ANY_NAME = "*"
"""In `Given.name`: a parameter of a name that is not known."""


class ValueRule(NamedTuple):
    """A remap rule, and its target as a value."""

    rule: names.RemapRule
    target: Value


class CommandLine(NamedTuple):
    """What the words mean. `parameters` are those of -p and of the files, in order; `missing` says which files are not known, and why.

    `errors` end the real program at once; `unreadable`: words whose holes may make them anything, `holes`: why they have these;
    `open`: why there may be further words.
    """

    remaps: tuple[ValueRule, ...] = ()
    parameters: tuple[Given, ...] = ()
    missing: tuple[Reason, ...] = ()
    enclave: Value | None = None
    rosout_logs: bool = True
    errors: tuple[str, ...] = ()
    unreadable: tuple[str, ...] = ()
    open: tuple[Reason, ...] = ()
    holes: tuple[Reason, ...] = ()

    @property
    def rules(self) -> tuple[names.RemapRule, ...]:
        """The remap rules as `ros/names.py` reads them."""
        return tuple(r.rule for r in self.remaps)


def read_words(series: Series, configuration: Configuration | None = None) -> CommandLine:
    """Read the words of a command line; `configuration` knows the parameter files that they name.

    What somebody types where the program runs is taken as nothing (docs/limits.md); of other words that are not known it is told.
    """
    words = (*series.head, *series.tail)
    between = _between(series.middle)
    if not words and between == _NOTHING:
        return CommandLine()
    parsed = arguments.parse_arguments([pattern(w) for w in words])
    at = parsed.positions
    found: list[tuple[int, ValueRule]] = []
    further = [*between.open]
    for rule, index in zip(parsed.remaps, at.remaps, strict=True):
        if renames_anything(rule):
            further += reasons_of(words[index])
        else:
            found.append((index, ValueRule(rule, behind(words[index], ":="))))
    remaps = (
        *(rule for index, rule in found if index < len(series.head)),
        *between.remaps,
        *(rule for index, rule in found if index >= len(series.head)),
    )
    parameters: list[Given] = []
    missing: list[Reason] = [*between.missing]
    for override, index in zip(parsed.overrides, at.overrides, strict=True):
        if isinstance(override, arguments.ParameterRule):
            parameters.append(Given(override.node, override.name, _rule_value(override.value, words[index])))
            continue
        files: Mapping[str, tuple[Given, ...] | None] = configuration.files if configuration is not None else {}
        content = files.get(override.path)
        if content is not None:
            parameters += content
        else:
            known = configuration.missing.get(override.path) if configuration is not None else None
            missing.append(known or Reason(Cause.FILE, f"parameter file {override.path}", Place("")))
    holes = tuple(dict.fromkeys(r for w in words if parsed.unknown and not _whole(w) for r in reasons_of(w)))
    missing += holes or [Reason(Cause.ARGUMENT, text, Place("")) for text in parsed.unknown]
    return CommandLine(
        remaps,
        tuple(parameters),
        tuple(missing),
        None if at.enclave is None else words[at.enclave],
        parsed.rosout_logs,
        parsed.errors,
        parsed.unknown,
        tuple(dict.fromkeys(further)),
        holes,
    )


def _whole(word: Value) -> bool:
    return not isinstance(word, (Unknown, Choice)) and "*" not in pattern(word)


def renames_anything(rule: names.RemapRule) -> bool:
    """Whether nothing is known of the names that a rule is for: then its target is no name that an entity surely may have."""
    return rule.match.strip("/") == HOLE


class _Between(NamedTuple):
    """What words of unknown number may mean: rules and parameters that may be set, and why there may be others."""

    remaps: tuple[ValueRule, ...] = ()
    missing: tuple[Reason, ...] = ()
    open: tuple[Reason, ...] = ()


_NOTHING: Final = _Between()
_PARAMETERS: Final = ("-p", "--param", "--params-file")


def _between(middle: Value | None) -> _Between:
    several = options(middle) if middle is not None else ()
    rules: list[ValueRule] = []
    parameters = False
    reasons: list[Reason] = []
    for word in several:
        if not isinstance(word, (Const, Text)):
            told = reasons_of(word) or (Reason(Cause.OPERATION, "a word", Place("")),)
            reasons += (r for r in told if r.cause is not Cause.ARGUMENT)
            continue
        text = pattern(word)
        parameters = parameters or text in _PARAMETERS
        try:
            rule = arguments.parse_remap_rule(text)._replace(maybe=True)
        except arguments.InvalidArgument:
            continue
        if renames_anything(rule):
            reasons += reasons_of(word)
        else:
            rules.append(ValueRule(rule, behind(word, ":=")))
    missing = (Reason(Cause.OPERATION, "ROS arguments that may be passed", Place("")),) if parameters else ()
    return _Between(tuple(rules), (*missing, *reasons), tuple(dict.fromkeys(reasons)))


def behind(word: Value, mark: str) -> Value:
    """What stands behind the first `mark` of a word: 'talker' of '__node:=talker'."""

    def one(value: Value) -> Value:
        parts = parts_of(value)
        for index, part in enumerate(parts):
            if isinstance(part, str) and mark in part:
                return make((part.partition(mark)[2], *parts[index + 1 :]), origins_of(value))
        return value

    return lift(one, word)


def _rule_value(value: ParameterValue, word: Value) -> Value:
    """The value of `-p name:=text`: typed, with the origins of the word; with its holes where it has any."""
    text = behind(word, ":=")
    if isinstance(text, Const):
        return from_plain(with_stars(value.value) if isinstance(value.value, str) else value.value, text)
    if isinstance(text, Text) and (value.type == "string" or is_path(text)):
        return text
    reasons = tuple(r for p in parts_of(text) if not isinstance(p, str) for r in p.reasons)
    return Unknown(reasons, "")


def from_plain(value: object, like: Value) -> Value:
    """A plain value of a parameter as an abstract one, with the origins of `like`."""
    if isinstance(value, tuple):
        return Tuple(tuple(from_plain(v, like) for v in value))
    if value is None:
        return Tuple(())  # an empty list: its type is not set
    if isinstance(value, (bool, int, float, str)):
        return Const(value, origins_of(like))
    return Unknown(())


def given_to(node_fqn: Holed, rows: Iterable[Given]) -> dict[str, Value]:
    """The values that rows, in their order, give the node of a full name; see `ros.arguments.parameters_of_node` for the precedence."""
    by_key: dict[str, dict[str, list[list[Given]]]] = {}
    for row in rows:
        entries = by_key.setdefault(row.node, {}).setdefault(row.name, [])
        if row.nested or not entries:
            entries.append([row])  # a nested name never joins an earlier one: it replaces it
        else:
            entries[0].append(row)
    found: dict[str, Value] = {}
    for key, values in by_key.items():
        fits = arguments.key_fits_node(key, node_fqn)
        if fits is False:
            continue
        for name, entries in values.items():
            value = _effective([g.value for g in entries[-1]])
            if fits is None and found.get(name) != value:
                value = Unknown((Reason(Cause.PARAMETER, name, entries[-1][-1].place or Place("")),))
            found[name] = value
    return found


def _effective(values: list[Value]) -> Value:
    """Of several values under one key that which holds: rcl looks at the types in a fixed order."""
    if len(values) == 1:
        return values[0]
    types = [type_word(v) for v in values]
    if None in types:
        return values[-1] if not isinstance(values[-1], Const) else Unknown(())
    chosen = effective_value(ParameterValue(t, n) for n, t in enumerate(types))
    return values[chosen.value] if isinstance(chosen.value, int) else values[-1]


def type_word(value: Value) -> str | None:
    """rcl's word for the type of a value."""
    if isinstance(value, Tuple):
        inner = {type_word(v) for v in value.items}
        return f"{inner.pop()}_array" if len(inner) == 1 and None not in inner else "not_set" if not inner else None
    if isinstance(value, Text):
        return "string"
    if isinstance(value, Const):
        for kind, word in ((bool, "bool"), (int, "integer"), (float, "double"), (str, "string")):
            if isinstance(value.value, kind):
                return word
    return None
