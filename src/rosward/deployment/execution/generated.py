# SPDX-License-Identifier: Apache-2.0
"""The parameter files that launch writes while it runs, and the content behind a path, written or found.

RewrittenYaml(source_file='$(find-pkg-share demo)/a.yaml', …)    ->    Const('/tmp/launch_params_1'), whose content is kept here

The path is passed on as text, through launch arguments and includes, until a node gets it. It is numbered instead of random.
"""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from typing import TYPE_CHECKING, Final, Protocol, final

from rosward.deployment.execution.content import Content
from rosward.deployment.execution.rewrites import (
    Pairs,
    Rows,
    below,
    is_refused_below,
    joined_rows,
    with_keys,
    with_new_values,
    with_values,
)
from rosward.deployment.execution.top_keys import has_key
from rosward.deployment.execution.yaml_values import as_plain_scalar, plain_text, replaced
from rosward.deployment.markup.substitutions import SubstitutionError, parse_substitution
from rosward.deployment.parameter_files import read_parameter_file
from rosward.domain.choice import join_all, lift, lift2, options, reasons_of
from rosward.domain.compound import Tuple
from rosward.domain.text import is_path, origins_of, parts_of, readable
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import NONE, Const, Hole, Text, Unknown, Value
from rosward.effects.configuration import Given
from rosward.location import Place

if TYPE_CHECKING:
    from rosward.deployment.execution.findings import FindingLog
    from rosward.deployment.execution.launch_files import LaunchFiles
    from rosward.deployment.tree import Template
    from rosward.findings import Finding

MAX_WAYS: Final = 8
MAX_FILES: Final = 2_000
STEM: Final = "/tmp/launch_params_"
"""How the names of the files begin that launch writes."""
_PUT: Final = "/tmp/launch_files_"
_TOKEN: Final = "rosward_hole_"
_ROOT: Final = re.compile("^//")


class Performs(Protocol):
    """Who performs the substitutions in a file that is written."""

    def text(self, template: Template) -> Value:
        """The text of a template now."""

    def fails(self, what: str, place: Place) -> None:
        """Tell that the real launch raises an exception here."""


