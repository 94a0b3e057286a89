# SPDX-License-Identifier: Apache-2.0
"""`rosward explain NAME`: why something is in the result: who has it, which line creates it, what its name was made of, which rule it causes."""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING

from rosward.cli.shared import (
    COMPLETE,
    INCOMPLETE,
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


def add(commands: Commands[argparse.ArgumentParser]) -> None:
    """Declare the command."""
    parser = commands.add_parser(
        "explain",
        help="say why a name is in the result",
        description="Says of a topic, service, action, node, enclave, finding or line where it comes from and which rule it causes.",
        epilog="Exit status: 0 it is told; 1 nothing is called so; 2 wrong use or nothing to read.",
    )
    parser.set_defaults(run=refusing(_run))
    parser.add_argument(
        "name",
        metavar="NAME",
        help="a full name (/robot/scan), the end of one (scan), a finding (RW101) or a place (talker.py:12)",
    )
    add_sources(parser)
    add_deployment(parser)
    add_enclaves(parser)
    add_unknown(parser)
    parser.add_argument("--json", action="store_true", help="as JSON, with nothing left out")


def _run(options: argparse.Namespace) -> int:
    from rosward.outputs.explain import explain_json, explain_text
    from rosward.outputs.explained import explained

    result = extracted(options, options.paths, request_of(options))
    answer = explained(result.network, options.name, result.root, result.systems, options.unknown)
    sys.stdout.write(explain_json(answer) if options.json else explain_text(answer))
    return INCOMPLETE if answer.empty else COMPLETE
