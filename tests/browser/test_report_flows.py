# SPDX-License-Identifier: Apache-2.0
"""Flows in the report as somebody uses them: what lights up, how strongly, by which lines; by mouse and by keys, in the dark, on paper."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import pytest
from outputs.flowing import flowing, robot, sink
from outputs.networks import node, pub, sub

from rosward.findings import Finding
from rosward.location import Place
from rosward.network.connect import connect
from rosward.outputs.background import Background

from .reports import click, drawn, opened, renewed, settle, shapes, title, written

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

pytestmark = pytest.mark.slow

FLOWS: Final = Background(loose=(), flow=True)
LINES: Final = [f"line {number}" for number in range(1, 130)]


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> str:
    folder = tmp_path_factory.mktemp("robot")
    (folder / "a.py").write_text("\n".join(LINES), encoding="utf-8")
    way = tuple(Place("a.py", line) for line in (36, 40))
    message = "/image reaches /boxes through /detector, which 'pictures stay' forbids"
    broken = Finding("RW601", message, way[-1], nodes=("/detector",), path=way)
    return written(folder, connect("jazzy", robot().nodes, [broken]), FLOWS._replace(root=folder))


@pytest.fixture(scope="module")
def window(browser: Browser, address: str) -> Iterator[Page]:
    with opened(browser, address) as page:
        yield page


@pytest.fixture
def page(window: Page) -> Page:
    window.evaluate("rosward.choice.set({ direction: 'both', weakest: 1, way: [], finding: null })")
    renewed(window)
    return window


def lit(page: Page, strength: str = "") -> set[str]:
    """The labels of the shapes that are lit, all or those of a strength."""
    settle(page)
    return set(shapes(page, f"node.shape.flow{f'.flow-{strength}' if strength else ''}"))


def lines(page: Page, strength: str) -> set[str]:
    """The connections that are lit so, each as `from > to`, with a mark where the flow goes against the arrow."""
    settle(page)
    found: list[str] = page.evaluate(
        """strength => rosward.graph.library().edges('.flow-' + strength).map(one => {
            const arrow = (one.hasClass('against') ? '<' : '') + (one.hasClass('along') ? '>' : '');
            return `${one.source().data('label')} ${arrow} ${one.target().data('label')}`;
        })""",
        strength,
    )
    return set(found)


def chosen(page: Page, fragment: str, **choice: Any) -> None:
    """Opens something, with what is chosen of its flows."""
    page.evaluate(
        "([fragment, choice]) => { rosward.choice.set(choice); location.hash = fragment; }", [fragment, choice]
    )
    title(page).wait_for()
    settle(page)
    drawn(page)


def rows(page: Page, side: str) -> list[str]:
    """What a list of the panel names, in its order."""
    return [
        " ".join(text.split()) for text in page.locator(f"#panel .flows .{side} summary .content-of").all_inner_texts()
    ]


def test_a_click_lights_what_is_up_and_downstream(page: Page) -> None:
    assert lit(page) == set()
    click(page, "node.topic[label = '/boxes']")
    title(page).get_by_text("/boxes").wait_for()
    assert lit(page) == {
        *("/boxes", "/camera", "/image", "/eye", "/image_* ?", "/detector", "/mode", "/planner", "/route", "/router", "/plan", "/driver", "/cmd_vel"),
    } - {"/eye", "/image_* ?"}  # fmt: skip
    assert set(shapes(page, "node.shape.aside")) == {
        "/lamp",
        "/light",
        "/viewer",
        "/view",
        "/eye",
        "/image_* ?",
        "/image_left",
        "/quality",
        "/status",
    }
    page.keyboard.press("Escape")
    assert lit(page) == set()
    assert shapes(page, ".aside") == []


def test_strengths_are_told_apart(page: Page) -> None:
    """What only decides is another line than what is in it; also further on, where it is data of what it decided."""
    chosen(page, "#t/mode", direction="down")
    assert lines(page, "control") >= {
        "/mode > /detector",
        "/detector > /boxes",
        "/boxes > /planner",
        "/planner <> /route",
    }
    assert lines(page, "data") == set()
    chosen(page, "#t/image", direction="down", weakest=2)
    assert "/detector > /boxes" in lines(page, "data")
    assert lines(page, "trigger") == {"/detector > /status"}
    styles = page.evaluate(
        """() => ['data', 'trigger'].map(word => rosward.graph.library().edges(`.flow-${word}`)[0].style('line-style'))"""
    )
    assert styles == ["solid", "dashed"]


def test_a_response_goes_against_the_arrow_of_its_service(page: Page) -> None:
    chosen(page, "#n/router", direction="down")
    assert "/route < /router" in {line for line in lines(page, "data") if "router" in line}
    chosen(page, "#s/route", direction="both")
    assert {line for line in lines(page, "data") if "rout" in line} == {"/planner <> /route", "/route <> /router"}


def test_one_direction_and_none(page: Page) -> None:
    chosen(page, "#t/boxes", direction="up")
    assert lit(page) == {"/boxes", "/detector", "/image", "/camera", "/mode"}
    assert page.locator("#panel .flows .down").count() == 0
    page.get_by_role("group", name="Information flow").get_by_label("Flow", exact=True).select_option("down")
    assert "/camera" not in lit(page)
    assert "/cmd_vel" in lit(page)
    page.locator("#flow-direction").select_option("off")
    assert lit(page) == set()
    assert page.locator("#panel .flows section").count() == 0


def test_the_weakest_strength_is_chosen_by_its_line(page: Page) -> None:
    chosen(page, "#t/mode", direction="down")
    assert "/boxes" in lit(page)
    decided, triggered = (page.get_by_role("button", name=name) for name in ("decided by", "triggered by"))
    assert [one.get_attribute("aria-pressed") for one in (decided, triggered)] == ["true", "false"]
    decided.click()
    assert lit(page) == set()
    assert "Nothing that is sent depends on it" in page.locator("#panel .flows .down").inner_text()
    triggered.click()
    assert [one.get_attribute("aria-pressed") for one in (decided, triggered)] == ["true", "true"]
    assert "/boxes" in lit(page)


def test_by_keys(page: Page) -> None:
    chosen(page, "#t/image")
    page.locator("#canvas").focus()
    page.keyboard.press("i")
    assert page.locator("#flow-direction").input_value() == "up"
    page.keyboard.press("w")
    assert page.get_by_role("button", name="triggered by").get_attribute("aria-pressed") == "true"
    page.locator("#search").focus()
    page.keyboard.type("wi")
    assert page.locator("#flow-direction").input_value() == "up"
    page.locator("#search").fill("")
    page.locator("#canvas").focus()
    page.keyboard.press("?")
    page.locator("#keys", has_text="information flow").wait_for()
    page.keyboard.press("Escape")
    page.locator("#panel .flows .up summary").first.focus()
    page.keyboard.press("Enter")
    page.locator("#panel .flows .up details[open] .steps").wait_for()


def test_the_panel_tells_each_source_once_the_strongest_first(page: Page) -> None:
    chosen(page, "#t/plan")
    assert rows(page, "up") == [
        *("response /route", "request /route", "files of /router", "/boxes", "/image", "parameter size of /detector", "devices of /camera"),
        "/mode",
    ]  # fmt: skip
    assert rows(page, "down") == ["/cmd_vel"]
    assert page.locator("#panel .flows .down summary").get_by_text("assumed").count() == 1
    assert page.locator("#flow-status").inner_text().replace("\xa0", " ") == "8 sources · 1 output"


def test_a_row_opens_to_its_way_line_by_line_and_marks_it(page: Page) -> None:
    chosen(page, "#t/boxes", direction="up")
    row = page.locator("#panel .flows .up details", has_text="devices of /camera")
    row.locator("summary .at").click()
    row.locator(".steps").wait_for()
    settle(page)
    assert row.locator(".steps > li").count() == 2
    text = row.locator(".steps > li").first.inner_text()
    assert "/camera" in text
    assert "goes into" in text
    assert row.locator(".line code").all_inner_texts() == ["line 16", "line 20", "line 36", "line 40"]
    assert row.locator(".line .number").all_inner_texts() == ["16", "20", "36", "40"]
    assert set(shapes(page, "node.flow-way")) == {"/camera", "/image", "/detector", "/boxes"}
    row.locator("summary .at").click()
    settle(page)
    assert shapes(page, ".flow-way") == []


def test_a_node_tells_what_each_output_is_made_of(page: Page) -> None:
    chosen(page, "#n/detector")
    section = page.locator("#panel .made-of")
    assert section.locator("h3").inner_text() == "What each output is made of 3"
    boxes = section.locator("details", has_text="/boxes")
    text = " ".join(boxes.locator("summary").inner_text().split())
    assert text.replace(" ,", ",") == "/boxes a.py:40 data /image, parameter size decided by /mode"
    boxes.locator("summary .title .at").click()
    boxes.locator(".line").first.wait_for()
    assert boxes.locator(".line code").all_inner_texts() == ["line 36", "line 40"] * 3
    status = section.locator("details", has_text="/status").locator("summary")
    assert " ".join(status.inner_text().split()).replace(" ,", ",") == "/status a.py:50 triggered by /image, timer"
    page.locator("#flow-direction").select_option("off")
    assert section.locator("details[open]").count() == 1


def test_what_a_node_sends_of_nothing_and_what_nobody_analysed(page: Page) -> None:
    chosen(page, "#n/lamp")
    assert "constant" in page.locator("#panel .made-of").inner_text()
    assert lit(page) == {"/lamp", "/light"}
    chosen(page, "#n/driver")
    assert "not analysed: each output may hold each input" in page.locator("#panel .made-of").inner_text()
    assert shapes(page, "edge.flow-assumed")
    chosen(page, "#t/quality")
    assert "It is constant" in page.locator("#panel .flows .up").inner_text()


def test_a_trigger_of_a_node_is_not_upstream_of_it_until_it_is_asked_for(page: Page) -> None:
    chosen(page, "#n/detector", direction="up")
    assert "/detector > /status" not in lines(page, "trigger")
    assert "timer of /detector" not in rows(page, "up")
    chosen(page, "#t/status", direction="up", weakest=2)
    assert rows(page, "up") == ["/image", "timer of /detector", "devices of /camera"]


def test_a_connection_is_that_of_its_node_alone(page: Page) -> None:
    """What /eye sends as /image_left, not what others may send under that name."""
    ids = page.evaluate(
        "rosward.model.report.entities.filter(e => ['/image', '/boxes'].includes(e.name)).map(e => [e.name, e.kind, e.id])"
    )
    by = {(name, kind): id_ for name, kind, id_ in ids}
    chosen(page, f"#e/{by['/image', 'publisher']}", direction="down")
    assert "/detector" in lit(page)
    chosen(page, f"#e/{by['/image', 'publisher']}", direction="up")
    assert rows(page, "up") == ["devices of /camera"]
    chosen(page, f"#e/{by['/boxes', 'subscription']}", direction="down")
    assert "/cmd_vel" in lit(page)


def test_what_is_sent_under_a_name_known_in_part_may_arrive(page: Page) -> None:
    chosen(page, "#n/eye", direction="down")
    assert lit(page) == {"/eye", "/image_* ?", "/image_left", "/viewer", "/view"}


def test_without_topics_and_in_closed_frames(page: Page) -> None:
    page.get_by_label("Show").select_option("nodes")
    chosen(page, "#t/boxes", direction="up")
    assert set(shapes(page, "node.shape.flow")) == {"/camera", "/detector"}
    assert lines(page, "data") == {"/camera > /detector"}


def test_a_finding_shows_its_way(page: Page) -> None:
    page.locator("#tabs a", has_text="Findings").click()
    item = page.locator("#code-RW601 li")
    item.locator(".line code").first.wait_for()
    assert item.locator(".line code").all_inner_texts() == ["line 36", "line 40"]
    item.get_by_role("button", name="Show the way in the graph").click()
    page.locator("#flow-status", has_text="the way of RW601").wait_for()
    settle(page)
    drawn(page)
    assert lit(page) == {"/image", "/detector", "/boxes"}
    page.get_by_role("button", name="Clear the way").click()
    assert lit(page) == set()


def test_a_drawing_that_is_made_anew_is_lit_again(page: Page) -> None:
    chosen(page, "#t/boxes")
    before = lit(page)
    page.get_by_label("Group by").select_option("process")
    drawn(page)
    assert lit(page) == before
    page.get_by_role("button", name="Light or dark theme").click()
    page.get_by_role("button", name="Light or dark theme").click()
    assert lit(page) == before


def test_in_the_dark_lines_have_the_colours_of_the_dark(browser: Browser, address: str) -> None:
    colours = []
    for scheme in ("light", "dark"):
        with opened(browser, address + "#t/boxes", color_scheme=scheme) as page:
            settle(page)
            colours.append(page.evaluate("rosward.graph.library().edges('.flow-data')[0].style('line-color')"))
    assert len(set(colours)) == 2


def test_on_a_small_screen(browser: Browser, address: str) -> None:
    with opened(browser, address + "#t/boxes", viewport={"width": 390, "height": 844}) as page:
        assert page.evaluate("document.documentElement.scrollWidth") == 390
        assert page.get_by_role("button", name="triggered by").is_visible()
        page.locator("#panel .flows .up summary .at").first.click()
        page.locator("#panel .flows .steps").first.wait_for()
        assert page.locator("#panel").evaluate("one => one.scrollWidth <= one.clientWidth")


def test_on_paper(page: Page) -> None:
    page.emulate_media(media="print")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    table = page.locator("#paper-flows section", has_text="/detector").locator("tbody tr")
    assert table.first.locator("td").all_inner_texts() == ["/boxes", "/image, parameter size", "/mode", "", "a.py:40"]
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    assert page.locator("#paper-flows").inner_text() == ""
    page.emulate_media(media="screen")


def test_evil_names_stay_names(browser: Browser, tmp_path: Path) -> None:
    evil = "/<img src=x onerror=alert(1)>"
    made = flowing(
        node("/a", sub(evil), pub("/b\u202ea"), system=False),
        sink("topic:/b\u202ea", data=[f"topic:{evil}", "parameter:</script>"]),
    )
    with opened(browser, written(tmp_path, connect("jazzy", [made]), FLOWS) + "#n/a") as page:
        page.locator("#panel .made-of summary .at").click()
        assert evil in page.locator("#panel .made-of").inner_text()
        assert "\\u202e" in page.locator("#panel .made-of").inner_text()
        assert page.locator("#panel img").count() == 0


def test_a_system_without_anything(browser: Browser, tmp_path: Path) -> None:
    with opened(browser, written(tmp_path, connect("jazzy", []), FLOWS)) as page:
        assert page.locator("#flow-status").inner_text() == "open something to see its flows"
        page.keyboard.press("i")
        page.keyboard.press("w")


def test_what_is_logged_goes_to_rosout_and_what_is_broadcast_to_tf(browser: Browser, tmp_path: Path) -> None:
    nodes = [
        flowing(node("/a", sub("/in"), pub("/tf")), sink("log", data=["topic:/in"]), sink("tf", data=["topic:/in"])),
        flowing(node("/b", sub("/tf"), pub("/out")), sink("topic:/out", control=["tf"])),
    ]
    with opened(browser, written(tmp_path, connect("jazzy", nodes), FLOWS)) as page:
        chosen(page, "#t/in", direction="down")
        assert lit(page, "data") == {"/in", "/a", "/tf"}
        assert lit(page, "control") == {"/b", "/out"}
        assert rows(page, "down") == ["log", "transforms (tf)", "/out"]
        chosen(page, "#t/rosout", direction="up")
        assert rows(page, "up") == ["/in"]
        assert "/a > /rosout" in lines(page, "data")


def test_a_topic_that_is_drawn_beside_each_of_its_nodes_is_lit_beside_those_that_use_it(
    browser: Browser, tmp_path: Path
) -> None:
    beats = [
        flowing(node(f"/n{at:02}", pub("/beat"), system=False), sink("topic:/beat", data=["clock"])) for at in range(15)
    ]
    watch = flowing(
        node("/watch", sub("/beat"), pub("/alarm"), system=False), sink("topic:/alarm", control=["topic:/beat"])
    )
    deaf = node("/deaf", sub("/beat"), system=False)
    with opened(browser, written(tmp_path, connect("jazzy", [*beats, watch, flowing(deaf)]), FLOWS)) as page:
        page.evaluate("rosward.state.set({ detail: 'all', collapsed: [] })")
        chosen(page, "#n/n03", direction="down")
        assert lit(page, "data") == {"/n03", "/beat"}
        assert lit(page, "control") == {"/watch", "/alarm"}
        hubs = "rosward.graph.library().nodes('.hub.flow').map(one => one.id().split(' at ')[1])"
        by = {
            one["id"]: one["fqn"]
            for one in page.evaluate("rosward.model.report.nodes.map(({ id, fqn }) => ({ id, fqn }))")
        }
        assert sorted(by[one] for one in page.evaluate(hubs)) == ["/n03", "/watch"]


def test_a_closed_frame_is_lit_where_something_goes_in(browser: Browser, tmp_path: Path) -> None:
    nodes = [
        flowing(
            node(name, sub(f"/t{at}"), pub(f"/t{at + 1}"), system=False),
            sink(f"topic:/t{at + 1}", data=[f"topic:/t{at}"]),
        )
        for at, name in enumerate(("/a/x", "/b/y", "/b/z", "/c/w"))
    ]
    with opened(browser, written(tmp_path, connect("jazzy", [*nodes, node("/c/v"), node("/a/u")]), FLOWS)) as page:
        page.get_by_role("button", name="Close all frames").click()
        chosen(page, "#n/a/x", direction="down")
        assert any(label.startswith("/b") for label in lit(page))


def test_a_thousand_nodes_answer_at_once(browser: Browser, tmp_path: Path) -> None:
    """A chain of as many, in a ring: everything reaches everything."""
    count = 1000
    ring = [
        flowing(
            node(f"/n{at}", sub(f"/t{at}"), pub(f"/t{(at + 1) % count}"), system=False),
            sink(f"topic:/t{(at + 1) % count}", data=[f"topic:/t{at}"], control=["parameter:on"]),
        )
        for at in range(count)
    ]
    with opened(browser, written(tmp_path, connect("jazzy", ring), FLOWS)) as page:
        reached, took = page.evaluate(
            """() => {
                const place = { one: rosward.model.report.endpoints[0], entities: [] };
                const start = performance.now();
                const { reached } = rosward.flows.search(rosward.flows.starts(place, true), true, 1);
                return [reached.size, performance.now() - start];
            }"""
        )
        assert reached == 2 * count
        assert took < 1000
        page.locator("#list a.topic").first.click()
        page.locator("#panel .flows .down .more").click()
        assert page.locator("#panel .flows .down details").count() == count - 1
