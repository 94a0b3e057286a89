# SPDX-License-Identifier: Apache-2.0
"""What is in a file that somebody is editing? What the editor shows, not what was saved last.

    with overlaid({"/ws/src/talker.py": b"..."}):
        read_bytes("/ws/src/talker.py", …)      ->  the bytes of the editor

Texts are by whole paths, as `os.path.abspath` gives them. An overlay stands over files that are there: it makes none.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Final

__all__ = ["overlaid", "shown_instead"]

_SHOWN: Final[ContextVar[Mapping[str, bytes] | None]] = ContextVar("rosward.source.overlay", default=None)


@contextmanager
def overlaid(texts: Mapping[str, bytes]) -> Iterator[None]:
    """Read these bytes in place of those of the files, in this context and in those that are copies of it."""
    token = _SHOWN.set(texts)
    try:
        yield
    finally:
        _SHOWN.reset(token)


def shown_instead(path: str | os.PathLike[str]) -> bytes | None:
    """The bytes in place of those of a file; None where those of the file count."""
    texts = _SHOWN.get()
    return texts.get(os.path.abspath(path)) if texts else None  # noqa: PTH100
