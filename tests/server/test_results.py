# SPDX-License-Identifier: Apache-2.0
"""The results: a bounded number, what can be had of each, and what a later server finds of them."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from rosward.server.limits import Limits

from .page import TALKER, Page, opened


def example(page: Page, name: str = "talker") -> str:
    identifier = str(page.post(f"/api/examples/{name}")["id"])
    page.wait(identifier)
    return identifier


def test_the_newest_comes_first(page: Page) -> None:
    made = [example(page) for _ in range(3)]
    assert [r["id"] for r in page.results()] == made[::-1]


def test_the_oldest_goes_when_there_are_too_many(tmp_path: Path) -> None:
    with opened(tmp_path, Limits(results=2)) as page:
        uploads = [page.send({"a.py": b""}).json()["id"] for _ in range(4)]
        page.wait(uploads[-1])
        assert [r["id"] for r in page.results()] == uploads[:1:-1]
        assert len(list((tmp_path / "results").iterdir())) == 2
        assert len(list((tmp_path / "sources").iterdir())) == 2


def test_a_removed_result_takes_its_upload_with_it(page: Page, tmp_path: Path) -> None:
    sent = page.send({"a.py": b""}).json()["id"]
    page.wait(sent)
    again = page.post(f"/api/results/{sent}/again")["id"]
    page.wait(again)
    page.post(f"/api/results/{sent}/delete")
    assert len(list((tmp_path / "results/sources").iterdir())) == 1, "another result is of it"
    page.post(f"/api/results/{again}/delete")
    assert list((tmp_path / "results/sources").iterdir()) == []
    assert page.client.get(f"/results/{sent}").status_code == 404
    assert "no longer exists" in page.refused(f"/api/results/{sent}/again", {})


def test_files_are_downloaded_or_looked_at_as_text(page: Page) -> None:
    result = example(page)
    saved = page.client.get(f"/results/{result}/files/policy.xml")
    assert saved.headers["content-disposition"] == 'attachment; filename="policy.xml"'
    assert saved.headers["content-type"] == "application/octet-stream"
    shown = page.client.get(f"/results/{result}/files/policy.xml?show")
    assert shown.headers["content-type"] == "text/plain; charset=utf-8"
    assert "sandbox" in shown.headers["content-security-policy"]
    packed = page.client.get(f"/results/{result}/files/outputs.zip")
    assert packed.headers["content-disposition"].startswith("attachment")


def test_only_the_outputs_are_served(page: Page) -> None:
    result = example(page)
    for path in (
        "summary.json",
        "../result.json",
        "%2e%2e/result.json",
        "..%2fresult.json",
        "%2e%2e%2fresult.json",
        "/etc/passwd",
        "//etc/passwd",
        "policy.xml/",
        "policy.xml%00",
        "",
    ):
        assert page.client.get(f"/results/{result}/files/{path}").status_code in {404, 307}, path


def test_a_link_among_the_outputs_is_not_followed(page: Page, tmp_path: Path) -> None:
    result = example(page)
    policy = tmp_path / "results/results" / result / "out/policy.xml"
    policy.unlink()
    policy.symlink_to("/etc/passwd")
    assert page.client.get(f"/results/{result}/files/policy.xml").status_code == 404


@pytest.mark.parametrize("identifier", ["x", "0123456789abcdef", "a%2fb", "0" * 1_000])
def test_a_result_that_is_not_there(page: Page, identifier: str) -> None:
    assert page.client.get(f"/results/{identifier}").status_code == 404
    assert page.client.get(f"/results/{identifier}/report").status_code == 404


def test_a_later_server_finds_them(tmp_path: Path) -> None:
    with opened(tmp_path) as page:
        kept = example(page)
    with opened(tmp_path) as page:
        assert [(r["id"], r["state"]) for r in page.results()] == [(kept, "done")]
        assert page.text(kept, "policy.xml") == "<policy/>"
        again = page.post(f"/api/results/{kept}/again")["id"]
        assert page.wait(again)["state"] == "done"


@pytest.mark.parametrize(
    "document",
    [
        "",
        "[]",
        "{}",
        "[" * 100_000,
        json.dumps({"source": {"kind": "upload", "key": "../../etc", "title": "x", "zipped": False}}),
    ],
)
def test_what_it_does_not_understand_is_left_alone(tmp_path: Path, document: str) -> None:
    foreign = tmp_path / "results/0123456789abcdef/result.json"
    foreign.parent.mkdir(parents=True)
    foreign.write_text(document, encoding="utf-8")
    (tmp_path / "results/notes.txt").write_text("mine", encoding="utf-8")
    with opened(tmp_path) as page:
        assert page.results() == []
    assert foreign.exists()


def test_an_upload_key_that_leads_elsewhere_is_not_read(tmp_path: Path) -> None:
    with opened(tmp_path) as page:
        kept = example(page)
    file = tmp_path / "results" / kept / "result.json"
    document = json.loads(file.read_text(encoding="utf-8"))
    document["source"]["key"] = "../../.."
    file.write_text(json.dumps(document), encoding="utf-8")
    with opened(tmp_path) as page:
        assert page.results() == []


def test_folders_are_for_this_user_alone(page: Page, tmp_path: Path) -> None:
    page.wait(page.send({"a.py": b""}).json()["id"])
    folders = [*(tmp_path / "results/results").iterdir(), *(tmp_path / "results/sources").iterdir()]
    parents = [tmp_path / "results/results", tmp_path / "results/sources"]
    assert {oct(f.stat().st_mode & 0o077) for f in parents} == {"0o0"}, folders


# Real analyses


def test_a_workspace_and_all_that_comes_of_it(real_page: Page, tmp_path: Path) -> None:
    (tmp_path / "ws").mkdir()
    (tmp_path / "ws/talker.py").write_text(TALKER, encoding="utf-8")
    asked = real_page.post("/api/workspaces", {"path": str(tmp_path / "ws")})
    result = real_page.wait(asked["id"])
    assert (result["state"], result["numbers"], result["complete"]) == ("done", ["1 node", "1 topic"], True)
    assert "<topic>/chatter</topic>" in real_page.text(result["id"], "policies/talker/policy.xml")
    assert "Complete: no errors" in real_page.text(result["id"], "findings.txt")
    assert "/chatter" in real_page.client.get(f"/results/{result['id']}/report").text
    shown = real_page.client.get(f"/results/{result['id']}").text
    assert f"/results/{result['id']}/files/policies/talker/policy.xml" in shown


def test_what_has_changed_since_the_result_before(real_page: Page, tmp_path: Path) -> None:
    program = tmp_path / "talker.py"
    program.write_text(TALKER, encoding="utf-8")
    first = real_page.wait(real_page.post("/api/workspaces", {"path": str(program)})["id"])
    program.write_text(TALKER.replace("chatter", "status"), encoding="utf-8")
    second = real_page.wait(real_page.post(f"/api/results/{first['id']}/again")["id"])
    changes = real_page.text(second["id"], "changes.txt")
    assert "+ /talker: publisher /status (std_msgs/msg/String)" in changes
    assert "- /talker: publisher /chatter (std_msgs/msg/String)" in changes
    assert "Changes since the previous result" in real_page.client.get(f"/results/{second['id']}").text


@pytest.mark.parametrize("path", ["", " ", "no/such/folder", "\0", "/dev/null", "a" * 5_000, 7, None])
def test_a_workspace_that_is_not_there_is_refused(page: Page, path: object) -> None:
    assert page.refused("/api/workspaces", {"path": path})


def test_a_folder_without_programs_says_so(real_page: Page, tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    result = real_page.wait(real_page.post("/api/workspaces", {"path": str(tmp_path / "empty")})["id"])
    assert (result["state"], result["message"]) == (
        "failed",
        "It contains no Python, C++ or launch files.",
    )


def test_names_of_others_stay_text(real_page: Page, tmp_path: Path) -> None:
    folder = tmp_path / "<script>alert(1)<b>"
    folder.mkdir()
    (folder / "talker.py").write_text(TALKER, encoding="utf-8")
    (folder / "<b>.launch.xml").write_text("<launch><arg name='&lt;i&gt;'/></launch>", encoding="utf-8")
    result = real_page.wait(real_page.post("/api/workspaces", {"path": str(folder)})["id"])
    assert result["state"] == "done"
    shown = real_page.client.get(f"/results/{result['id']}").text
    assert "<script>alert" not in shown
    assert "<b>" not in shown
    assert "&lt;script&gt;alert(1)" in shown
