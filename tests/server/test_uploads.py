# SPDX-License-Identifier: Apache-2.0
"""What is uploaded: files with their paths, or one zip; within bounds, and nowhere but in its folder."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Final

import pytest

from rosward.outputs.report.packed import document_in
from rosward.server.limits import Limits

from .page import OWN_PAGE, TALKER, Page, opened, packed


def kept(page: Page, tmp_path: Path) -> dict[str, bytes]:
    """All uploads that the server has, by their paths below the folders of uploads."""
    folder = tmp_path / "results/sources"
    files = (p for p in folder.rglob("*") if p.is_file() and p.name not in {".git", "left_out.json"})
    del page
    return {p.relative_to(folder).as_posix().partition("/")[2]: p.read_bytes() for p in files}


def refused(page: Page, tmp_path: Path, files: dict[str, bytes], **fields: object) -> str:
    """The upload is refused, and nothing is left of it."""
    answer = page.send(files, **fields)
    assert answer.status_code == 400, answer.text
    assert page.results() == []
    assert list((tmp_path / "results/sources").iterdir()) == []
    return str(answer.json()["error"])


def test_files_keep_their_folders(page: Page, tmp_path: Path) -> None:
    answer = page.send({"ws/src/talker.py": b"a", "ws/config/a.yaml": b"b"}, settings={"distro": "humble"})
    assert answer.status_code == 201
    result = page.wait(answer.json()["id"])
    assert (result["title"], result["kind"], result["settings"]) == ("ws", "upload", "humble")
    assert kept(page, tmp_path) == {"tree/ws/src/talker.py": b"a", "tree/ws/config/a.yaml": b"b"}


def test_several_files_without_a_folder(page: Page) -> None:
    assert page.wait(page.send({"a.py": b"", "b.py": b""}).json()["id"])["title"] == "2 files"


def test_a_zip_is_kept_for_the_process_that_analyses(page: Page, tmp_path: Path) -> None:
    data = packed({"a.py": b""})
    assert page.wait(page.send({"ws.zip": data}).json()["id"])["title"] == "ws.zip"
    assert kept(page, tmp_path) == {"upload.zip": data}


@pytest.mark.parametrize(
    "name", ["../evil.py", "/tmp/evil.py", "a/../../evil.py", "a\\evil.py", "../ws.zip", "a" * 300]
)
def test_a_name_that_leads_outside_is_refused(page: Page, tmp_path: Path, name: str) -> None:
    refused(page, tmp_path, {"good.py": b"", name: b"evil"})


def test_two_names_for_one_place_are_refused(page: Page, tmp_path: Path) -> None:
    assert "identical names" in refused(page, tmp_path, {"demo/a.py": b"", "Demo/a.py": b""})


def test_nothing_is_refused(page: Page, tmp_path: Path) -> None:
    assert "no file" in refused(page, tmp_path, {})


def test_a_zip_comes_alone(page: Page, tmp_path: Path) -> None:
    assert "on its own" in refused(page, tmp_path, {"a.zip": packed({"a.py": b""}), "b.py": b""})


def test_what_is_no_source_is_left_out_and_told(real_page: Page) -> None:
    files = {"ws/talker.py": TALKER.encode(), "ws/arm.stl": b"solid", "ws/.git/config": b"[core]"}
    done = real_page.wait(real_page.send(files, left_out=["ws/photo.jpg"]).json()["id"])
    assert done["state"] == "done"
    shown = real_page.client.get(f"/results/{done['id']}").text
    assert "3 files were not taken" in shown
    assert all(name in shown for name in ("ws/arm.stl", "ws/.git/config", "ws/photo.jpg"))


def test_settings_of_another_form_are_refused(page: Page, tmp_path: Path) -> None:
    wrong: tuple[object, ...] = (
        {"distro": "noetic"},
        {"paths": "/etc"},
        {"launch": ["../x.launch.py"]},
        {"launch": ["/x.py"]},
        [],
        "x",
    )
    for settings in wrong:
        refused(page, tmp_path, {"a.py": b""}, settings=settings)


def test_too_much_is_refused_before_and_while_it_comes(tmp_path: Path) -> None:
    with opened(tmp_path / "results", Limits(upload=10_000)) as page:
        assert "MB" in refused(page, tmp_path, {"a.py": bytes(20_000)})

        def trickle() -> Iterator[bytes]:
            yield from (bytes(1_000) for _ in range(20))

        headers = {**OWN_PAGE, "Content-Type": "multipart/form-data; boundary=x"}
        answer = page.client.post("/api/uploads", content=trickle(), headers=headers)
        assert answer.status_code == 400
        assert list((tmp_path / "results/sources").iterdir()) == []


def test_a_file_that_is_too_large_is_left_out(tmp_path: Path) -> None:
    with opened(tmp_path / "results", Limits(file=100)) as page:
        assert page.send({"a.py": b"", "b.py": bytes(200)}).status_code == 201
        assert kept(page, tmp_path) == {"tree/a.py": b""}


def test_too_many_files_are_refused(tmp_path: Path) -> None:
    with opened(tmp_path / "results", Limits(files=3)) as page:
        refused(page, tmp_path, {f"{n}.py": b"" for n in range(4)})


@pytest.mark.parametrize("body", [b"", b"--x", b"--x\r\nContent-Disposition: form-data\r\n\r\n", b"\0" * 100])
def test_a_form_that_is_broken_is_refused(page: Page, body: bytes) -> None:
    headers = {**OWN_PAGE, "Content-Type": "multipart/form-data; boundary=x"}
    assert page.client.post("/api/uploads", content=body, headers=headers).status_code == 400


def test_a_zip_that_is_hostile_ends_in_a_result_that_says_why(real_page: Page, tmp_path: Path) -> None:
    sent = real_page.send({"ws.zip": packed({"../evil.py": b"x", "a.py": b""})})
    result = real_page.wait(sent.json()["id"])
    assert result["state"] == "failed"
    assert "leaves the folder" in result["message"]
    assert "leaves the folder" in real_page.client.get(f"/results/{result['id']}").text
    assert not list(tmp_path.rglob("evil.py"))


def test_a_zip_is_analysed_and_again_with_other_settings(real_page: Page) -> None:
    first = real_page.wait(real_page.send({"ws.zip": packed({"ws/talker.py": TALKER.encode()})}).json()["id"])
    assert (first["state"], first["numbers"]) == ("done", ["1 node", "1 topic"])
    again = real_page.post(f"/api/results/{first['id']}/again", {"settings": {"distro": "humble"}})
    assert real_page.wait(again["id"])["settings"] == "humble"
    assert json.loads(real_page.text(again["id"], "network.json"))["distro"] == "humble"


RELAY: Final = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node("relay")
out = node.create_publisher(String, "out", 10)
node.create_subscription(String, "in", lambda message: out.publish(message), 10)
rclpy.spin(node)
"""


