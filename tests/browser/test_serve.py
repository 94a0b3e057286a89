# SPDX-License-Identifier: Apache-2.0
"""The page of `rosward serve` as somebody uses it: an example, an upload, a download, a workspace that changes; by mouse and by keys.

Whatever happens: no error on the console, and no request to anybody but the server.
"""

from __future__ import annotations

import io
import os
import re
import signal
import subprocess
import sys
import zipfile
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Final
from urllib.parse import urlsplit

import pytest

from .conftest import lacking

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

pytestmark = pytest.mark.slow

TALKER: Final = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node("talker")
node.create_publisher(String, "chatter", 10)
rclpy.spin(node)
"""
NEEDED: Final = ("starlette", "uvicorn", "python_multipart", "watchfiles")
SECONDS: Final = 300_000


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The address that a server has printed."""
    missing = [name for name in NEEDED if find_spec(name) is None]
    if missing:
        lacking("serve", f"no {', '.join(missing)}")
    folder = tmp_path_factory.mktemp("server")
    process = subprocess.Popen(
        [sys.executable, "-m", "rosward", "serve", "--port", "0"],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        env={**os.environ, "TMPDIR": str(folder)},
        cwd=folder,
    )
    assert process.stdout is not None
    found = next(m for line in process.stdout if (m := re.search(r"http://\S+", line)))
    yield found[0]
    process.send_signal(signal.SIGINT)
    rest = process.stdout.read()
    assert (process.wait(15), "Traceback" in rest) == (0, False)
    process.stdout.close()


@pytest.fixture
def page(browser: Browser, address: str) -> Iterator[Page]:
    """The start page, opened with the token; behind the test, nothing went wrong on it, and nobody else was asked."""
    context = browser.new_context(viewport={"width": 1280, "height": 800}, accept_downloads=True)
    opened = context.new_page()
    opened.set_default_timeout(SECONDS)
    trouble: list[str] = []
    asked: set[str] = set()
    opened.on("console", lambda said: trouble.append(said.text) if said.type in {"error", "warning"} else None)
    opened.on("pageerror", lambda error: trouble.append(str(error)))
    context.on("request", lambda request: asked.add(urlsplit(request.url).netloc))
    opened.goto(address)
    yield opened
    context.close()
    assert trouble == []
    assert asked - {""} == {urlsplit(address).netloc}


def report_of(page: Page) -> str:
    """What the report says once it is drawn."""
    frame = page.frame_locator("iframe")
    frame.locator("body").get_by_text("/talker").first.wait_for()
    return frame.locator("body").inner_text()


def open_tab(page: Page, name: str) -> None:
    """Click a tab, as soon as the page's script listens: that is when one of them is selected."""
    page.locator("[role=tab][aria-selected=true]").wait_for()
    page.get_by_role("tab", name=name).click()


def test_the_token_is_gone_from_the_address(page: Page, address: str) -> None:
    assert page.url == address.partition("?")[0]
    page.reload()
    assert page.locator("h1").inner_text().startswith("Which nodes")


def test_an_example_in_one_click(page: Page) -> None:
    page.locator("[data-example=talker]").click()
    page.wait_for_url("**/results/*")
    page.get_by_role("tab", name="Report").wait_for()
    assert "/listener" in report_of(page)
    open_tab(page, "Program")
    assert "class Talker(Node):" in page.locator("#program").inner_text()


def test_flows_are_shown_where_they_are_asked_for(page: Page) -> None:
    page.locator("[data-example=talker]").click()
    page.wait_for_url("**/results/*")
    first = page.url
    report_of(page)
    assert page.frame_locator("iframe").locator("#flow").count() == 0
    open_tab(page, "Options")
    page.get_by_label("Show what flows where").check()
    page.get_by_role("button", name="Analyse again").click()
    page.wait_for_url(lambda url: url != first)
    report_of(page)
    frame = page.frame_locator("iframe")
    frame.locator("#list a.node", has_text="/talker").click()
    frame.locator("#panel .made-of summary", has_text="/chatter").wait_for()
    open_tab(page, "Options")
    assert page.get_by_label("Show what flows where").is_checked()


def test_progress_is_told_while_it_lasts(page: Page) -> None:
    """The server says something of each step; the page shows it and then the report, without being asked."""
    with page.expect_response("**/api/news"):
        page.locator("[data-example=robots]").click()
    page.get_by_role("tab", name="Report").wait_for()
    page.goto(page.url.partition("/results")[0])
    page.locator("#results").get_by_text("3 nodes").first.wait_for()


def zipped() -> bytes:
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as archive:
        archive.writestr("ws/src/talker.py", TALKER)
    return data.getvalue()


