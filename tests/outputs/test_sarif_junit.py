# SPDX-License-Identifier: Apache-2.0
"""The findings for code scanning: SARIF that its schema accepts, JUnit XML that parses, whatever a message or a file name holds."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any, Final
from xml.etree import ElementTree

import jsonschema
import pytest

from rosward.findings import Finding
from rosward.location import Place
from rosward.outputs.documents.junit import junit_xml
from rosward.outputs.documents.sarif import sarif_json
from rosward.rules import RULES
from rosward.suppression.judge import Judged

SCHEMA: Final = Path(__file__).parent / "schemas" / "sarif-2.1.0.schema.json"
GUIDE: Final = Path(__file__).parent.parent.parent / "docs" / "findings.md"
ADDRESS: Final = "https://docs.example.org/findings"


def judged(code: str, file: str, line: int = 0, message: str = "m", *, known: bool = False) -> Judged:
    return Judged(Finding(code, message, Place(file, line, 5)), f"{code}{file}{line}", file, known)


def sarif(*findings: Judged, baseline: bool = False) -> dict[str, Any]:
    text = sarif_json(findings, baseline=baseline, documentation=ADDRESS)
    text.encode("utf-8")
    document = json.loads(text)
    jsonschema.Draft4Validator(json.loads(SCHEMA.read_text(encoding="utf-8"))).validate(document)
    run = document["runs"][0]
    assert isinstance(run, dict)
    return run


def test_a_finding_is_a_result_with_rule_level_place_and_fingerprint() -> None:
    run = sarif(judged("RW102", "src/talker.py", 20, "'a' is not known"))
    assert run["results"] == [
        {
            "ruleId": "RW102",
            "ruleIndex": list(RULES).index("RW102"),
            "level": "warning",
            "message": {"text": "'a' is not known"},
            "locations": [
                {
                    "physicalLocation": {
                        "artifactLocation": {"uri": "src/talker.py", "uriBaseId": "SRCROOT"},
                        "region": {"startLine": 20, "startColumn": 5},
                    }
                }
            ],
            "partialFingerprints": {"roswardFinding/v2": "RW102src/talker.py20"},
        }
    ]
    rule = run["tool"]["driver"]["rules"][run["results"][0]["ruleIndex"]]
    assert (rule["id"], rule["defaultConfiguration"]) == ("RW102", {"level": "warning"})


def test_without_a_finding_it_is_valid_too() -> None:
    assert sarif()["results"] == []


def test_what_has_no_file_is_a_notification_of_the_run() -> None:
    run = sarif(judged("RW007", "", 0, "No node was found."))
    assert run["results"] == []
    (notification,) = run["invocations"][0]["toolExecutionNotifications"]
    assert notification == {
        "level": "warning",
        "message": {"text": "No node was found."},
        "descriptor": {"id": "RW007"},
    }


@pytest.mark.parametrize(
    ("file", "uri"),
    [
        ("a b/c#d.py", "a%20b/c%23d.py"),
        ("ü.py", "%C3%BC.py"),
        ("a:b.py", "a%3Ab.py"),
        ("100%.py", "100%25.py"),
        ("\ud800.py", "%5Cud800.py"),
    ],
)
def test_paths_are_percent_encoded(file: str, uri: str) -> None:
    place = sarif(judged("RW001", file))["results"][0]["locations"][0]["physicalLocation"]
    assert place["artifactLocation"]["uri"] == uri
    assert place["region"] == {"startLine": 1}


def test_with_a_baseline_each_result_says_whether_it_is_in_it() -> None:
    run = sarif(judged("RW102", "a.py", 1), judged("RW102", "b.py", 1, known=True), baseline=True)
    assert [r["baselineState"] for r in run["results"]] == ["new", "unchanged"]


def test_every_rule_is_explained_where_its_address_points_to() -> None:
    """The page has one anchor and one heading for each rule, with its severity and help: a new rule needs its section."""
    guide = GUIDE.read_text(encoding="utf-8")
    anchors = re.findall(r'<a id="(\w+)"></a>', guide)
    rules = sarif()["tool"]["driver"]["rules"]
    assert [r["helpUri"] for r in rules] == [f"{ADDRESS}#{anchor}" for anchor in anchors]
    for rule in RULES.values():
        section = f"#### {rule.code}: {rule.title}\n\n{rule.severity.value.capitalize()}. {rule.help}\n"
        assert section in guide, rule.code


def test_without_an_address_there_is_no_link() -> None:
    driver = json.loads(sarif_json([]))["runs"][0]["tool"]["driver"]
    assert "informationUri" not in driver
    assert not any("helpUri" in rule for rule in driver["rules"])


def test_junit_has_a_case_for_each_rule_and_file() -> None:
    root = ElementTree.fromstring(
        junit_xml(
            [
                judged("RW102", "a.py", 3, "one"),
                judged("RW102", "a.py", 7, "two"),
                judged("RW205", "a.py", 9),
                judged("RW101", "b.py", 1, known=True),
            ]
        )
    )
    assert root.attrib == {"name": "rosward", "tests": "3", "failures": "1", "errors": "0", "skipped": "1"}
    cases = {(c.get("classname"), str(c.get("name"))[:5]): c[0] for c in root.iter("testcase")}
    assert cases["a.py", "RW102"].tag == "failure"
    assert cases["a.py", "RW102"].text == "a.py:3: one\na.py:7: two"
    assert cases["a.py", "RW205"].tag == "system-out"
    assert cases["b.py", "RW101"].tag == "skipped"


def test_junit_without_findings_has_a_case_that_passes() -> None:
    root = ElementTree.fromstring(junit_xml([]))
    assert (root.get("tests"), root.get("failures")) == ("1", "0")
    assert not list(root.iter("failure"))


def test_nothing_that_a_message_holds_breaks_either() -> None:
    message = 'a "quote" <tag> & \x00 \x1b[31m ]]> \ud800 \n next <failure '
    hostile = judged("RW102", 'x"<&>\x01.py', 2, message)
    assert sarif(hostile)["results"][0]["message"]["text"].startswith('a "quote"')
    root = ElementTree.fromstring(junit_xml([hostile]))
    assert root.get("failures") == "1"
    assert "\x1b" not in str(next(root.iter("failure")).text)
