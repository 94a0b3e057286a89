# SPDX-License-Identifier: Apache-2.0
"""Names that others wrote, in a real browser: whatever they hold, they are text, and nothing of them runs or is asked for."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Final

import pytest
from outputs.networks import entity, node, pub, sub, talker_and_listener

from rosward.findings import Finding
from rosward.location import Place
from rosward.network.connect import connect
from rosward.ros.entities import EntityKind, Parameter

from .reports import click, opened, settle, shapes, title, written

if TYPE_CHECKING:
    from playwright.sync_api import Browser

pytestmark = pytest.mark.slow

NASTY: Final = (
    "<img src=x onerror=alert(1)>",
    "</script><script>alert(2)</script>",
    "<!--<script>",
    "\"'`;alert(3)//",
    "javascript:alert(4)",
    "${alert(5)} {{7*7}} %s",
    "a\u202eb\u2066c\u200fd",
    "\u0000\u001b[31m\u2028",
    "constructor",
    "__proto__",
    "data(label)",
    "x" * 3000,
)


def test_hostile_names_are_inert(browser: Browser, tmp_path: Path) -> None:
    made = [
        node(
            f"/{text}/{text}",
            pub(f"/{text}", text, callback=text, reasons=(text,)),
            sub(f"/{text}", text),
            entity(EntityKind.SERVICE_SERVER, f"/{text}/service", text, created_at=(Place(text, 3),)),
            parameters=(Parameter(text, "string", text, text, Place(text, 1)),),
            package=text,
            executable=text,
            process=text,
            defined_at=Place(text, 1),
        )
        for text in NASTY
    ]
    findings = [Finding("RW101", f"publisher of node /{text}/{text}: {text}", Place(text, 1)) for text in NASTY]
    network = connect("jazzy", made, findings, files=1, lines=1, processes=len(made))
    with opened(browser, written(tmp_path, network)) as page:
        assert len(shapes(page, "node.node")) == len(NASTY)
        scripts = page.locator("script").count()
        for link in page.locator("#list a.node").all():
            link.click()
            title(page).wait_for()
            page.evaluate("document.querySelectorAll('#panel details').forEach(one => { one.open = true; })")
        assert "<img src=x onerror=alert(1)>" in "".join(page.locator("#list").all_text_contents())
        assert "\\u202e" in "".join(page.locator("#list").all_text_contents())
        for group in ("process", "enclave", "none"):
            page.get_by_label("Group by").select_option(group)
            shapes(page)
        page.get_by_role("link", name="Policies").click()
        for link in page.locator("#policies nav a").all():
            link.click()
        page.get_by_role("link", name="Findings").click()
        page.locator("#findings li").first.wait_for()
        page.evaluate("dispatchEvent(new Event('beforeprint'))")
        assert page.locator("img, iframe, object, embed, svg script, [onerror], [onclick], [src]").count() == 0
        assert page.locator("script").count() == scripts
        bad = "[...document.querySelectorAll('a')].filter(a => !a.getAttribute('href').startsWith('#')).length"
        assert page.evaluate(bad) == 0


def test_a_network_without_nodes_says_so(browser: Browser, tmp_path: Path) -> None:
    network = connect("jazzy", [], [], files=1, lines=1, processes=0)
    with opened(browser, written(tmp_path, network)) as page:
        assert "no ROS node" in page.locator("#blank").inner_text()
        page.get_by_role("link", name="Policies").click()
        page.get_by_role("heading", name="No policy").wait_for()
        page.get_by_role("link", name="Findings").click()
        page.get_by_role("heading", name="No findings").wait_for()


def test_doubtful_names_and_their_reasons_are_seen(browser: Browser, tmp_path: Path) -> None:
    with opened(browser, written(tmp_path, talker_and_listener())) as page:
        assert shapes(page, "node.topic.doubtful") == ["* ?", "/robot_*/cmd_vel ?"]
        assert shapes(page, "node.error") != []
        click(page, "node.topic.doubtful[label ^= '/robot_']")
        page.locator("#panel .callout.doubt").first.wait_for()
        assert "parameter 'robot_id' has no default" in page.locator("#panel").inner_text()
        page.locator("#tabs a", has_text="Findings").click()
        settle(page)
        page.locator("#findings details.error a.node, #findings details.error a.topic").first.click()
        title(page).wait_for()
        page.evaluate("location.hash = '#p/robot1/listener'")
        page.locator(".refused summary").first.wait_for()
