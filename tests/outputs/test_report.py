# SPDX-License-Identifier: Apache-2.0
"""The report as one file: everything is in it, it asks for nothing from outside, and what comes from the sources stays text."""

from __future__ import annotations

import base64
import hashlib
import json
import re
from html.parser import HTMLParser
from pathlib import Path

from hypothesis import given, settings
from hypothesis import strategies as st
from laws import examples

from rosward.network.connect import connect
from rosward.outputs.report import page
from rosward.outputs.report.document import report_document
from rosward.outputs.report.packed import packed, unpacked
from rosward.outputs.report.page import report_html

from .networks import fleet, hostile, talker_and_listener


class Page(HTMLParser):
    """Collects the tags, the addresses they refer to, the scripts, the styles and the policy."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.addresses: list[str] = []
        self.handlers: list[str] = []
        self.scripts: list[str] = []
        self.styles: list[str] = []
        self.held: dict[str, str] = {}
        self.policy = ""
        self._data: dict[str, str | None] = {}
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        values = dict(attrs)
        self.addresses += [
            values[key] or "" for key in ("src", "href", "xlink:href", "action", "data", "srcset") if key in values
        ]
        self.handlers += [key for key in values if key.startswith("on")]
        if values.get("http-equiv") == "Content-Security-Policy":
            self.policy = values["content"] or ""
        self._data = values

    def handle_data(self, data: str) -> None:
        if self.lasttag == "script" and self.cdata_elem == "script":
            if "type" not in self._data:
                self.scripts.append(data)
            elif key := self._data.get("id"):
                self.held[key] = self.held.get(key, "") + data
        elif self.lasttag == "style" and self.cdata_elem == "style":
            self.styles.append(data)

    @property
    def document(self) -> str:
        """The document of the report."""
        return unpacked(self.held["report"])

    @property
    def started(self) -> list[str]:
        """The scripts that run, in their order: the one that takes out the others, and these."""
        return [*self.scripts, *json.loads(unpacked(self.held["scripts"]))]


def digest(text: str) -> str:
    return "'sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode() + "'"


def test_the_document_is_in_it() -> None:
    shown = Page(report_html(talker_and_listener()))
    assert json.loads(shown.document) == report_document(talker_and_listener())


def test_it_asks_for_nothing_from_outside() -> None:
    shown = Page(report_html(fleet(2)))
    assert not {"link", "img", "iframe", "object", "embed", "base", "form"} & set(shown.tags)
    assert all(address.startswith("#") for address in shown.addresses)
    assert shown.policy.startswith("default-src 'none'; ")
    assert not re.search(r"https?:|\*|unsafe-eval|unsafe-inline", shown.policy.replace("'wasm-unsafe-eval'", ""))


def test_its_scripts_and_styles_are_those_that_it_allows() -> None:
    shown = Page(report_html(talker_and_listener()))
    rules = {rule.split()[0]: rule.split()[1:] for rule in shown.policy.split("; ")}
    assert len(shown.scripts) == 1
    assert len(shown.started) > 20
    assert [digest(script) for script in shown.started] == rules["script-src"]
    assert {digest(style) for style in shown.styles} == set(rules["style-src"])
    assert not shown.handlers


def test_a_network_without_nodes() -> None:
    assert json.loads(Page(report_html(connect("jazzy", []))).document)["nodes"] == []


def test_text_from_the_sources_stays_text() -> None:
    plain = Page(report_html(hostile("plain")))
    for text in (
        "<script>alert(1)</script>",
        "</script><script>alert(1)</script>",
        "<!--<script>",
        "</pre></textarea><img src=x onerror=alert(1)>",
        '"><b onclick="x">',
        "{{ 7 * 7 }}",
    ):
        shown = Page(report_html(hostile(text)))
        assert not shown.handlers
        assert shown.started == plain.started
        assert all(re.fullmatch("[A-Za-z0-9+/=]+", text) for text in shown.held.values())
        assert set(shown.tags) <= set(plain.tags)
        assert text in [f["message"] for f in json.loads(shown.document)["findings"]]


@settings(max_examples=examples(0.3))
@given(st.text(alphabet=st.characters(), max_size=10))
def test_any_text_gives_the_same_page_around_it(text: str) -> None:
    written = report_html(hostile(text))
    written.encode()
    assert Page(written).tags.count("script") == Page(report_html(hostile("plain"))).tags.count("script")


def test_the_same_network_gives_the_same_page() -> None:
    assert report_html(fleet(2)) == report_html(fleet(2))


@given(st.text(alphabet=st.characters(exclude_categories=["Cs"])))
def test_what_is_packed_comes_out_again(text: str) -> None:
    assert unpacked(packed(text)) == text


def test_it_is_small() -> None:
    """Two nodes: what the libraries take. Six hundred: hardly more (bench/report.py measures three thousand)."""
    assert len(report_html(talker_and_listener())) < 1_000_000
    assert len(report_html(fleet(100))) < 1_500_000


def test_it_tells_the_licences_of_what_it_holds() -> None:
    """And the versions are those of the libraries in it."""
    text = report_html(talker_and_listener())
    vendor = Path(page.__file__).parent / "assets" / "vendor"
    table = (vendor / "README.md").read_text(encoding="utf-8")
    for library in re.findall(r"\[((?:elkjs|cytoscape) [\d.]+)\]", table):
        assert library in text
    assert "Eclipse Public License 2.0" in text
    assert "https://github.com/kieler/elkjs/tree/" in text
    assert (vendor / "cytoscape" / "LICENSE").read_text(encoding="utf-8").splitlines()[0] in text
