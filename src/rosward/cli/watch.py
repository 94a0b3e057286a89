# SPDX-License-Identifier: Apache-2.0
"""`rosward watch`: what `extract` does, and again whenever the sources change; only what reads a changed file is analysed anew."""

from __future__ import annotations

import argparse
import asyncio
import os
import sys
from collections.abc import AsyncIterator, Callable
from importlib.util import find_spec
from pathlib import Path
from typing import Final

from rosward.cli import extract
from rosward.cli.shared import WrongUseError, refusing
from rosward.cli.status import COMPLETE
from rosward.safe import printable

_END: Final = object()


def add(parser: argparse.ArgumentParser) -> None:
    """Declare the options: those of `extract`."""
    extract.add(parser)
    parser.description = (
        "Do what `rosward extract` does, and again whenever the sources have changed and then stay unchanged for a moment. "
        "The outputs are replaced, and the terminal shows the new summary."
    )
    parser.epilog = "Exit status: 0 stopped with Ctrl-C; 2 usage error. This command needs an additional package: pip install 'rosward[serve]'."
    parser.set_defaults(run=refusing(_run))


def _run(options: argparse.Namespace) -> int:
    if find_spec("watchfiles") is None:
        raise WrongUseError("watch needs an additional package: pip install 'rosward[serve]'")
    if len(options.paths) > 1:
        raise WrongUseError("watch takes a single PATH")
    from rosward.server.watching import changes

    path, own = Path(options.paths[0] if options.paths else ".").resolve(), Path(options.output).resolve()
    try:
        asyncio.run(watch(lambda: changes(path, own), lambda: _once(options)))
    except KeyboardInterrupt:
        print("rosward: stopped", file=sys.stderr)  # noqa: T201
    except (OSError, RuntimeError) as error:  # the folder is gone, or the system watches no more files
        raise WrongUseError(f"cannot watch {path}: {error}") from error
    return COMPLETE


async def watch(changes: Callable[[], AsyncIterator[object]], once: Callable[[], None]) -> None:
    """Do something once, and again after each change; what changes meanwhile counts for the next time."""
    from rosward.pipeline import Memory, remembering

    memory = Memory()

    def again() -> None:
        memory.sources_changed()
        memory.begin()
        once()
        memory.keep_only(memory.used)

    with remembering(memory):
        news = changes()
        change = asyncio.ensure_future(anext(news, _END))
        await asyncio.to_thread(again)
        while await change is not _END:
            change = asyncio.ensure_future(anext(news, _END))
            await asyncio.to_thread(again)


def _once(options: argparse.Namespace) -> None:
    if sys.stdout.isatty():
        print("\x1b[H\x1b[2J\x1b[3J", end="")  # noqa: T201
    try:
        extract.run(options)
    except WrongUseError as error:  # nothing to read, for the moment
        print(f"rosward: {printable(str(error))}", file=sys.stderr)  # noqa: T201
    sys.stdout.flush()
    if os.isatty(2):
        print("rosward: waiting for changes; press Ctrl-C to stop", file=sys.stderr)  # noqa: T201
