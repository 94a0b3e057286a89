# SPDX-License-Identifier: Apache-2.0
"""The application: the routes of a server, behind the guard."""

from __future__ import annotations

from collections.abc import Callable

from starlette.applications import Starlette
from starlette.types import ASGIApp

from rosward.server.routes import routes
from rosward.server.security import Access, Guard, Hosts
from rosward.server.server import Server

__all__ = ["application"]


def application(server: Server, access: Access, hosts: Hosts, begin: Callable[[], None] | None = None) -> ASGIApp:
    """What uvicorn runs. `begin` is called once the application has begun."""
    app = Starlette(routes=routes(server), lifespan=lambda _: server.lifespan(begin))
    return Guard(app, access, hosts)
