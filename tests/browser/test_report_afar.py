# SPDX-License-Identifier: Apache-2.0
"""Systems of any size on a desk and on a phone: what the first view shows can be read, and nothing of it lies on something else."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import pytest
from outputs.networks import fleet, node, pub, stack, sub

from rosward.network.connect import connect
from rosward.network.graph import Network

from .reports import click, drawn, opened, settle, shapes, written

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

pytestmark = pytest.mark.slow

DESK: Final = {"viewport": {"width": 1440, "height": 900}}
PHONE: Final = {
    "viewport": {"width": 390, "height": 844},
    "device_scale_factor": 2,
    "is_mobile": True,
    "has_touch": True,
}
LEAST: Final = 9.5
"""Pixels of a letter's height, as type is measured, that are read without effort."""

LABELS: Final = """() => {
    const cy = rosward.graph.library();
    const seen = cy.nodes().filter(one => one.data('label'));
    return {
        sizes: seen.map(one => [one.data('label'), one.numericStyle('font-size') * cy.zoom()]),
        boxes: seen.map(one => {
            const named = { includeNodes: false, includeOverlays: false };
            const box = one.boundingBox(named);
            const [x, y, a, b] = one.hasClass('frame')
                ? [(box.x1 + box.x2) / 2, (box.y1 + box.y2) / 2, box.w / 2 - 2, box.h / 2 - 2]
                : [one.position('x'), one.position('y'), one.outerWidth() / 2, one.outerHeight() / 2];
            return { label: one.data('label'), x1: x - a, x2: x + a, y1: y - b, y2: y + b };
        }),
        room: [cy.width(), cy.height()],
        whole: cy.elements().renderedBoundingBox(),
        places: cy.nodes('.shape').map(one => one.renderedPosition()),
    };
}"""


def crowd(count: int) -> Network:
    """Nodes without any order in one namespace."""
    nodes = [node(f"/one_of_the_many_{i}", pub(f"/t{i}"), sub(f"/t{(7 * i) % count}")) for i in range(count)]
    return connect("jazzy", nodes, [], files=count, lines=count, processes=count)


SYSTEMS: Final[dict[str, Callable[[], Network]]] = {
    "10 nodes": lambda: stack(10),
    "24 nodes": lambda: stack(24),
    "24 in one namespace": lambda: crowd(24),
    "190 nodes": lambda: stack(190),
    "660 nodes": lambda: fleet(110),
}


def overlaps(boxes: list[dict[str, Any]]) -> list[str]:
    return [
        f"{a['label']!r} on {b['label']!r}"
        for at, a in enumerate(boxes)
        for b in boxes[at + 1 :]
        if a["x1"] < b["x2"] and b["x1"] < a["x2"] and a["y1"] < b["y2"] and b["y1"] < a["y2"]
    ]


@pytest.mark.parametrize("device", [DESK, PHONE], ids=["desk", "phone"])
@pytest.mark.parametrize("system", list(SYSTEMS))
def test_the_first_view_can_be_read(browser: Browser, tmp_path: Path, system: str, device: dict[str, Any]) -> None:
    with opened(browser, written(tmp_path, SYSTEMS[system]()), **device) as page:
        found = page.evaluate(LABELS)
        assert found["sizes"]
        assert min(size for _, size in found["sizes"]) >= LEAST
        assert overlaps(found["boxes"]) == []
        width, height = found["room"]
        assert all(0 < at["x"] < width and 0 < at["y"] < height for at in found["places"]), "out of sight"


def test_a_click_opens_a_frame_so_that_it_can_be_read(browser: Browser, tmp_path: Path) -> None:
    with opened(browser, written(tmp_path, stack(190)), **PHONE) as page:
        before = len(shapes(page, "node.group"))
        click(page, "node.group[id = 'frame /control']")
        drawn(page)
        assert len(shapes(page, "node.group")) == before - 1
        assert page.evaluate("rosward.graph.library().zoom()") * 12 >= LEAST
        inside = (
            "rosward.graph.library().nodes('.node[parent = \"frame /control\"]').map(one => one.renderedPosition())"
        )
        assert any(0 < at["x"] < 390 and 0 < at["y"] < 600 for at in page.evaluate(inside))
        assert "/control/trajectory_follower" not in shapes(page, "node.group"), (
            "its inner frames are few: they are open"
        )


def test_from_afar_the_names_of_frames_keep_their_size(browser: Browser, tmp_path: Path) -> None:
    with opened(browser, written(tmp_path, stack(190)), **DESK) as page:
        page.get_by_role("button", name="Draw everything").click()
        drawn(page)
        settle(page)
        page.evaluate("rosward.graph.fit()")
        settle(page)
        zoom = page.evaluate("rosward.graph.library().zoom()")
        assert zoom < 0.5
        far = page.evaluate(
            "rosward.graph.library().nodes('.frame.far[label != \"\"]').map(one => [one.id(), one.numericStyle('font-size')])"
        )
        assert len(far) >= 5
        assert {round(size * zoom) for _, size in far} == {12}


def _bundles(page: Page) -> list[tuple[str, str]]:
    found: list[list[str]] = page.evaluate(
        "rosward.graph.library().edges().map(one => [one.source().data('label'), one.target().data('label')])"
    )
    return [(a, b) for a, b in found]


def test_what_goes_between_two_is_one_edge(browser: Browser, tmp_path: Path) -> None:
    """Also where it goes both ways; and what joins everyone with everyone is told in words."""
    both = [
        node("/a", *(pub(f"/x{i}") for i in range(9)), sub("/y")),
        node("/b", *(sub(f"/x{i}") for i in range(9)), pub("/y")),
    ]
    rest = [node(f"/c{i}", pub("/tf"), sub("/tf")) for i in range(8)]
    with opened(browser, written(tmp_path, connect("jazzy", [*both, *rest])), **PHONE) as page:
        page.locator("#detail").select_option("nodes")
        drawn(page)
        assert [set(pair) for pair in _bundles(page)] == [{"/a", "/b"}]
        assert "omitted: 1 that connects many nodes with many" in (page.locator("#legend").text_content() or "")
