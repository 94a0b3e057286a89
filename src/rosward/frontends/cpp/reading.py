# SPDX-License-Identifier: Apache-2.0
"""What becomes of one file, line by line: directives carried out, conditions decided or kept both ways, macros expanded?"""

from __future__ import annotations

import re
from typing import Final, Protocol, final

from rosward.findings import Finding
from rosward.frontends.cpp.branches import CONDITIONS, Directive, begins_here, branch_ends, code_of, is_whole
from rosward.frontends.cpp.conditions import Asked, holds, is_defined
from rosward.frontends.cpp.file_text import SourceLines
from rosward.frontends.cpp.known import macro_prefix
from rosward.frontends.cpp.literals import hidden, shown
from rosward.frontends.cpp.macros import Expansion, Macro, Macros, TooMuchError, definition
from rosward.frontends.cpp.merged import merged
from rosward.frontends.cpp.prepared import Choice, Prepared
from rosward.frontends.cpp.registrations import registrations as registered_classes
from rosward.frontends.cpp.store import FileStore
from rosward.frontends.cpp.suited import suited
from rosward.frontends.cpp.tokens import NAME, open_brackets, tokens
from rosward.frontends.cpp.unknown import without_unknown
from rosward.location import Place

DEPTH: Final = 60
"""How deeply files may include each other, and conditions stand in each other."""

_TEXT_LIMIT: Final = 4_000_000
_GIVEN: Final = frozenset({"assert"})
"""Macros of which the language says what they do, however somebody defines them."""
_CALL_LINES: Final = 400
_SHORT: Final = 10_000
"""So many tokens may become of what is expanded only to be looked at."""
_GOES_ON: Final = re.compile(r"\s*else\b")
"""What belongs to a statement from before."""
_INCLUDE: Final = re.compile(r'"([^"\n]+)"|<([^>\n]+)>')


class UnitView(Asked, Protocol):
    """The unit that a file is read for."""

    store: FileStore
    includes: tuple[str, ...]
    macros: Macros
    active: set[str]
    once: set[str]
    prefixes: set[str]
    budget: int
    here: str

    def visit(self, path: str, depth: int) -> frozenset[str]:
        """Prepare a file that is included at file scope; the names in it and in what it includes."""


