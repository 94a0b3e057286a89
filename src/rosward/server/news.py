# SPDX-License-Identifier: Apache-2.0
"""How does a page learn that something has changed? It waits for news, and is told all there is to know; not each change by itself.

async for _ in news.stream():    at once, then after changes, a few times a second at most, until `close`
"""

from __future__ import annotations

import asyncio
from collections.abc import AsyncGenerator
from typing import Final, final

__all__ = ["News"]

_PAUSE: Final = 0.15
_ALIVE: Final = 15.0
"""Seconds after which a page is told something in any case: so it is noticed that the page is gone."""


@final
class News:
    """A number that grows with each change, and those who wait for it."""

    def __init__(self) -> None:
        self._number = 0
        self._waiting: set[asyncio.Event] = set()
        self._closed = False

    @property
    def streams(self) -> int:
        """How many wait."""
        return len(self._waiting)

    def tell(self) -> None:
        """Something has changed."""
        self._number += 1
        for event in self._waiting:
            event.set()

    def close(self) -> None:
        """There will be no more news: all streams end."""
        self._closed = True
        self.tell()

    async def stream(self) -> AsyncGenerator[None, None]:
        """Something is yielded at once, and whenever there is news."""
        event = asyncio.Event()
        self._waiting.add(event)
        try:
            while not self._closed:
                event.clear()
                yield
                if not self._closed:
                    await asyncio.sleep(_PAUSE)
                try:
                    await asyncio.wait_for(event.wait(), _ALIVE)
                except asyncio.TimeoutError:
                    continue
        finally:
            self._waiting.discard(event)
