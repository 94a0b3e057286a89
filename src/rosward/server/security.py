# SPDX-License-Identifier: Apache-2.0
"""Who may ask this server for something?

    no token                                   403    another user of this machine, a page that guesses
    Host: evil.example (rebound to 127.0.0.1)  421    a page that got its name to lead here
    POST, Origin: http://evil.example          403    a page that sends a form
    GET, Sec-Fetch-Site: cross-site            403    a page that embeds something of ours

The address that is printed holds a token. It is changed for a cookie that scripts cannot read and that no other site's requests carry. Nothing
is said to other origins (no CORS), every answer carries a Content-Security-Policy, and nobody can put a page of ours into a frame.
"""

from __future__ import annotations

import hmac
import ipaddress
import re
import secrets
from collections.abc import Collection, Mapping
from typing import Final, final
from urllib.parse import parse_qs

from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import HTMLResponse, Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from rosward.records import NamedTuple

__all__ = ["PAGE_POLICY", "REPORT_POLICY", "Access", "Guard", "Hosts"]

PAGE_POLICY: Final = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; connect-src 'self'; frame-src 'self'; "
    "form-action 'none'; base-uri 'none'; frame-ancestors 'none'"
)
REPORT_POLICY: Final = (
    "sandbox allow-scripts allow-downloads; default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
    "img-src data: blob:; worker-src blob:; font-src data:; form-action 'none'; base-uri 'none'; frame-ancestors 'self'"
)
"""A report has a policy of its own, too, which names its script by its hash. Both hold."""

_HEADERS: Final = {
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cache-Control": "no-store",
}
_SAFE: Final = frozenset({"GET", "HEAD"})
_OWN_SITE: Final = frozenset({"same-origin", "none"})
_HOST: Final = re.compile(r"(\[[0-9a-fA-F:.]+\]|[A-Za-z0-9.-]+)(?::([0-9]{1,5}))?")


@final
class Access:
    """The token of one server, and tickets that are good for one use: they stand in command lines, which others can see."""

    def __init__(self, port: int) -> None:
        self.token = secrets.token_urlsafe(32)
        self.cookie = f"rosward-{port}"
        self._tickets: set[str] = set()

    def ticket(self) -> str:
        """A token for one use."""
        ticket = secrets.token_urlsafe(32)
        self._tickets.add(ticket)
        return ticket

    def admits(self, given: str) -> bool:
        """Whether this is the token, or a ticket that was not used."""
        if _same(given, self.token):
            return True
        used = next((ticket for ticket in self._tickets if _same(given, ticket)), None)
        self._tickets.discard(used or "")
        return used is not None

    def remembers(self, headers: Headers) -> bool:
        """Whether the request has our cookie. Beside it there may be those of any other server of this machine, of whatever form."""
        pairs = [part.strip().partition("=") for part in headers.get("cookie", "").split(";")]
        return any(name == self.cookie and _same(value, self.token) for name, _, value in pairs)


class Hosts(NamedTuple):
    """The names under which the server is asked for. `names` without port; `numbers`: any numeric address, which no name can be rebound to."""

    names: Collection[str]
    port: int
    numbers: bool = False

    def has(self, host: str) -> bool:
        """Whether a Host header is one of ours."""
        match = _HOST.fullmatch(host)
        if match is None or int(match[2] or 80) != self.port:
            return False
        name = match[1].lower()
        return name in self.names or (self.numbers and _is_address(name.strip("[]")))


@final
class Guard:
    """Stands before the application."""

    def __init__(self, app: ASGIApp, access: Access, hosts: Hosts) -> None:
        self._app = app
        self._access = access
        self._hosts = hosts

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer, or let the request through."""
        if scope["type"] == "lifespan":
            await self._app(scope, receive, send)
            return
        if scope["type"] != "http":
            return
        headers = Headers(scope=scope)
        given = _token(scope)
        refusal = self._refusal(scope["method"], headers, given)

        async def guarded(message: Message) -> None:
            if message["type"] == "http.response.start":
                answer = MutableHeaders(scope=message)
                for name, value in _HEADERS.items():
                    answer[name] = value
                answer.setdefault("Content-Security-Policy", PAGE_POLICY)
                if given is not None and refusal is None:
                    answer.append(
                        "Set-Cookie", f"{self._access.cookie}={self._access.token}; Path=/; HttpOnly; SameSite=Strict"
                    )
            await send(message)

        await (self._app if refusal is None else refusal)(scope, receive, guarded)

    def _refusal(self, method: str, headers: Headers, given: str | None) -> Response | None:
        """Why not; None where nothing speaks against it."""
        hosts = headers.getlist("host")
        if len(hosts) != 1 or not self._hosts.has(hosts[0]):
            return _says(421, "Unknown host name for this server.")
        if not _from_own_page(method, headers, hosts[0]):
            return _says(403, "This request comes from another page.")
        admitted = self._access.admits(given) if given is not None else self._access.remembers(headers)
        if not admitted:
            return _says(
                403, "Open the address printed by <code>rosward serve</code>: it contains the token for this page."
            )
        return None


def _from_own_page(method: str, headers: Mapping[str, str], host: str) -> bool:
    """Whether a request was made by our own page, or by the user who opens an address."""
    site, origin = headers.get("sec-fetch-site"), headers.get("origin")
    if method in _SAFE:
        return site is None or site in _OWN_SITE or headers.get("sec-fetch-mode") == "navigate"
    if origin is None:
        return site == "same-origin"
    return origin == f"http://{host}" and site in {None, "same-origin"}


def _token(scope: Scope) -> str | None:
    """The token in the address of a page that is opened."""
    if scope["method"] != "GET":
        return None
    try:
        found = parse_qs(scope["query_string"].decode("ascii"), max_num_fields=10).get("token")
    except ValueError:
        return None
    return found[0] if found else None


def _same(given: str, held: str) -> bool:
    return hmac.compare_digest(given.encode("utf-8", "replace"), held.encode())


def _is_address(text: str) -> bool:
    try:
        ipaddress.ip_address(text)
    except ValueError:
        return False
    return True


def _says(status: int, text: str) -> Response:
    page = f'<!doctype html><html lang="en"><meta charset="utf-8"><title>rosward</title><p>{text}</p></html>'
    return HTMLResponse(page, status)
