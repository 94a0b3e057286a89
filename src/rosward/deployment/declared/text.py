# SPDX-License-Identifier: Apache-2.0
"""What does a template of a declared interface become, for a process that is started in a certain way?

    '${param:input}/relayed'   with -p input:=scan    Const('scan/relayed')
    '${param:input}/relayed'   with an unknown input  Text(hole, '/relayed'), and the reason

The expressions are listed in docs/declared-nodes.md.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Final

from rosward.deployment.declared.shapes import DeclaredCondition, DeclaredParameter
from rosward.domain.choice import join, lift, lift2, options, reasons_of
from rosward.domain.compound import Tuple
from rosward.domain.text import concat, is_path, parts_of
from rosward.domain.unknown import Cause, Origin, Reason
from rosward.domain.values import EMPTY, Const, Text, Unknown, Value
from rosward.location import Place
from rosward.models.python.plain import with_origins
from rosward.naming.command_line import ANY_NAME
from rosward.records import NamedTuple

DEEPEST: Final = 8

_MADE: Final = {"random": Cause.RANDOM, "address": Cause.ANEW}
"""What is made when the program runs: where a name given at the start takes its place, and where nothing does."""


class DeclaredParameters:
    """The parameters of one node: what it is given, else its defaults. `missing`: why some that are given may not be known."""

    def __init__(self, given: Mapping[str, Value], missing: tuple[Reason, ...]) -> None:
        self.given = {k: v for k, v in given.items() if k != ANY_NAME}
        more = tuple(r for k, v in given.items() if k == ANY_NAME for r in reasons_of(v))
        self.missing = (*missing, *more)
        self._open = bool(missing) or ANY_NAME in given
        self._defaults: dict[str, DeclaredParameter] = {}

    def declare(self, parameter: DeclaredParameter, name: str) -> None:
        """The default of a parameter, unless it has one already."""
        self._defaults.setdefault(name, parameter)

    def value(self, name: str) -> Value:
        """The value of a parameter."""
        if name in self.given:
            return with_origins(self.given[name], frozenset((Origin("parameter", name, settled=True, given=True),)))
        if self._open:
            return Unknown(self.missing or (Reason(Cause.PARAMETER, name, Place("")),))
        declared = self._defaults.get(name)
        if declared is None or declared.default is None:
            return Unknown((Reason(Cause.PARAMETER, name, Place("")),))
        return as_value(declared.default, name)

    def is_given(self, name: str) -> bool | None:
        """Whether somebody gives it a value; None where that is not known."""
        if name in self.given:
            return True
        return None if self._open else False

    def below(self, prefix: str) -> tuple[list[str], bool]:
        """The first part of the names given below a prefix (`topics` of `topics.joystick.topic`), and whether there may be more."""
        start = f"{prefix}." if prefix else ""
        found = [n[len(start) :].partition(".")[0] for n in self.given if n.startswith(start)]
        return list(dict.fromkeys(found)), self._open


def as_value(default: object, name: str) -> Value:
    """The default of a parameter as a value that depends on it: settled, for the execution that is analysed leaves it alone."""
    if isinstance(default, tuple):
        return Tuple(tuple(as_value(d, name) for d in default))
    origin = Origin("parameter", name, settled=True)
    return Const(default, frozenset((origin,))) if isinstance(default, (bool, int, float, str)) else Unknown(())


class TemplateScope(NamedTuple):
    """What templates can speak of. `outer`: the parameters of the first node, for those behind it.

    `resolve` gives the full name of a topic of the node, behind its remap rules or before them."""

    parameters: DeclaredParameters
    arguments: Sequence[Value]
    variables: Mapping[str, Value]
    namespace: Value
    resolve: Callable[[Value, bool], Value]
    outer: DeclaredParameters | None = None

    def bound(self, variable: str, value: Value) -> TemplateScope:
        """The same with one more variable."""
        return self._replace(variables={**self.variables, variable: value})


def expand(template: str, scope: TemplateScope, depth: int = 0) -> Value:
    """The text that a template stands for."""
    found: Value = EMPTY
    rest = template
    while "${" in rest and depth <= DEEPEST:
        before, _, rest = rest.partition("${")
        inside, rest = _matching(rest)
        found = joined(joined(found, Const(before)), _spoken(expand(inside, scope, depth + 1), scope))
    return Const(rest) if found is EMPTY and rest == template else joined(found, Const(rest))


def joined(left: Value, right: Value) -> Value:
    """The concatenation of two texts, each of which may have alternatives."""
    if left == EMPTY:
        return lift(as_text, right)
    if right == EMPTY:
        return lift(as_text, left)
    return lift2(lambda a, b: concat((as_text(a), as_text(b))), left, right)


def as_text(value: Value) -> Value:
    """A scalar as it stands in a name."""
    if isinstance(value, Const) and not isinstance(value.value, str):
        text = str(value.value).lower() if isinstance(value.value, bool) else str(value.value)
        return Const(text, value.origins)
    return value


def _matching(rest: str) -> tuple[str, str]:
    """What stands before the brace that closes, and what behind it."""
    depth = 1
    for at, char in enumerate(rest):
        if char == "{":
            depth += 1
        elif char == "}":
            depth -= 1
            if not depth:
                return rest[:at], rest[at + 1 :]
    return rest, ""


def _spoken(expression: Value, scope: TemplateScope) -> Value:
    return lift(lambda each: _one(each, scope), expression)


def _one(expression: Value, scope: TemplateScope) -> Value:
    kind, colon, _ = _text(expression).partition(":")
    if kind in ("resolved", "expanded", "parent", "outer") and colon:
        rest = _behind_colon(expression)
        if kind == "parent":
            return lift(_parent, rest)
        if kind == "outer":
            return lift(lambda name: _outer(name, scope), rest)
        return lift(lambda name: scope.resolve(name, kind == "resolved"), rest)
    if not isinstance(expression, Const):
        return Unknown(reasons_of(expression), "str")
    name = str(expression.value).partition(":")[2]
    if kind == "param":
        return scope.parameters.value(name)
    if kind == "outer_param":
        return (scope.outer or scope.parameters).value(name)
    if kind == "argument":
        return argument(name, scope)
    if kind == "operand":
        return operand(name, scope)
    if kind == "live":
        return Unknown((Reason(Cause.LIVE, name, Place("")),), "str")
    if expression.value in _MADE:
        return Unknown((Reason(_MADE[str(expression.value)], "", Place("")),), "str")
    if expression.value == "namespace":
        return _prefix(scope)
    return scope.variables.get(
        str(expression.value), Unknown((Reason(Cause.PARAMETER, str(expression.value), Place("")),))
    )


def _prefix(scope: TemplateScope) -> Value:
    return lift(lambda v: EMPTY if isinstance(v, Const) and v.value == "/" else v, scope.namespace)


def _outer(name: Value, scope: TemplateScope) -> Value:
    """A relative name is below the namespace of the first node; an absolute one stays."""
    if _text(name).startswith("/"):
        return name
    below = joined(joined(_prefix(scope), Const("/")), name)
    return below if _text(name) else join(name, below)


def _text(value: Value) -> str:
    first = parts_of(value)[0] if parts_of(value) else ""
    return first if isinstance(first, str) else ""


def _behind_colon(value: Value) -> Value:
    if isinstance(value, Const):
        return Const(str(value.value).partition(":")[2], value.origins)
    if isinstance(value, Text) and isinstance(value.parts[0], str):
        first = value.parts[0].partition(":")[2]
        return concat((Const(first, value.origins), _rest(value)))
    return value


def _rest(value: Text) -> Value:
    return concat(Const(p) if isinstance(p, str) else Unknown(p.reasons, "str") for p in value.parts[1:])


def _parent(name: Value) -> Value:
    """`/a/b` is `/a`; nothing for a name of one part. Of a name with a hole in its last part it is not known where that begins."""
    if isinstance(name, Const):
        return Const(str(name.value).rpartition("/")[0], name.origins)
    if isinstance(name, Text) and isinstance(name.parts[-1], str) and "/" in name.parts[-1]:
        kept = concat(Const(p) if isinstance(p, str) else Unknown(p.reasons, "str") for p in name.parts[:-1])
        return concat((kept, Const(name.parts[-1].rpartition("/")[0])))
    return Unknown(reasons_of(name), "str")


def argument(name: str, scope: TemplateScope) -> Value:
    """A word of the program's own arguments, by its number or by the flag before it; empty where there is none."""
    words = scope.arguments
    if name.isdigit():
        return words[int(name) - 1] if 0 < int(name) <= len(words) else EMPTY
    unclear = [w for w in words if not isinstance(w, Const) and _may_name(w, name)]
    for at, word in enumerate(words):
        for option in options(word):
            if isinstance(option, Const) and option.value == name:
                return words[at + 1] if at + 1 < len(words) else EMPTY
            if isinstance(option, Const) and str(option.value).startswith(f"{name}="):
                return Const(str(option.value)[len(name) + 1 :], option.origins)
    return Unknown(tuple(r for w in unclear for r in reasons_of(w)), "str") if unclear else EMPTY


