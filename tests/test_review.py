# SPDX-License-Identifier: Apache-2.0
"""Ignore comments are comments, and fingerprints stay when lines move."""

from __future__ import annotations

import time

import pytest

from rosward.findings import Finding
from rosward.location import Place
from rosward.suppression.comments import ignore_comments
from rosward.suppression.fingerprints import fingerprints


def found(text: str, suffix: str = ".py") -> list[tuple[tuple[int, ...], tuple[str, ...] | None]]:
    return [(c.lines, c.codes) for c in ignore_comments(text, suffix)]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("x = 1  # rosward: ignore[RW102]\n", [((1,), ("RW102",))]),
        ("x = 1  # rosward:ignore [ RW102 , RW104 ] why\n", [((1,), ("RW102", "RW104"))]),
        ("x = 1  # rosward: ignore\n", [((1,), None)]),
        ("x = 1  # noqa: E501  # rosward: ignore[RW102]\n", [((1,), ("RW102",))]),
        ("if x:\n    # rosward: ignore[RW102]\n    y()\n", [((2, 3), ("RW102",))]),
        ("x = 1  # rosward: ignore[]\n", [((1,), ())]),
        ("x = 1  # rosward: ignore[RW102\n", [((1,), ())]),
        ("x = '# rosward: ignore[RW102]'\n", []),
        ('"""\n# rosward: ignore\n"""\n', []),
        ("x = f'# rosward: ignore {x}'\n", []),
        ("x = 1  # rosward: ignored\n", []),
        ("x = 1  # see rosward: ignore[RW102]\n", []),
        ("x = 1  # rosward: ignore\ny = (\n", [((1,), None)]),
        ("x = '''\n'''  # rosward: ignore\n", [((2,), None)]),
    ],
)
def test_in_python(text: str, expected: object) -> None:
    assert found(text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("<l>\n<!-- rosward: ignore[RW311] -->\n<a/>\n</l>", [((2, 3), ("RW311",))]),
        ("<l>\n<a/> <!-- rosward: ignore -->\n</l>", [((2,), None)]),
        ("<l>\n<!--\n rosward: ignore[RW311]\n-->\n<a/></l>", [((2, 4, 5), ("RW311",))]),
        ("<l>\n<!-- rosward: ignore --> <a/>\n</l>", [((2,), None)]),
        ("<l>\n<![CDATA[<!-- rosward: ignore -->]]></l>", []),
        ("<l><!-- <![CDATA[ -->\n<!-- rosward: ignore -->\n</l>", [((2, 3), None)]),
        ("<l>\n<!-- rosward: ignore", []),
        ("<l a='# rosward: ignore'/>", []),
    ],
)
def test_in_xml(text: str, expected: object) -> None:
    assert found(text, ".xml") == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("- node:  # rosward: ignore[RW314]\n    pkg: a\n", [((1,), ("RW314",))]),
        ("# rosward: ignore\n- a: b\n", [((1, 2), None)]),
        ("a: '# rosward: ignore'  # rosward: ignore[RW314]\n", [((1,), ("RW314",))]),
        ("a: 'x # rosward: ignore'\n", []),
        ("a: |\n  # rosward: ignore\n  x\nb: 1\n", []),
        ("a: b#rosward: ignore\n", []),
    ],
)
def test_in_yaml(text: str, expected: object) -> None:
    assert found(text, ".yaml") == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("f();  // rosward: ignore[RW102]\n", [((1,), ("RW102",))]),
        ("  // rosward: ignore\nf();\n", [((1, 2), None)]),
        ("f();\n/* rosward: ignore[RW101]\n */\ng();\n", [((2, 3, 4), ("RW101",))]),
        ('auto s = "// rosward: ignore";\n', []),
        ('auto s = R"x(\n// rosward: ignore\n)x";  // rosward: ignore\n', [((3,), None)]),
        ("char c = '\"';  // rosward: ignore\n", [((1,), None)]),
        ("// see rosward: ignore\n", []),
    ],
)
def test_in_cpp(text: str, expected: object) -> None:
    assert found(text, ".cpp") == expected


