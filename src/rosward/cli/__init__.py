# SPDX-License-Identifier: Apache-2.0
"""The command line: options, exit status, choice of outputs. No analysis.

One module a command (`commands.py`); each has `add(parser)`, which declares its options, and a function that runs it.
"""
# PYTHON_ARGCOMPLETE_OK

from __future__ import annotations

import argparse
import io
import os
import sys
from collections.abc import Container, Sequence
from importlib import import_module

from rosward._version import __version__
from rosward.cli.commands import COMMANDS
from rosward.cli.parser import CommandParser
from rosward.cli.status import COMPLETE, INTERNAL, INTERRUPTED

__all__ = ["command_line", "main", "program"]


def program() -> None:
    """The command as a process. At its end nothing is taken apart: the system frees it faster."""
    status = main()
    try:
        sys.stdout.flush()
        sys.stderr.flush()
    except BrokenPipeError:  # as in `main`
        os._exit(COMPLETE)
    except (OSError, ValueError):
        sys.exit(status)  # Python tells what is wrong with the stream
    os._exit(status)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the exit status: 0 complete, 1 incomplete, 2 usage error or nothing to read, 3 a fault of rosward."""
    words = sys.argv[1:] if arguments is None else arguments
    if "_ARGCOMPLETE" in os.environ:
        from rosward.cli.completion import complete

        complete(_declared(os.environ.get("COMP_LINE", "").split()))
    options = command_line(words).parse_args(words)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # a terminal that cannot show a character shows its escape
            stream.reconfigure(errors="backslashreplace")
    try:
        return _run(options)
    except BrokenPipeError:  # the reader of our output has gone: that is no failure of ours
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return COMPLETE
    except KeyboardInterrupt:
        print("rosward: interrupted", file=sys.stderr)  # noqa: T201
        return INTERRUPTED
    except Exception as error:
        from rosward.guard import where

        what = f"{type(error).__name__} in {where(error)}"
        print(f"rosward: internal error ({what}). Please report this.", file=sys.stderr)  # noqa: T201
        return INTERNAL


def _run(options: argparse.Namespace) -> int:
    from rosward.cli.configuration import apply
    from rosward.cli.shared import with_exit_status

    def applied(given: argparse.Namespace) -> int:
        apply(given)
        status: int = given.run(given)
        return status

    return with_exit_status(applied)(options)


def command_line(words: Container[str] = COMMANDS) -> argparse.ArgumentParser:
    """The parser of all commands; those that are not among `words` have no options, for nobody asks for them."""
    parser = _declared(words)
    if any(name in words for name in COMMANDS):
        from rosward.cli.configuration import leave_open

        leave_open(parser)
    return parser


def _declared(words: Container[str]) -> argparse.ArgumentParser:
    parser = CommandParser(
        prog="rosward",
        description="Analyse the source of a ROS 2 system without running it, and write its computation graph and SROS2 policies.",
    )
    parser.add_argument("--version", action="version", version=f"rosward {__version__}")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    for name, (module, what) in COMMANDS.items():
        command = commands.add_parser(name, help=what)
        if name in words:
            import_module(f"rosward.cli.{module}").add(command)
    parser.set_defaults(commands=tuple(COMMANDS))
    return parser
