# SPDX-License-Identifier: Apache-2.0
"""The command line: options, exit status, choice of outputs. No analysis.

What a command has said before is said again (`replayed.py`) where nothing has changed; else its words are taken apart (`command_line.py`).
"""
# PYTHON_ARGCOMPLETE_OK

from __future__ import annotations

import gc
import io
import os
import sys

from rosward.cli.status import COMPLETE, INTERNAL, INTERRUPTED

TYPE_CHECKING = False  # not from typing: what says again what it said before loads little
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Final

__all__ = ["main", "program"]

_REPLAYED: Final = frozenset({"extract", "check"})
"""The commands that look at nothing but the disk, and whose files are all written by `outputs/whole_files.py`."""

_OBJECTS: Final = 50_000
"""New objects between two looks for circles: most of what a command makes lives to its end, and to look through it takes a while."""


_BRIEF: Final = frozenset({"check", "diff", "enclaves", "explain", "extract", "flow", "launch-tree", "list", "nodl"})
"""The commands that end with their work: to look for circles frees next to nothing there."""


def program() -> None:
    """The command as a process. At its end nothing is taken apart: the system frees it faster."""
    gc.set_threshold(_OBJECTS, *gc.get_threshold()[1:])
    if sys.argv[1:] and sys.argv[1] in _BRIEF:
        gc.disable()
    status = main()
    try:
        sys.stdout.flush()
        sys.stderr.flush()
    except BrokenPipeError:  # as in `main`
        os._exit(COMPLETE)
    except (OSError, ValueError):
        sys.exit(status)  # Python tells what is wrong with the stream
    os._exit(status)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the exit status: 0 complete, 1 incomplete, 2 usage error or nothing to read, 3 a fault of rosward."""
    words = sys.argv[1:] if arguments is None else arguments
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # a terminal that cannot show a character shows its escape
            stream.reconfigure(errors="backslashreplace")
    try:
        if words and words[0] in _REPLAYED and "_ARGCOMPLETE" not in os.environ:
            from rosward.cli.replayed import replayed_or

            return replayed_or(words, _parsed_and_run)
        return _parsed_and_run(words)
    except BrokenPipeError:  # the reader of our output has gone: that is no failure of ours
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return COMPLETE
    except KeyboardInterrupt:
        print("rosward: interrupted", file=sys.stderr)  # noqa: T201
        return INTERRUPTED
    except Exception as error:
        from rosward.guard import where

        what = f"{type(error).__name__} in {where(error)}"
        print(f"rosward: internal error ({what}). Please report this.", file=sys.stderr)  # noqa: T201
        return INTERNAL


def _parsed_and_run(words: Sequence[str]) -> int:
    from rosward.cli.command_line import parsed_and_run

    return parsed_and_run(words)