@pytest.mark.parametrize(
    ("text", "suffix"),
    [
        ("/*" * 300_000 + "rosward:", ".cpp"),
        ('R"(' * 300_000 + "rosward:", ".hpp"),
        ('"' + '\\"' * 300_000 + "rosward:", ".cpp"),
        ("<!-- rosward: ignore -->" * 60_000, ".xml"),
        ("<!--" * 300_000 + "rosward:", ".xml"),
        ("<![CDATA[" * 100_000 + "rosward: -->", ".xml"),
        ("x # rosward: ignore\n" * 50_000, ".py"),
        ("# rosward: ignore[" * 50_000, ".py"),
        ("# rosward: ignore[" * 50_000, ".yaml"),
        ("[" + '"a # ", ' * 4_000 + "] # rosward: ignore", ".yaml"),
        ("[" * 5_000 + "# rosward: ignore", ".yaml"),
    ],
)
def test_hostile_text_takes_no_time(text: str, suffix: str) -> None:
    start = time.process_time()
    ignore_comments(text, suffix)
    assert time.process_time() - start < 10


def test_a_fingerprint_stays_when_lines_move_and_indentation_changes() -> None:
    before = {("a.py", 3): "publish(x)"}
    after = {("a.py", 9): "    publish(x)  "}
    old = Finding("RW102", "'x' of a.py:1 is not known, see line 2", Place("a.py", 3))
    new = Finding("RW102", "'x' of a.py:7 is not known, see line 8", Place("a.py", 9))
    assert fingerprints([old], lambda f, n: before[f, n]) == fingerprints([new], lambda f, n: after[f, n])


def test_a_fingerprint_does_not_depend_on_the_folder_that_is_analysed() -> None:
    near = Finding("RW102", "'x' of demo/a.py:1 is not known", Place("demo/a.py", 3))
    far = Finding("RW102", "'x' of src/demo/a.py:1 is not known", Place("src/demo/a.py", 3))
    assert fingerprints([near], lambda _f, _n: "x", "src/") == fingerprints([far], lambda _f, _n: "x")


def test_a_long_message_takes_no_time() -> None:
    start = time.process_time()
    for text in ("a" * 200_000, "a/" * 100_000, ("a/" * 50 + ":") * 2_000, ":1" * 100_000):
        fingerprints([Finding("RW102", text, Place("a.py"))], lambda _f, _n: "")
    assert time.process_time() - start < 5


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("the name of this publisher is only known as /r_*", "/r_* is all that is known of the name of this publisher"),
        ("'a b' is no valid name: try --arg a:=b", "not a valid name, 'a b', set a:=b"),
        ("`ros2 run x` is started, whose interface is not known", "`ros2 run x` has an unknown interface"),
        ("Broadcaster /tf of TransformBroadcaster", "TransformBroadcaster creates /tf"),
    ],
)
def test_a_fingerprint_does_not_depend_on_the_words_of_a_message(old: str, new: str) -> None:
    marks = [fingerprints([Finding("RW102", text, Place("a.py", 3))], lambda _f, _n: "x") for text in (old, new)]
    assert marks[0] == marks[1]


@pytest.mark.parametrize(
    "other", ["this publisher is /b", "this subscription is /a", "'this' publisher is /a", "publisher /a 2"]
)
def test_a_fingerprint_depends_on_what_a_message_names(other: str) -> None:
    texts = ("this publisher is /a", other)
    marks = [fingerprints([Finding("RW102", text, Place("a.py", 3))], lambda _f, _n: "x") for text in texts]
    assert marks[0] != marks[1]


def test_a_fingerprint_tells_code_file_line_names_and_occurrence_apart() -> None:
    findings = [
        Finding("RW102", "of '/m'", Place("a.py", 1)),
        Finding("RW102", "of '/m'", Place("a.py", 2)),
        Finding("RW104", "of '/m'", Place("a.py", 1)),
        Finding("RW102", "of '/n'", Place("a.py", 1)),
        Finding("RW102", "of '/m'", Place("b.py", 1)),
    ]
    marks = fingerprints(findings, lambda _f, _n: "same")
    assert len(set(marks)) == len(findings)
    assert fingerprints(findings[:1], lambda _f, _n: "same", "src/") != marks[:1]
    assert fingerprints(findings[:1], lambda _f, _n: "other") != marks[:1]
