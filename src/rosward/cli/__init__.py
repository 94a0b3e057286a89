# SPDX-License-Identifier: Apache-2.0
"""The command line: options, exit status, choice of outputs. No analysis.

One module a command; each has `add(commands)`, which declares its options, and a function that runs it.
"""
# PYTHON_ARGCOMPLETE_OK

from __future__ import annotations

import argparse
import io
import os
import sys
from collections.abc import Sequence

from rosward._version import __version__
from rosward.cli import (
    audit,
    check,
    completion_script,
    declare,
    diff,
    enclaves,
    explain,
    extract,
    flow,
    launch_tree,
    listing,
    nodl,
    serve,
    snapshot,
)
from rosward.cli.configuration import apply, leave_open
from rosward.cli.parser import CommandParser
from rosward.cli.shared import COMPLETE, INTERNAL, INTERRUPTED, with_exit_status
from rosward.guard import where

__all__ = ["command_line", "main"]


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the exit status: 0 complete, 1 incomplete, 2 usage error or nothing to read, 3 a fault of rosward."""
    parser = command_line()
    if "_ARGCOMPLETE" in os.environ:
        from rosward.cli.completion import complete

        complete(parser)
    options = parser.parse_args(arguments)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # a terminal that cannot show a character shows its escape
            stream.reconfigure(errors="backslashreplace")
    try:
        status: int = with_exit_status(_run)(options)
    except BrokenPipeError:  # the reader of our output has gone: that is no failure of ours
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return COMPLETE
    except KeyboardInterrupt:
        print("rosward: interrupted", file=sys.stderr)  # noqa: T201
        return INTERRUPTED
    except Exception as error:
        what = f"{type(error).__name__} in {where(error)}"
        print(f"rosward: internal error ({what}). Please report this.", file=sys.stderr)  # noqa: T201
        return INTERNAL
    return status


def _run(options: argparse.Namespace) -> int:
    apply(options)
    status: int = options.run(options)
    return status


def command_line() -> argparse.ArgumentParser:
    """The parser of all commands."""
    parser = CommandParser(
        prog="rosward",
        description="Analyse the source of a ROS 2 system without running it, and write its computation graph and SROS2 policies.",
    )
    parser.add_argument("--version", action="version", version=f"rosward {__version__}")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    for command in (
        extract,
        listing,
        explain,
        flow,
        declare,
        check,
        diff,
        enclaves,
        launch_tree,
        nodl,
        snapshot,
        audit,
        serve,
        completion_script,
    ):
        command.add(commands)
    leave_open(parser)
    parser.set_defaults(commands=tuple(commands.choices))
    return parser
