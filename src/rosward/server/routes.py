# SPDX-License-Identifier: Apache-2.0
"""What can be asked of the server, address by address.

    GET  /                                the page on which something is chosen
    POST /api/uploads                     files, or a zip                         -> {"id": …}
    POST /api/workspaces                  {"path": …, "settings": …, "watch": …}  -> {"id": …}
    POST /api/examples/talker                                                     -> {"id": …}
    GET  /api/results, /api/news          all results in short, once or with every change (server-sent events)
    GET  /results/ID                      the page of a result
    GET  /results/ID/report               its report, in a sandbox
    GET  /results/ID/files/policy.xml     one of its files
    POST /api/results/ID/again            {"settings": …}                         -> {"id": …}
    POST /api/results/ID/cancel, …/delete, …/watch

What is refused is answered by {"error": "…"} and status 400; 503 where too much is asked at a time, 507 where there is no room.
"""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator, Awaitable, Callable
from pathlib import Path
from typing import Final

from starlette.requests import ClientDisconnect, Request
from starlette.responses import FileResponse, HTMLResponse, JSONResponse, Response, StreamingResponse
from starlette.routing import BaseRoute, Route
from starlette.types import Receive, Scope, Send

from rosward.findings import Finding
from rosward.records import NamedTuple
from rosward.safe import encodable, printable
from rosward.server.pages import ASSETS, asset
from rosward.server.places import UploadRefusedError
from rosward.server.results import StoredResult
from rosward.server.security import REPORT_POLICY
from rosward.server.server import Server
from rosward.server.settings import read_settings
from rosward.server.shown import in_short
from rosward.server.uploads import read_upload
from rosward.source import limits
from rosward.source.text import read_bytes

__all__ = ["routes"]

_LONGEST_BODY: Final = 256 * 1024
_TEXT: Final = "text/plain; charset=utf-8"

Answer = Callable[[Request], Awaitable[Response]]


def routes(server: Server) -> list[BaseRoute]:
    """The addresses of a server."""
    asked = _Asked(server)
    posts = {
        "/api/uploads": asked.upload,
        "/api/workspaces": asked.workspace,
        "/api/examples/{name}": asked.example,
        "/api/results/{id}/again": asked.again,
        "/api/results/{id}/cancel": asked.cancel,
        "/api/results/{id}/delete": asked.delete,
        "/api/results/{id}/watch": asked.watch,
    }
    gets = {
        "/": asked.start,
        "/assets/{name}": asked.asset,
        "/api/results": asked.results,
        "/api/news": asked.news,
        "/results/{id}": asked.result,
        "/results/{id}/report": asked.report,
        "/results/{id}/files/{path:path}": asked.file,
    }
    return [
        *(Route(path, _refusing(answer), methods=["POST"]) for path, answer in posts.items()),
        *(Route(path, answer, methods=["GET"]) for path, answer in gets.items()),
    ]


def _refusing(answer: Answer) -> Answer:
    """An answer that says why something is refused."""

    async def answered(request: Request) -> Response:
        try:
            return await answer(request)
        except UploadRefusedError as error:
            return JSONResponse({"error": printable(str(error))}, 400)
        except OSError as error:  # no room on the disk, no file descriptor, a folder that somebody removed
            reason = printable(error.strerror or str(error))
            return JSONResponse({"error": f"it cannot be stored on this machine: {reason}"}, 507)
        except ClientDisconnect:
            return Response(status_code=400)  # nobody reads it

    return answered


