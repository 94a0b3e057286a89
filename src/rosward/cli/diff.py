# SPDX-License-Identifier: Apache-2.0
"""`rosward diff OLD NEW`: which nodes, entities and rights came and went between two networks, or two policies."""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING

from rosward.cli.shared import COMPLETE, INCOMPLETE, WRONG_USE, WrongUseError
from rosward.outputs.safe import printable

if TYPE_CHECKING:
    from rosward.cli.shared import Commands
    from rosward.differences.compare import Differences


def add(commands: Commands[argparse.ArgumentParser]) -> None:
    """Declare the command."""
    parser = commands.add_parser(
        "diff",
        help="compare two networks, or two policies",
        description="Says which nodes, entities and rights came and went between two network.json files, or two policies.",
        epilog="Exit status: 0 compared; 1 there are new rights and --fail-on new-rights is given; 2 wrong use or not readable.",
    )
    parser.set_defaults(run=_run)
    parser.add_argument("old", metavar="OLD", help="network.json, policy.xml or permissions.xml")
    parser.add_argument("new", metavar="NEW", help="a file of the same kind")
    parser.add_argument("--format", choices=("text", "markdown", "json"), default="text", help="(default: %(default)s)")
    parser.add_argument("--fail-on", choices=("new-rights",), help="exit with 1 if there are new rights")


def _run(options: argparse.Namespace) -> int:
    from rosward.outputs.diff_text import diff_json, diff_markdown, diff_text

    try:
        differences = _differences(options)
    except WrongUseError as error:
        print(f"rosward: {printable(str(error))}", file=sys.stderr)  # noqa: T201
        return WRONG_USE
    write = {"text": diff_text, "markdown": diff_markdown, "json": diff_json}[options.format]
    sys.stdout.write(write(differences))
    return INCOMPLETE if options.fail_on and differences.rights.gained else COMPLETE


def _differences(options: argparse.Namespace) -> Differences:
    from rosward.differences.compare import compare, read_snapshot
    from rosward.differences.snapshot import UnreadableError

    try:
        old, new = read_snapshot(options.old), read_snapshot(options.new)
    except UnreadableError as error:
        raise WrongUseError(str(error)) from error
    if old.kind != new.kind:
        raise WrongUseError(f"{options.old} is a {old.kind}, {options.new} a {new.kind}: compare two of one kind")
    return compare(old, new)
