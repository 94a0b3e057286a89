# SPDX-License-Identifier: Apache-2.0
"""`rosward explain NAME`: why something is in the result: who has it, which line creates it, what its name was made of, which rule it causes."""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING

from rosward.cli.shared import (
    COMPLETE,
    INCOMPLETE,
    ProgressLine,
    WrongUseError,
    add_deployment,
    add_sources,
    refusing,
    request_of,
    underlays_of,
)

if TYPE_CHECKING:
    from rosward.cli.shared import Commands
    from rosward.network.launch_tree import LaunchSystem


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
    parser.add_argument(
        "--enclaves",
        choices=("node", "process", "launch"),
        default=None,
        help="as for extract (default: process with launch files, else node)",
    )
    parser.add_argument(
        "--unknown",
        choices=("deny", "wildcard"),
        default="deny",
        help="in the policy, leave out a name that is not known, or write * for it (default: %(default)s)",
    )
    parser.add_argument("--json", action="store_true", help="as JSON, with nothing left out")


def _run(options: argparse.Namespace) -> int:
    from rosward.outputs.explain import explain_json, explain_text
    from rosward.outputs.explained import explained
    from rosward.pipeline import NothingToReadError, UnknownRequestError, extract, launched

    request = request_of(options)
    underlays = underlays_of(options)
    try:
        with ProgressLine(shown=True) as progress:
            result = extract(
                *options.paths,
                distro=options.distro,
                unknown=options.unknown,
                models=options.models,
                tests=options.tests,
                request=request,
                underlays=underlays,
                enclaves=options.enclaves,
                progress=progress,
            )
            systems: tuple[LaunchSystem, ...] = ()
            if request.deploys:
                systems, _ = launched(
                    *options.paths,
                    distro=options.distro,
                    models=options.models,
                    tests=options.tests,
                    request=request,
                    underlays=underlays,
                )
    except (NothingToReadError, UnknownRequestError) as error:
        raise WrongUseError(str(error)) from error
    answer = explained(result.network, options.name, result.root, systems, options.unknown)
    sys.stdout.write(explain_json(answer) if options.json else explain_text(answer))
    return INCOMPLETE if answer.empty else COMPLETE
