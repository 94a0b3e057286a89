# SPDX-License-Identifier: Apache-2.0
"""`rosward check`: does an existing policy let the system do what its code does, and nothing else?"""

from __future__ import annotations

import argparse
import os
import sys
from typing import TYPE_CHECKING

from rosward.cli.shared import (
    COMPLETE,
    INCOMPLETE,
    WrongUseError,
    add_deployment,
    add_enclaves,
    add_sources,
    extracted,
    refusing,
    request_of,
)

if TYPE_CHECKING:
    from rosward.cli.shared import Commands


def add(commands: Commands[argparse.ArgumentParser]) -> None:
    """Declare the command."""
    parser = commands.add_parser(
        "check",
        help="compare an existing policy with what the sources need",
        usage="%(prog)s [options] POLICY.xml|permissions.xml… [PATH…]",
        description="Says what the code needs and the policy lacks, and what the policy allows and no code uses. "
        "The files that end in .xml are the policies, SROS2's or permissions of DDS; the other paths are the sources.",
        epilog="Exit status: 0 the policy is exactly right; 1 there are findings; 2 wrong use or nothing to read.",
    )
    parser.set_defaults(run=refusing(_run))
    add_sources(parser)
    add_deployment(parser)
    add_enclaves(parser)
    parser.add_argument("--format", choices=("text", "json"), default="text", help="(default: %(default)s)")


def _run(options: argparse.Namespace) -> int:
    from rosward.outputs.check_json import check_json
    from rosward.outputs.check_text import check_text
    from rosward.policies.compare import compare
    from rosward.policies.read import read_policy

    files = [p for p in options.paths if p.lower().endswith(".xml") and not os.path.isdir(p)]  # noqa: PTH112
    if not files:
        raise WrongUseError("name the policy to check: a file that ends in .xml")
    request = request_of(options)
    policy = read_policy(files)
    result = extracted(options, [p for p in options.paths if p not in files], request)
    found = compare(result.network, policy) if policy.enclaves else ()
    write = check_json if options.format == "json" else check_text
    sys.stdout.write(write(policy, found, result.findings))
    return INCOMPLETE if found or policy.findings or not result.complete else COMPLETE
