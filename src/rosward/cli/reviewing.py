# SPDX-License-Identifier: Apache-2.0
"""What several commands share where they show findings: which of them, which are new, and where they are written.

add_review(parser)                       --baseline, --write-baseline
reviewed(findings, sources, options)     comments, `ignore`, `ignore-in` and the baseline, applied
deliver(text, options.output)            to the terminal, or whole into a file
findings_text("sarif", shown, options)   findings alone, in a format that each command has
write_file(text, "policy.xml")           whole, or told why not
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from rosward.cli.shared import WrongUseError, note_failures
from rosward.guard import Steps

if TYPE_CHECKING:
    from rosward.findings import Finding
    from rosward.outputs.writing import Scan
    from rosward.result import Result
    from rosward.suppression.judge import Judged, Reviewed, SourceTexts

__all__ = [
    "add_output_file",
    "add_review",
    "deliver",
    "findings_text",
    "reviewed",
    "reviewed_result",
    "scan_of",
    "write_baseline",
    "write_file",
]


def add_review(parser: argparse.ArgumentParser) -> None:
    """Which findings are known."""
    parser.add_argument("--baseline", metavar="FILE", help="known findings, which do not count for the exit status")
    parser.add_argument("--write-baseline", metavar="FILE", help="write the findings of this run to this file")


def add_output_file(parser: argparse.ArgumentParser) -> None:
    """Where a command that prints one document writes it instead."""
    parser.add_argument("-o", "--output", metavar="FILE", help="write to this file instead of printing")


def reviewed(
    findings: Sequence[Finding], sources: SourceTexts, options: argparse.Namespace, *, unused: bool
) -> Reviewed:
    """The findings without those that are to be ignored. `unused`: whether comments without a finding are told. Raises WrongUseError."""
    from rosward.suppression.baseline import BaselineError, read_baseline
    from rosward.suppression.judge import Wishes, review

    try:
        baseline = read_baseline(options.baseline) if options.baseline is not None else frozenset[str]()
    except BaselineError as error:
        raise WrongUseError(f"--baseline: {error}") from error
    wishes = Wishes(frozenset(options.ignore), frozenset(options.accepted), baseline, options.ignore_in)
    return review(findings, sources, wishes, unused=unused)


def reviewed_result(
    result: Result, sources: SourceTexts, options: argparse.Namespace, *, unused: bool
) -> tuple[Reviewed, tuple[Finding, ...]]:
    """The findings of an analysis as `reviewed`, and apart from them its loose ends, which the report tells unasked.

    Loose ends are judged also where `--loose-ends` does not ask for them, so that a comment that ignores one is not told to be without use.
    """
    from rosward.network.loose_ends import LOOSE_ENDS, loose_ends

    steps = Steps()
    nothing: list[Finding] = []
    ends = steps(lambda: loose_ends(result.network), nothing, "loose ends were not checked")
    note_failures(options, steps.findings)
    found = reviewed((*result.findings, *steps.findings, *ends), sources, options, unused=unused)
    loose = tuple(f for f in found.findings if f.code in LOOSE_ENDS)
    if getattr(options, "loose_ends", False):
        return found, loose
    shown = tuple(j for j in found.shown if j.finding.code not in LOOSE_ENDS)
    return found._replace(shown=shown, ignored=found.ignored - (len(ends) - len(loose))), loose


def write_baseline(shown: Iterable[Judged], file: str) -> str:
    """Write the findings of a run as a baseline; returns the path. Raises WrongUseError."""
    from rosward.suppression.baseline import baseline_text

    return write_file(baseline_text(shown), file)


def deliver(text: str, file: str | None) -> None:
    """Print the text, or write it to a file. Raises WrongUseError."""
    if file is None:
        sys.stdout.write(text)
    else:
        write_file(text, file)


def write_file(text: str, file: str) -> str:
    """Write a text; returns the path. Raises WrongUseError."""
    from rosward.outputs.whole_files import write_text
    from rosward.source.disk import wrote

    folder, name = os.path.split(file)
    try:
        path = write_text(folder or ".", name, text)
        wrote(folder or ".", name, text.encode())
        return path
    except OSError as error:
        raise WrongUseError(f"cannot write to {file}: {error.strerror or error}") from error


def scan_of(shown: Sequence[Judged], options: argparse.Namespace) -> Scan:
    """The findings as the formats of findings take them."""
    from rosward.outputs.writing import Scan

    return Scan(shown, options.baseline is not None, _documentation())


def findings_text(name: str, shown: Sequence[Judged], options: argparse.Namespace) -> str:
    """The findings in one of the formats of `formats.OF_FINDINGS`."""
    from rosward.outputs.formats import BY_NAME
    from rosward.outputs.writing import text

    return text(BY_NAME[name], scan_of(shown, options))


def _documentation() -> str | None:
    """Where the installed package says that the explanation of findings is."""
    from importlib.metadata import PackageNotFoundError, metadata

    try:
        urls = metadata("rosward").get_all("Project-URL") or []
    except PackageNotFoundError:
        return None
    return next((url.partition(", ")[2] for url in urls if url.startswith("Findings, ")), None)
