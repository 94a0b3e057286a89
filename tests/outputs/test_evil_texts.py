# SPDX-License-Identifier: Apache-2.0
"""Whatever a text holds, and wherever it stands: each output can be read, and nothing in it acts, hides or turns a line round unmarked."""

from __future__ import annotations

import io
import json
import re
import shutil
import subprocess
import sys
import unicodedata
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from typing import Any, Final
from xml.etree import ElementTree

import pytest
from rich.console import Console

from outputs.networks import entity, node, pub
from rosward import safe
from rosward.findings import Finding
from rosward.location import Place
from rosward.network.connect import connect
from rosward.network.graph import Network
from rosward.network.launch_tree import GivenParameter, Inclusion, LaunchEntry, LaunchSystem, Shown
from rosward.outputs.background import Background
from rosward.outputs.documents.github import github_commands
from rosward.outputs.documents.junit import junit_xml
from rosward.outputs.documents.launch_tree_json import launch_tree_json
from rosward.outputs.documents.network_json import network_json
from rosward.outputs.documents.sarif import sarif_json
from rosward.outputs.graphs.dot import graph_dot
from rosward.outputs.graphs.mermaid import fenced, graph_mermaid
from rosward.outputs.graphs.svg import graph_svg
from rosward.outputs.policies.permissions import permissions
from rosward.outputs.policies.policy import policies, policy_xml
from rosward.outputs.policies.starts import starts_text
from rosward.outputs.report.packed import document_in
from rosward.outputs.report.page import report_html
from rosward.outputs.terminal.launch_tree import launch_tree_text
from rosward.outputs.terminal.paper import Drawn
from rosward.outputs.terminal.summary import summary
from rosward.ros.entities import EntityKind, Parameter, Resolution
from rosward.source.toml import read_toml
from rosward.suppression.judge import Judged, RelatedPlace, of_no_file

EVIL: Final = {
    "surrogate": "a\ud800b",
    "two surrogates": "a\udc00\ud800b",
    "arabic letter mark": "a\u061cb",
    "zero width": "a\u200b\u200c\u200d\u2060\ufeffb",
    "bidi controls": "a\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069\u200e\u200fb",
    "filler": "a\u115f\u3164\uffa0\u00adb",
    "tag characters": "a\U000e0041\U000e007fb",
    "variation": "a\ufe0f\U000e0100\u180eb",
    "NUL": "a\x00b",
    "escape": "a\x1b[31m\x9b2Jb\x07",
    "CDATA end": "a]]>b",
    "script end": "a</script><script>alert(1)</script>b",
    "comment end": "a--><!--b",
    "title end": "a</title></text></svg><img src=x onerror=alert(1)>b",
    "double quote": 'a" onload="alert(1)" x="b',
    "single quote": "a' onload='alert(1)' x='b",
    "newline": "a\r\nb\nc\rd\x0be\x0cf\x85g\u2028h\u2029i",
    "entity": "a&lt;script&gt;&#x202e;&amp;b",
    "dot": 'a\\N\\" ]; x [URL="javascript:alert(1)"]; y [label=<<b>b</b>>',
    "workflow command": "a\n::error::b%0A::stop-commands::x",
    "mermaid": 'a"] ; click n1 call alert(1)\n%% b ``` #quot;',
    "template": "a{{ 7 * 7 }}${7*7}<%= 7 %>b",
    "long": "a" * 20_000 + "b",
}
HIDDEN: Final = re.compile("[\ud800-\udfff]|" + safe._CONTROL)


