# SPDX-License-Identifier: Apache-2.0
"""`rosward list topics`: what there is of one kind, one line each."""

from __future__ import annotations

import argparse
import sys
from typing import Final

from rosward.cli.shared import add_deployment, add_enclaves, add_format, add_sources, extracted, refusing, request_of
from rosward.cli.status import COMPLETE, INCOMPLETE

_KINDS: Final = ("nodes", "topics", "services", "actions", "packages", "parameters")


def add(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.description = "Print all entries of one kind, one per line; - marks an empty field."
    parser.epilog = (
        "Exit status: 0 complete; 1 something may be missing (run extract for details); 2 usage error or nothing to read; "
        "3 internal error."
    )
    parser.set_defaults(run=refusing(_run))
    parser.add_argument("kind", choices=_KINDS, metavar="KIND", help=", ".join(_KINDS))
    add_sources(parser)
    add_deployment(parser)
    add_enclaves(parser)
    parser.add_argument("--system", action="store_true", help="include what the client library creates by itself")
    add_format(parser, "text", "json")


def _run(options: argparse.Namespace) -> int:
    from rosward.explanation.listing import rows_of
    from rosward.outputs.documents.listing_json import listing_json
    from rosward.outputs.terminal.listing import listing_text

    result = extracted(options, options.paths, request_of(options))
    rows = rows_of(result.network, options.kind, system=options.system)
    write = listing_json if options.format == "json" else listing_text
    sys.stdout.write(write(rows, options.kind))
    if result.complete:
        return COMPLETE
    errors = sum(f.rule.severity.value == "error" for f in result.findings)
    told = f"rosward: something may be missing: {errors} findings are errors (run rosward extract for details)"
    print(told, file=sys.stderr)  # noqa: T201
    return INCOMPLETE
