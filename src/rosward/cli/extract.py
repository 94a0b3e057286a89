# SPDX-License-Identifier: Apache-2.0
"""`rosward extract`: the graph, the policies and a report of the sources, or of the system that a launch file starts."""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING, Final

from rosward.cli.shared import (
    COMPLETE,
    INCOMPLETE,
    ProgressLine,
    WrongUseError,
    add_deployment,
    add_sources,
    refusing,
    request_of,
    underlays_of,
)

if TYPE_CHECKING:
    from rosward.cli.shared import Commands
    from rosward.pipeline import Result

FORMATS: Final = ("json", "policy", "svg", "dot", "html", "mermaid", "permissions")
DEFAULT_FORMATS: Final = ("json", "policy", "svg", "dot", "html")


def add(commands: Commands[argparse.ArgumentParser]) -> None:
    """Declare the command."""
    parser = commands.add_parser(
        "extract",
        help="write the graph, the policies and a report of the sources",
        description="Reads files, packages or workspaces and writes the computation graph, the SROS2 policies and a report.",
        epilog="Exit status: 0 complete; 1 extracted, but incomplete (an unknown name, an unreadable file, a limit); 2 wrong use or nothing to read.",
    )
    parser.set_defaults(run=refusing(_run))
    add_sources(parser)
    add_deployment(parser)
    parser.add_argument(
        "--enclaves",
        choices=("node", "process", "launch"),
        default=None,
        help="one enclave for each node, or for each process, or as the launch files say (default: process with launch files, else node)",
    )
    parser.add_argument(
        "-o", "--output", default="rosward-out", metavar="DIR", help="where to write (default: %(default)s)"
    )
    parser.add_argument(
        "--format",
        type=_formats,
        default=DEFAULT_FORMATS,
        metavar="LIST",
        help=f"comma-separated outputs out of {', '.join(FORMATS)} (default: all but mermaid and permissions)",
    )
    parser.add_argument(
        "--unknown",
        choices=("deny", "wildcard"),
        default="deny",
        help="in the policy, leave out a name that is not known, or write * for it (default: %(default)s)",
    )
    parser.add_argument("--system", action="store_true", help="show the entities of the client library in the graph")
    parser.add_argument("--types", action="store_true", help="show interface types in the graph")
    volume = parser.add_mutually_exclusive_group()
    volume.add_argument("-q", "--quiet", action="store_true", help="print nothing but errors")
    volume.add_argument("-v", "--verbose", action="store_true", help="print every doubt")


def _formats(text: str) -> tuple[str, ...]:
    wanted = tuple(dict.fromkeys(part.strip() for part in text.split(",") if part.strip()))
    wrong = [w for w in wanted if w not in FORMATS]
    if wrong or not wanted:
        raise argparse.ArgumentTypeError(f"choose out of {', '.join(FORMATS)}: {', '.join(wrong) or 'nothing given'}")
    return wanted


def _run(options: argparse.Namespace) -> int:
    from rosward.pipeline import NothingToReadError, UnknownRequestError, extract

    request = request_of(options)
    try:
        with ProgressLine(shown=not options.quiet) as progress:
            result = extract(
                *options.paths,
                distro=options.distro,
                unknown=options.unknown,
                models=options.models,
                tests=options.tests,
                request=request,
                underlays=underlays_of(options),
                enclaves=options.enclaves,
                progress=progress,
            )
    except (NothingToReadError, UnknownRequestError) as error:
        raise WrongUseError(str(error)) from error
    try:
        written = _write(result, options)
    except OSError as error:
        raise WrongUseError(f"cannot write to {options.output}: {error.strerror or error}") from error
    if not options.quiet:
        _summarise(result, written, verbose=options.verbose)
    return COMPLETE if result.complete else INCOMPLETE


def _write(result: Result, options: argparse.Namespace) -> list[str]:
    from rosward.outputs.files import write_outputs

    return write_outputs(
        result.network,
        options.output,
        options.format,
        unknown=options.unknown,
        system=options.system,
        types=options.types,
    )


def _summarise(result: Result, written: list[str], *, verbose: bool) -> None:
    from rich.console import Console

    from rosward.outputs.text import summary

    summary(result.network, Console(soft_wrap=not sys.stdout.isatty()), verbose=verbose, written=written)
