# SPDX-License-Identifier: Apache-2.0
"""`rosward explain NAME`: why something is in the result: who has it, which line creates it, the parts of its name, which rule it causes."""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING

from rosward.cli.shared import (
    WrongUseError,
    add_deployment,
    add_enclaves,
    add_format,
    add_sources,
    add_unknown,
    extracted,
    refusing,
    request_of,
)
from rosward.cli.status import COMPLETE, INCOMPLETE

if TYPE_CHECKING:
    from rosward.deployment.request import Request
    from rosward.explanation.answers import Answer


def add(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.description = "Explain where a topic, service, action, node, enclave, finding or line comes from, and which policy rule it causes."
    parser.epilog = "Exit status: 0 found; 1 no such name; 2 usage error or nothing to read; 3 internal error."
    parser.set_defaults(run=refusing(_run))
    parser.add_argument(
        "name",
        metavar="NAME",
        help="a full name (/robot/scan), the end of one (scan), a finding (RW101) or a place (talker.py:12)",
    )
    parser.add_argument(
        "--made-of",
        action="store_true",
        help="of a topic, service or action: also what its content is made of, step by step through the nodes",
    )
    add_sources(parser)
    add_deployment(parser)
    add_enclaves(parser)
    add_unknown(parser)
    add_format(parser, "text", "json", what="json is complete, text may be shortened (default: text)")


def _run(options: argparse.Namespace) -> int:
    from rosward.explanation.answers import rule_alone
    from rosward.outputs.documents.explain_json import explain_json
    from rosward.outputs.terminal.explain import explain_text

    request = request_of(options)
    alone = rule_alone(options.name) if not (options.paths or request.deploys) else None
    answer = alone or _answer(options, request)
    if options.made_of and not (answer.empty or answer.meetings):
        raise WrongUseError(f"--made-of: {options.name} is no topic, service or action")
    sys.stdout.write(explain_json(answer) if options.format == "json" else explain_text(answer))
    return INCOMPLETE if answer.empty else COMPLETE


def _answer(options: argparse.Namespace, request: Request) -> Answer:
    from rosward.explanation.answers import explained
    from rosward.explanation.content import Contents

    result = extracted(options, options.paths, request, flow=options.made_of)
    contents = Contents(result.network.nodes) if options.made_of else None
    return explained(result.network, options.name, result.root, result.systems, options.unknown, contents)