class _Asked(NamedTuple):
    """What the server does when it is asked."""

    server: Server

    # Pages

    async def start(self, _request: Request) -> Response:
        server = self.server
        return HTMLResponse(server.pages.start(tuple(server.examples.values()), names_paths=server.names_paths))

    async def asset(self, request: Request) -> Response:
        name = request.path_params["name"]
        return Response(asset(name), media_type=ASSETS[name]) if name in ASSETS else Response(status_code=404)

    async def result(self, request: Request) -> Response:
        server = self.server
        result = self._of(request)
        if result is None:
            return HTMLResponse(server.pages.missing(), 404)
        changes = _read(server.results.output(result) / "changes.txt") if result.summary.get("changed") else ""
        watched = server.watches.watches(result.source)
        return HTMLResponse(server.pages.result(result, server.example_of(result), changes, watched=watched))

    async def report(self, request: Request) -> Response:
        result = self._of(request)
        page = None if result is None else _regular(self.server.results.output(result), "report.html")
        if page is None:
            return Response(status_code=404)
        return FileResponse(page, media_type="text/html", headers={"Content-Security-Policy": REPORT_POLICY})

    async def file(self, request: Request) -> Response:
        """One of the files that the analysis wrote; `?show` for a look at it, else to be saved."""
        result, path = self._of(request), request.path_params["path"]
        if result is None or path not in _files(result):
            return Response(status_code=404)
        file = _regular(self.server.results.output(result), path)
        if file is None:
            return Response(status_code=404)
        headers = {"Content-Security-Policy": "sandbox; default-src 'none'"}
        if "show" in request.query_params:
            return FileResponse(file, media_type=_TEXT, headers=headers)
        name = f"{encodable(result.source.title)}-rosward.zip" if path == "outputs.zip" else path.rpartition("/")[2]
        return FileResponse(file, media_type="application/octet-stream", filename=name, headers=headers)

    # News

    async def results(self, _request: Request) -> Response:
        return JSONResponse(self._all())

    async def news(self, _request: Request) -> Response:
        server = self.server
        if server.streaming.locked():
            return JSONResponse({"error": "too many pages are open"}, 503)
        await server.streaming.acquire()  # at once: many may ask before the first of them is answered

        async def events() -> AsyncIterator[str]:
            async for _ in server.news.stream():
                yield f"data: {json.dumps(self._all())}\n\n"

        return _Released(events(), server.streaming)

    # What is to be done

    async def upload(self, request: Request) -> Response:
        server = self.server
        if server.uploading.locked():
            return JSONResponse({"error": "too many uploads at once: try again later"}, 503)
        async with server.uploading:
            key, folder = server.results.new_upload()
            try:
                came = await asyncio.wait_for(read_upload(request, folder, server.limits), server.limits.sending)
            except asyncio.TimeoutError as error:
                server.results.drop_upload(key)
                raise UploadRefusedError(f"it took more than {server.limits.sending:g} seconds") from error
            except BaseException:
                server.results.drop_upload(key)
                raise
        return _started(server.open_upload(key, came.title, came.settings, zipped=came.zipped))

    async def workspace(self, request: Request) -> Response:
        body = await self._body(request)
        path = body.get("path")
        if not self.server.names_paths:
            raise UploadRefusedError(
                "this server can be reached from other machines, so it does not open folders named on a page"
            )
        if not isinstance(path, str):
            raise UploadRefusedError("enter a folder or a file")
        settings = read_settings(body.get("settings", {}))
        return _started(self.server.open_workspace(path, settings, watch=body.get("watch") is True))

    async def example(self, request: Request) -> Response:
        example = self.server.examples.get(request.path_params["name"])
        return Response(status_code=404) if example is None else _started(self.server.open_example(example))

    async def again(self, request: Request) -> Response:
        body, result = await self._body(request), self._wanted(request)
        return _started(self.server.again(result, read_settings(body.get("settings", {}))))

    async def cancel(self, request: Request) -> Response:
        await self.server.jobs.cancel(self._wanted(request).id)
        return JSONResponse({})

    async def delete(self, request: Request) -> Response:
        await self.server.remove(self._wanted(request))
        return JSONResponse({})

    async def watch(self, request: Request) -> Response:
        body, result = await self._body(request), self._wanted(request)
        if result.source.kind != "workspace":
            raise UploadRefusedError("only folders on this machine can be watched")
        if body.get("on") is True:
            self.server.watches.start(result.source)
        else:
            await self.server.watches.stop(result.source)
        self.server.results.touch()
        return JSONResponse({})

    def _all(self) -> list[dict[str, object]]:
        watches = self.server.watches
        return [in_short(result, watched=watches.watches(result.source)) for result in self.server.results.all()]

    async def _body(self, request: Request) -> dict[str, object]:
        """The JSON object of a request. Raises UploadRefusedError."""
        silence = self.server.limits.silence
        try:
            return await asyncio.wait_for(_read_json(request), silence)
        except asyncio.TimeoutError as error:
            raise UploadRefusedError(f"the request was incomplete after {silence:g} seconds") from error

    def _of(self, request: Request) -> StoredResult | None:
        return self.server.results.get(request.path_params["id"])

    def _wanted(self, request: Request) -> StoredResult:
        result = self._of(request)
        if result is None:
            raise UploadRefusedError("this result no longer exists")
        return result


class _Released(StreamingResponse):
    """A stream of events that gives its place back, however it ends."""

    def __init__(self, events: AsyncIterator[str], place: asyncio.Semaphore) -> None:
        super().__init__(events, media_type="text/event-stream")
        self._place = place

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer."""
        try:
            await super().__call__(scope, receive, send)
        finally:
            self._place.release()


def _started(result: StoredResult) -> Response:
    return JSONResponse({"id": result.id}, 201)


def _files(result: StoredResult) -> frozenset[str]:
    files = result.summary.get("files")
    return frozenset([*map(str, files), "outputs.zip"]) if isinstance(files, list) else frozenset()


def _regular(folder: Path, name: str) -> Path | None:
    """A file of a result: no link leads to it from elsewhere, and it is neither gone nor a FIFO."""
    file = (folder / name).resolve()
    return file if not folder.is_symlink() and file.is_relative_to(folder.resolve()) and file.is_file() else None


def _read(file: Path) -> str:
    data = read_bytes(file, file.name, limits.RESULT_FILE)
    return "" if isinstance(data, Finding) else data.decode("utf-8", "replace")


async def _read_json(request: Request) -> dict[str, object]:
    """The JSON object of a request. Raises UploadRefusedError."""
    data = bytearray()
    async for part in request.stream():
        data += part
        if len(data) > _LONGEST_BODY:
            raise UploadRefusedError("the request is too large")
    try:
        document = json.loads(data or b"{}")
    except (ValueError, RecursionError) as error:
        raise UploadRefusedError("not valid JSON") from error
    if not isinstance(document, dict):
        raise UploadRefusedError("not a JSON object")
    return document
