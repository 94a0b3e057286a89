# SPDX-License-Identifier: Apache-2.0
"""Which findings are shown, which of them are new, and which are ignored?

    findings + comments + ignored codes + baseline  ->  Reviewed(shown, ignored=3, accepted=1)

Warnings and notes are ignored by a comment or by their code. An error says that the result lacks something, so it is ignored only where
its code is accepted as well; else it stays, comment or not. RW010 tells of comments for which there is no finding.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from pathlib import Path

from rosward.findings import Finding
from rosward.location import Place
from rosward.records import NamedTuple
from rosward.rules import RULES, Severity
from rosward.source import disk
from rosward.source.text import read_source
from rosward.source.workspace import SourceFile
from rosward.suppression.comments import IgnoreComment, ignore_comments
from rosward.suppression.fingerprints import BaselineEntry, fingerprints, fingerprints_without_line
from rosward.suppression.ignore_in import IgnoredPaths, IgnoreIn

__all__ = ["Judged", "RelatedPlace", "Reviewed", "SourceTexts", "Wishes", "judged", "of_no_file", "review"]


class RelatedPlace(NamedTuple):
    """Another place that has to do with a finding; `file` as in `Judged`."""

    message: str
    file: str
    line: int
    column: int = 1


class Judged(NamedTuple):
    """A finding that is shown. `file` is relative to the root of the repository; `known` are those of the baseline."""

    finding: Finding
    fingerprint: str
    file: str
    known: bool = False
    related: tuple[RelatedPlace, ...] = ()


class Reviewed(NamedTuple):
    """What is shown, and how many were ignored; `accepted` of these are errors."""

    shown: tuple[Judged, ...]
    ignored: int = 0
    accepted: int = 0

    @property
    def findings(self) -> tuple[Finding, ...]:
        """All that is shown."""
        return tuple(j.finding for j in self.shown)

    @property
    def new(self) -> tuple[Finding, ...]:
        """What is not in the baseline."""
        return tuple(j.finding for j in self.shown if not j.known)

    @property
    def known(self) -> tuple[Finding, ...]:
        """What is in the baseline."""
        return tuple(j.finding for j in self.shown if j.known)

    @property
    def complete(self) -> bool:
        """Whether no new error is left."""
        return not any(f.rule.severity is Severity.ERROR for f in self.new)


class Wishes(NamedTuple):
    """What a person asks for: codes that are ignored everywhere, or in some files; errors that may be; the baseline."""

    ignore: Collection[str] = ()
    accepted: Collection[str] = ()
    baseline: Collection[str] = ()
    ignore_in: Sequence[IgnoreIn] = ()

    def may_ignore(self, finding: Finding) -> bool:
        """Whether a comment or a code can make this finding go."""
        return finding.rule.severity is not Severity.ERROR or finding.code in self.accepted


class SourceTexts:
    """The text of the files that were read, again: lines for fingerprints, comments. Each file is read once."""

    def __init__(self, root: Path, files: Iterable[SourceFile]) -> None:
        self.root = root
        self._paths = {file.relative: file.path for file in files}
        self._lines: dict[str, list[str]] = {}
        self.prefix = _below_repository(root)
        """The root of the analysis as a path below the root of the repository, with `/` behind it; empty where they are the same."""

    @property
    def files(self) -> tuple[str, ...]:
        """What was read, as places name it."""
        return tuple(self._paths)

    def text(self, file: str) -> str:
        """The text of a file; empty where it cannot be read."""
        path = self._paths.get(file)
        found = read_source(path if path is not None else self.root / file, self.root) if "\0" not in file else None
        return "" if found is None or isinstance(found, Finding) else found.text

    def line_at(self, file: str, line: int) -> str:
        """The text of a line."""
        if file not in self._lines:
            self._lines[file] = self.text(file).split("\n")
        lines = self._lines[file]
        return lines[line - 1] if 0 < line <= len(lines) else ""


def _below_repository(root: Path) -> str:
    """The way from the folder above `root` that holds a version control's data."""
    folder = root.absolute()
    for above in (folder, *folder.parents):
        if disk.exists(above / ".git") or disk.exists(above / ".hg"):
            way = folder.relative_to(above).as_posix()
            return "" if way == "." else f"{way}/"
    return ""