def test_a_zip_is_uploaded_and_its_policy_downloaded(page: Page, tmp_path: Path) -> None:
    page.set_input_files("#pick-files", {"name": "ws.zip", "mimeType": "application/zip", "buffer": zipped()})
    page.wait_for_url("**/results/*")
    open_tab(page, "Downloads")
    page.get_by_role("button", name="View the policy of /talker").click()
    page.locator("#look pre").get_by_text("<topic>/chatter</topic>").wait_for()
    with page.expect_download() as coming:
        page.get_by_role("link", name="Download the policy of /talker").click()
    coming.value.save_as(tmp_path / "policy.xml")
    assert coming.value.suggested_filename == "policy.xml"
    assert "<topic>/chatter</topic>" in (tmp_path / "policy.xml").read_text(encoding="utf-8")
    with page.expect_download() as coming:
        page.get_by_role("link", name="Download all").click()
    coming.value.save_as(tmp_path / "all.zip")
    names = zipfile.ZipFile(tmp_path / "all.zip").namelist()
    assert {"rosward-out/policy.xml", "rosward-out/report.html", "rosward-out/policies/talker/policy.xml"} <= set(names)


def test_a_folder_is_uploaded_without_what_is_no_source(page: Page, tmp_path: Path) -> None:
    for name, text in {
        "src/talker.py": TALKER,
        "src/arm.stl": "solid",
        ".git/config": "x",
        "build/talker.py": "x",
    }.items():
        (tmp_path / "ws" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "ws" / name).write_text(text, encoding="utf-8")
    page.set_input_files("#pick-folder", tmp_path / "ws")
    page.wait_for_url("**/results/*")
    page.get_by_text("1 file was not taken from the upload").wait_for()
    assert "1 node" in report_of(page).replace("\n", " ")


def test_a_dropped_file_is_taken(page: Page) -> None:
    page.evaluate(
        """text => {
            const held = new DataTransfer();
            held.items.add(new File([text], "talker.py"));
            dispatchEvent(new DragEvent("drop", { dataTransfer: held, bubbles: true, cancelable: true }));
        }""",
        TALKER,
    )
    page.wait_for_url("**/results/*")
    assert "/chatter" in report_of(page)


def test_a_workspace_that_changes_shows_its_new_result_by_itself(page: Page, tmp_path: Path) -> None:
    program = tmp_path / "talker.py"
    program.write_text(TALKER, encoding="utf-8")
    page.get_by_label("or open a folder on this machine").fill(str(tmp_path))
    page.keyboard.press("Enter")
    page.wait_for_url("**/results/*")
    assert "/chatter" in report_of(page)
    first = page.url
    assert page.get_by_label("Watch").is_checked()
    program.write_text(TALKER.replace("chatter", "status"), encoding="utf-8")
    page.wait_for_url(lambda url: url != first)
    assert "/status" in report_of(page)
    open_tab(page, "Changes")
    assert "- /talker: publisher /chatter" in page.locator("#changes pre").inner_text()


def test_a_launch_argument_is_changed(page: Page) -> None:
    page.locator("[data-example=robots]").click()
    open_tab(page, "Options")
    page.locator("[data-argument=robots]").fill("left,right,spare")
    first = page.url.partition("#")[0]
    page.get_by_role("button", name="Analyse again").click()
    page.wait_for_url(lambda url: not url.startswith(first))
    open_tab(page, "As text")
    page.locator("#findings-text").get_by_text("4 nodes").wait_for()


def test_what_went_wrong_is_told(page: Page) -> None:
    """An expected refusal is an answer of status 400, which a browser notes on its console: so a zip that is refused later is taken."""
    page.set_input_files("#pick-files", {"name": "ws.zip", "mimeType": "application/zip", "buffer": b"no zip"})
    page.get_by_text("not a readable zip file").wait_for()
    assert page.get_by_role("heading", name="No result").is_visible()


def test_everything_is_reached_by_keys(page: Page) -> None:
    names: list[str] = []
    for _ in range(16):
        page.keyboard.press("Tab")
        names.append(
            page.evaluate(
                "() => { const it = document.activeElement; return it.id || it.dataset.example || it.textContent }"
            )
        )
    assert {"pick-folder", "pick-files", "path", "watch", "Options", "talker", "robots"} <= set(names)
    page.locator("[data-example=talker]").press("Enter")
    page.get_by_role("tab", name="Report").wait_for()
    page.locator("[role=tab][aria-selected=true]").wait_for()
    page.get_by_role("tab", name="Report").press("ArrowRight")
    assert page.locator("#downloads").is_visible()
    assert page.evaluate("document.activeElement.id") == "tab-downloads"


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_text_stands_out_in_light_and_dark(page: Page, scheme: str) -> None:
    page.emulate_media(color_scheme="dark" if scheme == "dark" else "light")
    ink, paper = page.evaluate(
        "[getComputedStyle(document.body).color, getComputedStyle(document.body).backgroundColor]"
        ".map(c => c.match(/\\d+/g).slice(0, 3).reduce((sum, n) => sum + Number(n), 0))"
    )
    assert abs(ink - paper) > 400
    assert (paper < ink) is (scheme == "dark")


def test_it_fits_a_narrow_window(page: Page) -> None:
    page.set_viewport_size({"width": 380, "height": 700})
    assert page.evaluate("document.documentElement.scrollWidth") <= 380
