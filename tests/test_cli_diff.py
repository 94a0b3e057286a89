# SPDX-License-Identifier: Apache-2.0
"""`rosward diff`: what came and went, in three forms, and what fails the build."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from rosward.cli import main

NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node("talker")
node.create_publisher(String, {name}, 10)
rclpy.spin(node)
"""
POLICY = """<policy version="0.2.0"><enclaves><enclave path="/e"><profiles><profile ns="/" node="n">
{rules}
</profile></profiles></enclave></enclaves></policy>
"""


@pytest.fixture(autouse=True)
def in_a_folder_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each test runs in an empty folder."""
    monkeypatch.chdir(tmp_path)


def network(folder: str, name: str) -> str:
    Path(folder).mkdir()
    Path(folder, "talker.py").write_text(NODE.format(name=name), encoding="utf-8")
    main(["extract", folder, "-q", "--format", "json,policy", "-o", folder])
    return f"{folder}/network.json"


def policy(file: str, *rules: tuple[str, str, str]) -> str:
    """A policy of rules on topics: attribute, value, name."""
    text = "\n".join(f'<topics {a}="{v}"><topic>{n}</topic></topics>' for a, v, n in rules)
    Path(file).write_text(POLICY.format(rules=text), encoding="utf-8")
    return file


def rights(old: str, new: str, capsys: pytest.CaptureFixture[str]) -> tuple[list[str], list[str]]:
    capsys.readouterr()
    status = main(["diff", old, new, "--format", "json", "--fail-on", "new-rights"])
    found = json.loads(capsys.readouterr().out)["rights"]
    assert status == bool(found["gained"])
    gained, lost = ([f"{r['words']} {r['name']}" for r in found[k]] for k in ("gained", "lost"))
    return gained, lost


def test_two_networks_as_text(capsys: pytest.CaptureFixture[str]) -> None:
    old, new = network("old", '"chatter"'), network("new", '"status"')
    assert main(["diff", old, new]) == 0
    assert capsys.readouterr().out == (
        "entities gained: 1\n"
        "  + /talker: publisher /status (std_msgs/msg/String)\n"
        "entities lost: 1\n"
        "  - /talker: publisher /chatter (std_msgs/msg/String)\n"
        "permissions gained: 1\n"
        "  + /talker: publisher /status  (talker.py:7)\n"
        "permissions lost: 1\n"
        "  - /talker: publisher /chatter  (talker.py:7)\n"
    )
    assert main(["diff", old, new, "--fail-on", "new-rights"]) == 1
    assert main(["diff", old, old, "--fail-on", "new-rights"]) == 0


def test_two_networks_as_markdown(capsys: pytest.CaptureFixture[str]) -> None:
    old, new = network("old", '"chatter"'), network("new", '"status"')
    main(["diff", old, new, "--format", "markdown"])
    out = capsys.readouterr().out
    assert out.startswith(
        "**rosward:** 1 new permission, 1 permission removed, 1 new entity, 1 entity removed.\n\n"
        "| enclave | new permission | where |\n|---|---|---|\n| `/talker` | publisher `/status` | `talker.py:7` |\n\n"
        "<details><summary>entities gained: 1</summary>\n\n- `/talker: publisher /status (std_msgs/msg/String)`\n\n</details>"
    )
    main(["diff", old, old, "--format", "markdown"])
    assert capsys.readouterr().out == "**rosward:** no change in nodes, entities or permissions.\n"


def test_a_name_that_became_unknown_is_a_new_right(capsys: pytest.CaptureFixture[str]) -> None:
    old, new = network("old", '"chatter"'), network("new", "input()")
    assert rights(old, new, capsys) == (["publisher /*"], [])
    assert rights(new, old, capsys) == ([], ["publisher /*"])


def test_two_policies_of_two_sources(capsys: pytest.CaptureFixture[str]) -> None:
    network("old", '"chatter"')
    network("new", '"status"')
    assert rights("old/policy.xml", "new/policy.xml", capsys) == (
        ["topics publish /status"],
        ["topics publish /chatter"],
    )


@pytest.mark.parametrize(
    ("old", "new", "gained", "lost"),
    [
        ([("publish", "ALLOW", "/a_*")], [("publish", "ALLOW", "/a_1")], [], ["/a_*"]),
        ([("publish", "ALLOW", "/a")], [("publish", "ALLOW", "~/../a")], ["/n/../a"], ["/a"]),
        # a denial that is taken away is a right gained; one that stays changes nothing
        ([("publish", "DENY", "/a_1"), ("publish", "ALLOW", "/a_*")], [("publish", "ALLOW", "/a_*")], ["/a_*"], []),
        (
            [("publish", "DENY", "/a_1"), ("publish", "ALLOW", "/a_*")],
            [("publish", "DENY", "/a_1"), ("publish", "ALLOW", "/a_*"), ("publish", "ALLOW", "/b")],
            ["/b"],
            [],
        ),
        ([("publish", "ALLOW", "/a")], [("publish", "DENY", "/a"), ("publish", "ALLOW", "/a")], [], ["/a"]),
    ],
)
def test_rights_are_compared_by_what_they_allow(
    old: list[tuple[str, str, str]],
    new: list[tuple[str, str, str]],
    gained: list[str],
    lost: list[str],
    capsys: pytest.CaptureFixture[str],
) -> None:
    found = rights(policy("old.xml", *old), policy("new.xml", *new), capsys)
    assert found == ([f"topics publish {n}" for n in gained], [f"topics publish {n}" for n in lost])


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "not valid JSON"),
        ("[" * 100_000, "not valid JSON"),
        ("[]", "the document must be an object"),
        ('{"schema_version": 3}', "schema_version must be 1 or 2"),
        ('{"schema_version": true}', "schema_version must be 1 or 2"),
        ('{"schema_version": 1}', "the document.distro must be a string"),
        ('{"schema_version": 1, "distro": "jazzy"}', "the document.nodes must be a list"),
        ('{"schema_version": 1, "distro": "jazzy", "nodes": [3]}', "nodes[0] must be an object"),
        ("<policy", "not well-formed"),
        ("<x/>", "neither an SROS2 policy"),
    ],
)
def test_what_cannot_be_read_is_status_2(text: str, message: str, capsys: pytest.CaptureFixture[str]) -> None:
    Path("bad").write_text(text, encoding="utf-8")
    assert main(["diff", "bad", "bad"]) == 2
    assert message in capsys.readouterr().err


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"enclave": 3}, "nodes[0].enclave must be a string"),
        ({"publishers": None}, "nodes[0].publishers must be a list"),
        ({"publishers": [{"name": "x"}]}, "nodes[0].publishers[0].resolution must be a string"),
        ({"defined_at": {"file": "a.py", "line": -1}}, "nodes[0].defined_at.line must be a non-negative integer"),
    ],
)
def test_a_node_of_another_form_is_refused(
    change: dict[str, object], message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    file = Path(network("old", '"chatter"'))
    document = json.loads(file.read_text(encoding="utf-8"))
    document["nodes"][0].update(change)
    Path("bad").write_text(json.dumps(document), encoding="utf-8")
    assert main(["diff", str(file), "bad"]) == 2
    assert message in capsys.readouterr().err


def test_a_name_that_no_topic_has_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    file = Path(network("old", '"chatter"'))
    document = json.loads(file.read_text(encoding="utf-8"))
    document["nodes"][0]["publishers"][0]["name"] = "/[a-z]"
    Path("bad").write_text(json.dumps(document), encoding="utf-8")
    assert main(["diff", str(file), "bad"]) == 2
    assert "'/[a-z]' is not a full name" in capsys.readouterr().err


def test_a_network_and_a_policy_are_not_compared(capsys: pytest.CaptureFixture[str]) -> None:
    new = network("new", '"status"')
    assert main(["diff", policy("old.xml", ("publish", "ALLOW", "/a")), new]) == 2
    assert "both must be of the same kind" in capsys.readouterr().err
    assert main(["diff", "missing.json", new]) == 2


def test_a_network_of_too_many_patterns_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    old = Path(network("old", '"chatter"'))
    document = json.loads(old.read_text(encoding="utf-8"))
    one = document["nodes"][0]["publishers"][0]
    document["nodes"][0]["publishers"] = [{**one, "name": f"/*{n}", "resolution": "pattern"} for n in range(2_000)]
    Path("new.json").write_text(json.dumps(document), encoding="utf-8")
    assert main(["diff", str(old), "new.json"]) == 2
    assert "more than 1,000 names with a wildcard" in capsys.readouterr().err
