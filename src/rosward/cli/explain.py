# SPDX-License-Identifier: Apache-2.0
"""`rosward explain NAME`: why something is in the result: who has it, which line creates it, the parts of its name, which rule it causes."""

from __future__ import annotations

import argparse
import sys

from rosward.cli.shared import (
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
    add_sources(parser)
    add_deployment(parser)
    add_enclaves(parser)
    add_unknown(parser)
    add_format(parser, "text", "json", what="json is complete, text may be shortened (default: text)")


def _run(options: argparse.Namespace) -> int:
    from rosward.explanation.answers import explained, rule_alone
    from rosward.outputs.documents.explain_json import explain_json
    from rosward.outputs.terminal.explain import explain_text

    request = request_of(options)
    alone = rule_alone(options.name) if not (options.paths or request.deploys) else None
    if alone is not None:
        sys.stdout.write(explain_json(alone) if options.format == "json" else explain_text(alone))
        return COMPLETE
    result = extracted(options, options.paths, request)
    answer = explained(result.network, options.name, result.root, result.systems, options.unknown)
    sys.stdout.write(explain_json(answer) if options.format == "json" else explain_text(answer))
    return INCOMPLETE if answer.empty else COMPLETE