@final
class Reading:
    """One file in the course of being prepared."""

    def __init__(self, unit: UnitView, path: str, source: SourceLines, depth: int) -> None:
        self._unit = unit
        self._path = path
        self._source = source
        self._depth = depth
        self._out: list[str] = []
        self._size = 0
        self._includes: dict[str, None] = {}
        self._external: dict[str, None] = {}
        self._choices: list[Choice] = []
        self._counted = self._open = 0
        self._conditions = 0
        self._depth_of_conditions = 0
        self._expanded: set[int] = set()
        self._findings: list[Finding] = []
        self.inner: list[frozenset[str]] = []
        self.changes: list[tuple[str, Macro | None]] = []

    def prepared(self) -> Prepared:
        """Prepare it."""
        self._unit.here = self._path
        self._run(0, len(self._source.lines))
        text = "\n".join(self._out)
        text, registrations = registered_classes(text)
        text, contents = hidden(text)
        text, blanked = without_unknown(text)
        for name, line in blanked:
            self._tell(
                "RW206", f"The macro {name} is not defined in the sources: what it declares is not known.", line - 1
            )
        return Prepared(
            self._path,
            self._source.file,
            shown(suited(text), contents),
            tuple(self._includes),
            tuple(self._external),
            tuple(self._choices),
            tuple(registrations),
            frozenset(self._expanded),
            tuple(dict.fromkeys(self._findings)),
        )

    def _run(self, first: int, last: int) -> None:
        """The lines of a part of the file; each is put out, be it as an empty one."""
        lines, found = self._source.lines, self._source.found
        number = first
        while number < last:
            directive = found.get(number)
            if directive is None:
                start = number
                while number < last and number not in found:
                    number += 1
                self._text(lines[start:number])
            elif directive.name in CONDITIONS and directive.following >= 0:
                number = self._condition(directive, last)
            else:
                self._directive(directive)
                number += 1

    def _text(self, lines: list[str]) -> None:
        """Lines without directives, with macros expanded."""
        unit = self._unit
        self._size += sum(map(len, lines))
        if self._size > _TEXT_LIMIT:
            self._tell("RW201", "This file is too large after preprocessing: not all of it is read.", len(self._out))
            self._out += [""] * len(lines)
            return
        macros = unit.macros
        if macros.keys().isdisjoint(self._source.names) or macros.keys().isdisjoint(NAME.findall("\n".join(lines))):
            self._out += lines
            return
        number = 0
        while number < len(lines):
            line = lines[number]
            number += 1
            if macros.keys().isdisjoint(NAME.findall(line)):
                self._out.append(line)
                continue
            start = number
            depth = open_brackets(line)
            while depth > 0 and number < len(lines) and number - start < _CALL_LINES:
                depth += open_brackets(lines[number])
                number += 1
            if (
                depth == 0
                and number < len(lines)
                and NAME.fullmatch(line.rpartition(" ")[2].strip() or "-")
                and lines[number].lstrip().startswith("(")
            ):
                number += 1
            taken = lines[start - 1 : number]
            expansion = Expansion(macros, unit.budget, self._tell_of_macro)
            try:
                made = "".join(expansion.expand(tokens("\n".join(taken))))
            except TooMuchError:
                self._tell("RW201", "The macros here make too much text: they are not expanded.", len(self._out))
                unit.budget //= 2
                self._out += taken
                continue
            unit.budget = expansion.budget
            result = made.split("\n")
            self._expanded.update(range(len(self._out) + 1, len(self._out) + len(taken) + 1))
            self._size += len(made)
            more = len(result) - len(taken)
            if more > 0:
                result[: more + 1] = [" ".join(result[: more + 1])]
            self._out += result + [""] * (len(taken) - len(result))

    def _tell_of_macro(self, name: str, message: str) -> None:
        self._tell("RW206", message, len(self._out), (f"macro {name}",))

    def _tell(self, code: str, message: str, line: int, causes: tuple[str, ...] = ()) -> None:
        if len(self._findings) < 50:
            self._findings.append(Finding(code, message, Place(self._source.file, line + 1), causes))

    def _directive(self, directive: Directive) -> None:
        unit = self._unit
        self._out.append("")
        match directive.name:
            case "define":
                macro = definition(directive.text)
                if macro is not None and macro.name not in _GIVEN:
                    unit.macros[macro.name] = macro
                    self.changes.append((macro.name, macro))
            case "undef":
                name = directive.text.split(" ")[0]
                unit.macros.pop(name, None)
                self.changes.append((name, None))
            case "include" | "include_next" | "import":
                self._include(directive)
            case _:
                pass

    def _include(self, directive: Directive) -> None:
        unit = self._unit
        text = directive.text
        if text[:1] not in {'"', "<"}:
            text = self._with_macros(text).strip()
        found = _INCLUDE.match(text)
        if found is None:
            self._tell("RW206", "Which file is included here is not known.", directive.line)
            return
        name = found[1] or found[2]
        path = unit.store.find(name, self._path, unit.includes, found[1] is not None)
        path = path or unit.store.above(name, self._path)
        if path is None:
            self._external[name] = None
            unit.prefixes.add(macro_prefix(name))
            return
        if self._within_brackets():
            self._in_place(path, directive)
        else:
            self._includes[path] = None
            self.inner.append(unit.visit(path, self._depth + self._depth_of_conditions + 1))
            unit.here = self._path

    def _within_brackets(self) -> bool:
        text = "\n".join(self._out[self._counted :])
        self._counted = len(self._out)
        self._open += text.count("{") + text.count("(") - text.count("}") - text.count(")")
        return self._open > 0

    def _in_place(self, path: str, directive: Directive) -> None:
        """The text of a file that is included within brackets, in the line of the directive."""
        unit = self._unit
        source = unit.store.source(path)
        if isinstance(source, Finding) or self._depth > DEPTH or path in unit.active or path in unit.once:
            return
        unit.active.add(path)
        inner = Reading(unit, path, source, self._depth + self._depth_of_conditions + 1)
        text = inner.prepared().text
        unit.active.discard(path)
        unit.here = self._path
        self.inner += [source.names, *inner.inner]
        self.changes += inner.changes
        self._includes |= inner._includes
        self._findings += inner._findings
        self._size += len(text)
        unit.budget -= len(text) // 10
        if self._size <= _TEXT_LIMIT and unit.budget > 0:
            self._out[-1] = " ".join(text.split("\n"))
            self._expanded.add(directive.line + 1)
        else:
            self._tell("RW201", "What is included here is too large: it is not read.", directive.line)

    # Conditions

    def _verdict(self, directive: Directive) -> bool | None:
        unit = self._unit
        match directive.name:
            case "ifdef" | "elifdef" | "ifndef" | "elifndef":
                name = directive.text.split(" ")[0]
                answer = is_defined(name, unit.macros, unit)
                if name == self._source.guard:
                    answer = False
                return answer if answer is None or "n" not in directive.name else not answer
            case "else":
                return True
            case _ if (
                self._source.guard
                and self._source.guard in directive.text
                and directive.line == next(iter(self._source.found))
            ):
                return True
            case _:
                return holds(directive.text, unit.macros, unit, 20_000)

    def _condition(self, opening: Directive, last: int) -> int:
        """The branches of a condition; the line behind its end."""
        lines, found = self._source.lines, self._source.found
        branches = branch_ends(found, opening.line, len(lines))
        end = branches[-1][1]
        chosen: list[int] = []
        complete = False
        for number, (first, _) in enumerate(branches):
            verdict = self._verdict(found[first - 1])
            if verdict is not False:
                chosen.append(number)
            if verdict:
                complete = True
                break
        several = bool(chosen) and len(chosen) + (not complete) > 1
        if several and not self._can_keep(branches):
            if self._merge([branches[n] for n in chosen], end, complete=complete):
                self._out += [""] * (end - opening.line - 1 - (end >= last))
                return end + 1
            self._tell(
                "RW206",
                "Whether this condition holds is not known, and its branches are no whole statements: the first is taken.",
                opening.line,
            )
            chosen, several = chosen[:1], False
        if self._depth + self._depth_of_conditions > DEPTH:
            self._tell("RW201", "Conditions are nested too deeply: these branches are not read.", opening.line)
            chosen = []
        if several:
            self._both(branches, chosen, complete)
        else:
            for number, (first, behind) in enumerate(branches):
                self._out.append("")
                if number in chosen:
                    self._nested(first, behind)
                else:
                    self._out += [""] * (behind - first)
        if end < last:
            self._out.append("")
        return end + 1

    def _merge(self, branches: list[tuple[int, int]], end: int, *, complete: bool) -> bool:
        """Put out one text for all branches, in the line of the first, where that can be."""
        lines, found = self._source.lines, self._source.found
        if any(number in found for first, behind in branches for number in range(first, behind)):
            return False
        before = "\n".join(self._out[-200:])
        after = "\n".join(lines[end + 1 : end + 20])
        text = merged(["\n".join(lines[first:behind]) for first, behind in branches], before, after, complete=complete)
        if text is None:
            return False
        self._out.append("")
        self._text([text])
        self._expanded.add(len(self._out))
        return True

    def _nested(self, first: int, behind: int) -> None:
        self._depth_of_conditions += 1
        self._run(first, behind)
        self._depth_of_conditions -= 1

    def _can_keep(self, branches: list[tuple[int, int]]) -> bool:
        """Whether all branches can stand one after the other in the text."""
        before = ""
        for line in reversed(self._out[-200:]):
            if line.strip():
                before = line
                break
        codes = [code_of(self._source.lines, self._source.found, *branch) for branch in branches]
        if not any(code.strip() for code in codes):
            return True
        return begins_here(before) and all(map(self._is_whole, codes))

    def _is_whole(self, code: str) -> bool:
        """Whether a branch is whole statements or members: as it is written, or with its macros (`MEMBERS(a, b)`)."""
        return not _GOES_ON.match(code) and (is_whole(code) or is_whole(self._with_macros(code)))

    def _with_macros(self, text: str) -> str:
        """A text with macros expanded; as it is where that is too much."""
        unit = self._unit
        if unit.macros.keys().isdisjoint(NAME.findall(text)):
            return text
        expansion = Expansion(unit.macros, _SHORT, lambda _, __: None)
        try:
            made = "".join(expansion.expand(tokens(text)))
        except TooMuchError:
            return text
        unit.budget -= _SHORT - expansion.budget
        return made

    def _both(self, branches: list[tuple[int, int]], chosen: list[int], complete: bool) -> None:
        """Each branch that may be taken, one after the other, each with the macros from before; what they define is joined."""
        unit = self._unit
        self._conditions += 1
        condition = self._conditions
        before = unit.macros
        unit.budget -= len(before) // 4 * len(chosen)
        after: list[Macros] = [] if complete else [before]
        for number, (first, behind) in enumerate(branches):
            self._out.append("")
            if number in chosen and unit.budget < 0:
                self._tell("RW201", "There are too many conditions that nobody knows: this branch is not read.", first)
            if number not in chosen or unit.budget < 0:
                self._out += [""] * (behind - first)
                continue
            unit.macros = dict(before)
            self._nested(first, behind)
            after.append(unit.macros)
            self._choices.append(Choice(condition, number, first + 1, behind, complete))
        unit.macros = dict(before)
        for name in sorted(set().union(*after)):
            values = dict.fromkeys(each.get(name) for each in after)
            if len(values) > 1 or next(iter(values)) != before.get(name):
                made: Macro | None = next(iter(values))
                if len(values) > 1:
                    parts = [p for v in values for p in (v.alternatives if v is not None and v.alternatives else (v,))]
                    made = Macro(name, (), None, "", tuple(dict.fromkeys(parts))[:8])
                if made is None:
                    unit.macros.pop(name, None)
                else:
                    unit.macros[name] = made
                self.changes.append((name, made))
