# SPDX-License-Identifier: Apache-2.0
"""`rosward serve`: a page on this machine on which sources are dropped, and analysed."""

from __future__ import annotations

import argparse
import sys
from importlib.util import find_spec
from typing import TYPE_CHECKING, Final

from rosward.cli.shared import COMPLETE, WrongUseError, refusing
from rosward.ros.distro import DEFAULT_DISTRO, DISTROS

if TYPE_CHECKING:
    from rosward.cli.shared import Commands

_NEEDED: Final = ("starlette", "uvicorn", "python_multipart", "watchfiles")


def add(commands: Commands[argparse.ArgumentParser]) -> None:
    """Declare the command."""
    parser = commands.add_parser(
        "serve",
        help="try it on a page in the browser",
        description="Serves a page on this machine: drop sources or choose an example, and see the report and the policies.",
        epilog="Exit status: 0 when it was ended (Ctrl-C); 2 wrong use. It needs further packages: pip install 'rosward[serve]'.",
    )
    parser.set_defaults(run=refusing(_run), models=[], underlay=[])
    parser.add_argument(
        "paths", nargs="*", metavar="PATH", help="workspace to begin with; it is analysed again when it changes"
    )
    parser.add_argument(
        "--distro", choices=DISTROS, default=DEFAULT_DISTRO, help=f"for PATH (default: {DEFAULT_DISTRO})"
    )
    parser.add_argument(
        "--port", type=_port, metavar="N", help="where to listen (default: 8765, or another that is free)"
    )
    parser.add_argument(
        "--results", metavar="DIR", help="where results are kept (default: a folder that is removed at the end)"
    )
    parser.add_argument("--open", action="store_true", help="open the page in the browser")
    parser.add_argument(
        "--host", default="127.0.0.1", help="let other machines reach it (default: 127.0.0.1, this machine alone)"
    )


def _port(text: str) -> int:
    if not text.isascii() or not text.isdigit() or not 0 <= int(text) <= 65_535:
        raise argparse.ArgumentTypeError("a port is a number from 0 (any that is free) to 65535")
    return int(text)


def _run(options: argparse.Namespace) -> int:
    if any(find_spec(name) is None for name in _NEEDED):
        raise WrongUseError("serve needs further packages: pip install 'rosward[serve]'")
    from rosward.server.run import CannotServeError, Serving, serve
    from rosward.server.settings import Settings

    if len(options.paths) > 1:
        raise WrongUseError("serve begins with one PATH: name others on the page")
    path = options.paths[0] if options.paths else None
    serving = Serving(path, Settings(options.distro), options.host, options.port, options.results, options.open)
    try:
        serve(serving, lambda text: print(text, flush=True))  # noqa: T201
    except CannotServeError as error:
        raise WrongUseError(str(error)) from error
    print("rosward: ended", file=sys.stderr)  # noqa: T201
    return COMPLETE
