# SPDX-License-Identifier: Apache-2.0
"""Which substitutions stand in the text of an attribute?

    $(find-pkg-share demo)/$(var kind)_$(eval '1 + $(var n)').yaml
    ->  (Substitution('find-pkg-share', …), Const('/'), Substitution('var', …), Const('_'), Substitution('eval', …), Const('.yaml'))

The grammar is launch's own (frontend/grammar.lark, the same from humble to rolling), which is stricter than it looks: arguments are divided
by exactly one blank, a quoted argument is quoted as a whole, and quotes within quotes are text. What it refuses ends the whole launch file.
"""

from __future__ import annotations

import re
from typing import Final, final

from rosward.deployment.tree import Substitution, Template
from rosward.domain.values import Const, Value
from rosward.location import Place
from rosward.records import NamedTuple

UNKNOWN: Final = "unknown"
"""The kind of a substitution that launch does not know; its name is the argument."""

_DEPTH_LIMIT: Final = 50
_MANY: Final = 1_000_000


class SubstitutionError(ValueError):
    """launch refuses this text; the message says why."""


class _Quoting(NamedTuple):
    """How text is written inside a kind of quotes: between substitutions, and as a part of an argument."""

    text: re.Pattern[str]
    part: re.Pattern[str]


# A backslash makes the $ or the parenthesis after it text, even where a backslash before makes it text itself.
_UNQUOTED: Final = _Quoting(
    re.compile(r"(?:[^$]+|\$(?!\()|(?<=\\)\$)+"),
    re.compile(r"""(?:[^ '"\\$()]+|(?<=\\)[()$]|\$(?!\()|\\['"]|\\)+"""),
)
_QUOTED: Final = {
    "'": _Quoting(
        re.compile(r"(?:[^'\\$]+|\$(?!\()|(?<=\\)\$|\\'|\\)+"),
        re.compile(r"(?:[^ '\\$()]+|(?<=\\)[()$]|\$(?!\()|\\'|\\)+"),
    ),
    '"': _Quoting(
        re.compile(r'(?:[^"\\$]+|\$(?!\()|(?<=\\)\$|\\"|\\)+'),
        re.compile(r'(?:[^ "\\$()]+|(?<=\\)[()$]|\$(?!\()|\\"|\\)+'),
    ),
}
_NAME: Final = re.compile(r"[A-Za-z][A-Za-z0-9_-]*")
_ESCAPE: Final = re.compile(r"\\(.)")


class _Form(NamedTuple):
    """How a substitution is written: the kind that it becomes, and how many arguments it takes."""

    kind: str
    least: int
    most: int


_FORMS: Final = {
    "var": _Form("var", 1, 2),
    "env": _Form("env", 1, 2),
    "find-pkg-share": _Form("find-pkg-share", 1, 1),
    "find-pkg-prefix": _Form("find-pkg-prefix", 1, 1),
    "exec-in-pkg": _Form("exec-in-pkg", 2, 2),
    "find-exec": _Form("find-exec", 1, 1),
    "dirname": _Form("dirname", 0, 0),
    "filename": _Form("filename", 0, 0),
    "launch_log_dir": _Form("launch-log-dir", 0, 0),
    "log_dir": _Form("launch-log-dir", 0, 0),
    "anon": _Form("anon", 1, 1),
    "eval": _Form("eval", 1, 2),
    "command": _Form("command", 1, 2),
    "param": _Form("param", 1, 2),
    "not": _Form("not", 1, 1),
    "and": _Form("and", 2, 2),
    "or": _Form("or", 2, 2),
    "any": _Form("any", 0, _MANY),
    "all": _Form("all", 0, _MANY),
    "equals": _Form("equals", 2, 2),
    "not-equals": _Form("not-equals", 2, 2),
    "if": _Form("if", 2, 3),
    "file-content": _Form("file-content", 1, 1),
    "string-join": _Form("string-join", 1, _MANY),
    "for-var": _Form("for-var", 1, 2),
    "index": _Form("index", 1, 2),
}


