# SPDX-License-Identifier: Apache-2.0
"""`rosward diff`: which nodes, entities and rights came and went between two commits, folders, networks or policies."""

from __future__ import annotations

import argparse

from rosward.cli.reviewing import add_output_file, deliver
from rosward.cli.shared import add_deployment, add_enclaves, add_format, add_sources, note_failures, with_exit_status
from rosward.cli.sides import differences
from rosward.cli.status import COMPLETE, INCOMPLETE
from rosward.guard import Steps


def add(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.usage = "%(prog)s [options] OLD NEW\n       %(prog)s [options] --git REV..REV [PATH…]"
    parser.description = (
        "Report which nodes, entities and permissions were gained and lost between two network.json files, two policies, two folders, "
        "or two commits. Folders and commits are analysed with the same options. Nothing is executed, and the work tree is only read."
    )
    parser.epilog = (
        "Exit status: 0 compared; 1 new permissions and --fail-on new-rights; 2 usage error or unreadable input; "
        "3 internal error."
    )
    parser.set_defaults(run=with_exit_status(_run))
    parser.add_argument(
        "--git",
        metavar="REV..REV",
        help="compare two commits; REV alone compares it with the work tree; REV...REV starts at their common ancestor",
    )
    add_sources(parser)
    add_deployment(parser)
    add_enclaves(parser)
    add_format(parser, "text", "markdown", "json", what="markdown is meant for a pull request comment (default: text)")
    add_output_file(parser)
    parser.add_argument("--fail-on", choices=("new-rights",), help="exit with 1 if there are new permissions")


def _run(options: argparse.Namespace) -> int:
    from rosward.diff.compare import not_compared
    from rosward.outputs.documents.diff_json import diff_json
    from rosward.outputs.terminal.diff_text import diff_markdown, diff_text

    found = differences(options)
    write = {"text": diff_text, "markdown": diff_markdown, "json": diff_json}[options.format]
    steps = Steps()
    text = steps(lambda: write(found), None, "the differences were not written")
    note_failures(options, (*found.failures, *steps.findings))
    deliver(write(not_compared(steps.findings)) if text is None else text, options.output)
    return INCOMPLETE if options.fail_on and found.rights.gained else COMPLETE