def network_of(text: str) -> Network:
    """A system with the text in each place where one can stand."""
    kind, place = EntityKind, Place(text, 3, 2)
    more: dict[str, Any] = {
        "reasons": (text,),
        "depends_on": (text,),
        "created_at": (place,),
        "path": (place, Place(text, 4)),
    }
    entities = [
        entity(each, f"/{text}", text, callback=text, via=text, resolution=resolution, **more)
        for each in kind
        for resolution in (Resolution.EXACT, Resolution.PATTERN)
    ]
    parameters = tuple(Parameter(text, text, value, [text], place) for value in (text, [text], {text: text}))
    one = node(
        "/a",
        *entities,
        name=text,
        namespace=f"/{text}",
        process=text,
        reasons=(text,),
        defined_at=place,
        parameters=parameters,
        system=False,
    )
    placed = replace(one, package=text, executable=text, launched_by=place, enclave=f"/{text}")
    told = [Finding(code, text, place) for code in ("RW101", "RW205", "RW302", "RW299")]
    return connect("jazzy", [placed, node("/b", pub("/plain"))], told, files=1, lines=1, processes=2)


def systems_of(text: str) -> tuple[LaunchSystem, ...]:
    """What is launched, with the text in each place."""
    value, place = Shown(text, text), Place(text, 2)
    one = LaunchEntry(
        text, value, value, value, value, value, value, ((value, value),),
        (GivenParameter(text, text, value, text, place),), (value,), ((text, value),),
        place, (Inclusion(place, text, 1),), text, True, (text,), text,
    )  # fmt: skip
    return (LaunchSystem(text, text, (one,)),)


def judged_of(text: str) -> list[Judged]:
    return [
        judged._replace(file=judged.finding.place.file, related=(RelatedPlace(text, text, 3),))
        for judged in of_no_file(network_of(text).findings)
    ]


def shown(text: str) -> str:
    console = io.StringIO()
    paper = Drawn(Console(file=console, soft_wrap=True, no_color=True))
    summary(network_of(text), paper, verbose=True, written=[text])
    return console.getvalue()


def test_a_string_of_toml_is_read_as_it_was_and_hides_nothing(evil: str) -> None:
    written = safe.toml_string(evil)
    assert read_toml(f"a = {written}")["a"] == safe.encodable(evil)
    assert not HIDDEN.search(written)


def texts_of_xml(document: str) -> list[str]:
    """What an XML reader finds: contents and attributes."""
    root = ElementTree.fromstring(document)
    found = []
    for element in root.iter():
        assert str(element.tag).rpartition("}")[2].lower() not in ("script", "img", "foreignobject", "iframe", "b")
        assert not [name for name in element.attrib if name.lower().startswith("on")]
        found += [element.text or "", element.tail or "", *element.attrib.values()]
    return found


class _Page(HTMLParser):
    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.tags: list[str] = []
        self.texts: list[str] = []
        self.scripts: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        assert not [name for name, _ in attrs if name.startswith("on")]
        self.texts += [value or "" for _, value in attrs]

    def handle_data(self, data: str) -> None:
        (self.scripts if self.tags and self.tags[-1] in ("script", "style") else self.texts).append(data)


def hidden(text: str, *, but: str = "\n") -> set[str]:
    """The characters of a text that nobody sees, or that act."""
    return {f"U+{ord(c):04X}" for c in HIDDEN.findall(text) if c not in but}


@pytest.fixture(params=EVIL, ids=lambda key: key.replace(" ", "_"))
def evil(request: pytest.FixtureRequest) -> str:
    return EVIL[request.param]


def test_json(evil: str) -> None:
    for text in (network_json(network_of(evil)), launch_tree_json(systems_of(evil), network_of(evil).findings)):
        assert not hidden(text)
        text.encode()
        assert json.loads(text)
    assert evil in [d["message"] for d in json.loads(network_json(network_of(evil)))["diagnostics"]]


def test_sarif(evil: str) -> None:
    text = sarif_json(judged_of(evil), documentation="https://example.org")
    assert not hidden(text)
    assert json.loads(text)["runs"][0]["results"]


