# SPDX-License-Identifier: Apache-2.0
"""`rosward check`: a policy that is exactly right is clean, and each change to it is one finding."""

from __future__ import annotations

import json
import re
import xml.etree.ElementTree as ET
from importlib import resources
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from rosward.cli import main

NODE = """\
import rclpy
from rclpy.action import ActionServer
from rclpy.node import Node
from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from std_msgs.msg import String

rclpy.init()
node = Node("talker", namespace="robot")
node.create_publisher(String, "chatter", 10)
node.create_client(AddTwoInts, "add")
ActionServer(node, Fibonacci, "fib", None)
node.declare_parameter("arm", rclpy.Parameter.Type.STRING)
node.create_subscription(String, node.get_parameter("arm").value + "/state", None, 10)
rclpy.spin(node)
"""
SCHEMA = jsonschema.Draft202012Validator(
    json.loads((resources.files("rosward.outputs") / "schemas" / "check.schema.json").read_text())
)
RULE = re.compile(r" *<(topic|service|action)>(.*)</\1>.*\n")


@pytest.fixture(autouse=True)
def policy(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """A program, and the policy that is written for it."""
    monkeypatch.chdir(tmp_path)
    Path("src").mkdir()
    Path("src/talker.py").write_text(NODE, encoding="utf-8")
    assert main(["extract", "src", "-q", "--format", "policy,permissions", "-o", "."]) == 0
    return Path("policy.xml").read_text(encoding="utf-8")


def checked(text: str, capsys: pytest.CaptureFixture[str], *options: str) -> tuple[int, list[str]]:
    """The exit status, and each finding as `code file right`."""
    Path("policy.xml").write_text(text, encoding="utf-8")
    status = main(["check", "policy.xml", "src", "--format", "json", *options])
    document = json.loads(capsys.readouterr().out)
    SCHEMA.validate(document)
    assert document["clean"] is (status == 0)
    found = [f for e in document["enclaves"] for f in e["findings"]]
    return status, [
        f"{f['code']} {f['file']} {f.get('right')}" for f in [*found, *document["policy"]]
    ] if status else []


def test_the_policy_of_the_same_sources_is_clean(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", "policy.xml", "src"]) == 0
    assert capsys.readouterr().out == "Clean: 1 enclave allows its process exactly what the code does.\n"
    assert main(["check", "permissions/robot/talker/permissions.xml", "src"]) == 0


def test_each_rule_that_is_taken_away_is_one_finding(policy: str, capsys: pytest.CaptureFixture[str]) -> None:
    rules = list(RULE.finditer(policy))
    assert len(rules) == 13
    for rule in rules:
        status, found = checked(policy[: rule.start()] + policy[rule.end() :], capsys)
        assert status == 1
        assert len(found) == 1
        assert found[0].startswith("RW401 talker.py ")
        assert found[0].endswith(f" {rule[2]}")


def test_each_line_of_permissions_that_is_taken_away_is_one_finding(capsys: pytest.CaptureFixture[str]) -> None:
    text = Path("permissions/robot/talker/permissions.xml").read_text(encoding="utf-8")
    rules = list(RULE.finditer(text))
    assert len(rules) > 20
    for rule in rules:
        status, found = checked(text[: rule.start()] + text[rule.end() :], capsys)
        assert (status, [f[:5] for f in found]) == (1, ["RW401"])


@pytest.mark.parametrize("attribute", ["publish", "subscribe"])
def test_a_rule_that_is_added_is_one_finding(attribute: str, policy: str, capsys: pytest.CaptureFixture[str]) -> None:
    extra = f'<topics {attribute}="ALLOW"><topic>/extra</topic></topics></profile>'
    changed = policy.replace("</profile>", extra)
    expected = f"RW402 policy.xml topics {attribute} /extra"
    # a name that ends in /state is subscribed to: /extra cannot be it, /left/state can
    assert checked(changed, capsys) == (1, [expected])
    assert checked(changed.replace("/extra", "/robot/left/state"), capsys)[0] == (attribute == "publish")


def test_a_rule_that_is_too_wide_is_told(policy: str, capsys: pytest.CaptureFixture[str]) -> None:
    changed = policy.replace("<topic>/robot/chatter<", "<topic>/robot/*<")
    assert checked(changed, capsys) == (1, ["RW402 policy.xml topics publish /robot/*"])
    assert main(["check", "policy.xml", "src"]) == 1
    assert "allows more than is used: publisher /robot/chatter" in capsys.readouterr().out.replace(
        "action server /robot/fib, ", ""
    )


def test_part_of_a_pattern_is_not_all_of_it(policy: str, capsys: pytest.CaptureFixture[str]) -> None:
    pattern = next(m[2] for m in RULE.finditer(policy) if "*" in m[2])
    status, found = checked(policy.replace(f">{pattern}<", ">/robot/left/state<"), capsys)
    assert (status, found) == (1, [f"RW401 talker.py subscription {pattern}"])
    main(["check", "policy.xml", "src"])
    assert "may be missing" in capsys.readouterr().out


def test_what_is_denied_is_lacking(policy: str, capsys: pytest.CaptureFixture[str]) -> None:
    changed = policy.replace("</profile>", '<topics publish="DENY"><topic>chatter</topic></topics></profile>')
    assert checked(changed, capsys) == (1, ["RW401 talker.py publisher /robot/chatter"])
    main(["check", "policy.xml", "src"])
    assert "denied by topics publish /robot/chatter (policy.xml:" in capsys.readouterr().out


def test_enclaves_are_compared_too(policy: str, capsys: pytest.CaptureFixture[str]) -> None:
    changed = policy.replace('path="/robot/talker"', 'path="/other"')
    assert checked(changed, capsys) == (1, ["RW404 policy.xml None", "RW405 talker.py None"])


def test_a_policy_that_cannot_be_read_is_a_finding(capsys: pytest.CaptureFixture[str]) -> None:
    assert checked("<policy", capsys) == (1, ["RW403 policy.xml None"])


def test_what_is_not_known_of_the_code_is_never_clean(policy: str, capsys: pytest.CaptureFixture[str]) -> None:
    Path("src/talker.py").write_text(NODE.replace('"chatter"', "input()"), encoding="utf-8")
    status, found = checked(policy, capsys)
    assert (status, found) == (1, [])
    main(["check", "policy.xml", "src"])
    told = capsys.readouterr().out
    assert "RW101 talker.py" in told
    assert "No difference as far as the code is known: 1 open question about the code" in told


@pytest.mark.parametrize("arguments", [["src"], ["missing.xml", "src"], ["policy.xml", "missing"]])
def test_wrong_use_is_status_2(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", *arguments]) == 2
    assert capsys.readouterr().err.startswith("rosward: ")


def test_an_enclave_that_is_known_in_part_may_be_any_that_matches(
    policy: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """`--enclaves node`: the enclave is the name of the node, which depends on a parameter that nobody has set."""
    code = NODE.replace('namespace="robot"', 'namespace=open("x").read()')
    Path("src/talker.py").write_text(code, encoding="utf-8")
    found = checked(policy, capsys)[1]
    assert found
    assert not [f for f in found if f.startswith(("RW404", "RW405"))]
    assert checked(policy.replace("/talker", "/listener"), capsys)[1] == [
        "RW404 policy.xml None",
        "RW405 talker.py None",
    ]


# Outputs for machines, comments, baseline


def broken(policy: str) -> None:
    """The right to /robot/chatter is taken away, that to /extra is too much."""
    text = policy.replace("<topic>/robot/chatter</topic>", "<topic>/extra</topic>")
    Path("policy.xml").write_text(text, encoding="utf-8")


def results(capsys: pytest.CaptureFixture[str], *options: str) -> list[dict[str, Any]]:
    capsys.readouterr()
    main(["check", "policy.xml", "src", "--format", "sarif", *options])
    found: list[dict[str, Any]] = json.loads(capsys.readouterr().out)["runs"][0]["results"]
    return found


def at(location: dict[str, Any]) -> str:
    physical = location["physicalLocation"]
    return f"{physical['artifactLocation']['uri']}:{physical['region']['startLine']}"


def test_sarif_has_the_place_in_the_policy_and_the_place_in_the_source(
    policy: str, capsys: pytest.CaptureFixture[str]
) -> None:
    Path(".git").mkdir()
    broken(policy)
    line = next(n for n, text in enumerate(policy.splitlines(), 1) if "/robot/chatter" in text)
    enclave = next(n for n, text in enumerate(policy.splitlines(), 1) if "<enclave " in text)
    lacking, extra = sorted(results(capsys), key=lambda r: str(r["ruleId"]))
    assert (lacking["ruleId"], extra["ruleId"]) == ("RW401", "RW402")
    places = {
        r["ruleId"]: [at(p) for key in ("locations", "relatedLocations") for p in r[key]] for r in (lacking, extra)
    }
    assert places == {
        "RW401": ["src/talker.py:10", f"policy.xml:{enclave}"],
        "RW402": [f"policy.xml:{line}", "src/talker.py:9"],
    }


def test_fingerprints_stay_when_lines_move(policy: str, capsys: pytest.CaptureFixture[str]) -> None:
    broken(policy)
    before = {str(r["partialFingerprints"]) for r in results(capsys)}
    Path("src/talker.py").write_text("# moved\n" + NODE, encoding="utf-8")
    Path("policy.xml").write_text(
        Path("policy.xml").read_text(encoding="utf-8").replace("<enclaves>", "\n<enclaves>"), encoding="utf-8"
    )
    assert {str(r["partialFingerprints"]) for r in results(capsys)} == before


def test_junit_and_github(policy: str, capsys: pytest.CaptureFixture[str]) -> None:
    broken(policy)
    assert main(["check", "policy.xml", "src", "--format", "junit", "-o", "out/check.xml"]) == 1
    assert capsys.readouterr().out == ""
    names = [case.get("name") for case in ET.parse("out/check.xml").iter("testcase")]
    assert [str(n)[:5] for n in names] == ["RW402", "RW401"]
    assert main(["check", "policy.xml", "src", "--format", "github"]) == 1
    out = capsys.readouterr().out.splitlines()
    assert out[0].startswith("::error file=talker.py,line=10,col=1,title=RW401 ")
    assert out[1].startswith("::warning file=policy.xml,line=")


def test_comments_in_code_and_policy_count(policy: str, capsys: pytest.CaptureFixture[str]) -> None:
    """A right that lacks is an error, so its code has to be accepted, too."""
    broken(policy)
    text = Path("policy.xml").read_text(encoding="utf-8")
    Path("policy.xml").write_text(
        text.replace("/extra</topic>", "/extra</topic> <!-- rosward: ignore[RW402] -->"), encoding="utf-8"
    )
    Path("src/talker.py").write_text(
        NODE.replace('"chatter", 10)', '"chatter", 10)  # rosward: ignore[RW401]'), encoding="utf-8"
    )
    assert main(["check", "policy.xml", "src"]) == 1
    assert capsys.readouterr().out.endswith("\n1 missing permission, 1 ignored.\n")
    Path("rosward.toml").write_text('accepted = ["RW401"]\n', encoding="utf-8")
    assert main(["check", "policy.xml", "src"]) == 0
    assert capsys.readouterr().out.endswith("exactly what the code does, 2 ignored.\n")


def test_a_baseline(policy: str, capsys: pytest.CaptureFixture[str]) -> None:
    broken(policy)
    assert main(["check", "policy.xml", "src", "--write-baseline", "known.json"]) == 1
    assert main(["check", "policy.xml", "src", "--baseline", "known.json"]) == 0
    assert capsys.readouterr().out.endswith("Nothing new: 2 in the baseline.\n")
    Path("policy.xml").write_text(policy.replace("<topic>/robot/chatter</topic>", ""), encoding="utf-8")
    assert main(["check", "policy.xml", "src", "--baseline", "known.json"]) == 0
    Path("policy.xml").write_text(policy.replace("<topic>/rosout</topic>", ""), encoding="utf-8")
    assert main(["check", "policy.xml", "src", "--baseline", "known.json"]) == 1
