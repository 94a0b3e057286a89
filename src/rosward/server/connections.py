# SPDX-License-Identifier: Apache-2.0
"""How long may a connection be there without having asked anything, and which one goes where too many do?

    200 clients connect, and send nothing, or half of a request    ->    each is closed after some seconds, the oldest at once
    a browser connects                                             ->    it is answered

uvicorn bounds how many connections there are, not how long one may take to send its request: so whoever opens enough of them would keep
everybody else out.
"""

from __future__ import annotations

import asyncio
from typing import Final, final

from uvicorn.protocols.http.h11_impl import H11Protocol, RequestResponseCycle

__all__ = ["MOST_CONNECTIONS", "PatientProtocol"]

_SECONDS: Final = 10.0
"""For the head of a request, from when the connection is made, or from the answer before."""

_MOST_WAITING: Final = 64
"""Connections on which nothing was asked yet."""

MOST_CONNECTIONS: Final = 256
"""Beyond them a request is refused. More than may wait, so that those that wait never use them up."""


@final
class PatientProtocol(H11Protocol):
    """HTTP as uvicorn speaks it, with a bound on connections that ask nothing."""

    _end: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]  # as uvicorn's own
        """Somebody connects."""
        super().connection_made(transport)
        self._begin_to_wait()
        waiting = [c for c in self.connections if isinstance(c, PatientProtocol) and c._end is not None]
        if len(waiting) > _MOST_WAITING:
            min(waiting, key=lambda each: each._end.when() if each._end is not None else 0.0)._give_up()

    def data_received(self, data: bytes) -> None:
        """A part of a request, which may be its last."""
        super().data_received(data)
        cycle: RequestResponseCycle | None = self.cycle  # which uvicorn has None before the first request
        if cycle is not None and not cycle.response_complete:
            self._stop_waiting()

    def on_response_complete(self) -> None:
        """A request is answered: the next one may come."""
        self._begin_to_wait()
        super().on_response_complete()

    def connection_lost(self, exc: Exception | None) -> None:
        """The other side is gone, or was sent away."""
        self._stop_waiting()
        super().connection_lost(exc)

    def _begin_to_wait(self) -> None:
        self._stop_waiting()
        self._end = self.loop.call_later(_SECONDS, self._give_up)

    def _stop_waiting(self) -> None:
        if self._end is not None:
            self._end.cancel()
            self._end = None

    def _give_up(self) -> None:
        self._stop_waiting()
        self.connections.discard(self)
        self.transport.abort()
