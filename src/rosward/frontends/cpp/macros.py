# SPDX-License-Identifier: Apache-2.0
"""What does a text become where macros are expanded?

    #define TOPIC(name) "/robot/" #name
    TOPIC(state)                            ->   "/robot/" "state"

Object-like and function-like macros with `#`, `##`, `__VA_ARGS__` and `__VA_OPT__`; a macro is not expanded within itself. What is made
is counted, since a dozen definitions can ask for more text than there is memory.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Final, final

from rosward.frontends.cpp.tokens import is_name, tokens, trimmed
from rosward.records import NamedTuple

_NOTHING: Final = "\0"
"""An empty argument beside `##`."""
_NO_MORE: Final = _NOTHING * 2
"""The same of `...`: compilers take away the comma before it, in `, ##__VA_ARGS__`."""
EITHER: Final = "__rosward_either"
"""Called with the alternatives of a macro whose definition depends on what nobody knows."""

_DEPTH: Final = 60
_ARGUMENT: Final = 20_000  # tokens


class Macro(NamedTuple):
    """A definition; `parameters` is None for an object-like one. With `alternatives`, it is one of these, and nobody knows which."""

    name: str
    body: tuple[str, ...]
    parameters: tuple[str, ...] | None = None
    variadic: str = ""
    alternatives: tuple[Macro | None, ...] = ()


Macros = dict[str, Macro]


class TooMuchError(Exception):
    """The expansion of macros makes more text than is read."""


def definition(text: str) -> Macro | None:
    """The macro that the text behind `#define` makes; None where it makes none."""
    found = tokens(text.strip())
    if not found or not is_name(found[0]):
        return None
    name, rest = found[0], found[1:]
    if rest[:1] != ["("]:
        return Macro(name, _body(rest))
    if ")" not in rest:
        return None
    end = rest.index(")")
    parameters = [token for token in rest[1:end] if not token.isspace() and token != ","]
    variadic = ""
    if "".join(parameters[-3:]) == "...":
        parameters = parameters[:-3]
        variadic = "__VA_ARGS__"
        inside = "".join(rest[1:end])
        if parameters and not inside.rstrip(". \t").rstrip().endswith(","):  # `args...`
            variadic = parameters.pop()
    if not all(map(is_name, parameters)):
        return None
    return Macro(name, _body(rest[end + 1 :]), tuple(parameters), variadic)


def _body(found: list[str]) -> tuple[str, ...]:
    """The tokens of a definition; what only a compiler reads of it is left out."""
    result = trimmed(found)
    if "__attribute__" in result or "__declspec" in result:
        kept: list[str] = []
        depth, inside = 0, False
        for token in result:
            if token in {"__attribute__", "__declspec"}:
                inside = True
            elif inside:
                depth += (token == "(") - (token == ")")
                inside = depth > 0 or token == " "
            else:
                kept.append(token)
        result = trimmed(kept)
    return tuple(result)


@final
class Expansion:
    """Expands with the macros of a moment; `budget` is how many tokens may still be made."""

    def __init__(self, macros: Macros, budget: int, tell: Callable[[str, str], None]) -> None:
        self.macros = macros
        self.budget = budget
        self._tell = tell

    def expand(self, found: Sequence[str], hidden: frozenset[str] = frozenset(), depth: int = 0) -> list[str]:
        """The tokens with all macros expanded. Raises TooMuchError."""
        result: list[str] = []
        pending: list[tuple[str, frozenset[str]]] = [(token, hidden) for token in reversed(found)]
        while pending:
            token, hiding = pending.pop()
            macro = self.macros.get(token)
            if macro is None or token in hiding:
                result.append(token)
                continue
            self.budget -= 1 + len(macro.body) + len(hiding) // 8
            if self.budget < 0 or depth > _DEPTH:
                raise TooMuchError
            if macro.alternatives:
                macro = self._either(macro)
            if macro.parameters is None:
                made = _pasted(list(macro.body)) if "##" in macro.body else macro.body
                inner = hiding | {token}
                pending += [(each, inner) for each in reversed(made)]
                continue
            arguments = _arguments(pending)
            if arguments is None:
                result.append(token)
                continue
            made = self._put(macro, arguments, hiding, depth)
            inner = hiding | {token}
            pending += [(each, inner) for each in reversed(made)]
        return result

    def _put(self, macro: Macro, given: list[list[str]], hidden: frozenset[str], depth: int) -> list[str]:
        """The body of a function-like macro with its arguments."""
        names = macro.parameters or ()
        if not names and not macro.variadic and given == [[]]:
            given = []
        raw = dict(zip(names, given, strict=False)) | {name: [] for name in names[len(given) :]}
        if macro.variadic:
            rest: list[str] = []
            for argument in given[len(names) :]:
                rest += [",", " ", *argument] if rest or argument is not given[len(names)] else argument
            raw[macro.variadic] = rest
        expanded: dict[str, list[str]] = {}
        result: list[str] = []
        body = macro.body
        position = 0
        while position < len(body):
            token = body[position]
            position += 1
            if token == "#" and _next_name(body, position) in raw:
                while body[position] not in raw:
                    position += 1
                result.append(_quoted(raw[body[position]]))
                position += 1
            elif token == "__VA_OPT__" and body[position : position + 1] == ("(",):
                end = _closing(body, position)
                if any(t != " " for t in raw.get("__VA_ARGS__", ())):
                    result += body[position + 1 : end]
                position = end + 1
            elif token in raw:
                if _beside_paste(body, position):
                    result += raw[token] or [_NO_MORE if token == macro.variadic else _NOTHING]
                else:
                    if token not in expanded:
                        expanded[token] = self.expand(raw[token], hidden, depth + 1)
                    result += expanded[token]
            else:
                result.append(token)
            if len(result) > self.budget:
                raise TooMuchError
        self.budget -= len(result)
        return [t for t in _pasted(result) if t not in (_NOTHING, _NO_MORE)] if "##" in body else result

    def _either(self, macro: Macro) -> Macro:
        """One macro for several: its value is one of theirs."""
        there = [m for m in macro.alternatives if m is not None]
        with_text = [m for m in there if m.body]
        if (
            all(m.parameters is None for m in there)
            and len(with_text) > 1
            and all(_is_value(m.body) for m in with_text)
        ):
            body: list[str] = []
            for each in with_text:
                body += [",", " ", *each.body] if body else each.body
            return Macro(macro.name, (EITHER, "(", *body, ")"))
        self._tell(
            macro.name,
            f"The macro {macro.name} has several definitions, and nobody knows which one holds: the first is taken.",
        )
        return with_text[0] if with_text else there[0] if there else Macro(macro.name, ())


def _is_value(body: Sequence[str]) -> bool:
    """Whether a body is a value: no statement, all brackets closed."""
    depth = 0
    for token in body:
        depth += (token in {"(", "["}) - (token in {")", "]"})
        if depth < 0 or token in {";", "{", "}"} or (token == "," and not depth):
            return False
    return depth == 0


def _arguments(pending: list[tuple[str, frozenset[str]]]) -> list[list[str]] | None:
    """The arguments of a call that begins at the end of `pending`, which are taken from it; None where there is no call."""
    at = len(pending) - 1
    while at >= 0 and pending[at][0].isspace():
        at -= 1
    if at < 0 or pending[at][0] != "(":
        return None
    arguments: list[list[str]] = [[]]
    depth, position = 1, at - 1
    while position >= 0:
        token = pending[position][0]
        position -= 1
        if token in {"(", "[", "{"}:
            depth += token == "("
        elif token == ")":
            depth -= 1
            if not depth:
                del pending[position + 1 :]
                return [trimmed(argument) for argument in arguments]
        elif token == "," and depth == 1:
            arguments.append([])
            continue
        arguments[-1].append(token)
        if at - position > _ARGUMENT:
            raise TooMuchError
    return None


def _next_name(body: Sequence[str], position: int) -> str:
    while position < len(body) and body[position] == " ":
        position += 1
    return body[position] if position < len(body) else ""


def _closing(body: Sequence[str], position: int) -> int:
    depth = 0
    for at in range(position, len(body)):
        depth += (body[at] == "(") - (body[at] == ")")
        if not depth:
            return at
    return len(body)


def _beside_paste(body: Sequence[str], after: int) -> bool:
    """Whether the token before `after` is an operand of `##`."""
    if _next_name(body, after) == "##":
        return True
    at = after - 2
    while at >= 0 and body[at] == " ":
        at -= 1
    return at >= 0 and body[at] == "##"


def _pasted(found: list[str]) -> list[str]:
    """The tokens with those beside `##` made one."""
    result: list[str] = []
    position = 0
    while position < len(found):
        token = found[position]
        position += 1
        if token != "##" or not result:
            result.append(token)
            continue
        while position < len(found) and found[position] == " ":
            position += 1
        while result and result[-1] == " ":
            result.pop()
        if position < len(found) and result:
            if result[-1] == ",":  # it stays before what is given, and goes where that is nothing
                if found[position] == _NO_MORE:
                    result.pop()
                else:
                    result.append(found[position])
            else:
                one = (result.pop() + found[position]).replace(_NOTHING, "")
                result.append(one or _NOTHING)
            position += 1
    return result


def _quoted(argument: Sequence[str]) -> str:
    """The argument of `#` as a literal."""
    text = "".join(t.replace("\\", "\\\\").replace('"', '\\"') if t[-1:] in {'"', "'"} else t for t in argument)
    return f'"{text}"'
