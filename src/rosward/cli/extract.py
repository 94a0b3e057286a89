# SPDX-License-Identifier: Apache-2.0
"""`rosward extract`: the graph, the policies and a report of the sources, or of the system that a launch file starts."""

from __future__ import annotations

import argparse
import os
import sys
from dataclasses import replace
from typing import TYPE_CHECKING, Final

from rosward.cli.configuration import apply, unset
from rosward.cli.shared import (
    COMPLETE,
    INCOMPLETE,
    WrongUseError,
    add_deployment,
    add_enclaves,
    add_sources,
    add_unknown,
    extracted,
    refusing,
    request_of,
)

if TYPE_CHECKING:
    from rosward.cli.shared import Commands
    from rosward.pipeline import Result
    from rosward.review.judge import Reviewed

FORMATS: Final = ("json", "policy", "svg", "dot", "html", "mermaid", "permissions", "sarif", "junit")
DEFAULT_FORMATS: Final = ("json", "policy", "svg", "dot", "html")


def add(commands: Commands[argparse.ArgumentParser]) -> None:
    """Declare the command."""
    parser = commands.add_parser(
        "extract",
        help="write the graph, the policies and a report of the sources",
        description="Reads files, packages or workspaces and writes the computation graph, the SROS2 policies and a report.",
        epilog="Exit status: 0 complete; 1 extracted, but incomplete (an unknown name, an unreadable file, a limit); 2 wrong use or nothing to read.",
    )
    parser.set_defaults(run=refusing(_run, _complete))
    add_sources(parser)
    add_deployment(parser)
    add_enclaves(parser)
    parser.add_argument("-o", "--output", metavar="DIR", help="where to write (default: rosward-out)")
    parser.add_argument(
        "--format",
        type=_formats,
        metavar="LIST",
        help=f"comma-separated outputs out of {', '.join(FORMATS)} (default: {', '.join(DEFAULT_FORMATS)})",
    )
    add_unknown(parser)
    parser.add_argument("--system", action="store_true", help="show the entities of the client library in the graph")
    parser.add_argument("--types", action="store_true", help="show interface types in the graph")
    parser.add_argument(
        "--baseline", metavar="FILE", help="findings in it are not new: they do not count for the exit status"
    )
    parser.add_argument("--write-baseline", metavar="FILE", help="write the findings of this run there")
    parser.add_argument(
        "--no-config", action="store_true", help="do not read rosward.toml or pyproject.toml of what is analysed"
    )
    volume = parser.add_mutually_exclusive_group()
    volume.add_argument("-q", "--quiet", action="store_true", help="print nothing but errors")
    volume.add_argument("-v", "--verbose", action="store_true", help="print every doubt")
    parser.set_defaults(**unset())


def _formats(text: str) -> tuple[str, ...]:
    wanted = tuple(dict.fromkeys(part.strip() for part in text.split(",") if part.strip()))
    wrong = [w for w in wanted if w not in FORMATS]
    if wrong or not wanted:
        raise argparse.ArgumentTypeError(f"choose out of {', '.join(FORMATS)}: {', '.join(wrong) or 'nothing given'}")
    return wanted


def _complete(options: argparse.Namespace) -> None:
    """The options of the configuration file, and defaults."""
    apply(options)
    try:
        options.format = DEFAULT_FORMATS if options.format is None else options.format
        options.format = _formats(options.format) if isinstance(options.format, str) else options.format
    except argparse.ArgumentTypeError as error:
        raise WrongUseError(f"format: {error}") from error


def _run(options: argparse.Namespace) -> int:
    request = request_of(options)
    result = extracted(options, options.paths, request, shown=not options.quiet)
    reviewed = _reviewed(result, options, unused=not request.deploys)
    written = _write(result, reviewed, options)
    if not options.quiet:
        _summarise(result, reviewed, written, options)
    return COMPLETE if reviewed.complete else INCOMPLETE


def _reviewed(result: Result, options: argparse.Namespace, *, unused: bool) -> Reviewed:
    """The findings without those that are to be ignored. `unused`: whether comments without a finding are told."""
    from rosward.review.baseline import BaselineError, read_baseline
    from rosward.review.judge import Sources, Wishes, review

    try:
        baseline = read_baseline(options.baseline) if options.baseline is not None else frozenset[str]()
    except BaselineError as error:
        raise WrongUseError(f"--baseline: {error}") from error
    wishes = Wishes(frozenset(options.ignore), frozenset(options.accepted), baseline)
    return review(result.findings, Sources(result.root, result.files), wishes, unused=unused)


def _write(result: Result, reviewed: Reviewed, options: argparse.Namespace) -> list[str]:
    from rosward.outputs.files import Scan, write_outputs
    from rosward.outputs.whole_files import write_text
    from rosward.review.baseline import baseline_text

    target = options.output
    try:
        written = write_outputs(
            replace(result.network, findings=reviewed.findings),
            options.output,
            options.format,
            unknown=options.unknown,
            system=options.system,
            types=options.types,
            scan=Scan(reviewed.shown, options.baseline is not None, _documentation()),
        )
        if options.write_baseline is not None:
            target = options.write_baseline
            folder, name = os.path.split(target)
            written.append(write_text(folder or ".", name, baseline_text(reviewed.shown)))
    except OSError as error:
        raise WrongUseError(f"cannot write to {target}: {error.strerror or error}") from error
    return written


def _documentation() -> str | None:
    """Where the installed package says that the explanation of findings is."""
    from importlib.metadata import PackageNotFoundError, metadata

    try:
        urls = metadata("rosward").get_all("Project-URL") or []
    except PackageNotFoundError:
        return None
    return next((url.partition(", ")[2] for url in urls if url.startswith("Findings, ")), None)


def _summarise(result: Result, reviewed: Reviewed, written: list[str], options: argparse.Namespace) -> None:
    from rich.console import Console

    from rosward.outputs.text import summary

    console = Console(soft_wrap=not sys.stdout.isatty())
    network = replace(result.network, findings=reviewed.new)
    summary(network, console, options.verbose, written, reviewed, options.configuration)
