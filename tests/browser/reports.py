# SPDX-License-Identifier: Apache-2.0
"""Reports in files, and pages that show them: behind each test, no error was told and nothing was asked of anybody."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from rosward.network.graph import Network
from rosward.outputs.background import Background
from rosward.outputs.report.page import report_html

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Locator, Page, Request, Route

NOTHING: Final = Background()
OWN: Final = ("file:", "blob:", "data:")
SECONDS: Final = 300_000


def written(folder: Path, network: Network, background: Background = NOTHING) -> str:
    """The address of a report in a file."""
    file = folder / "report.html"
    file.write_text(report_html(network, background), encoding="utf-8")
    return file.as_uri()


@contextmanager
def opened(browser: Browser, address: str, **options: Any) -> Iterator[Page]:
    """A page with the report, drawn; `options` are those of a browser context."""
    context = browser.new_context(**{"viewport": {"width": 1400, "height": 900}, "offline": True, **options})
    context.set_default_timeout(SECONDS)
    trouble: list[str] = []
    page = context.new_page()

    def refuse(route: Route, request: Request) -> None:
        if request.url.startswith(OWN):
            route.continue_()
        else:
            trouble.append(f"asked for {request.url}")
            route.abort()

    context.route("**/*", refuse)
    page.on("console", lambda said: trouble.append(f"{said.type}: {said.text}"))
    page.on("pageerror", lambda error: trouble.append(str(error)))
    page.on("dialog", lambda dialog: trouble.append(f"dialog: {dialog.message}"))
    page.goto(address)
    drawn(page)
    yield page
    context.close()
    assert trouble == []


def renewed(page: Page) -> None:
    """The page as it was when it was opened; much faster than to open it again."""
    page.emulate_media(media="screen")
    page.evaluate(
        """() => {
            location.hash = '#graph';
            document.activeElement.blur();
            document.querySelector('dialog').close();
            rosward.state.set(rosward.state.DEFAULTS);
        }"""
    )
    page.locator("#panel").wait_for(state="hidden")
    page.locator("#search").fill("")
    settle(page)
    page.locator("#canvas").evaluate("one => { document.activeElement.blur(); }")
    drawn(page)


def settle(page: Page) -> None:
    """Waits for the events that are on their way: a change of the address, of the media, of the search."""
    page.evaluate("new Promise(done => setTimeout(() => requestAnimationFrame(() => requestAnimationFrame(done)), 30))")


def drawn(page: Page) -> None:
    """Waits until the layout is done."""
    page.locator("#graph:not([aria-busy])").wait_for(state="attached")


def shapes(page: Page, selector: str = "node.shape") -> list[str]:
    """The labels of what is drawn."""
    drawn(page)
    found: list[str] = page.evaluate(
        "selector => rosward.graph.library().elements(selector).map(one => one.data('name') ?? one.data('label'))",
        selector,
    )
    return sorted(found)


def chosen(page: Page) -> list[str]:
    """The labels of the shapes that the drawing marks."""
    return shapes(page, "node.chosen")


def click(page: Page, selector: str, *, double: bool = False) -> None:
    """A click of the mouse on what is drawn: on the middle of a shape or an edge."""
    drawn(page)
    x, y = page.evaluate(
        """selector => {
            const cy = rosward.graph.library();
            const one = cy.elements(selector)[0];
            cy.stop();
            cy.zoom(1);
            const at = () => one.isNode() ? one.renderedPosition() : one.renderedMidpoint();
            cy.panBy({ x: cy.width() / 2 - at().x, y: cy.height() / 2 - at().y });
            const box = cy.container().getBoundingClientRect();
            return [box.x + at().x, box.y + at().y];
        }""",
        selector,
    )
    page.mouse.move(x - 3, y)
    page.mouse.move(x, y)
    if double:
        page.mouse.dblclick(x, y)
    else:
        page.mouse.click(x, y)


def fragment(page: Page) -> str:
    """What stands behind `#` in the address."""
    found: str = page.evaluate("location.hash")
    return found


def title(page: Page) -> Locator:
    """The heading of the panel."""
    return page.locator("#panel h2")
