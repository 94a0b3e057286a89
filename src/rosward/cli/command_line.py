# SPDX-License-Identifier: Apache-2.0
"""How is a command line taken apart, and its command run?

One module a command (`commands.py`); each has `add(parser)`, which declares its options, and a function that runs it.
"""

from __future__ import annotations

import argparse
import os
from collections.abc import Container, Sequence
from importlib import import_module

from rosward._version import __version__
from rosward.cli.commands import COMMANDS
from rosward.cli.parser import CommandParser

__all__ = ["command_line", "parsed_and_run"]


def parsed_and_run(words: Sequence[str]) -> int:
    """Run a command; returns the exit status."""
    if "_ARGCOMPLETE" in os.environ:
        from rosward.cli.completion import complete

        complete(_declared(os.environ.get("COMP_LINE", "").split()))
    return _run(command_line(words).parse_args(words))


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
