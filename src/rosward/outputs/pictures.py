# SPDX-License-Identifier: Apache-2.0
"""What was drawn so far, so that a graph that several formats show is drawn once, and one that does not change is not drawn in each run."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from functools import partial
from typing import Final, Protocol, TypeVar, final

__all__ = ["Keeper", "Pictures"]

_KIND: Final = "picture"
_T = TypeVar("_T")


class Keeper(Protocol):
    """Where drawings are from one run to the next, as `cache.store.Store` is."""

    def kept(self, kind: str, question: bytes, accept: Callable[[bytes], _T | None], /) -> _T | None:
        """What `accept` makes of an answer to a question."""

    def keep(self, kind: str, question: bytes, answer: bytes, /) -> None:
        """Keep an answer."""


@final
class Pictures:
    """Drawings by the text that was drawn, for one writing of all formats."""

    def __init__(self, keeper: Keeper | None = None) -> None:
        self._keeper = keeper
        self._drawn: dict[str, str] = {}

    def of(self, text: str, draw: Callable[[], str]) -> str:
        """The drawing of a text in the language of Graphviz, which `draw` makes where it is not there yet."""
        found = self._drawn.get(text)
        if found is None:
            found = self._drawn[text] = draw()
        return found

    def by_program(self, program: str, text: str, draw: Callable[[], str | None]) -> str | None:
        """What a program draws of a text; `program` tells it from any other. `draw` gives None where it fails, which another time it may not."""
        if self._keeper is None:
            return draw()
        question = f"{program}\0{text}".encode("utf-8", "surrogatepass")
        mark = hashlib.blake2b(question, digest_size=20).hexdigest().encode("ascii")
        found = self._keeper.kept(_KIND, question, partial(_accepted, mark))
        if found is None:
            found = draw()
            if found is not None:
                self._keeper.keep(_KIND, question, mark + b"\n" + found.encode("utf-8", "surrogatepass"))
        return found


def _accepted(mark: bytes, answer: bytes) -> str | None:
    asked, _, drawn = answer.partition(b"\n")
    try:
        return drawn.decode("utf-8", "surrogatepass") if asked == mark else None
    except ValueError:
        return None
