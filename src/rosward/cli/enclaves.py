# SPDX-License-Identifier: Apache-2.0
"""`rosward enclaves suggest`: which processes could share an enclave, and what would each then hold that it does not need?"""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING

from rosward.cli.reviewing import write_file
from rosward.cli.shared import (
    WrongUseError,
    add_deployment,
    add_format,
    add_sources,
    add_unknown,
    extracted,
    refusing,
    request_of,
)
from rosward.cli.status import COMPLETE, INCOMPLETE

if TYPE_CHECKING:
    from rosward.enclaves.suggestion import Suggestion


def add(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.description = "Commands for the enclaves of a system."
    questions = parser.add_subparsers(dest="question", metavar="QUESTION", required=True)
    suggest = questions.add_parser(
        "suggest",
        help="group processes into fewer enclaves",
        description="Group processes into enclaves by the permissions that they share. Prints every step from one enclave per process "
        "to a single enclave, with its price: the permissions that processes would hold but do not need. "
        "Then prints the enclaves of the chosen step, by default the last step that costs nothing.",
        epilog="Exit status: 0 complete; 1 the analysis is incomplete, or no step meets the request; "
        "2 usage error or nothing to read; "
        "3 internal error.",
    )
    suggest.set_defaults(run=refusing(_run))
    add_sources(suggest)
    add_deployment(suggest)
    add_unknown(suggest)
    cut = suggest.add_mutually_exclusive_group()
    cut.add_argument("--max", type=_positive, metavar="N", help="at most N enclaves")
    cut.add_argument(
        "--price",
        type=_natural,
        metavar="PRICE",
        help="as few enclaves as possible within this price",
    )
    suggest.add_argument(
        "--ignore-given", action="store_true", help="also regroup processes whose enclave is set by a launch file"
    )
    suggest.add_argument(
        "--influence",
        action="store_true",
        help="also count what a process could influence with the permissions of the others, by what the nodes make of their inputs",
    )
    suggest.add_argument(
        "--write", metavar="FILE.toml", help="write the suggestion to this file, for `--enclaves FILE.toml`"
    )
    suggest.add_argument("-v", "--verbose", action="store_true", help="list every permission that is not needed")
    add_format(suggest, "text", "json")


def _natural(text: str) -> int:
    if not text.isdecimal():
        raise argparse.ArgumentTypeError(f"{text!r} is not a number")
    return int(text)


def _positive(text: str) -> int:
    number = _natural(text)
    if number == 0:
        raise argparse.ArgumentTypeError("at least one enclave is needed")
    return number


def _run(options: argparse.Namespace) -> int:
    from rosward.enclaves.suggestion import Wish, suggest
    from rosward.outputs.documents.enclaves_json import enclaves_json
    from rosward.outputs.terminal.enclaves_text import enclaves_text

    wish, limit = Wish.FREE, 0
    if options.max is not None:
        wish, limit = Wish.MOST, options.max
    elif options.price is not None:
        wish, limit = Wish.BUDGET, options.price
    options.enclaves = "process"
    result = extracted(options, options.paths, request_of(options), flow=options.influence)
    if not result.network.nodes:
        raise WrongUseError("no node was found, so there is nothing to group")
    found = suggest(
        result.network.nodes,
        wish,
        limit,
        unknown=options.unknown,
        ignore_given=options.ignore_given,
        influence=options.influence,
    )
    if options.write is not None:
        _write(found, options.write)
    sys.stdout.write(
        enclaves_json(found) if options.format == "json" else enclaves_text(found, verbose=options.verbose)
    )
    return COMPLETE if found.met and result.complete else INCOMPLETE


def _write(found: Suggestion, file: str) -> None:
    from rosward.outputs.policies.enclaves_toml import enclaves_toml

    if not file.endswith(".toml"):
        raise WrongUseError(f"--write {file}: the name must end in .toml")
    write_file(enclaves_toml(found), file)
