# SPDX-License-Identifier: Apache-2.0
"""How long does a person wait for the report in a browser? One line for each system.

    pip install -e '.[browser]' && python bench/report_browser.py [REPORT.html...]

Milliseconds from the start of the page, the median of five: until it answers (`page`), until a graph is drawn (`picture`), and until the graph stands
where it stays (`settled`). `blank` is a page with the same libraries and no node, in the same run: the part that is the browser's and theirs. Without
a REPORT they are those of made-up systems of 50, 500 and 3,000 nodes (the fleet of the tests).
CHROMIUM names another browser.
"""

from __future__ import annotations

import argparse
import os
import statistics
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from playwright.sync_api import Browser, sync_playwright

from rosward.network.connect import connect
from rosward.network.graph import Network
from rosward.outputs.background import Background
from rosward.outputs.report.page import report_html

ROOT: Final = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "tests"))

from outputs.networks import fleet  # noqa: E402

_RUNS: Final = 5
_MARKS: Final = ("page", "picture", "settled")
_LOOK: Final = """
  window.marks = {};
  const look = () => {
    if (typeof rosward === "object" && document.readyState === "complete" && rosward.graph?.library()) {
      marks.page ??= performance.now();
      if (rosward.graph.library().nodes().length || !rosward.model.nodes.size) marks.picture ??= performance.now();
      if (!document.querySelector("[aria-busy]")) marks.settled ??= performance.now();
    }
    if (!marks.settled) requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
"""


def main() -> int:
    """Print the table."""
    parser = argparse.ArgumentParser(description="Milliseconds until the report is there.")
    parser.add_argument("reports", nargs="*", type=Path, metavar="REPORT.html")
    wanted = parser.parse_args().reports
    print(f"{'report':<32} {'page':>8} {'picture':>8} {'settled':>8}")
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        options = ["--headless", "--no-sandbox", "--disable-gpu"]
        browser = playwright.chromium.launch(
            executable_path=os.environ.get("CHROMIUM", "/usr/bin/chromium"), args=options
        )
        for name, file in [*_made(Path(folder)), *((f.stem, f) for f in wanted)]:
            runs = [_run(browser, file) for _ in range(_RUNS)]
            print(f"{name:<32}", *(f"{statistics.median(r[mark] for r in runs):8.0f}" for mark in _MARKS))
        browser.close()
    return 0


def _made(folder: Path) -> Iterator[tuple[str, Path]]:
    systems: list[tuple[str, Network]] = [("blank", connect("jazzy", ()))]
    systems += [(f"fleet of {robots} robots", fleet(robots)) for robots in (8, 83, 500)]
    for name, network in systems:
        file = folder / f"{name}.html"
        file.write_text(report_html(network, Background()), encoding="utf-8")
        yield f"{name}, {len(network.nodes)} nodes", file


def _run(browser: Browser, file: Path) -> dict[str, float]:
    page = browser.new_context(viewport={"width": 1400, "height": 900}, offline=True, bypass_csp=True).new_page()
    page.add_init_script(_LOOK)
    page.goto(file.absolute().as_uri())
    page.wait_for_function("() => marks.settled", polling=50, timeout=60_000)
    found: dict[str, float] = page.evaluate("marks")
    page.context.close()
    return found


if __name__ == "__main__":
    raise SystemExit(main())