def review(findings: Sequence[Finding], sources: SourceTexts, wishes: Wishes, *, unused: bool) -> Reviewed:
    """Sort the findings. `unused` says whether a comment without a finding is told: not where only parts of the sources are started."""
    by_path = IgnoredPaths(wishes.ignore_in, sources.root)
    comments = _Comments(sources, sources.files if unused else dict.fromkeys(f.place.file for f in findings))
    kept: list[Finding] = []
    ignored = accepted = 0
    for finding in findings:
        meant = comments.mean(finding) or finding.code in wishes.ignore or by_path.mean(finding)
        if meant and wishes.may_ignore(finding):
            ignored += 1
            accepted += finding.rule.severity is Severity.ERROR
        else:
            kept.append(finding)
    if unused and "RW010" not in wishes.ignore:
        kept += comments.without_finding()
    kept.sort(key=lambda f: (f.place, f.code, f.message))
    return Reviewed(judged(kept, sources, wishes.baseline), ignored, accepted)


def judged(findings: Sequence[Finding], sources: SourceTexts, baseline: Collection[str] = ()) -> tuple[Judged, ...]:
    """The findings with their fingerprints."""
    marks = fingerprints(findings, sources.line_at, sources.prefix)
    files = [sources.prefix + f.place.file if f.place.file else "" for f in findings]
    without_line = fingerprints_without_line(
        [BaselineEntry(f.code, file, f.message) for f, file in zip(findings, files, strict=True)]
    )
    return tuple(
        Judged(f, mark, file, mark in baseline or other in baseline)
        for f, mark, other, file in zip(findings, marks, without_line, files, strict=True)
    )


def of_no_file(findings: Collection[Finding]) -> tuple[Judged, ...]:
    """The same for findings that stand in no file: none of them is ignored, or known."""
    marks = fingerprints(tuple(findings), lambda _file, _line: "")
    return tuple(Judged(finding, mark, "") for finding, mark in zip(findings, marks, strict=True))


class _Comments:
    """The ignore comments of the files, and which of their codes met a finding."""

    def __init__(self, sources: SourceTexts, files: Iterable[str]) -> None:
        self._at: dict[tuple[str, int], list[IgnoreComment]] = {}
        self._met: dict[tuple[str, IgnoreComment], set[str]] = {}
        for file in files:
            for comment in ignore_comments(sources.text(file), Path(file).suffix):
                self._met[file, comment] = set()
                for line in comment.lines:
                    self._at.setdefault((file, line), []).append(comment)

    def mean(self, finding: Finding) -> bool:
        """Whether a comment asks to ignore the finding."""
        place = finding.place
        meant = [c for c in self._at.get((place.file, place.line), ()) if c.means(finding.code)]
        for comment in meant:
            self._met[place.file, comment].add(finding.code)
        return bool(meant)

    def without_finding(self) -> list[Finding]:
        """RW010, for each comment that ignores nothing, or names a code that it does not ignore."""
        return [
            Finding("RW010", message, Place(file, comment.line, comment.column))
            for (file, comment), met in self._met.items()
            if (message := _unused(comment, met))
        ]


def _unused(comment: IgnoreComment, met: set[str]) -> str:
    if comment.codes is None:
        return "" if met else "there is no finding on this line"
    if not comment.codes:
        return "the brackets contain no code, so nothing is ignored"
    if "RW010" in comment.codes:
        return ""
    unknown = [code for code in comment.codes if code not in RULES]
    if unknown:
        return f"there is no code {', '.join(unknown)}"
    rest = [code for code in comment.codes if code not in met]
    return f"there is no {', '.join(rest)} on this line" if rest else ""
