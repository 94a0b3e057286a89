# SPDX-License-Identifier: Apache-2.0
"""`rosward lsp`: a server for editors; and the processes that analyse for it, each of which is this command with `--worker`."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Final

from rosward.cli.shared import WrongUseError, add_deployment, add_sources, reading, refusing, request_of
from rosward.cli.status import COMPLETE

if TYPE_CHECKING:
    from rosward.lsp.session import Settings

_NEEDED: Final = ("pygls", "lsprotocol")
_PAUSES: Final = {"sources": 0.1, "launch": 0.4}
"""Seconds without a further change, after which each worker begins."""


def add(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.description = (
        "Serve an editor over standard input and output by the Language Server Protocol: findings as you type, names at each call, "
        "the other end of a topic. The editor says which folders are open; rosward.toml of each says what is started there."
    )
    parser.epilog = (
        "Exit status: 0 the editor has asked to stop; 1 it has gone; 2 usage error. "
        "This command needs additional packages: pip install 'rosward[lsp]'."
    )
    parser.set_defaults(run=refusing(_run), ignore=[], accepted=[], ignore_in=[])
    add_sources(parser)
    add_deployment(parser, "every executable, and each launch file as a system of its own")
    parser.add_argument("--stdio", action="store_true", help="speak over standard input and output (the default)")
    parser.add_argument(
        "--worker", choices=tuple(_PAUSES), help="analyse PATH for a server; the server starts such processes by itself"
    )


def _run(options: argparse.Namespace) -> int:
    if options.worker is not None:
        return _work(options)
    if any(find_spec(name) is None for name in _NEEDED):
        raise WrongUseError("lsp needs additional packages: pip install 'rosward[lsp]'")
    from rosward.lsp.protocol import server

    own = [word for word in sys.argv[2:] if word != "--stdio" and word not in options.paths]

    def commands(root: str) -> Sequence[tuple[Sequence[str], float]]:
        program = [sys.executable, "-m", "rosward", "lsp", *own]
        return [([*program, f"--worker={each}", "--", root], pause) for each, pause in _PAUSES.items()]

    server(commands).start_io()
    return COMPLETE


def _work(options: argparse.Namespace) -> int:
    from rosward.lsp.session import Session
    from rosward.lsp.worker import serve

    serve(Session(_settings(options), (options.worker,)))
    return COMPLETE


def _settings(options: argparse.Namespace) -> Settings:
    from rosward.lsp.session import Settings
    from rosward.suppression.judge import Wishes

    request = request_of(options)
    given = reading(options, request)
    return Settings(
        str(Path(options.paths[0] if options.paths else ".").absolute()),
        given["distro"],
        tuple(given["models"]),
        tuple(given["underlays"]),
        {
            "budget": given["budget"],
            "environment": given["env"],
            "tests": given["tests"],
            "exclude": given["exclude"],
            "follow_links": given["follow_links"],
        },
        request.launches,
        Wishes(frozenset(options.ignore), frozenset(options.accepted), (), options.ignore_in),
        assumed=not options.no_assumed,
    )
