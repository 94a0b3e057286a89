# SPDX-License-Identifier: Apache-2.0
"""The command line: options, exit status, choice of outputs. No analysis."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from rosward._version import __version__

if TYPE_CHECKING:
    from rosward.pipeline import Progress, Result

FORMATS: Final = ("json", "policy", "svg", "dot", "html", "permissions")
DEFAULT_FORMATS: Final = ("json", "policy", "svg", "dot", "html")
DISTROS: Final = ("humble", "iron", "jazzy", "kilted", "rolling")

COMPLETE, INCOMPLETE, WRONG_USE = 0, 1, 2


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the exit status: 0 complete, 1 incomplete, 2 wrong use or nothing to read."""
    options = _parser().parse_args(arguments)
    try:
        return _extract(options)
    except BrokenPipeError:  # the reader of our output has gone: that is no failure of ours
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return COMPLETE
    except KeyboardInterrupt:
        print("rosward: interrupted", file=sys.stderr)  # noqa: T201
        return 130


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="rosward",
        description="Reads the source of a ROS 2 system, running nothing of it, and writes its computation graph and SROS2 policies.",
    )
    parser.add_argument("--version", action="version", version=f"rosward {__version__}")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    extract = commands.add_parser(
        "extract",
        help="write the graph, the policies and a report of the sources",
        description="Reads files, packages or workspaces and writes the computation graph, the SROS2 policies and a report.",
        epilog="Exit status: 0 complete; 1 extracted, but incomplete (an unknown name, an unreadable file, a limit); 2 wrong use or nothing to read.",
    )
    extract.add_argument(
        "paths", nargs="*", metavar="PATH", help="file, package or workspace (default: the current folder)"
    )
    extract.add_argument(
        "-o", "--output", default="rosward-out", metavar="DIR", help="where to write (default: %(default)s)"
    )
    extract.add_argument(
        "--format",
        type=_formats,
        default=DEFAULT_FORMATS,
        metavar="LIST",
        help=f"comma-separated outputs out of {', '.join(FORMATS)} (default: all but permissions)",
    )
    extract.add_argument(
        "--distro",
        choices=DISTROS,
        default="jazzy",
        help="what the client library adds by itself (default: %(default)s)",
    )
    extract.add_argument(
        "--unknown",
        choices=("deny", "wildcard"),
        default="deny",
        help="in the policy, leave out a name that is not known, or write * for it (default: %(default)s)",
    )
    extract.add_argument(
        "--models", action="append", default=[], metavar="DIR", help="stub files that describe further libraries"
    )
    extract.add_argument("--tests", action="store_true", help="read test files too")
    extract.add_argument("--system", action="store_true", help="show the entities of the client library in the graph")
    extract.add_argument("--types", action="store_true", help="show interface types in the graph")
    volume = extract.add_mutually_exclusive_group()
    volume.add_argument("-q", "--quiet", action="store_true", help="print nothing but errors")
    volume.add_argument("-v", "--verbose", action="store_true", help="print every doubt")
    return parser


def _formats(text: str) -> tuple[str, ...]:
    wanted = tuple(dict.fromkeys(part.strip() for part in text.split(",") if part.strip()))
    wrong = [w for w in wanted if w not in FORMATS]
    if wrong or not wanted:
        raise argparse.ArgumentTypeError(f"choose out of {', '.join(FORMATS)}: {', '.join(wrong) or 'nothing given'}")
    return wanted


def _extract(options: argparse.Namespace) -> int:
    from rosward.pipeline import NothingToReadError, extract

    missing = [p for p in options.paths if not os.path.lexists(p)]
    if missing:
        return _wrong(f"no such file or folder: {', '.join(missing)}")
    absent = [m for m in options.models if not os.path.isdir(m)]  # noqa: PTH112
    if absent:
        return _wrong(f"--models: no such folder: {', '.join(absent)}")
    try:
        with _Progress(shown=not options.quiet) as progress:
            result = extract(
                *options.paths,
                distro=options.distro,
                unknown=options.unknown,
                models=options.models,
                tests=options.tests,
                progress=progress,
            )
    except NothingToReadError as error:
        return _wrong(f"nothing to read: no Python file in {error}")
    try:
        written = _write(result, options)
    except OSError as error:
        return _wrong(f"cannot write to {options.output}: {error.strerror or error}")
    if not options.quiet:
        _summarise(result, written, verbose=options.verbose)
    return COMPLETE if result.complete else INCOMPLETE


def _wrong(message: str) -> int:
    print(f"rosward: {message}", file=sys.stderr)  # noqa: T201
    return WRONG_USE


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


class _Progress:
    """A progress line on a terminal, for work that takes longer than a moment."""

    def __init__(self, *, shown: bool) -> None:
        self._shown = shown and sys.stderr.isatty()
        self._drawn = False

    def __enter__(self) -> Progress:
        return self._tell

    def __exit__(self, *_: object) -> None:
        if self._drawn:
            print("\r\x1b[K", end="", file=sys.stderr, flush=True)  # noqa: T201

    def _tell(self, what: str, done: int, count: int) -> None:
        if self._shown and count > 20 and (done % 10 == 0 or done == count):
            self._drawn = True
            print(f"\r\x1b[K{what} {done}/{count}", end="", file=sys.stderr, flush=True)  # noqa: T201


if __name__ == "__main__":
    sys.exit(main())
