# SPDX-License-Identifier: Apache-2.0
"""The report of the example fleet as somebody uses it: by mouse, by keys, by links, on a small screen, in the dark, on paper."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Final

import pytest

from rosward.deployment.request import LaunchRequest, Request
from rosward.outputs.background import Background
from rosward.pipeline import extract

from .reports import chosen, click, drawn, fragment, opened, renewed, settle, shapes, title, written

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

pytestmark = pytest.mark.slow

EXAMPLES: Final = Path(__file__).parents[2] / "examples"
PLANNER: Final = "#n/porter1/delivery_planner"


@pytest.fixture(scope="module")
def fleet(tmp_path_factory: pytest.TempPathFactory) -> str:
    result = extract(EXAMPLES, request=Request(launches=(LaunchRequest("fleet.launch.py", "delivery_bringup"),)))
    return written(tmp_path_factory.mktemp("fleet"), result.network, Background(result.root, result.systems))


@pytest.fixture(scope="module")
def window(browser: Browser, fleet: str) -> Iterator[Page]:
    with opened(browser, fleet) as page:
        yield page


@pytest.fixture
def page(window: Page) -> Page:
    renewed(window)
    return window


def test_it_opens_with_all_nodes_and_without_system_entities(page: Page) -> None:
    assert len(shapes(page, "node.node")) == 28
    assert "/rosout" not in shapes(page, "node.topic")
    assert "28 nodes" in page.locator("#facts").inner_text()
    assert "Nothing was executed." in page.locator("#facts").inner_text()
    assert shapes(page, "node.frame") == [
        "/building",
        "/fleet",
        "/porter1",
        "/porter2",
        *["lidars"] * 2,
        *["teleop"] * 2,
    ]


def test_no_two_shapes_lie_on_each_other(page: Page) -> None:
    """Also not on the frames of others."""
    overlaps = page.evaluate(
        """() => {
            const all = rosward.graph.library().nodes('.shape').toArray();
            const apart = (a, b, way, size) => Math.abs(a.position(way) - b.position(way)) >= (a[size]() + b[size]()) / 2;
            const meet = (a, b) => !apart(a, b, 'x', 'outerWidth') && !apart(a, b, 'y', 'outerHeight');
            return all.flatMap((a, at) => all.slice(at + 1).filter(b => meet(a, b)).map(b => a.id() + ' ' + b.id()));
        }"""
    )
    assert overlaps == []


def test_a_click_on_a_node_tells_everything_about_it(page: Page) -> None:
    click(page, "node.node[label = 'gateway']")
    title(page).get_by_text("/fleet/gateway").wait_for()
    assert fragment(page) == "#n/fleet/gateway"
    assert chosen(page) == ["gateway"]
    page.locator("#panel details.entity summary").first.click()
    inside = page.locator("#panel details.entity .inside").first
    assert "create_" in inside.locator(".line.marked").first.inner_text()
    inside.locator("a.rule").click()
    assert page.locator("#policies .xml .line.marked").count() == 1


def test_a_click_on_a_topic_names_both_sides(page: Page) -> None:
    click(page, "node.topic[label = 'cmd_vel']")
    page.locator("#panel .kind", has_text="topic").wait_for()
    text = page.locator("#panel").inner_text()
    assert "Publishers 1" in text
    assert "Subscriptions 1" in text
    assert "geometry_msgs/msg/Twist" in text


def test_a_click_on_an_edge_tells_what_it_stands_for(page: Page) -> None:
    click(page, "edge.action")
    page.locator("#panel details.entity[open]").first.wait_for()
    assert fragment(page).startswith("#e/")
    assert page.locator("#panel details.entity").count() == 1


def test_back_leads_back(page: Page) -> None:
    click(page, "node.node[label = 'gateway']")
    title(page).get_by_text("/fleet/gateway").wait_for()
    page.locator("#panel .entity a.thing").first.click()
    page.locator("#panel .kind", has_text="topic").wait_for()
    page.go_back()
    title(page).get_by_text("/fleet/gateway").wait_for()
    page.go_back()
    page.locator("#panel").wait_for(state="hidden")


def test_a_link_opens_what_it_names(browser: Browser, fleet: str) -> None:
    with opened(browser, fleet + PLANNER) as page:
        assert title(page).inner_text() == "/porter1/delivery_planner"
        assert chosen(page) == ["delivery_planner"]
        assert page.locator("#list a[aria-current]").inner_text() == "/porter1/delivery_planner"
    with opened(browser, fleet + "#p/fleet/gateway") as page:
        assert page.locator("#policies article h2").inner_text() == "/fleet/gateway"
    with opened(browser, fleet + "#n/nobody/%E0%A4%A") as page:
        assert page.locator("#panel").is_hidden()


def test_search_goes_over_names_types_and_packages(page: Page) -> None:
    def found(words: str) -> set[str]:
        page.locator("#search").fill(words)
        settle(page)
        return set(page.locator("#list a.thing").all_text_contents())

    assert found("planner porter2") == {"/porter2/delivery_planner", "/porter2/teleop/mux/planner"}
    assert "/porter1/scan" in found("LaserScan")
    assert found("delivery_fleet gateway") | {"/fleet/gateway"} == found("delivery_fleet gateway")
    assert found("no such thing") == set()
    assert "Nothing here" in page.locator("#list").inner_text()
    found("gateway")
    assert set(shapes(page, "node.hit")) == {"gateway", "door_gateway"}
    page.locator("#search").press("Enter")
    title(page).wait_for()


def test_each_filter(page: Page) -> None:
    everything = shapes(page)
    page.get_by_role("button", name="Services").click()
    assert set(everything) - set(shapes(page)) >= {"request_delivery"}
    page.get_by_role("button", name="Reset").click()
    assert shapes(page) == everything

    page.get_by_label("System entities").check()
    assert "/rosout" in shapes(page, "node.topic.system")
    page.get_by_label("System entities").uncheck()

    page.get_by_label("Only with findings").check()
    assert 0 < len(shapes(page)) < len(everything)
    assert "camera_mount" not in shapes(page)
    page.get_by_label("Only with findings").uncheck()

    page.get_by_label("Loose ends").uncheck()
    assert shapes(page, "node.topic.note") == []
    page.get_by_label("Loose ends").check()

    page.locator("#filter-namespace").select_option("/porter1")
    assert len(shapes(page, "node.node")) == 14
    page.locator("#filter-package").select_option("delivery_navigation")
    assert len(shapes(page, "node.node")) == 2
    page.get_by_role("button", name="Reset").click()
    assert shapes(page) == everything


@pytest.mark.parametrize("kind", ["topic", "service", "action"])
def test_each_kind_can_be_left_out(page: Page, kind: str) -> None:
    assert shapes(page, f"node.{kind}")
    page.get_by_role("button", name=f"{kind.title()}s", exact=True).click()
    assert shapes(page, f"node.{kind}") == []
    assert page.locator(f"#list a.{kind}").count() == 0


def test_focus_leaves_what_is_near(page: Page) -> None:
    click(page, "node.node[label = 'gateway']", double=True)
    page.locator(".focus-line").wait_for()
    assert shapes(page, "node.node") == ["delivery_planner", "delivery_planner", "gateway"]
    page.get_by_label("How far").select_option("2")
    assert len(shapes(page, "node.node")) > 3
    page.get_by_role("button", name="End focus").click()
    assert len(shapes(page, "node.node")) == 28


def test_grouping(page: Page) -> None:
    page.get_by_label("Group by").select_option("process")
    assert len(shapes(page, "node.frame")) == 22
    page.get_by_label("Group by").select_option("enclave")
    assert "/porter1/base_driver" in shapes(page, "node.frame")
    page.get_by_label("Group by").select_option("none")
    assert shapes(page, "node.frame") == []
    assert "/fleet/gateway" in shapes(page, "node.node")


def test_nodes_only(page: Page) -> None:
    page.get_by_label("Show").select_option("nodes")
    drawn(page)
    assert shapes(page) == shapes(page, "node.node")
    click(page, "edge.action")
    page.locator("#panel details.entity").nth(1).wait_for()
    assert page.locator("#panel").inner_text().count("/porter1/deliver") >= 2


def test_frames_close_and_open(page: Page) -> None:
    page.get_by_role("button", name="Close all frames").click()
    assert "/porter1\n14 nodes" in shapes(page, "node.group")
    page.evaluate("location.hash = '#n/porter1/localisation'")
    title(page).wait_for()
    assert "localisation" in shapes(page, "node.node")
    assert "/porter2\n11 nodes" in shapes(page, "node.group")
    page.get_by_role("button", name="Open all frames").click()
    assert len(shapes(page, "node.node")) == 28


def test_a_policy_is_copied_as_it_is_in_the_file(browser: Browser, fleet: str, tmp_path: Path) -> None:
    with opened(browser, fleet + "#p/porter1/localisation", accept_downloads=True) as page:
        page.context.grant_permissions(["clipboard-read", "clipboard-write"])
        page.get_by_role("button", name="Copy policy").click()
        page.get_by_role("button", name="Copied").wait_for()
        copied = page.evaluate("navigator.clipboard.readText()")
        with page.expect_download() as coming:
            page.get_by_role("button", name="Download policy.xml").click()
        coming.value.save_as(tmp_path / "policy.xml")
    policy = (tmp_path / "policy.xml").read_text(encoding="utf-8")
    assert copied == policy
    assert policy.startswith('<?xml version="1.0"')
    assert "<topic>/porter1/pose</topic>" in policy


def test_a_rule_leads_to_its_source_and_back(browser: Browser, fleet: str) -> None:
    with opened(browser, fleet + "#p/porter1/localisation") as page:
        page.locator(".xml a", has_text="/porter1/pose").click()
        page.locator("#panel", has_text="publish /porter1/pose").wait_for()
        assert "create_publisher" in page.locator("#panel .line.marked").first.inner_text()
        page.locator("#panel .entity a.node").first.click()
        title(page).get_by_text("/porter1/localisation").wait_for()
        assert page.locator("#canvas").is_visible()
        page.locator("#panel a", has_text="Policy").click()
        assert page.locator("#policies article h2").inner_text() == "/porter1/localisation"


def test_a_finding_leads_to_the_thing(page: Page) -> None:
    page.get_by_role("link", name="Findings").click()
    page.locator("#findings details.code", has_text="RW331").locator("li a.topic").first.click()
    name = title(page).inner_text()
    page.locator("#panel a.callout.note").first.click()
    marked = page.locator("#findings li.marked")
    assert name in marked.inner_text().replace("\n", "")
    page.locator("#findings .chip.note").click()
    assert marked.is_hidden()
    page.locator("#findings .chip.note").click()


def test_by_keys_alone(page: Page) -> None:
    keys = page.keyboard
    keys.press("/")
    keys.type("gateway")
    keys.press("ArrowDown")
    keys.press("ArrowDown")
    keys.press("Enter")
    title(page).get_by_text("gateway").wait_for()
    assert page.evaluate("document.activeElement.matches('#list a.thing')")
    keys.press("f")
    page.locator(".focus-line").wait_for()
    keys.press("Escape")
    page.locator("#panel").wait_for(state="hidden")
    keys.press("Escape")
    page.locator(".focus-line").wait_for(state="hidden")
    keys.press("g")
    assert page.get_by_label("Group by").input_value() == "process"
    page.locator("#canvas").focus()
    drawn(page)
    keys.press("ArrowRight")
    title(page).wait_for()
    before = fragment(page)
    for arrow in ("ArrowRight", "ArrowDown", "ArrowLeft", "ArrowUp"):
        keys.press(arrow)
    settle(page)
    assert fragment(page) != "#graph"
    keys.press("Enter")
    assert page.evaluate("document.activeElement.matches('#panel h2')")
    keys.press("Escape")
    assert before != fragment(page) == "#graph"
    keys.press("2")
    page.locator("#policies article").wait_for()
    keys.press("3")
    page.locator("#findings details").first.wait_for()
    keys.press("?")
    assert page.get_by_role("heading", name="Keys").is_visible()
    keys.press("Escape")
    assert page.get_by_role("heading", name="Keys").is_hidden()


def test_every_control_has_a_name(page: Page) -> None:
    click(page, "node.node[label = 'gateway']")
    title(page).wait_for()
    for control in page.locator("button:visible, select:visible, input:visible, a:visible").all():
        name = control.evaluate(
            "one => one.getAttribute('aria-label') || one.textContent.trim() || [...(one.labels || [])].map(l => l.textContent).join('')"
        )
        assert name, control.evaluate("one => one.outerHTML")


def test_about_tells_the_licences(page: Page) -> None:
    page.get_by_role("button", name="About").click()
    assert "Eclipse Public License 2.0" in page.locator("#about").inner_text()
    page.locator("#about").get_by_role("button", name="Close").click()
    assert page.locator("#about").is_hidden()


def test_light_and_dark_follow_the_system_until_the_user_says(browser: Browser, fleet: str) -> None:
    colour = "getComputedStyle(document.body).backgroundColor"
    ink = "rosward.graph.library().nodes('.node')[0].style('color')"
    with opened(browser, fleet, color_scheme="light") as page:
        light, light_ink = page.evaluate(colour), page.evaluate(ink)
        page.emulate_media(color_scheme="dark")
        settle(page)
        dark = page.evaluate(colour)
        assert dark != light
        assert page.evaluate(ink) != light_ink
        page.get_by_role("button", name="Light or dark theme").click()
        assert (page.evaluate(colour), page.evaluate(ink)) == (light, light_ink)
        page.reload()
        drawn(page)
        assert page.evaluate(colour) == light


def test_it_fits_a_narrow_window(browser: Browser, fleet: str) -> None:
    with opened(browser, fleet, viewport={"width": 390, "height": 780}) as page:
        assert page.evaluate("document.documentElement.scrollWidth") <= 390
        assert page.locator("#search").is_hidden()
        page.get_by_role("button", name="List and filters").click()
        page.locator("#list a.thing").first.click()
        title(page).wait_for()
        page.locator("#search").wait_for(state="hidden")
        page.get_by_role("link", name="Policies").click()
        assert page.locator(".xml").is_visible()
        assert page.evaluate("document.documentElement.scrollWidth") <= 390


def test_less_motion(browser: Browser, fleet: str) -> None:
    with opened(browser, fleet + PLANNER, reduced_motion="reduce") as page:
        assert page.evaluate("rosward.graph.library().animated()") is False


def test_on_paper_no_kind_and_no_code_is_broken_in_two(page: Page) -> None:
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    heights = page.locator("#paper td:first-child .name").evaluate_all(
        "all => all.map((one) => one.getClientRects().length)"
    )
    assert heights
    assert set(heights) == {1}


def test_on_paper_there_is_all_of_it(page: Page) -> None:
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    paper = page.locator("#paper")
    assert paper.locator("canvas").is_visible()
    assert page.locator("#workspace").is_hidden()
    assert paper.locator("h3", has_text="/fleet/gateway").count() == 2  # the node, and its policy
    assert '<enclave path="/fleet/gateway">' in paper.inner_text()
    assert page.pdf()[:4] == b"%PDF"


def test_without_scripts_there_is_a_drawing(browser: Browser, fleet: str) -> None:
    context = browser.new_context(java_script_enabled=False)
    page = context.new_page()
    page.goto(fleet)
    assert page.locator(".fallback svg").is_visible()
    assert "network.json" in page.locator("body").inner_text()
    context.close()
