# SPDX-License-Identifier: Apache-2.0
"""Requests and folders of results that somebody made to break the server: each is refused or shown, and the server goes on."""

from __future__ import annotations

import asyncio
import json
import os
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from rosward.server.analysis import analyse
from rosward.server.app import application
from rosward.server.job import Job, JobEnd, JobStep
from rosward.server.jobs import Jobs
from rosward.server.limits import Limits
from rosward.server.results import ENDED, AnalysedSource, Results
from rosward.server.security import Access, Hosts
from rosward.server.server import Server
from rosward.server.settings import Settings

from .page import OWN_PAGE, PORT, TALKER, Page, opened, status_of, those_that_end

posix = pytest.mark.skipif(sys.platform != "linux", reason="names without encoding, and FIFOs")


@pytest.mark.parametrize("name", ["distro", "unknown", "enclaves", "tests", "flows", "launch", "arguments"])
@pytest.mark.parametrize("value", [[[]], [{}], {"a": []}, 1])
def test_settings_of_any_form_are_refused(name: str, value: object, page: Page, tmp_path: Path) -> None:
    page.refused("/api/workspaces", {"path": str(tmp_path), "settings": {name: value}})


@posix
def test_text_that_has_no_encoding_is_shown(page: Page, tmp_path: Path) -> None:
    folder = os.fsencode(tmp_path) + b"/ws\xff"
    os.mkdir(folder)  # noqa: PTH102
    settings = {"launch": ["a.launch.py"], "arguments": {"\udc80": "\ud800"}}
    body = json.dumps({"path": os.fsdecode(folder), "settings": settings})
    identifier = page.client.post("/api/workspaces", content=body, headers=OWN_PAGE).json()["id"]
    assert page.wait(identifier)["title"] == "ws\\udcff"
    assert page.client.get(f"/results/{identifier}").status_code == 200
    assert page.client.get(f"/results/{identifier}/files/outputs.zip").status_code == 200


def test_an_upload_that_stops_gives_its_place_to_the_next(tmp_path: Path) -> None:
    """Each is given up after a while."""

    async def story() -> list[int]:
        access = Access(PORT)
        app = application(Server(tmp_path, Limits(silence=0.2)), access, Hosts({"127.0.0.1"}, PORT))
        return await asyncio.wait_for(
            asyncio.gather(*(status_of(app, access, "POST", "/api/uploads") for _ in range(4))), 300
        )

    assert asyncio.run(story()) == [400] * 4


def test_streams_that_are_opened_at_once_are_counted(tmp_path: Path) -> None:
    async def story() -> list[int]:
        access = Access(PORT)
        server = Server(tmp_path, Limits(streams=5))
        app = application(server, access, Hosts({"127.0.0.1"}, PORT))
        asking = [asyncio.create_task(status_of(app, access, "GET", "/api/news")) for _ in range(50)]
        done, open_ = await those_that_end(asking, 45)
        assert len(open_) == 5
        server.news.close()
        ended = await asyncio.wait_for(asyncio.gather(*open_), 300)
        assert not server.streaming.locked()
        return [task.result() for task in done] + ended

    assert sorted(asyncio.run(story())) == [200] * 5 + [503] * 45


def test_an_analysis_that_cannot_be_started_has_failed(tmp_path: Path) -> None:
    async def run(_job: Job, _tell: Callable[[JobStep], None]) -> JobEnd:
        raise BlockingIOError(11, "Resource temporarily unavailable")

    async def story() -> str:
        results = Results(tmp_path, Limits(), lambda: None)
        jobs = Jobs(results, Limits(), run)
        identifier = jobs.submit(AnalysedSource("workspace", "/nowhere", "nowhere"), Settings()).id
        while results.all()[0].state not in ENDED:
            await asyncio.sleep(0.01)
        await jobs.close()
        found = results.get(identifier)
        assert found is not None
        assert found.state == "failed"
        return found.message

    assert asyncio.run(story()) == "The analysis cannot be started: Resource temporarily unavailable."