@final
class GeneratedFiles:
    """Files that were written, by path, and files that were read, each once."""

    def __init__(self, files: LaunchFiles, findings: FindingLog) -> None:
        self._files = files
        self._findings = findings
        self._made: dict[str, Content] = {}
        self._paths = 0
        # By path: the text that the launch files have written, None of Python where they removed it.
        self._put: dict[str, Value] = {}
        self._parsed_put: dict[str, Content] = {}
        self._read: dict[str, tuple[Content, tuple[Finding, ...]]] = {}
        # By path: what is wrong, as parameters, with a file of any kind in which texts were replaced.
        self._doubts: dict[str, tuple[Finding, ...]] = {}

    def write(self, content: Content) -> Const:
        """A new file; its path."""
        path = f"{STEM}{len(self._made) + 1}"
        if len(self._made) < MAX_FILES:
            self._made[path] = content
        return Const(path)

    def is_made(self, path: Value) -> bool:
        """Whether the launch writes the file behind a path: what it lacks for that is told there."""
        return plain_text(path) in self._made

    def new_path(self) -> Value:
        """A path for what Python code of the launch writes, numbered instead of random."""
        self._paths += 1
        return Const(f"{_PUT}{self._paths}")

    def put(self, path: Value, text: Value) -> None:
        """Python code of the launch writes a file. Which one it is has to be known: whoever reads it by another path finds what was there before."""
        for option in options(path):
            name = self._name(option)
            if name and (name in self._put or len(self._put) < MAX_FILES):
                self._put[name] = text if len(options(path)) == 1 else Unknown(reasons_of(path))
                self._parsed_put.pop(name, None)

    def _name(self, path: Value) -> str:
        """One name for all spellings of a path; none where it is not known."""
        known = plain_text(path) is not None or is_path(path)
        return _ROOT.sub("/", os.path.normpath(self._files.show(path))) if known else ""

    def written(self, path: Value) -> Value | None:
        """The text that Python code of the launch has written into the file behind a path, if it has; None of Python where it has removed it."""
        return self._put.get(self._name(path)) if self._put else None

    def _written(self, path: Value, place: Place) -> Content | None:
        """The parameters that Python code of the launch has written into the file behind a path, if it has."""
        name = self._name(path)
        found = self._put.get(name)
        if found is not None and name not in self._parsed_put:
            reason = (*reasons_of(found), Reason(Cause.FILE, name, place))[0]
            if all(_is_text(option) for option in options(found)):
                self._parsed_put[name] = self._parsed([found], name, place)
            else:
                self._parsed_put[name] = Content(None, file=name, reason=reason, absent=found == NONE)
        return self._parsed_put.get(name)

    def content(self, path: Value, place: Place, *, as_text: bool = False) -> Content:
        """The content of the file behind one path (not a Choice). `as_text`: what is wrong with it as parameters does not matter yet."""
        name = plain_text(path) or ""
        made = self._made.get(name)
        if made is None and self._put:
            made = self._written(path, place)
        if not as_text:
            self._findings.add(*self._doubts.get(name, ()))
        if made is not None:
            return made
        file = self._files.find(path)
        if file is None:
            return self._outside(path, place)
        if file not in self._read:
            self._read[file] = self._load(file, place)
        content, findings = self._read[file]
        if not as_text:
            self._findings.add(*findings)
        return content

    def _outside(self, path: Value, place: Place) -> Content:
        shown = self._files.show(path)
        first = parts_of(path)[0]
        absent = isinstance(first, Hole) and is_path(path) and len(parts_of(path)) == 2
        if absent and isinstance(first, Hole):
            absent = all(r.cause is not Cause.PREFIX and self._has(r) for r in first.reasons)
        return Content(None, reason=Reason(Cause.FILE, shown, place), absent=absent)

    def _has(self, reason: Reason) -> bool:
        return reason.cause is Cause.SOURCES or self._files.has_package(reason.subject)

    def _load(self, file: str, place: Place) -> tuple[Content, tuple[Finding, ...]]:
        text = self._files.text(file)
        if text is None:
            return Content(None, file=file, reason=Reason(Cause.FILE, file, place)), ()
        rows, findings = read_parameter_file(text, file)
        return Content(rows, text, file), tuple(findings)

    def has_key(self, path: Value, key: Value, place: Place) -> Value:
        """HasNodeParams of nav2_common: 'True' where a key stands at the top of the file."""

        def one(file: Value, name: Value) -> Value:
            content = self.content(file, place)
            if content.absent:
                shown = self._files.show(file)
                self._findings.tell("RW320", f"The file {shown}, whose keys are requested, does not exist.", place)
            plain = plain_text(name)
            found = has_key(content, plain) if plain is not None else None
            if found is None:
                reason = content.reason or Reason(Cause.FILE, readable(file), place)
                return Unknown((*reasons_of(file), *reasons_of(name), reason), "str")
            return Const(str(found), origins_of(file) | origins_of(name))

        return lift2(one, path, key)

    # Files that are written from others

    def performed(self, scene: Performs, path: Value, place: Place) -> Value:
        """A parameter file whose text holds substitutions, performed now."""

        def one(option: Value) -> Value:
            source = self.content(option, place, as_text=True)
            if source.text is None:
                if source.absent:
                    shown = self._files.show(option)
                    scene.fails(
                        f"the parameter file {shown}, whose substitutions are to be performed, does not exist", place
                    )
                if source.rows is None:
                    return self.write(source)
                rows = tuple(row._replace(value=_performed(row.value, scene)) for row in source.rows)
                return self.write(Content(rows, None, source.file))
            inside = Place(source.file, 0)
            try:
                template = parse_substitution(source.text, inside)
            except SubstitutionError as error:
                scene.fails(f"the substitutions in {source.file} cannot be read ({error})", place)
                return self.write(source)
            return self.write(self._parsed([scene.text((piece,)) for piece in template], source.file, place))

        return lift(one, path)

    def _parsed(self, pieces: Sequence[Value], file: str, place: Place) -> Content:
        content, findings = _read(pieces, file, place)
        self._findings.add(*findings)
        return content

    def rewritten(self, source: Value, tables: Sequence[Pairs], root: Value, convert: Value, place: Place) -> Value:
        """RewrittenYaml of nav2_common; `tables` are its param_rewrites, key_rewrites and value_rewrites."""
        values, keys, contents = tables
        numbers = str(plain_text(convert) or "").lower() in ("true", "1")

        def one(option: Value) -> Value:
            before = self.content(option, place)
            if before.rows is None:
                self._fails_without(before, option, place)
                return self.write(before)
            rows = with_keys(with_values(before.rows, values, numbers, place), keys)
            rows = with_new_values(rows, contents, numbers)
            ways = [below(rows, readable(r)) for r in options(root)[:MAX_WAYS]]
            if all(is_refused_below(rows, readable(r)) for r in options(root)):
                message = "rcl rejects this content: a key that begins with a slash is below root_key."
                self._findings.tell("RW317", message, place)
            return self.write(Content(joined_rows(ways, place), None, before.file))

        return lift(one, source)

    def replaced(self, source: Value, pairs: Pairs, place: Place) -> Value:
        """ReplaceString of nav2_common: in the text of the file where that is at hand, else in names and values."""

        def one(option: Value) -> Value:
            before = self.content(option, place, as_text=True)
            if before.text is not None:
                pieces: list[Value] = [Const(before.text)]
                for old, new in pairs:
                    token = plain_text(old)
                    if token:
                        pieces = [p for piece in pieces for p in _split(piece, token, new)]
                after, doubts = _read(pieces, before.file, place)
                path = self.write(after)
                self._doubts[str(path.value)] = doubts
                return path
            if before.rows is None:
                self._fails_without(before, option, place)
                return self.write(before)
            return self.write(Content(tuple(_row_replaced(r, pairs) for r in before.rows), None, before.file))

        return lift(one, source)

    def _fails_without(self, content: Content, path: Value, place: Place) -> None:
        if content.absent:
            shown = self._files.show(path)
            self._findings.tell("RW320", f"The file {shown}, which is to be rewritten, does not exist.", place)


