# SPDX-License-Identifier: Apache-2.0
"""What does `ros2 security extract_policy` take, and what does it do?

    ros2 security extract_policy policy.xml ~/ws/src --launch bringup:robot.launch.py
    ->  the policy.xml that `rosward extract` writes, for the distro and with the underlays of the sourced ROS

Unlike `generate_policy`, which adds what it sees to a file that is there, this writes the file anew, since the sources say all of it; a file
that somebody else wrote is left alone. Nothing of ROS is imported here: the class that sros2 loads stands in `ros2_security.py`.
"""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Final

from rosward.cli.commands import COMMANDS
from rosward.cli.configuration import apply, leave_open
from rosward.cli.extract import add_compact, compacted, summarise
from rosward.cli.reviewing import add_review, reviewed_result, write_baseline, write_file
from rosward.cli.shared import (
    WrongUseError,
    add_deployment,
    add_enclaves,
    add_sources,
    add_unknown,
    check_paths,
    extracted,
    request_of,
    with_exit_status,
)
from rosward.cli.status import COMPLETE, INCOMPLETE
from rosward.ros.distro import DEFAULT_DISTRO, DISTROS
from rosward.source import limits
from rosward.source.text import read_bytes

if TYPE_CHECKING:
    from rosward.enclaves.widened import Widenings

__all__ = ["add_arguments", "run"]

_OURS: Final = b"<!-- Written by rosward"
_HEAD: Final = 4_096


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.epilog = "Exit status: 0 complete; 1 written but incomplete, or no nodes; 2 usage error or nothing to read; 3 internal error."
    parser.add_argument("POLICY_FILE_PATH", help="path of the policy file to write")
    add_sources(parser)
    _as_sourced(parser)
    add_deployment(parser)
    add_enclaves(parser)
    add_unknown(parser)
    add_compact(parser)
    add_review(parser)
    parser.add_argument("--replace", action="store_true", help="overwrite the file even if rosward did not write it")
    volume = parser.add_mutually_exclusive_group()
    volume.add_argument("-q", "--quiet", action="store_true", help="print only errors")
    volume.add_argument("-v", "--verbose", action="store_true", help="print every finding")
    leave_open(parser)
    if "_ARGCOMPLETE" in os.environ:
        from rosward.cli.completion import offer

        offer(parser)


def _as_sourced(parser: argparse.ArgumentParser) -> None:
    """The defaults of a shell in which ROS is set up."""
    parser.add_argument(
        "--no-ament-prefix-path",
        dest="ament_prefix_path",
        action="store_false",
        help="do not use the folders of AMENT_PREFIX_PATH as underlays",
    )
    parser.set_defaults(ament_prefix_path=True, distro=os.environ.get("ROS_DISTRO") or DEFAULT_DISTRO)
    texts = {
        "--distro": f"ROS 2 distro, which determines what the client library adds (default: ROS_DISTRO, else {DEFAULT_DISTRO})",
        "--ament-prefix-path": "also use the folders of AMENT_PREFIX_PATH as underlays (default)",
    }
    for action in parser._actions:
        action.help = next((texts[o] for o in action.option_strings if o in texts), action.help)


def run(options: argparse.Namespace) -> int:
    """Extract and write; returns the exit status."""
    return with_exit_status(_run)(options)


def _run(options: argparse.Namespace) -> int:
    from rosward.outputs.policies.policy import policy_xml
    from rosward.suppression.judge import SourceTexts

    options.command, options.commands = "extract_policy", tuple(COMMANDS)
    apply(options)
    check_paths(options)
    if options.distro not in DISTROS:
        raise WrongUseError(f"ROS_DISTRO is {options.distro}, which is unknown: choose --distro {'|'.join(DISTROS)}")
    file = Path(options.POLICY_FILE_PATH)
    if not options.replace and not _replaceable(file):
        raise WrongUseError(f"{file} was not written by rosward: compare it with `rosward check`, or use --replace")
    request = request_of(options)
    result = extracted(options, options.paths, request, shown=not options.quiet)
    widened: Widenings = {}
    if options.compact:
        result, widened = compacted(result, options)
    found, _ = reviewed_result(result, SourceTexts(result.root, result.files), options, unused=not request.deploys)
    if not result.network.nodes:
        print("rosward: no nodes found, no policy written", file=sys.stderr)  # noqa: T201
        return INCOMPLETE
    policy = policy_xml(result.network, unknown=options.unknown, widened=widened)
    written = [write_file(policy, str(file))]
    if options.write_baseline is not None:
        written.append(write_baseline(found.shown, options.write_baseline))
    if not options.quiet:
        summarise(result, found, written, options)
    return COMPLETE if found.complete else INCOMPLETE


def _replaceable(file: Path) -> bool:
    """Whether nothing of anybody else is lost with the file."""
    if not os.path.lexists(file):
        return True
    data = read_bytes(file, str(file), limits.REPLACED_FILE)
    return isinstance(data, bytes) and (not data or _OURS in data[:_HEAD])
