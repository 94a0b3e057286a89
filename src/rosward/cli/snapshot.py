# SPDX-License-Identifier: Apache-2.0
"""`rosward snapshot -o FILE`: what is in the graph of the running robot, as a document for `rosward audit`."""

from __future__ import annotations

import argparse
import sys
from importlib.resources import files

from rosward.cli.shared import WrongUseError, with_exit_status
from rosward.cli.status import COMPLETE


def add(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.description = "Observe the graph of the running ROS 2 system for a few seconds and write a snapshot for `rosward audit`. Needs rclpy."
    parser.epilog = "Exit status: 0 written; 2 usage error, or rclpy is not available."
    parser.set_defaults(run=with_exit_status(_run))
    parser.add_argument("-o", "--output", metavar="FILE", help="output file; - writes to standard output")
    add_looks(parser)
    parser.add_argument(
        "--print-script",
        action="store_true",
        help="print this command as a single Python file, for a robot without rosward: python3 FILE -o robot.json",
    )


def add_looks(parser: argparse._ActionsContainer) -> None:
    """How the graph is looked at."""
    parser.add_argument("--seconds", type=float, default=5.0, metavar="N", help="how long to observe (default: 5)")
    parser.add_argument("--domain-id", type=int, metavar="N", help="DDS domain (default: ROS_DOMAIN_ID)")
    parser.add_argument("--enclave", metavar="PATH", help="enclave to join with, if the graph is secured")


def _run(options: argparse.Namespace) -> int:
    if options.print_script:
        sys.stdout.write(files("rosward.audit").joinpath("snapshot.py").read_text(encoding="utf-8"))
        return COMPLETE
    if options.output is None:
        raise WrongUseError("no output file given: use -o FILE")
    from rosward.audit.snapshot import run

    return run(options.output, options.seconds, options.domain_id, options.enclave)
