# SPDX-License-Identifier: Apache-2.0
"""The report: everything is in it, it asks for nothing from outside, and what comes from the sources stays text."""

from __future__ import annotations

import base64
import hashlib
import re
from html.parser import HTMLParser

from hypothesis import given, settings
from hypothesis import strategies as st

from rosward.findings import Finding
from rosward.network.connect import connect
from rosward.network.graph import Network
from rosward.outputs.report import report_html
from rosward.source.location import Place

from .networks import fleet, node, pub, talker_and_listener


class Page(HTMLParser):
    """Collects the tags, the addresses they refer to and the text."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.addresses: list[str] = []
        self.handlers: list[str] = []
        self.ids: list[str] = []
        self.text = ""
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        for key, value in attrs:
            if key in {"src", "href", "xlink:href", "action", "data", "srcset"}:
                self.addresses.append(value or "")
            if key.startswith("on"):
                self.handlers.append(key)
            if key == "id":
                self.ids.append(value or "")

    def handle_data(self, data: str) -> None:
        self.text += data


def test_everything_is_in_it() -> None:
    page = Page(report_html(talker_and_listener()))
    for part in (
        "/robot1/talker",
        "geometry_msgs/msg/Twist",
        "Listener.on_message",
        "src/demo/demo/node.py:20",
        "rate",
        "RW101 unknown name",
        "sys.argv[1] is not known",
        "Give the value that is missing",
        "<topic>/robot1/chatter</topic>  <!-- src/demo/demo/node.py:20 -->",
        "of which 14 system",
    ):
        assert part in page.text
    assert "svg" in page.tags


def test_it_asks_for_nothing_from_outside() -> None:
    page = Page(report_html(fleet(2)))
    assert not {"link", "img", "iframe", "object", "base", "form"} & set(page.tags)
    assert page.addresses
    assert all(address.startswith("#") for address in page.addresses)
    assert {address[1:] for address in page.addresses} <= set(page.ids)


def test_its_one_script_is_the_one_that_it_allows() -> None:
    text = report_html(talker_and_listener())
    (script,) = re.findall(r"<script>(.*?)</script>", text, re.DOTALL)
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    assert f"script-src 'sha256-{digest}'" in text


def test_no_doubts_and_no_nodes() -> None:
    page = Page(report_html(connect("jazzy", [])))
    assert "None: every file was read" in page.text


def hostile(text: str) -> Network:
    bad = node(
        "/a",
        pub(
            "/" + text, text, callback=text, reasons=(text,), depends_on=(text,), via=text, created_at=(Place(text, 1),)
        ),
        name=text,
        namespace="/" + text,
        process=text,
        reasons=(text,),
        defined_at=Place(text, 2),
    )
    return connect("jazzy", [bad], [Finding("RW101", text, Place(text, 3))])


def test_text_from_the_sources_stays_text() -> None:
    plain = Page(report_html(hostile("plain")))
    for text in (
        "<script>alert(1)</script>",
        "</pre></textarea><img src=x onerror=alert(1)>",
        '"><b onclick="x">',
        "{{ 7 * 7 }}",
    ):
        page = Page(report_html(hostile(text)))
        assert not page.handlers
        assert page.tags.count("script") == 1
        assert set(page.tags) == set(plain.tags)
        assert text in page.text


@settings(max_examples=25, deadline=None)
@given(st.text(alphabet=st.characters(), max_size=10))
def test_any_text_gives_the_same_page_around_it(text: str) -> None:
    written = report_html(hostile(text))
    written.encode()
    assert Page(written).tags.count("table") == Page(report_html(hostile("plain"))).tags.count("table")


def test_the_same_network_gives_the_same_page() -> None:
    assert report_html(fleet(2)) == report_html(fleet(2))
