# SPDX-License-Identifier: Apache-2.0
"""Five hundred nodes: the first view can be read, and everything is still within reach."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import pytest
from outputs.networks import fleet

from .reports import click, opened, settle, shapes, title, written

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def page(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Page]:
    with opened(browser, written(tmp_path_factory.mktemp("large"), fleet(83))) as page:
        yield page


def test_the_first_view_can_be_read(page: Page) -> None:
    """Namespaces are closed, so there is room for the letters."""
    assert len(shapes(page, "node.group")) == 83
    assert len(shapes(page)) < 120
    assert page.evaluate("rosward.graph.library().zoom()") > 0.5
    assert page.locator("#hint").is_visible()
    assert page.locator("#list a.node").count() == 500


def test_a_frame_is_opened_by_a_double_click(page: Page) -> None:
    click(page, "node.group[id = 'frame /robot7']", double=True)
    page.locator("#hint").wait_for(state="hidden")
    assert "lidar_driver" in shapes(page, "node.node")
    assert len(shapes(page, "node.group")) == 82


def test_search_leads_into_a_closed_frame(page: Page) -> None:
    page.locator("#search").fill("robot42/planner")
    settle(page)
    page.locator("#search").press("Enter")
    title(page).get_by_text("/robot42/planner").wait_for()
    assert shapes(page, "node.chosen") == ["planner"]
    page.locator("#search").fill("")


def test_all_of_it_can_be_drawn_without_overlaps(page: Page) -> None:
    page.evaluate("rosward.state.set({ collapsed: [] })")
    assert len(shapes(page, "node.node")) == 500
    assert len(shapes(page, "node.frame")) == 84
    frames = page.evaluate(
        """() => {
            const all = rosward.graph.library().nodes('.frame[name != "/robot*"]').toArray();
            const apart = (a, b, way, size) => Math.abs(a.position(way) - b.position(way)) >= (a[size]() + b[size]()) / 2;
            const meet = (a, b) => !apart(a, b, 'x', 'outerWidth') && !apart(a, b, 'y', 'outerHeight');
            return all.flatMap((a, at) => all.slice(at + 1).filter(b => meet(a, b))).length;
        }"""
    )
    assert frames == 0


def test_filters_make_it_small(page: Page) -> None:
    page.locator("#filter-namespace").select_option("/robot42")
    assert len(shapes(page, "node.node")) == 6
    page.get_by_role("button", name="Reset").click()
    page.get_by_label("Show").select_option("nodes")
    assert shapes(page) == shapes(page, "node.node")
