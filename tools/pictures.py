# SPDX-License-Identifier: Apache-2.0
"""Take the pictures of the documentation again: the report of the example's fleet, and the pages of `rosward serve`.

    pip install -e '.[browser,serve]' && python tools/pictures.py

They go to docs/img. CHROMIUM names another browser.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Final

from playwright.sync_api import Browser, Page, sync_playwright

ROOT: Final = Path(__file__).parents[1]
PICTURES: Final = ROOT / "docs" / "img"
_FLEET: Final = ("--launch", "delivery_bringup:fleet.launch.py")
_ROBOT: Final = ("--launch", "delivery_bringup:robot.launch.py", "--arg", "robot:=porter", "--flows")


def _report(folder: Path, *options: str) -> str:
    command = [sys.executable, "-m", "rosward", "extract", str(ROOT / "examples"), *options, "-o", str(folder), "-q"]
    subprocess.run(command, check=True)
    return (folder / "report.html").as_uri()


def _opened(browser: Browser, address: str, height: int = 900, width: int = 1400) -> Page:
    page = browser.new_context(viewport={"width": width, "height": height}).new_page()
    page.goto(address)
    page.wait_for_load_state()
    return page


def _drawn(page: Page) -> None:
    page.wait_for_function("() => rosward.graph?.library()?.nodes().length && !document.querySelector('[aria-busy]')")
    page.wait_for_timeout(800)


def _of_report(browser: Browser, folder: Path) -> None:
    address = _report(folder, *_FLEET)
    page = _opened(browser, address)
    _drawn(page)
    page.screenshot(path=PICTURES / "report-overview.png")
    page = _opened(browser, address + "#n/porter1/delivery_planner")
    _drawn(page)
    page.locator("#panel").get_by_role("button", name="Focus").click()
    page.locator(".focus-line").wait_for()
    call = page.locator("#panel details.entity", has_text="/building/doors/open")
    call.locator("summary").first.click()
    _drawn(page)
    page.locator("#panel h3", has_text="Subscribes to").evaluate("h => h.scrollIntoView()")
    page.wait_for_timeout(300)
    page.screenshot(path=PICTURES / "report-graph.png")


def _of_flows(browser: Browser, folder: Path) -> None:
    page = _opened(browser, _report(folder, *_ROBOT))
    _drawn(page)
    page.evaluate("rosward.state.set({ detail: 'all' })")
    _drawn(page)
    page.evaluate("location.hash = '#n/porter/delivery_planner'")
    page.locator("#panel .made-of").evaluate("section => section.scrollIntoView()")
    page.locator("#panel .made-of summary .at").last.click()
    page.wait_for_timeout(800)
    page.screenshot(path=PICTURES / "report-flows.png")


def _of_server(browser: Browser, folder: Path) -> None:
    command = [sys.executable, "-u", "-m", "rosward", "serve"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, cwd=folder) as server:
        assert server.stdout is not None
        try:
            address = next(m[0] for line in server.stdout if (m := re.search(r"http://\S+", line)))
            page = _opened(browser, address, 1160, 1280)
            page.wait_for_timeout(800)
            page.screenshot(path=PICTURES / "serve-start.png")
            page.set_viewport_size({"width": 1280, "height": 860})
            page.get_by_text("Two robots from one launch file").click()
            report = page.frame_locator("iframe")
            report.locator("#facts", has_text="nodes").wait_for()
            page.wait_for_timeout(4000)
            page.screenshot(path=PICTURES / "serve-result.png")
        finally:
            server.terminate()


def main() -> int:
    """Take them all."""
    program = os.environ.get("CHROMIUM") or shutil.which("chromium") or shutil.which("chromium-browser")
    with tempfile.TemporaryDirectory() as place, sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=program, args=["--headless", "--no-sandbox", "--disable-gpu"]
        )
        _of_report(browser, Path(place) / "report")
        _of_flows(browser, Path(place) / "flows")
        _of_server(browser, Path(place))
        browser.close()
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