def test_policy_and_permissions(evil: str) -> None:
    network = network_of(evil)
    documents = [policy_xml(network, unknown="wildcard"), *policies(network).values(), *permissions(network).values()]
    assert len(documents) > 2
    for document in documents:
        assert not hidden(document)
        assert ElementTree.fromstring(document) is not None
        texts_of_xml(document)


def test_svg(evil: str) -> None:
    document = graph_svg(network_of(evil), system=True, types=True)
    assert not hidden(document)
    assert not [text for text in texts_of_xml(document) if hidden(text)]


def test_dot(evil: str) -> None:
    document = graph_dot(network_of(evil), system=True, types=True)
    assert not hidden(document)
    assert "URL=" not in re.sub(r'"(?:[^"\\]|\\.)*"', '""', document)
    if shutil.which("dot"):
        drawn = subprocess.run(["dot", "-Tsvg"], input=document.encode(), capture_output=True, check=True, timeout=60)
        assert not [text for text in texts_of_xml(drawn.stdout.decode()) if hidden(text)]


def test_mermaid(evil: str) -> None:
    document = graph_mermaid(network_of(evil), system=True)
    assert not hidden(document)
    assert fenced(document).count("```") == 2
    assert not re.search(r"^\s*(click|%%|call)", document, re.MULTILINE)


def test_html(evil: str) -> None:
    document = report_html(network_of(evil), Background(systems=systems_of(evil)))
    plain = _Page()
    plain.feed(report_html(network_of("other"), Background(systems=systems_of("other"))))
    page = _Page()
    page.feed(document)
    assert set(page.tags) <= set(plain.tags)
    assert page.tags.count("script") == plain.tags.count("script")
    assert not [text for text in page.texts if hidden(text, but="\n\t")]
    data = document_in(document)
    assert not hidden(data)
    assert json.loads(data)


def test_junit(evil: str) -> None:
    document = junit_xml(judged_of(evil))
    assert not hidden(document)
    assert not [text for text in texts_of_xml(document) if hidden(text)]


def test_github(evil: str) -> None:
    text = github_commands(judged_of(evil))
    assert not hidden(text)
    lines = text.splitlines()
    assert len(lines) == len(judged_of(evil))
    assert all(re.match(r"::(error|warning|notice) [^\n]*::", line) for line in lines)


def test_terminal(evil: str) -> None:
    for text in (
        shown(evil),
        launch_tree_text(systems_of(evil), network_of(evil).findings),
        starts_text(network_of(evil)),
    ):
        assert not hidden(text)
        text.encode()


def test_both_lists_of_invisible_characters_agree() -> None:
    """That of Python, and that of the browser."""
    script = (
        Path(safe.__file__).parent.joinpath("outputs", "report", "assets", "js", "names.js").read_text(encoding="utf-8")
    )
    (pattern,) = re.findall(r"const HIDDEN =\s*/\[(.*)\]/gu;", script)
    pattern = re.sub(r"\\u\{([0-9a-f]+)\}", lambda m: f"\\U{int(m[1], 16):08x}", pattern)
    theirs, ours = re.compile(f"[{pattern}]"), re.compile(safe._CONTROL)
    differ = [
        f"U+{code:04X}"
        for code in range(sys.maxunicode + 1)
        if bool(theirs.match(chr(code))) != bool(ours.match(chr(code)))
    ]
    assert differ == []


def test_every_character_of_no_width_is_on_the_list() -> None:
    """Controls, formats, line separators and surrogates, as Unicode has them; a few formats are seen."""
    seen = {*range(0x600, 0x606), 0x6DD, 0x70F, 0x890, 0x891, 0x8E2, 0x110BD, 0x110CD, *range(0x13430, 0x13440)}
    missing = [
        f"U+{code:04X}"
        for code in range(sys.maxunicode + 1)
        if unicodedata.category(chr(code)) in ("Cc", "Cf", "Cs", "Zl", "Zp") and code not in seen
        if not re.match(safe._CONTROL, chr(code))
    ]
    assert missing == []