@pytest.fixture
def kept(tmp_path: Path) -> Path:
    """The folder of a result that an earlier server has kept."""
    with opened(tmp_path / "results") as page:
        page.wait(page.send({"talker.py": TALKER.encode()}).json()["id"])
    return next((tmp_path / "results/results").iterdir())


def change(file: Path, **fields: object) -> None:
    document = json.loads(file.read_text(encoding="utf-8"))
    file.write_text(json.dumps({**document, **fields}), encoding="utf-8")


@pytest.mark.parametrize("created", [float("nan"), float("inf")])
def test_a_kept_result_of_no_time_is_left_alone(created: float, kept: Path) -> None:
    change(kept / "result.json", created=created)
    with opened(kept.parent.parent) as page:
        assert page.results() == []


def test_kept_files_of_no_name_are_not_there(kept: Path) -> None:
    change(kept / "out/summary.json", files=[["policy.xml"], {}, None])
    with opened(kept.parent.parent) as page:
        assert page.client.get(f"/results/{kept.name}/files/policy.xml").status_code == 404


@posix
def test_what_never_ends_is_not_read(kept: Path) -> None:
    change(kept / "out/summary.json", changed=1)
    os.mkfifo(kept / "out/changes.txt")
    with opened(kept.parent.parent) as page:
        assert page.client.get(f"/results/{kept.name}").status_code == 200
    (kept / "result.json").unlink()
    os.mkfifo(kept / "result.json")
    with opened(kept.parent.parent) as page:
        assert page.results() == []


@posix
@pytest.mark.parametrize("name", ["report.html", "policy.xml"])
def test_no_link_and_no_fifo_of_a_kept_result_is_answered(name: str, kept: Path, tmp_path: Path) -> None:
    (tmp_path / "secret").write_text("secret", encoding="utf-8")
    address = f"/results/{kept.name}/{'report' if name == 'report.html' else f'files/{name}'}"
    for make in (lambda path: path.symlink_to(tmp_path / "secret"), os.mkfifo):
        (kept / "out" / name).unlink()
        make(kept / "out" / name)
        with opened(kept.parent.parent) as page:
            assert page.client.get(address).status_code == 404


def test_a_file_that_has_gone_is_not_there(kept: Path) -> None:
    (kept / "out/report.html").unlink()
    with opened(kept.parent.parent) as page:
        assert page.client.get(f"/results/{kept.name}/report").status_code == 404


def test_what_was_unpacked_by_half_goes_with_its_result(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """An analysis that is killed cannot tidy up; an upload that is analysed again and again must not fill the disk."""
    where: list[Path] = []

    def killed(_archive: Path, folder: Path, *_: object) -> None:
        where.append(folder)
        raise KeyboardInterrupt

    monkeypatch.setattr("rosward.server.analysis.unpack", killed)
    output, upload = tmp_path / "result/out", tmp_path / "source"
    output.mkdir(parents=True)
    upload.mkdir()
    notes = str(upload / "left_out.json")
    with pytest.raises(KeyboardInterrupt):
        analyse(Job(str(upload / "tree"), str(output), archive="x.zip", notes=notes), lambda *_: None)  # type: ignore[arg-type]
    assert [folder.parent for folder in where] == [output]


def test_a_format_that_fails_is_told_in_what_the_page_shows(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def failing(*_: object, **__: object) -> str:
        raise RuntimeError("no")

    tree, output = tmp_path / "tree", tmp_path / "out"
    tree.mkdir()
    output.mkdir()
    (tree / "talker.py").write_text("import rclpy\nrclpy.init()\nrclpy.create_node('talker')\n")
    monkeypatch.setattr("rosward.outputs.graphs.dot.graph_dot", failing)
    analyse(Job(str(tree), str(output)), lambda *_: None)  # type: ignore[arg-type]
    assert not (output / "graph.dot").exists()
    assert "RW299" in (output / "findings.txt").read_text()
    assert json.loads((output / "summary.json").read_text())["complete"] is False
