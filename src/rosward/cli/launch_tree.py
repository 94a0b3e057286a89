# SPDX-License-Identifier: Apache-2.0
"""`rosward launch-tree`: what a launch file starts, as a tree, with the source of each value."""

from __future__ import annotations

import argparse
import sys

from rosward.cli.shared import (
    WrongUseError,
    add_deployment,
    add_format,
    add_sources,
    note_failures,
    reading,
    refusing,
    request_of,
)
from rosward.cli.status import COMPLETE, INCOMPLETE
from rosward.guard import Steps


def add(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.description = "Print what launch files start as a tree, with the source of each value. Nothing is executed."
    parser.epilog = (
        "Exit status: 0 everything is known; 1 something is unknown; 2 usage error or nothing to read; "
        "3 internal error."
    )
    parser.set_defaults(run=refusing(_run))
    add_sources(parser)
    add_deployment(parser, "each launch file, as a separate system")
    add_format(parser, "text", "json")


def _run(options: argparse.Namespace) -> int:
    from rosward.analysis.launched import launched
    from rosward.outputs.documents.launch_tree_json import launch_tree_json
    from rosward.outputs.terminal.launch_tree import launch_tree_text
    from rosward.pipeline import NothingToReadError, UnknownRequestError

    options.all_launch = options.all_launch or not (options.launch or options.node)
    request = request_of(options)
    try:
        systems, findings = launched(*options.paths, **reading(options, request))
    except (NothingToReadError, UnknownRequestError) as error:
        raise WrongUseError(str(error)) from error
    write = launch_tree_json if options.format == "json" else launch_tree_text
    steps = Steps()
    text = steps(lambda: write(systems, findings), None, "the launch tree was not written")
    findings = (*findings, *steps.findings)
    note_failures(options, findings)
    sys.stdout.write(write((), findings) if text is None else text)
    return INCOMPLETE if any(f.rule.severity.value == "error" for f in findings) else COMPLETE
