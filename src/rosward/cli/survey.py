# SPDX-License-Identifier: Apache-2.0
"""`rosward survey`: many repositories, one set of tables."""

from __future__ import annotations

import argparse
import sys
from contextlib import nullcontext
from typing import TYPE_CHECKING, Final

from rosward.cli.amounts import factor
from rosward.cli.progress import ProgressLine
from rosward.cli.shared import WrongUseError, add_selection, refusing
from rosward.cli.status import COMPLETE, INCOMPLETE, INTERNAL
from rosward.ros.distro import DEFAULT_DISTRO, DISTROS
from rosward.safe import printable

if TYPE_CHECKING:
    from rosward.surveying.run import Survey

_NAMED: Final = 10


def add(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.description = (
        "Analyse many repositories, each in a separate process with bounded time and memory, and write one set of tables "
        "(Parquet) and an overview. If a run is stopped, the same command continues it."
    )
    parser.epilog = (
        "Exit status: 0 there is a result for each repository; 1 a repository failed, took too long or is missing, or the run was stopped; "
        "2 usage error or the output cannot be written; 3 rosward itself failed on a repository or a part of it. "
        "This command needs additional packages: pip install 'rosward[survey]', and 'rosward[survey,dask]' for --scheduler."
    )
    parser.set_defaults(run=refusing(_run), models=[], underlay=[])
    parser.add_argument(
        "paths",
        nargs=1,
        metavar="PATH",
        help="a folder in which each folder is a repository, or a file that lists repositories, one path per line",
    )
    parser.add_argument("--null", action="store_true", help="the paths of the list end with NUL, as of `find -print0`")
    parser.add_argument(
        "-o", "--output", metavar="DIR", default="rosward-survey", help="output folder (default: rosward-survey)"
    )
    running = parser.add_argument_group("where it runs").add_mutually_exclusive_group()
    running.add_argument(
        "-j", "--jobs", type=_number, metavar="N", help="processes at a time (default: the number of cores)"
    )
    running.add_argument(
        "--scheduler", metavar="ADDRESS", help="use the workers of this Dask scheduler, such as tcp://10.0.0.1:8786"
    )
    limits = parser.add_argument_group("limits of each repository")
    limits.add_argument(
        "--seconds", type=_number, metavar="N", default=600, help="seconds of processor time (default: 600)"
    )
    limits.add_argument(
        "--memory",
        type=_number,
        metavar="MB",
        default=4096,
        help="megabytes of address space, 512 of which are reserved for the stack (default: 4096)",
    )
    parser.add_argument(
        "--retry", action="store_true", help="also analyse again what failed or took too long in an earlier run"
    )
    group = parser.add_argument_group("how each repository is analysed")
    group.add_argument(
        "--distro", choices=DISTROS, default=DEFAULT_DISTRO, help=f"ROS 2 distro (default: {DEFAULT_DISTRO})"
    )
    group.add_argument(
        "--all-launch",
        action="store_true",
        help="analyse what the launch files start, each as a separate system (default: every executable, as with `ros2 run`)",
    )
    add_selection(group)
    group.add_argument(
        "--no-assumed", action="store_true", help="omit nodes of classes that the sources never instantiate"
    )
    group.add_argument(
        "--budget",
        type=factor,
        default=1.0,
        metavar="N",
        help="multiply the number of analysis steps per program by N",
    )
    parser.add_argument("-q", "--quiet", action="store_true", help="print only errors")


def _number(text: str) -> int:
    if not text.isascii() or not text.isdigit() or not 0 < int(text[:9]) <= 1_000_000:
        raise argparse.ArgumentTypeError(f"{text!r} must be a number from 1 to 1000000")
    return int(text)


def _run(options: argparse.Namespace) -> int:
    from rosward.surveying.cluster import cluster
    from rosward.surveying.executing import LostExecutorError
    from rosward.surveying.run import SurveyError, survey

    try:
        with (
            cluster(options.scheduler) if options.scheduler else nullcontext() as executor,
            ProgressLine(shown=not options.quiet) as progress,
        ):
            found = survey(
                options.paths[0],
                options.output,
                executor=executor,
                jobs=options.jobs,
                null=options.null,
                distro=options.distro,
                all_launch=options.all_launch,
                tests=options.tests,
                exclude=options.exclude,
                assumed=not options.no_assumed,
                budget=options.budget,
                seconds=options.seconds,
                memory=options.memory,
                retry=options.retry,
                progress=progress,
            )
    except SurveyError as error:
        raise WrongUseError(str(error)) from error
    except LostExecutorError as error:
        print(f"rosward: {printable(str(error))}", file=sys.stderr)  # noqa: T201
        return INCOMPLETE
    except OSError as error:
        raise WrongUseError(f"cannot write to {options.output}: {error.strerror or error}") from error
    if not options.quiet:
        _summarise(found)
    if found.faults:
        print(  # noqa: T201
            f"rosward: rosward itself failed on {found.faults} of the repositories (fault in repositories.parquet); please report it",
            file=sys.stderr,
        )
        return INTERNAL
    return COMPLETE if found.complete else INCOMPLETE


def _summarise(found: Survey) -> None:
    from rosward.network.counts import several
    from rosward.surveying.overview import OVERVIEW
    from rosward.surveying.tables import file_of

    total = sum(found.states.values())
    states = ", ".join(f"{found.states[s]:,} {s}" for s in ("ok", "empty", "failed", "timeout") if found.states.get(s))
    lines = [f"rosward surveyed {several(total, 'repository', 'repositories')}: {states}."]
    if found.analysed < total:
        lines.append(f"  {total - found.analysed:,} had a result from an earlier run")
    if found.duplicates:
        lines.append(
            f"  {several(found.duplicates, 'path leads', 'paths lead')} to a folder that is in the list already"
        )
    if found.links:
        lines.append(f"  {several(found.links, 'symbolic link was', 'symbolic links were')} not followed; use a list")
    rows = found.rows
    lines += ["", "  " + " · ".join(f"{name} {rows[name]:,}" for name in ("nodes", "entities", "findings", "systems"))]
    if found.without:
        lines += ["", *(f"  {name}: {reason}" for name, reason in found.without[:_NAMED])]
        more = found.states.get("failed", 0) + found.states.get("timeout", 0) - len(found.without[:_NAMED])
        lines += [f"  … and {more:,} more without a result"] if more else []
    lines += ["", *(f"  {found.output}/{name}" for name in (*map(file_of, rows), OVERVIEW))]
    print("\n".join(printable(line) for line in lines))  # noqa: T201
