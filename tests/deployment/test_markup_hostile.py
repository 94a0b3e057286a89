# SPDX-License-Identifier: Apache-2.0
"""Launch files that are broken or made to do harm end in one finding, soon."""

from __future__ import annotations

import time

import pytest

from rosward.deployment.markup.xml import read_xml
from rosward.deployment.markup.yaml_file import read_yaml

LAUGHS = (
    '<!DOCTYPE launch [<!ENTITY a "ha">'
    + "".join(f'<!ENTITY {b} "{f"&{a};" * 10}">' for a, b in zip("abcdefghi", "bcdefghij", strict=True))
    + ']><launch><node pkg="a" exec="b" name="&j;"/></launch>'
)

XML = {
    "nothing": ("", "no element found"),
    "no XML": ("launch:\n- node: {}", "syntax error"),
    "not closed": ("<launch><node>", "no element found"),
    "another root": ("<robot/>", "The root is <robot>"),
    "billion laughs": (LAUGHS, "document type"),
    "external entity": (
        '<!DOCTYPE launch [<!ENTITY a SYSTEM "file:///etc/passwd">]><launch>&a;</launch>',
        "document type",
    ),
    "external document type": ('<!DOCTYPE launch SYSTEM "http://localhost/a.dtd"><launch/>', "document type"),
    "undefined entity": ("<launch>&a;</launch>", "undefined entity"),
    "an attribute twice": ('<launch><log message="a" message="b"/></launch>', "duplicate attribute"),
    "nested without end": ("<launch>" + "<group>" * 100_000, "nested too deeply"),
    "too many tags": (f"<launch>{'<a/>' * 60_000}</launch>", "more than"),
    "too long": (f"<launch>{' ' * 2_000_000}</launch>", "longer than"),
    "a NUL": ("<launch>\0</launch>", "not well-formed"),
    "bytes that are no text": ("<launch>\udcff</launch>", "not UTF-8"),
}

YAML = {
    "nothing": ("", "not a mapping"),
    "a list": ("- launch: []", "not a mapping"),
    "a text": ("launch", "not a mapping"),
    "two roots": ("launch: []\nmore: []", "only key"),
    "another root": ("group: []", "only key"),
    "empty": ("launch:", "not a list of actions"),
    "not YAML": ("launch: [", "not YAML"),
    "a tab": ("launch:\n\t- log: {}", "not YAML"),
    "two documents": ("launch: []\n---\nlaunch: []", "not YAML"),
    "an object of Python": ("launch:\n- log: !!python/object/apply:os.system ['true']", "is not supported"),
    "an object as value": ("launch:\n- log: {message: !!python/name:os.system ''}", "is not supported"),
    "an object as key": ("launch:\n- log: {!!python/name:os.system '': a}", "is not supported"),
    "a tag of nobody": ("launch:\n- log: {message: !mine a}", "is not supported"),
    "no date": ("launch:\n- log: {message: 2024-99-99}", "is not a value"),
    "a key that is a list": ("launch:\n- log: {[a, b]: c}", "A key is not a scalar"),
    "nested without end": ("launch: " + "[" * 100_000, "nested too deeply"),
    "nested in blocks": ("launch:\n" + "\n".join(f"{'  ' * n}- group:" for n in range(500)), "nested too deeply"),
    "an alias of itself": ("launch: &a\n- group: *a", "nested too deeply"),
    "a merge of itself": ("launch:\n- log: &a\n    <<: *a", "nested too deeply"),
    "bomb of aliases": (
        "launch:\n"
        + "".join(
            f"- group: &g{n} [{', '.join([f'group: *g{n - 1}'] * 10 if n else ['log: {}'])}]\n" for n in range(9)
        ),
        "With its aliases it is too large",
    ),
    "bomb of merges": (
        "launch:\n- log: &m0 {message: a}\n"
        + "".join(f"- log: &m{n} {{<<: [{', '.join([f'*m{n - 1}'] * 20)}]}}\n" for n in range(1, 9)),
        "With its aliases it is too large",
    ),
    "a number without end": (f"launch:\n- log: {{message: {'9' * 100_000}}}", "too long"),
    "too long": (f"launch: []\n#{' ' * 500_000}", "longer than"),
    "too many nodes": (f"launch: [{'a, ' * 70_000}]", "too long"),
    "a NUL": ("launch: []\0", "not YAML"),
    "bytes that are no text": ("launch: [\udcff]", "not YAML"),
}


@pytest.mark.parametrize(("text", "why"), XML.values(), ids=XML)
def test_xml_that_cannot_be_read(text: str, why: str) -> None:
    began = time.process_time()
    description, findings = read_xml(text, "f.xml")
    assert [finding.code for finding in findings] == ["RW310"]
    assert why in findings[0].message
    assert description.actions == ()
    assert time.process_time() - began < 20


@pytest.mark.parametrize(("text", "why"), YAML.values(), ids=YAML)
def test_yaml_that_cannot_be_read(text: str, why: str) -> None:
    began = time.process_time()
    description, findings = read_yaml(text, "f.yaml")
    assert [finding.code for finding in findings] == ["RW310"]
    assert why in findings[0].message
    assert description.actions == ()
    assert time.process_time() - began < 20


def test_a_document_type_without_entities_is_harmless() -> None:
    assert read_xml("<!DOCTYPE launch><launch/>", "f.xml")[1] == ()


VALUES = {
    "an object": "!!python/object/apply:os.system ['true']",
    "an alias bomb": "[&a [x], &b [*a, *a], &c [*b, *b]]",
    "an alias of itself": "&amp;a [*a]",
    "brackets": "[" * 10_000,
    "a number": "9" * 10_000,
    "substitutions": "$(var " * 10_000,
    "quotes": "$(eval '" * 10_000,
    "backslashes": "\\" * 10_000 + "$(",
}


@pytest.mark.parametrize("value", VALUES.values(), ids=VALUES)
def test_a_value_that_does_harm_leaves_the_node(value: str) -> None:
    """The node stays, with whatever its parameter may be."""
    text = value.replace("&", "&amp;").replace("&amp;amp;", "&amp;").replace('"', "&quot;")
    description, findings = read_xml(
        f'<launch><node pkg="a" exec="b" args="$(var x)"><param name="p" value="{text}"/></node></launch>', "f.xml"
    )
    assert len(description.actions) == 1
    assert {finding.code for finding in findings} <= {"RW320"}


def test_what_is_refused_everywhere_is_told_to_a_limit() -> None:
    _, findings = read_xml("<launch>" + '<log message="a" b="c"/>' * 10_000 + "</launch>", "f.xml")
    assert len(findings) == 501