def _read(pieces: Sequence[Value], file: str, place: Place) -> tuple[Content, tuple[Finding, ...]]:
    """The content of a text in pieces, of which some may be unknown or one of several, and what is wrong with it as parameters."""
    ways: list[Rows] = []
    doubts: list[Finding] = []
    texts = _ways(pieces)
    for plain, holes in texts:
        rows, findings = read_parameter_file(plain, file)
        doubts += findings
        ways.append(tuple(_filled(row, holes) for row in rows))
    known = len(texts) == 1 and not texts[0][1]
    return Content(joined_rows(ways, place), texts[0][0] if known else None, file), tuple(doubts)


def _is_text(value: Value) -> bool:
    """Whether this is what a file holds. An empty one was made for something that is not seen to write it: the output of a command."""
    return isinstance(value, Text) or (isinstance(value, Const) and isinstance(value.value, str) and value.value != "")


def _performed(value: Value, scene: Performs) -> Value:
    """A value of a file that was rewritten, and so dumped: its substitutions are performed, and what they make is read as YAML."""
    if isinstance(value, Tuple):
        return Tuple(tuple(_performed(i, scene) for i in value.items))
    text = plain_text(value)
    if text is None or "$(" not in text:
        return value
    try:
        return lift(as_plain_scalar, scene.text(parse_substitution(text, Place("", 0))))
    except SubstitutionError:
        return value


def _ways(pieces: Sequence[Value]) -> list[tuple[str, list[Hole]]]:
    """The texts that the pieces can make, with a token for each hole; a piece of too many alternatives is a hole itself."""
    texts: list[tuple[str, list[Hole]]] = [("", [])]
    for piece in pieces:
        ways = options(piece)
        if len(ways) * len(texts) > MAX_WAYS:
            ways = (Unknown(reasons_of(piece), "str"),)
        texts = [_extended(text, holes, way) for text, holes in texts for way in ways]
    return texts


def _extended(text: str, holes: list[Hole], way: Value) -> tuple[str, list[Hole]]:
    found = list(holes)
    for part in parts_of(way):
        if isinstance(part, Hole):
            text += f"{_TOKEN}{len(found)}_"
            found.append(part)
        else:
            text += part
    return text, found


def _split(piece: Value, token: str, by: Value) -> list[Value]:
    """The piece with `by` in place of each token."""
    text = plain_text(piece)
    if text is None or token not in text:
        return [piece]
    found: list[Value] = []
    for index, part in enumerate(text.split(token)):
        found += [by, Const(part)] if index else [Const(part)]
    return found


def _row_replaced(row: Given, pairs: Pairs) -> Given:
    node, name, value = row.node, row.name, row.value
    for old, new in pairs:
        token = plain_text(old)
        if token:
            shown = readable(new)
            node, name = node.replace(token, shown), name.replace(token, shown)
            value = join_all(replaced(value, token, option) for option in options(new))
    return row._replace(node=node, name=name, value=value)


def _filled(row: Given, holes: Sequence[Hole]) -> Given:
    node, name, value = row.node, row.name, row.value
    for index, hole in enumerate(holes):
        token = f"{_TOKEN}{index}_"
        node = node.replace(token, "*")
        name = "*" if token in name else name
        if plain_text(value) == token:
            value = Unknown(hole.reasons)  # its type is open too
        elif reasons_of(value) or plain_text(value) is not None:
            value = replaced(value, token, Unknown(hole.reasons, "str"))
    return row._replace(node=node, name=name, value=value)
