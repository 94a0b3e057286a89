# SPDX-License-Identifier: Apache-2.0
"""The command line: options, exit status, choice of outputs. No analysis.

One module a command; each has `add(commands)`, which declares its options, and a function that runs it.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence

from rosward._version import __version__
from rosward.cli import check, diff, explain, extract, launch_tree, nodl
from rosward.cli.shared import COMPLETE, INTERRUPTED

__all__ = ["main"]


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the exit status: 0 complete, 1 incomplete, 2 wrong use or nothing to read."""
    options = _parser().parse_args(arguments)
    try:
        status: int = options.run(options)
    except BrokenPipeError:  # the reader of our output has gone: that is no failure of ours
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return COMPLETE
    except KeyboardInterrupt:
        print("rosward: interrupted", file=sys.stderr)  # noqa: T201
        return INTERRUPTED
    return status


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="rosward",
        description="Reads the source of a ROS 2 system, running nothing of it, and writes its computation graph and SROS2 policies.",
    )
    parser.add_argument("--version", action="version", version=f"rosward {__version__}")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    for command in (extract, explain, check, diff, launch_tree, nodl):
        command.add(commands)
    return parser
