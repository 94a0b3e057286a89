# SPDX-License-Identifier: Apache-2.0
"""What the tests ask a server, as its page would: with the cookie, and from the page's own origin."""

from __future__ import annotations

import asyncio
import contextlib
import io
import json
import time
import zipfile
from collections.abc import Callable, Collection, Iterator, Mapping
from pathlib import Path
from typing import Any, Final, final

from starlette.testclient import TestClient

from rosward.server.app import application
from rosward.server.job import Job, JobEnd, JobStep
from rosward.server.limits import Limits
from rosward.server.security import Access, Hosts
from rosward.server.server import Server
from rosward.server.workers import run_job

HANGING: Final = 300.0
"""So long is waited for what never comes."""

PORT: Final = 8765
ORIGIN: Final = f"http://127.0.0.1:{PORT}"
OWN_PAGE: Final = {"Origin": ORIGIN, "Sec-Fetch-Site": "same-origin"}
DEFAULT: Final = Limits()
TALKER: Final = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node("talker")
node.create_publisher(String, "chatter", 10)
rclpy.spin(node)
"""


async def status_of(app: Any, access: Access, method: str, address: str, drop: bytes = b"") -> int:
    """The status of a request of which `drop` comes again and again; of which no body comes where there is none."""
    found: list[int] = []
    headers = {
        "host": f"127.0.0.1:{PORT}",
        "cookie": f"{access.cookie}={access.token}",
        "content-type": "multipart/form-data; boundary=x",
        **{key.lower(): value for key, value in OWN_PAGE.items()},
    }
    scope = {
        "type": "http", "method": method, "path": address, "raw_path": address.encode(), "query_string": b"", "http_version": "1.1",
        "headers": [(key.encode(), value.encode()) for key, value in headers.items()],
    }  # fmt: skip

    async def receive() -> dict[str, object]:
        await (asyncio.sleep(0.01) if drop else asyncio.Event().wait())
        return {"type": "http.request", "body": drop, "more_body": True}

    async def send(message: dict[str, Any]) -> None:
        if message["type"] == "http.response.start":
            found.append(message["status"])

    await app(scope, receive, send)
    return found[0]


@final
class Page:
    """A page that is open in a browser."""

    def __init__(self, server: Server, client: TestClient, access: Access) -> None:
        self.server = server
        self.client = client
        self.access = access

    def post(self, address: str, body: object = None) -> Any:
        """Ask for something to be done; what is answered, which has to be a success."""
        answer = self.client.post(address, json=body, headers=OWN_PAGE)
        assert answer.status_code < 400, answer.text
        return answer.json()

    def refused(self, address: str, body: object = None) -> str:
        """The same, and the reason why it is refused."""
        answer = self.client.post(address, json=body, headers=OWN_PAGE)
        assert answer.status_code == 400, answer.text
        return str(answer.json()["error"])

    def send(self, files: Mapping[str, bytes], **fields: object) -> Any:
        """Upload files by their names; the answer."""
        parts = [("file", (name, data, "application/octet-stream")) for name, data in files.items()]
        fields_of_text = {name: json.dumps(value) for name, value in fields.items()}
        return self.client.post("/api/uploads", files=parts, data=fields_of_text, headers=OWN_PAGE)

    def results(self) -> list[dict[str, Any]]:
        """All results in short."""
        found: list[dict[str, Any]] = self.client.get("/api/results").json()
        return found

    def wait(self, identifier: str) -> dict[str, Any]:
        """A result once it has ended."""
        return self.wait_for(lambda: next((r for r in self.results() if r["id"] == identifier and _ended(r)), None))

    def wait_for(self, found: Callable[[], dict[str, Any] | None]) -> dict[str, Any]:
        """What is there after some time."""
        end = time.monotonic() + HANGING
        while time.monotonic() < end:
            result = found()
            if result is not None:
                return result
            time.sleep(0.02)
        raise AssertionError(f"nothing came: {self.results()}")

    def text(self, identifier: str, file: str) -> str:
        """One of the files of a result."""
        answer = self.client.get(f"/results/{identifier}/files/{file}")
        assert answer.status_code == 200
        return answer.text


def _ended(result: Mapping[str, Any]) -> bool:
    return result["state"] in {"done", "failed", "cancelled"}


async def those_that_end(
    asked: Collection[asyncio.Task[int]], number: int
) -> tuple[list[asyncio.Task[int]], list[asyncio.Task[int]]]:
    """So many that end, however long that takes, and with them whatever else has ended then; and those that have not."""
    waiting = set(asked)
    while len(asked) - len(waiting) < number:
        ended, waiting = await asyncio.wait(waiting, timeout=HANGING, return_when=asyncio.FIRST_COMPLETED)
        assert ended, "nothing came"
    for _ in range(100):
        await asyncio.sleep(0)
    return [task for task in asked if task.done()], [task for task in asked if not task.done()]


@contextlib.contextmanager
def opened(folder: Path, limits: Limits = DEFAULT, *, real: bool = False, names_paths: bool = True) -> Iterator[Page]:
    """A page that has opened the address with the token."""
    server = Server(folder, limits, names_paths=names_paths, run=run_job if real else not_really)
    access = Access(PORT)
    app = application(server, access, Hosts({"127.0.0.1", "localhost"}, PORT))
    with TestClient(app, base_url=ORIGIN, follow_redirects=False) as client:
        assert client.get(f"/?token={access.token}").status_code == 200
        yield Page(server, client, access)


async def not_really(job: Job, tell: Callable[[JobStep], None]) -> JobEnd:
    """An analysis that finds one node in anything."""
    tell(JobStep("reading", 0, 1))
    output = Path(job.output)
    (output / "policy.xml").write_text("<policy/>", encoding="utf-8")
    (output / "report.html").write_text("<p>report</p>", encoding="utf-8")
    (output / "outputs.zip").write_bytes(packed({"policy.xml": b"<policy/>"}))
    (output / "network.json").write_text("{}", encoding="utf-8")
    summary = {"nodes": 1, "complete": True, "files": ["policy.xml", "report.html", "network.json"]}
    (output / "summary.json").write_text(json.dumps(summary), encoding="utf-8")
    return JobEnd("done")


def packed(files: Mapping[str, bytes], method: int = zipfile.ZIP_DEFLATED) -> bytes:
    """A zip of these files."""
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", method) as archive:
        for name, content in files.items():
            archive.writestr(zipfile.ZipInfo(name), content, method)
    return data.getvalue()