def operand(name: str, scope: TemplateScope) -> Value:
    """`N:--flag,-f`: the N-th word that is no option and not behind one; the flags named are those that take no word."""
    number, _, flags = name.partition(":")
    plain = frozenset(flags.split(","))
    found: list[Value] = []
    skip = False
    for word in scope.arguments:
        text = _text(word)
        if skip:
            skip = False
        elif text.startswith("-"):
            skip = text not in plain and "=" not in text
        else:
            found.append(word)
    at = int(number) if number.isdigit() else 0
    return found[at - 1] if 0 < at <= len(found) else EMPTY


def has_argument(name: str, scope: TemplateScope) -> bool | None:
    """Whether an argument is given; None where a word that is not known may be it."""
    if name.isdigit():
        return int(name) <= len(scope.arguments)
    known = [str(w.value) for w in scope.arguments if isinstance(w, Const)]
    if any(w == name or w.startswith(f"{name}=") for w in known):
        return True
    return None if any(_may_name(w, name) for w in scope.arguments if not isinstance(w, Const)) else False


def _may_name(word: Value, name: str) -> bool:
    """Whether a word that is not wholly known may be `--flag` or `--flag=…`."""
    if not isinstance(word, Text):
        return True
    first = word.parts[0]
    if not isinstance(first, str):
        return not is_path(word)
    return f"{name}=".startswith(first) or first.startswith(f"{name}=")