def test_flows_are_in_the_report_of_who_asks_for_them(real_page: Page) -> None:
    first = real_page.wait(real_page.send({"ws.zip": packed({"ws/relay.py": RELAY.encode()})}).json()["id"])
    assert "flows" not in json.loads(document_in(real_page.text(first["id"], "report.html")))
    again = real_page.post(f"/api/results/{first['id']}/again", {"settings": {"flows": True}})
    assert real_page.wait(again["id"])["settings"] == "jazzy, with flows"
    (node,) = json.loads(document_in(real_page.text(again["id"], "report.html")))["flows"]["nodes"]
    assert [len(output["sources"]) for output in node["outputs"]] == [1]
    (node,) = json.loads(real_page.text(again["id"], "flow.json"))["nodes"]
    assert node["sinks"][0]["data"] == ["topic:/in"]


def test_uploaded_programs_are_never_run(real_page: Page, tmp_path: Path) -> None:
    mark = tmp_path / "was_run"
    hostile = f"open({str(mark)!r}, 'w')\n"
    names = [
        "setup.py",
        "sitecustomize.py",
        "rosward.py",
        "jinja2.py",
        "a.launch.py",
        "conftest.py",
        "encodings/__init__.py",
    ]
    files = {"ws/talker.py": TALKER.encode(), **{f"ws/{name}": (hostile + TALKER).encode() for name in names}}
    assert real_page.wait(real_page.send(files).json()["id"])["state"] == "done"
    assert not mark.exists()
