# SPDX-License-Identifier: Apache-2.0
"""`rosward nodl PKG/EXE`: the interface of an executable as a NoDL document, for its package to ship."""

from __future__ import annotations

import argparse
import sys

from rosward.cli.shared import WrongUseError, add_sources, extracted, refusing
from rosward.cli.status import COMPLETE, INCOMPLETE


def add(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.description = "Write the interface of an executable of the workspace as NoDL 2 documents, one per node."
    parser.epilog = (
        "Exit status: 0 complete; 1 the interface is partially unknown; 2 usage error or no such executable; "
        "3 internal error."
    )
    parser.set_defaults(run=refusing(_run))
    parser.add_argument("executable", metavar="PKG/EXE", help="the executable")
    add_sources(parser)
    parser.add_argument(
        "-o", "--output", metavar="DIR", help="write NODE.nodl.yaml files to this folder instead of printing"
    )


def _run(options: argparse.Namespace) -> int:
    from rosward.deployment.request import Request, RequestError, parse_node
    from rosward.outputs.policies.nodl import nodl_document
    from rosward.outputs.whole_files import write_text

    try:
        wanted = parse_node(options.executable)
    except RequestError as error:
        raise WrongUseError(str(error)) from error
    result = extracted(options, options.paths, Request(nodes=(wanted,)), shown=False)
    if not result.network.nodes:
        raise WrongUseError(f"{options.executable} creates no node")
    for node in result.network.nodes:
        document = nodl_document(node)
        if options.output is None:
            sys.stdout.write(document)
            continue
        try:
            write_text(options.output, f"{node.name.replace('*', '_')}.nodl.yaml", document)
        except OSError as error:
            raise WrongUseError(f"cannot write to {options.output}: {error.strerror or error}") from error
    return COMPLETE if result.complete else INCOMPLETE
