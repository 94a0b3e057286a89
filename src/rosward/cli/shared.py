# SPDX-License-Identifier: Apache-2.0
"""What several commands share: what to read and what to start, exit status, progress, refusals."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Final, TypedDict

from rosward.cli.amounts import cores, factor, jobs
from rosward.cli.kept import add_cache, known_or, store_of
from rosward.cli.progress import ProgressLine
from rosward.cli.status import INTERNAL, WRONG_USE
from rosward.network.enclave_mode import EnclaveMode
from rosward.ros.distro import DEFAULT_DISTRO, DISTROS
from rosward.rules import INTERNAL_ERROR, UNREAD_ARGUMENT
from rosward.safe import printable
from rosward.source import disk
from rosward.source.exclude import PatternError, pattern_of
from rosward.source.surroundings import SurroundingsError, parse_variable, surroundings

if TYPE_CHECKING:
    from rosward.deployment.request import Request
    from rosward.findings import Finding
    from rosward.network.assigned import Assignment
    from rosward.network.checks import UnknownNames
    from rosward.pipeline import Budget
    from rosward.result import Result
    from rosward.source.exclude import Exclusion

MODES: Final = tuple(mode.value for mode in EnclaveMode)

_LISTING: Final = ("extract", "extract_policy")
"""The commands that print the findings themselves; others tell what is wrong with how they are called."""


class _Reading(TypedDict):
    env: dict[str, str]
    distro: str
    models: list[str]
    tests: bool
    exclude: list[str | Exclusion]
    follow_links: bool
    request: Request
    underlays: list[str]


class _ReadingWithin(_Reading):
    budget: Budget


class _WantedEnclaves(TypedDict, total=False):
    enclaves: str | None
    assigned: Assignment


class WrongUseError(Exception):
    """The command cannot be carried out; the message says why."""


def add_sources(parser: argparse.ArgumentParser) -> None:
    """What to read."""
    parser.add_argument(
        "paths", nargs="*", default=[], metavar="PATH", help="file, package or workspace (default: current folder)"
    )
    parser.add_argument(
        "--distro",
        choices=DISTROS,
        default=DEFAULT_DISTRO,
        help=f"ROS 2 distro, which determines what the client library adds (default: {DEFAULT_DISTRO})",
    )
    parser.add_argument(
        "--models",
        action="append",
        default=[],
        metavar="DIR",
        help="folder with stub files for additional libraries and declared interfaces of nodes (DIR/nodes/PKG.yaml)",
    )
    parser.add_argument(
        "--underlay",
        action="append",
        default=[],
        metavar="DIR",
        help="another workspace or install folder to search for launch and parameter files",
    )
    parser.add_argument(
        "--ament-prefix-path",
        action="store_true",
        help="also use the folders of AMENT_PREFIX_PATH as underlays",
    )
    add_environment(parser)
    add_selection(parser)
    parser.add_argument("--follow-links", action="store_true", help="follow symbolic links that lead out of the PATHs")
    parser.add_argument(
        "--no-assumed",
        action="store_true",
        help="omit nodes of classes that the sources never instantiate",
    )
    parser.add_argument(
        "--budget",
        type=factor,
        default=1.0,
        metavar="N",
        help="multiply the number of analysis steps per program by N; at the limit, the analysis stops with RW201 (default: 1)",
    )
    parser.add_argument(
        "-j",
        "--jobs",
        type=jobs,
        metavar="N",
        default=None,
        help="analyse with up to N processes at once; the result is the same (default: the number of cores)",
    )
    add_cache(parser)
    parser.add_argument(
        "--no-config", action="store_true", help="ignore rosward.toml and pyproject.toml of the sources"
    )


def add_selection(parser: argparse._ActionsContainer) -> None:
    """Which files of the sources are read."""
    parser.add_argument("--tests", action="store_true", help="also read test files")
    parser.add_argument(
        "--exclude",
        action="append",
        type=_pattern,
        default=[],
        metavar="PATTERN",
        help="skip matching files and folders, with patterns as in .gitignore; may be repeated",
    )


def add_environment(parser: argparse.ArgumentParser) -> None:
    """In which environment everything is started. Of several values of one name the last one counts."""
    parser.add_argument(
        "--env",
        action="append",
        type=_variable,
        default=[],
        metavar="NAME=VALUE",
        help="environment variable of the shell that starts the system; may be repeated",
    )
    parser.add_argument(
        "--env-from-shell",
        dest="env",
        action="extend",
        type=_of_shell,
        default=[],
        metavar="NAME[,NAME…]",
        help="environment variables to take from the current shell; may be repeated",
    )


def _variable(text: str) -> tuple[str, str]:
    try:
        return parse_variable(text)
    except SurroundingsError as error:
        raise argparse.ArgumentTypeError(str(error)) from error


def _of_shell(text: str) -> list[tuple[str, str]]:
    names = [name.strip() for name in text.split(",")]
    missing = [name for name in names if name not in os.environ]
    if missing:
        raise argparse.ArgumentTypeError(f"not set in this shell: {', '.join(missing)}")
    return [(name, os.environ[name]) for name in names]


def _pattern(text: str) -> str:
    try:
        return pattern_of(text)
    except PatternError as error:
        raise argparse.ArgumentTypeError(str(error)) from error


def add_format(parser: argparse.ArgumentParser, *formats: str, what: str = "") -> None:
    """In which form the answer is printed; the first is the default. `--json` is short for `--format json`."""
    default = formats[0]
    parser.add_argument("--format", choices=formats, default=default, help=what or f"(default: {default})")
    parser.add_argument("--json", dest="format", action="store_const", const="json", help="same as --format json")


def add_deployment(parser: argparse.ArgumentParser, default: str = "every executable, as with `ros2 run`") -> None:
    """What to start; `default` says what is where nothing is asked for."""
    group = parser.add_argument_group(f"what to start (default: {default})")
    group.add_argument(
        "--launch",
        action="append",
        default=[],
        metavar="FILE|PKG:FILE[,arg:=value…]",
        help="analyse what this launch file starts; may be repeated",
    )
    group.add_argument("--all-launch", action="store_true", help="every launch file, each as a separate system")
    group.add_argument(
        "--arg", action="append", default=[], metavar="NAME:=VALUE", help="launch argument; * leaves its value open"
    )
    group.add_argument(
        "--node", action="append", default=[], metavar="PKG/EXE[:NAME]", help="also start this executable"
    )
    group.add_argument(
        "--params", action="append", default=[], metavar="FILE.yaml", help="parameter file for every process"
    )


def add_enclaves(parser: argparse.ArgumentParser) -> None:
    """How enclaves are chosen."""
    parser.add_argument(
        "--enclaves",
        type=_enclaves,
        metavar="{node,process,launch,FILE.toml}",
        default=None,
        help="one enclave per node, per process, as set by the launch files, or as assigned by FILE.toml "
        "(default: process with launch files, otherwise node)",
    )


def _enclaves(text: str) -> str:
    if text not in MODES and not text.endswith(".toml"):
        raise argparse.ArgumentTypeError(f"invalid choice: {text!r} (choose from {', '.join(MODES)}, or a FILE.toml)")
    return text


def add_unknown(parser: argparse.ArgumentParser) -> None:
    """What a policy says of a name that is not known."""
    parser.add_argument(
        "--unknown",
        choices=("deny", "wildcard"),
        default="deny",
        help="unknown names in the policy: omit them, or write * for them (default: deny)",
    )


def extracted(
    options: argparse.Namespace,
    paths: Iterable[str],
    request: Request,
    *,
    shown: bool = True,
    flow: bool = False,
    watched: frozenset[str] = frozenset(),
) -> Result:
    """What the options ask to read and to start; `shown`: progress is drawn. Raises WrongUseError.

    `flow`: also what flows in each node, where what `watched` functions give is told apart.
    """
    read, given = tuple(paths), _reading(options, request)
    enclaves = _wanted_enclaves(getattr(options, "enclaves", None))
    unknown: UnknownNames = getattr(options, "unknown", "deny")
    assumed = not options.no_assumed
    store = store_of(options)

    def compute() -> Result:
        from rosward.pipeline import NothingToReadError, UnknownRequestError, budget_of, extract

        many = options.jobs or cores()
        budget = budget_of(options.budget)._replace(flow=flow, watched=watched)
        try:
            with ProgressLine(shown=shown) as progress:
                return extract(
                    *read,
                    **given,
                    budget=budget,
                    unknown=unknown,
                    **enclaves,
                    assumed=assumed,
                    jobs=many,
                    store=store,
                    progress=progress,
                )
        except (NothingToReadError, UnknownRequestError) as error:
            raise WrongUseError(str(error)) from error

    asked = {**given, **enclaves, "paths": read, "unknown": unknown, "assumed": assumed}
    result = known_or(compute, store, {**asked, "budget": options.budget, "flow": flow, "watched": watched})
    note_failures(options, result.findings)
    if options.command not in _LISTING:
        for finding in result.findings:
            if finding.code == UNREAD_ARGUMENT:
                print(f"rosward: {printable(finding.message)}", file=sys.stderr)  # noqa: T201
    return result


def note_failures(options: argparse.Namespace, findings: Iterable[Finding]) -> None:
    """Keep in mind which findings say that rosward itself failed: they decide the exit status, whatever is made of them."""
    failures: list[str] = getattr(options, "failures", [])
    failures += (f"{f.place}: {f.message}" if f.place.file else f.message for f in findings if f.code == INTERNAL_ERROR)


def reading(options: argparse.Namespace, request: Request) -> _ReadingWithin:
    """What the options ask to read, as `extract` and `launched` are told."""
    from rosward.pipeline import budget_of

    return {**_reading(options, request), "budget": budget_of(options.budget)}


def _reading(options: argparse.Namespace, request: Request) -> _Reading:
    try:
        surroundings(options.distro, dict(options.env))
    except SurroundingsError as error:
        raise WrongUseError(f"--env: {error}") from error
    return {
        "env": dict(options.env),
        "distro": options.distro,
        "models": options.models,
        "tests": options.tests,
        "exclude": options.exclude,
        "follow_links": options.follow_links,
        "request": request,
        "underlays": _underlays_of(options),
    }


def _wanted_enclaves(wanted: str | None) -> _WantedEnclaves:
    if wanted is None or wanted in MODES:
        return {"enclaves": wanted}
    from rosward.network.assigned import AssignmentError, read_assignment

    try:
        return {"enclaves": "process", "assigned": read_assignment(Path(wanted))}
    except AssignmentError as error:
        raise WrongUseError(f"--enclaves {wanted}: {error}") from error


def _underlays_of(options: argparse.Namespace) -> list[str]:
    """The underlays, nearest first: those that are named, then the sourced ones where that is asked for."""
    sourced = os.environ.get("AMENT_PREFIX_PATH", "") if options.ament_prefix_path else ""
    return [*options.underlay, *(folder for folder in sourced.split(os.pathsep) if disk.is_folder(folder))]


def request_of(options: argparse.Namespace) -> Request:
    """What the options ask to start. Raises WrongUseError."""
    from rosward.deployment.request import Request, RequestError, assignments, parse_launch, parse_node

    try:
        request = Request(
            tuple(parse_launch(text) for text in options.launch),
            tuple(parse_node(text) for text in options.node),
            tuple(options.params),
            assignments(options.arg),
            options.all_launch,
        )
    except RequestError as error:
        raise WrongUseError(str(error)) from error
    if request.arguments and not (request.launches or request.all_launch):
        raise WrongUseError("--arg needs --launch or --all-launch")
    return request


def refusing(
    run: Callable[[argparse.Namespace], int], prepare: Callable[[argparse.Namespace], None] | None = None
) -> Callable[[argparse.Namespace], int]:
    """A command that says why it cannot be carried out, and exits with 2. `prepare` completes its options."""

    def checked(options: argparse.Namespace) -> int:
        if prepare is not None:
            prepare(options)
        check_paths(options)
        return run(options)

    return with_exit_status(checked)


def with_exit_status(run: Callable[[argparse.Namespace], int]) -> Callable[[argparse.Namespace], int]:
    """The same, and wrong use is told and is status 2; where rosward itself failed, it is status 3, whatever else there is to say."""

    def refused(options: argparse.Namespace) -> int:
        failures: list[str] = []
        options.failures = failures
        try:
            status = run(options)
        except WrongUseError as error:
            print(f"rosward: {printable(str(error))}", file=sys.stderr)  # noqa: T201
            return WRONG_USE
        if failures and status != INTERNAL:
            told = f"rosward: internal error (RW299), so the result is incomplete; please report it: {failures[0]}"
            print(printable(told), file=sys.stderr)  # noqa: T201
            return INTERNAL
        return status

    return refused


def check_paths(options: argparse.Namespace) -> None:
    """Raise WrongUseError where a path of the options is not there."""
    missing = [p for p in options.paths if not disk.is_there(p)]
    if missing:
        hint = next((f"; use --arg {p} to set a launch argument" for p in missing if ":=" in p), "")
        raise WrongUseError(f"no such file or folder: {', '.join(missing)}{hint}")
    for option in ("models", "underlay"):
        absent = [m for m in getattr(options, option) if not disk.is_folder(m)]
        if absent:
            raise WrongUseError(f"--{option}: no such folder: {', '.join(absent)}")
    for file in getattr(options, "params", ()):
        if not disk.is_file(file):
            raise WrongUseError(f"--params: no such file: {file}")
