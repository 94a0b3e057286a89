# SPDX-License-Identifier: Apache-2.0
"""How does the server start, where does it listen, and what is left of it when it ends? No process, and no folder that nobody asked for.

serve(Serving(path="my_ws", port=None), print)    ->    http://127.0.0.1:8765/results/6f0c…?token=…    until Ctrl-C
"""

from __future__ import annotations

import contextlib
import ipaddress
import shutil
import signal
import socket
import sys
import tempfile
import threading
import webbrowser
from collections.abc import Callable, Iterator
from pathlib import Path
from types import FrameType
from typing import Final

import uvicorn

from rosward.records import NamedTuple
from rosward.server.app import application
from rosward.server.connections import MOST_CONNECTIONS, PatientProtocol
from rosward.server.limits import Limits
from rosward.server.places import UploadRefusedError
from rosward.server.security import Access, Hosts
from rosward.server.server import Server, workspace_at
from rosward.server.settings import Settings

__all__ = ["CannotServeError", "Serving", "serve"]

_PORT: Final = 8765
_ANY: Final = frozenset({"0.0.0.0", "::"})
_SECONDS_TO_END: Final = 3


class CannotServeError(Exception):
    """The server cannot start; the message says why."""


class Serving(NamedTuple):
    """What the user asks for. Without a port, one that is free is taken; without `results`, they are gone with the server."""

    path: str | None = None
    settings: Settings = Settings()
    host: str = "127.0.0.1"
    port: int | None = None
    results: str | None = None
    open: bool = False
    limits: Limits = Limits()


class _Uvicorn(uvicorn.Server):
    """Lets the open streams of news end before it waits for all connections to end."""

    def __init__(self, config: uvicorn.Config, leave: Callable[[], None]) -> None:
        super().__init__(config)
        self._leave = leave

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        """End."""
        self._leave()
        await super().shutdown(sockets)


def serve(serving: Serving, tell: Callable[[str], None]) -> None:
    """Serve until the user ends it. Raises CannotServeError."""
    _check(serving.path)
    with contextlib.ExitStack() as stack:
        listening = stack.enter_context(_listen(serving))
        folder = stack.enter_context(_folder(serving.results))
        stack.enter_context(_ends_like_ctrl_c())
        local = _is_local(serving.host)
        port = int(listening.getsockname()[1])
        access = Access(port)
        server = Server(folder, serving.limits, names_paths=local)

        def begin() -> None:
            page = _first_page(server, serving)
            address = f"http://{_host_in_url(serving.host)}:{port}{page}"
            tell(f"rosward is running at\n\n    {address}?token={access.token}\n")
            tell(_who_can_reach(serving.host, local=local))
            if serving.open:
                threading.Thread(
                    target=webbrowser.open, args=(f"{address}?token={access.ticket()}",), daemon=True
                ).start()

        config = uvicorn.Config(
            application(server, access, _hosts(serving.host, port), begin),
            http=PatientProtocol,
            ws="none",
            lifespan="on",
            log_level="warning",
            access_log=False,
            server_header=False,
            proxy_headers=False,
            limit_concurrency=MOST_CONNECTIONS,
            timeout_graceful_shutdown=_SECONDS_TO_END,
        )
        with contextlib.suppress(KeyboardInterrupt):
            _Uvicorn(config, server.news.close).run(sockets=[listening])


def _check(path: str | None) -> None:
    try:
        if path is not None:
            workspace_at(path)
    except UploadRefusedError as error:
        raise CannotServeError(str(error)) from error


def _first_page(server: Server, serving: Serving) -> str:
    """The start page, or that of the workspace that was named."""
    if serving.path is None:
        return "/"
    return f"/results/{server.open_workspace(serving.path, serving.settings, watch=True).id}"


@contextlib.contextmanager
def _listen(serving: Serving) -> Iterator[socket.socket]:
    """The socket, so that the port is known before anything is said."""
    last: OSError | None = None
    for port in [serving.port] if serving.port is not None else [_PORT, 0]:
        family = socket.AF_INET6 if ":" in serving.host else socket.AF_INET
        listening = socket.socket(family, socket.SOCK_STREAM)
        try:
            if sys.platform != "win32":
                listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            listening.bind((serving.host, port))
            listening.listen(128)
        except OSError as error:
            listening.close()
            last = error
            continue
        with listening:
            yield listening
        return
    reason = last.strerror if last is not None else "invalid port"
    raise CannotServeError(f"cannot listen on {serving.host}, port {serving.port or _PORT}: {reason}")


@contextlib.contextmanager
def _folder(results: str | None) -> Iterator[Path]:
    """Where results are kept."""
    if results is not None:
        folder = Path(results)
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise CannotServeError(f"cannot write to {results}: {error.strerror or error}") from error
        yield folder.resolve()
        return
    folder = Path(tempfile.mkdtemp(prefix="rosward-serve-"))
    try:
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)


@contextlib.contextmanager
def _ends_like_ctrl_c() -> Iterator[None]:
    """Let a closed terminal and `kill` end the server as Ctrl-C does, with all that is tidied up then."""

    def end(_number: int, _frame: FrameType | None) -> None:
        raise KeyboardInterrupt

    def hang_up(_number: int, _frame: FrameType | None) -> None:
        signal.raise_signal(signal.SIGTERM)  # which uvicorn knows while it runs

    before = {signal.SIGTERM: signal.signal(signal.SIGTERM, end)}
    if sys.platform != "win32":
        before[signal.SIGHUP] = signal.signal(signal.SIGHUP, hang_up)
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _is_local(host: str) -> bool:
    if host == "localhost":
        return True
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False


def _hosts(host: str, port: int) -> Hosts:
    names = {"127.0.0.1", "localhost", "[::1]", _host_in_url(host).lower()}
    if host in _ANY:
        names.add(socket.gethostname().lower())
    return Hosts(frozenset(names), port, numbers=not _is_local(host))


def _host_in_url(host: str) -> str:
    """The host as it stands in an address."""
    if host in _ANY:
        return "127.0.0.1" if host == "0.0.0.0" else "[::1]"
    return f"[{host}]" if ":" in host else host


def _who_can_reach(host: str, *, local: bool) -> str:
    if local:
        return "It can be reached only from this machine and only with this address. Press Ctrl-C to stop."
    return (
        f"WARNING: listening on {host} without encryption. Other machines can reach it, and anyone who learns this address can use it.\n"
        "Folders of this machine cannot be opened from the page. Press Ctrl-C to stop."
    )