def holds(condition: DeclaredCondition, scope: TemplateScope) -> bool | None:
    """Whether a condition holds; None where that is not known."""
    if condition.test == "installed":
        return None
    if condition.test == "set":
        kind, _, name = _spoken_subject(condition.subject, scope)
        known = scope.parameters.is_given(name) if kind == "param" else has_argument(name, scope)
        return known if known is None else known is condition.values[0]
    answers = {_compare(option, condition) for option in options(expand(condition.subject, scope))}
    return answers.pop() if len(answers) == 1 else None


def _spoken_subject(subject: str, scope: TemplateScope) -> tuple[str, str, str]:
    """The kind and the name in `${param:NAME}`, NAME itself expanded."""
    inner = expand(subject[2:-1], scope)
    return str(inner.value).partition(":") if isinstance(inner, Const) else ("", "", "")


def _compare(value: Value, condition: DeclaredCondition) -> bool | None:
    same = any(_same(value, wanted) for wanted in condition.values)
    if isinstance(value, Text):
        if not any(isinstance(w, str) and _may_be(value, w) for w in condition.values):
            return condition.test == "not"
        return None
    if isinstance(value, Tuple):
        return condition.test == "not"
    if not isinstance(value, Const):
        return None
    return same is (condition.test != "not")


def _same(value: Value, wanted: object) -> bool:
    if not isinstance(value, Const):
        return False
    if isinstance(wanted, bool) or isinstance(value.value, bool):
        return value.value is wanted or (isinstance(value.value, str) and value.value == str(wanted).lower())
    return value.value == wanted or str(value.value) == str(wanted)


def _may_be(value: Text, wanted: str) -> bool:
    first, last = value.parts[0], value.parts[-1]
    return not (
        (isinstance(first, str) and not wanted.startswith(first))
        or (isinstance(last, str) and not wanted.endswith(last))
    )
