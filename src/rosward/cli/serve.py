# SPDX-License-Identifier: Apache-2.0
"""`rosward serve`: a page on this machine on which sources are dropped, and analysed."""

from __future__ import annotations

import argparse
import sys
from importlib.util import find_spec
from typing import Final

from rosward.cli.shared import WrongUseError, refusing
from rosward.cli.status import COMPLETE
from rosward.ros.distro import DEFAULT_DISTRO, DISTROS

_NEEDED: Final = ("starlette", "uvicorn", "python_multipart", "watchfiles")


def add(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.description = "Serve a page on this machine where you can drop sources or choose an example, and see the report and the policies."
    parser.epilog = "Exit status: 0 stopped with Ctrl-C; 2 usage error. This command needs additional packages: pip install 'rosward[serve]'."
    parser.set_defaults(run=refusing(_run), models=[], underlay=[])
    parser.add_argument(
        "paths", nargs="*", metavar="PATH", help="workspace to open; it is analysed again when it changes"
    )
    parser.add_argument(
        "--distro", choices=DISTROS, default=DEFAULT_DISTRO, help=f"ROS 2 distro of PATH (default: {DEFAULT_DISTRO})"
    )
    parser.add_argument("--port", type=_port, metavar="N", help="port to listen on (default: 8765, or any free port)")
    parser.add_argument("--results", metavar="DIR", help="folder for results (default: a temporary folder)")
    parser.add_argument("--open", action="store_true", help="open the page in the browser")
    parser.add_argument(
        "--host",
        default="127.0.0.1",
        help="address to listen on (default: 127.0.0.1, reachable only from this machine)",
    )


def _port(text: str) -> int:
    if not text.isascii() or not text.isdigit() or not 0 <= int(text) <= 65_535:
        raise argparse.ArgumentTypeError("a port must be a number from 0 (any free port) to 65535")
    return int(text)


def _run(options: argparse.Namespace) -> int:
    if any(find_spec(name) is None for name in _NEEDED):
        raise WrongUseError("serve needs additional packages: pip install 'rosward[serve]'")
    from rosward.server.run import CannotServeError, Serving, serve
    from rosward.server.settings import Settings

    if len(options.paths) > 1:
        raise WrongUseError("serve takes a single PATH; open others on the page")
    path = options.paths[0] if options.paths else None
    serving = Serving(path, Settings(options.distro), options.host, options.port, options.results, options.open)
    try:
        serve(serving, lambda text: print(text, flush=True))  # noqa: T201
    except CannotServeError as error:
        raise WrongUseError(str(error)) from error
    print("rosward: stopped", file=sys.stderr)  # noqa: T201
    return COMPLETE
