# SPDX-License-Identifier: Apache-2.0
"""What does a translation unit hold after preprocessing?

    #include "demo/topics.hpp"                    files: demo/topics.hpp, then the source itself,
    auto pub = node->advertise(STATUS_TOPIC);     with "/robot/status" where the macro stood

Each file keeps its own text and its own lines; a header is prepared once for all units in which the macros that it looks at are the
same. Only what is included within brackets is put in place. No program of the machine has a part in this, and no header that is not of
the sources is read.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from typing import Final, final

from rosward.findings import Finding
from rosward.frontends.cpp.branches import Directive, begins_here, branch_ends, code_of, directives, guard, is_whole
from rosward.frontends.cpp.clean import cleaned
from rosward.frontends.cpp.conditions import Asked, holds, is_defined
from rosward.frontends.cpp.known import (
    DEPENDS,
    HEADERS,
    NOT_DEFINED,
    REGISTERING,
    VERSIONS,
    macro_prefix,
    predefined,
)
from rosward.frontends.cpp.macros import Expansion, Macro, Macros, TooMuchError, definition
from rosward.frontends.cpp.prepared import Choice, Prepared, Registration, Translation
from rosward.frontends.cpp.suited import suited
from rosward.frontends.cpp.tokens import NAME, tokens
from rosward.frontends.cpp.unknown import without_unknown
from rosward.source.location import Place

_BUDGET: Final = 2_000_000
"""How many tokens macros may make in one unit, and what else takes long."""

_DEPTH: Final = 60
_TEXT_LIMIT: Final = 4_000_000
_CALL_LINES: Final = 400
_VARIANTS: Final = 12
_REGISTER: Final = re.compile(rf"\b({'|'.join(sorted(REGISTERING))})\s*\(")
_INCLUDE: Final = re.compile(r'"([^"\n]+)"|<([^>\n]+)>')
_CONDITIONS: Final = frozenset({"if", "ifdef", "ifndef"})

Read = Callable[[str], str | Finding]
Find = Callable[[str, str, Sequence[str], bool], str | None]


@final
class _Source:
    """A file as it is on disk, cleaned."""

    __slots__ = ("file", "found", "guard", "lines", "names")

    def __init__(self, file: str, text: str) -> None:
        self.file = file
        self.lines = cleaned(text).split("\n")
        self.found = directives(self.lines)
        self.guard = guard(self.lines, self.found)
        self.names = frozenset(NAME.findall("\n".join(self.lines)))


@final
class _Result:
    """What became of a file where the macros were these: `seen` are the ones at its beginning that it could look at."""

    __slots__ = ("changes", "names", "prepared", "seen")

    def __init__(
        self, prepared: Prepared, names: frozenset[str], seen: Macros, changes: list[tuple[str, Macro | None]]
    ) -> None:
        self.prepared = prepared
        self.names = names
        self.seen = seen
        self.changes = changes


@final
class Preprocessor:
    """Prepares the sources of a workspace; what it has read and prepared is shared by all units.

    `read` gives the text of a file, `named` how places call it, `find` the file of the workspace that an include leads to.
    """

    def __init__(self, read: Read, named: Callable[[str], str], find: Find, distro: str = "") -> None:
        self._read = read
        self._named = named
        self.find = find
        self.distro = distro
        self._sources: dict[str, _Source | Finding] = {}
        self._results: dict[str, list[_Result]] = {}
        self._same: dict[tuple[str, str, tuple[Choice, ...]], Prepared] = {}
        self._predefined = predefined()
        self.guards: set[str] = set()

    def translate(
        self, path: str, includes: Sequence[str], definitions: Iterable[tuple[str, str, bool]]
    ) -> Translation:
        """The unit of the source at `path`, with its folders of headers and the macros of its command line (name, value, sure)."""
        macros = dict(self._predefined)
        for name, value, sure in definitions:
            macro = definition(f"{name} {value}")
            if macro is not None:
                macros[macro.name] = macro if sure else Macro(macro.name, (), None, "", (macro, None))
        unit = _Unit(self, tuple(includes), macros)
        unit.visit(path, 0)
        return Translation(path, tuple(unit.order.values()), tuple(dict.fromkeys(unit.findings)))

    def source(self, path: str) -> _Source | Finding:
        """A file, read once."""
        found = self._sources.get(path)
        if found is None:
            text = self._read(path)
            found = self._sources[path] = text if isinstance(text, Finding) else _Source(self._named(path), text)
            if isinstance(found, _Source) and found.guard:
                self.guards.add(found.guard)
        return found

    def known(self, path: str, macros: Macros) -> _Result | None:
        """What became of the file before, under macros that for it are the same."""
        for result in self._results.get(path, ()):
            seen = result.seen
            if len(seen) == len(self.looked_at(macros, result.names)) and all(
                macros.get(n) is m or macros.get(n) == m for n, m in seen.items()
            ):
                return result
        return None

    def looked_at(self, macros: Macros, names: frozenset[str]) -> Macros:
        """The macros that a file with these names in it can look at."""
        return {n: macros[n] for n in macros.keys() & names if n not in self.guards and n not in self._predefined}

    def keep(self, path: str, result: _Result) -> None:
        """Remember what became of a file."""
        several = self._results.setdefault(path, [])
        if len(several) < _VARIANTS:
            several.append(result)

    def one(self, prepared: Prepared) -> Prepared:
        """The same record for the same text."""
        return self._same.setdefault((prepared.path, prepared.text, prepared.choices), prepared)


@final
class _Unit(Asked):
    """A translation unit in the course of being prepared."""

    def __init__(self, preprocessor: Preprocessor, includes: tuple[str, ...], macros: Macros) -> None:
        self.preprocessor = preprocessor
        self.includes = includes
        self.macros = macros
        self.order: dict[str, Prepared] = {}
        self.active: set[str] = set()
        self.once: set[str] = set()
        self.prefixes: set[str] = set()
        self.findings: list[Finding] = []
        self.budget = _BUDGET
        self.here = ""

    def visit(self, path: str, depth: int) -> frozenset[str]:
        """Prepare a file that is included at file scope; the names in it and in what it includes."""
        source = self.preprocessor.source(path)
        if isinstance(source, Finding):
            self.findings.append(source)
            return frozenset()
        if path in self.once or path in self.active or depth > _DEPTH:
            if depth > _DEPTH:
                self.findings.append(
                    Finding("RW201", "Files include each other too deeply: not all are read.", Place(source.file))
                )
            return frozenset()
        if source.guard is not None:
            self.once.add(path)
        before = self.here
        self.active.add(path)
        result = self.preprocessor.known(path, self.macros)
        if result is None:
            reading = _Reading(self, path, source, depth)
            seen = dict(self.macros)
            prepared = self.preprocessor.one(reading.prepared())
            names = frozenset().union(source.names, *reading.inner)
            result = _Result(prepared, names, self.preprocessor.looked_at(seen, names), reading.changes)
            self.preprocessor.keep(path, result)
        else:
            self.prefixes.update(map(macro_prefix, result.prepared.external))
            for inner in result.prepared.includes:
                self.visit(inner, depth + 1)
            for name, macro in result.changes:
                if macro is None:
                    self.macros.pop(name, None)
                else:
                    self.macros[name] = macro
        self.order[path] = result.prepared
        self.active.discard(path)
        self.here = before
        return result.names

    def defined(self, name: str) -> bool | None:
        """By the tables, and by the headers from elsewhere that were included: these may define what begins with their name."""
        if name in NOT_DEFINED:
            return False
        if name in DEPENDS or name in VERSIONS or name.endswith(("_VERSION", "_VERSION_MAJOR", "_VERSION_MINOR")):
            return None
        return None if name.partition("_")[0] in self.prefixes and "_" in name else False

    def has_include(self, name: str, *, quoted: bool) -> bool | None:
        """A header of the workspace or of the standard library is there; nobody knows about others."""
        if name in HEADERS or self.preprocessor.find(name, self.here, self.includes, quoted) is not None:
            return True
        return None

    def call(self, name: str, arguments: Sequence[str]) -> bool | None:
        """`RCLCPP_VERSION_GTE(28, 0, 0)` by the distro."""
        version = VERSIONS.get(name, {}).get(self.preprocessor.distro)
        if version is None or not all(a.isdigit() for a in arguments):
            return None
        return version >= tuple(int(a[:9]) for a in arguments)


@final
class _Reading:
    """One file in the course of being prepared."""

    def __init__(self, unit: _Unit, path: str, source: _Source, depth: int) -> None:
        self._unit = unit
        self._path = path
        self._source = source
        self._depth = depth
        self._out: list[str] = []
        self._size = 0
        self._includes: dict[str, None] = {}
        self._external: dict[str, None] = {}
        self._choices: list[Choice] = []
        self._conditions = 0
        self._expanded: set[int] = set()
        self._findings: list[Finding] = []
        self.inner: list[frozenset[str]] = []
        self.changes: list[tuple[str, Macro | None]] = []

    def prepared(self) -> Prepared:
        """Prepare it."""
        self._unit.here = self._path
        self._run(0, len(self._source.lines))
        text = "\n".join(self._out)
        text, registrations = self._registrations(text)
        text, blanked = without_unknown(text)
        for name, line in blanked:
            self._tell(
                "RW206", f"The macro {name} is not defined in the sources: what it declares is not known.", line - 1
            )
        return Prepared(
            self._path,
            self._source.file,
            suited(text),
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
            elif directive.name in _CONDITIONS and directive.following >= 0:
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
            depth = line.count("(") - line.count(")")
            while depth > 0 and number < len(lines) and number - start < _CALL_LINES:
                depth += lines[number].count("(") - lines[number].count(")")
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
            result = [" ".join(result[: len(result) - len(taken) + 1]), *result[len(result) - len(taken) + 1 :]]
            self._out += result + [""] * (len(taken) - len(result))

    def _tell_of_macro(self, message: str) -> None:
        self._tell("RW206", message, len(self._out))

    def _tell(self, code: str, message: str, line: int) -> None:
        if len(self._findings) < 50:
            self._findings.append(Finding(code, message, Place(self._source.file, line + 1)))

    def _directive(self, directive: Directive) -> None:
        unit = self._unit
        self._out.append("")
        match directive.name:
            case "define":
                macro = definition(directive.text)
                if macro is not None:
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
            try:
                text = "".join(Expansion(unit.macros, 10_000, lambda _: None).expand(tokens(text))).strip()
            except TooMuchError:
                text = ""
        found = _INCLUDE.match(text)
        if found is None:
            self._tell("RW206", "Which file is included here is not known.", directive.line)
            return
        name = found[1] or found[2]
        path = unit.preprocessor.find(name, self._path, unit.includes, found[1] is not None)
        if path is None:
            self._external[name] = None
            unit.prefixes.add(macro_prefix(name))
            return
        if self._within_brackets():
            self._in_place(path, directive)
        else:
            self._includes[path] = None
            self.inner.append(unit.visit(path, self._depth + 1))
            unit.here = self._path

    def _within_brackets(self) -> bool:
        text = "\n".join(self._out)
        self._unit.budget -= len(text) // 100
        return text.count("{") + text.count("(") > text.count("}") + text.count(")")

    def _in_place(self, path: str, directive: Directive) -> None:
        """The text of a file that is included within brackets, in the line of the directive."""
        unit = self._unit
        source = unit.preprocessor.source(path)
        if isinstance(source, Finding) or self._depth > _DEPTH or path in unit.active or path in unit.once:
            return
        unit.active.add(path)
        inner = _Reading(unit, path, source, self._depth + 1)
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
        possible: list[tuple[int, int, bool]] = []
        complete = False
        for number, (first, behind) in enumerate(branches):
            directive = found[first - 1]
            verdict = self._verdict(directive)
            if verdict is not False:
                possible.append((number, first, True))
            if verdict:
                complete = True
                break
            del behind
        several = len(possible) + (not complete) > 1 and bool(possible)
        chosen = [number for number, _, _ in possible]
        if several and not self._can_keep(branches):
            self._tell(
                "RW206",
                "Whether this condition holds is not known, and its branches are no whole statements: the first is taken.",
                opening.line,
            )
            chosen, several = chosen[:1], False
        if self._depth_of_conditions > _DEPTH:
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

    _depth_of_conditions = 0

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
        return begins_here(before) and all(map(is_whole, codes))

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

    # Registrations

    @staticmethod
    def _registrations(text: str) -> tuple[str, list[Registration]]:
        """The text without the macros that register a class, and what they register."""
        found: list[Registration] = []
        pieces: list[str] = []
        position = 0
        for match in _REGISTER.finditer(text):
            if match.start() < position:
                continue
            depth, end = 1, match.end()
            while end < len(text) and depth and end - match.end() < 2_000:
                depth += (text[end] == "(") - (text[end] == ")")
                end += 1
            if depth:
                continue
            arguments = tuple(part.strip() for part in text[match.end() : end - 1].split(","))
            found.append(Registration(match[1], arguments, text.count("\n", 0, match.start()) + 1))
            pieces += [text[position : match.start()], "\n" * text.count("\n", match.start(), end)]
            position = end
        return "".join([*pieces, text[position:]]), found