def parse_substitution(text: str, place: Place) -> Template:
    """The pieces of `text`; raises SubstitutionError where launch's grammar refuses it."""
    if not text:
        return (Const(""),)
    parser = _Parser(text, place)
    template = parser.fragments(_UNQUOTED)
    if parser.position < len(text):
        raise parser.error("a substitution is not closed")
    return template


def unescaped(text: str) -> str:
    r"""The text without its escapes: `\$` is `$`. Names of arguments are written so, without substitutions."""
    return _ESCAPE.sub(r"\1", text)


def unknown_text(what: str, place: Place) -> Template:
    """Text that stands for what cannot be read."""
    return (Substitution(UNKNOWN, ((Const(what),),), place),)


def plain_text(template: Template) -> str | None:
    """The text itself, if there is no substitution in it."""
    words: list[str] = []
    for piece in template:
        if not isinstance(piece, Const) or not isinstance(piece.value, str):
            return None
        words.append(piece.value)
    return "".join(words)


@final
class _Parser:
    """One text, read from left to right; the grammar is unambiguous once every text is as long as it can be."""

    def __init__(self, text: str, place: Place) -> None:
        self._text = text
        self._place = place
        self._depth = 0
        self.position = 0

    def fragments(self, quoting: _Quoting) -> Template:
        """Text and substitutions, as far as they go."""
        return self._pieces(quoting, quoting.text)

    def error(self, why: str) -> SubstitutionError:
        """The text is refused at the present position."""
        rest = self._text[self.position : self.position + 20]
        where = f"before {rest!r}" if rest else "at the end"
        shown = self._text if len(self._text) <= 100 else self._text[:100] + "…"
        return SubstitutionError(f"{shown!r} is not a valid launch string: {why} ({where}).")

    def _pieces(self, quoting: _Quoting, text: re.Pattern[str]) -> Template:
        pieces: list[Value | Substitution] = []
        while True:
            found = text.match(self._text, self.position)
            if found:
                self.position = found.end()
                pieces.append(Const(unescaped(found[0])))
            elif self._text.startswith("$(", self.position):
                pieces.append(self._substitution(quoting))
            else:
                return tuple(pieces)

    def _substitution(self, quoting: _Quoting) -> Substitution:
        self._depth += 1
        if self._depth > _DEPTH_LIMIT:
            raise self.error("substitutions are nested too deeply")
        self.position += 2
        name = _NAME.match(self._text, self.position)
        if not name:
            raise self.error("the name of a substitution is missing")
        self.position = name.end()
        arguments: list[Template] = []
        while self._take(" "):
            arguments.append(self._argument(quoting))
        if not self._take(")"):
            raise self.error("a substitution is not closed, or its arguments are not separated by one space")
        self._depth -= 1
        return self._made(name[0], arguments)

    def _argument(self, quoting: _Quoting) -> Template:
        mark = self._text[self.position : self.position + 1]
        if quoting is _UNQUOTED and mark in _QUOTED:
            self.position += 1
            template = self.fragments(_QUOTED[mark])
            if not self._take(mark):
                raise self.error(f"a {mark} is not closed")
            return template
        template = self._pieces(quoting, quoting.part)
        if not template:
            raise self.error("an argument is missing (arguments are separated by exactly one space)")
        return template

    def _take(self, sign: str) -> bool:
        if self._text.startswith(sign, self.position):
            self.position += 1
            return True
        return False

    def _made(self, name: str, arguments: list[Template]) -> Substitution:
        form = _FORMS.get(name)
        if form is None:
            return Substitution(UNKNOWN, ((Const(name),),), self._place)
        if not form.least <= len(arguments) <= form.most:
            raise self.error(f"$({name} …) does not take {len(arguments)} arguments")
        if name == "if" and len(arguments) == 2:
            arguments.append(())
        if name == "eval" and len(arguments) == 2:
            arguments[1:] = _modules(arguments[1])
        return Substitution(form.kind, tuple(arguments), self._place)


def _modules(template: Template) -> list[Template]:
    """The modules of $(eval …): names with commas between them, of which launch looks at the first piece only."""
    names = plain_text(template[:1]) or ""
    return [(Const(each.strip()),) for each in names.split(",")] if template else []
