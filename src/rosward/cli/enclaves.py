# SPDX-License-Identifier: Apache-2.0
"""`rosward enclaves suggest`: which processes could share an enclave, and what would each then hold that it does not need?"""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING

from rosward.cli.reviewing import write_file
from rosward.cli.shared import (
    COMPLETE,
    INCOMPLETE,
    WrongUseError,
    add_deployment,
    add_format,
    add_sources,
    add_unknown,
    extracted,
    refusing,
    request_of,
)

if TYPE_CHECKING:
    from rosward.cli.shared import Commands
    from rosward.enclaves.suggestion import Suggestion


def add(commands: Commands[argparse.ArgumentParser]) -> None:
    """Declare the command."""
    parser = commands.add_parser(
        "enclaves",
        help="suggest which processes share an enclave, with the price in rights that nobody needs",
        description="Questions about the enclaves of a system.",
    )
    questions = parser.add_subparsers(dest="question", metavar="QUESTION", required=True)
    suggest = questions.add_parser(
        "suggest",
        help="group processes into fewer enclaves",
        description="Groups processes into enclaves by the rights that they share. Prints every step from one enclave for each process "
        "to one for all, with its price: the rights that processes would hold and do not need; then the enclaves of the chosen step, "
        "which is the last that costs nothing unless another one is asked for.",
        epilog="Exit status: 0 complete; 1 complete but for what the analysis does not know, or no step fulfils the wish; "
        "2 wrong use or nothing to read; "
        "3 a fault of rosward.",
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
        help="as few enclaves as this price allows",
    )
    suggest.add_argument(
        "--ignore-given", action="store_true", help="regroup also processes whose enclave the launch files name"
    )
    suggest.add_argument("--write", metavar="FILE.toml", help="write the suggestion there, for `--enclaves FILE.toml`")
    suggest.add_argument("-v", "--verbose", action="store_true", help="print every right that is not needed")
    add_format(suggest, "text", "json")


def _natural(text: str) -> int:
    if not text.isdecimal():
        raise argparse.ArgumentTypeError(f"{text!r} is no number")
    return int(text)


def _positive(text: str) -> int:
    number = _natural(text)
    if number == 0:
        raise argparse.ArgumentTypeError("there is at least one enclave")
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
    result = extracted(options, options.paths, request_of(options))
    if not result.network.nodes:
        raise WrongUseError("no node was found, so there is nothing to group")
    found = suggest(result.network.nodes, wish, limit, unknown=options.unknown, ignore_given=options.ignore_given)
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
