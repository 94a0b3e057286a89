# SPDX-License-Identifier: Apache-2.0
"""What is read of a policy or of permissions: small documents, and the rights that they mean."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosward.policies.judge import Judge, Verdict
from rosward.policies.read import read_policy
from rosward.policies.records import Policy
from rosward.policies.rights import Direction, Right, rights_of
from rosward.ros.entities import EntityKind

POLICY = """<policy version="0.2.0" xmlns:xi="http://www.w3.org/2001/XInclude">
<enclaves><enclave path="/e"><profiles><profile ns="{ns}" node="n">
{rules}
</profile></profiles></enclave></enclaves></policy>
"""
GRANT = """<dds><permissions><grant name="g"><subject_name>{subject}</subject_name>
{rules}
<default>{default}</default></grant></permissions></dds>
"""


@pytest.fixture(autouse=True)
def in_a_folder_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each test runs in an empty folder."""
    monkeypatch.chdir(tmp_path)


def written(text: str, file: str = "policy.xml") -> str:
    Path(file).parent.mkdir(parents=True, exist_ok=True)
    Path(file).write_text(text, encoding="utf-8")
    return file


def policy(rules: str, ns: str = "/robot") -> Policy:
    return read_policy([written(POLICY.format(ns=ns, rules=rules))])


def names(found: Policy) -> list[str]:
    return [f"{'' if r.allow else 'deny '}{r}" for e in found.enclaves for r in e.rules]


def messages(found: Policy) -> list[str]:
    return [f"{f.place} {f.message}" for f in found.findings]


@pytest.mark.parametrize(
    ("ns", "text", "name"),
    [
        ("/robot", "/x", "/robot/x"),
        ("/robot", "x", "/robot/x"),
        ("/", "x", "/x"),
        ("/robot", "~/x", "/robot/n/x"),
        ("/robot", "~x", "/robot/nx"),  # as permissions.xsl does it
        ("/robot", " x ", "/robot/ x "),
    ],
)
def test_names_are_completed_as_sros2_does_it(ns: str, text: str, name: str) -> None:
    expected = text if text.startswith("/") else name
    assert names(policy(f'<topics publish="ALLOW"><topic>{text}</topic></topics>', ns)) == [
        f"topics publish {expected}"
    ]


def test_denials_come_first() -> None:
    found = policy(
        '<topics publish="ALLOW" subscribe="DENY"><topic>a</topic></topics><services reply="ALLOW"><service>s</service></services>'
    )
    assert names(found) == ["deny topics subscribe /robot/a", "topics publish /robot/a", "services reply /robot/s"]


def test_an_inclusion_stays_in_the_folder_of_the_policy() -> None:
    written('<profile><topics publish="ALLOW"><topic>/rosout</topic></topics></profile>', "p/common/node.xml")
    written("<profile/>", "secret.xml")
    include = '<xi:include href="{}" xpointer="xpointer(/profile/*)"/>'
    rules = "\n".join(map(include.format, ("common/node.xml", "../secret.xml", "http://localhost/x.xml", "no.xml")))
    found = read_policy([written(POLICY.format(ns="/", rules=rules), "p/policy.xml")])
    assert names(found) == ["topics publish /rosout"]
    assert messages(found) == [
        "p/policy.xml:4 '../secret.xml' is not a file in or below the folder of the policy. It was not read.",
        "p/policy.xml:5 'http://localhost/x.xml' is not a file in or below the folder of the policy. It was not read.",
        "p/no.xml The file cannot be read: No such file or directory.",
    ]


def test_a_file_that_includes_itself_ends() -> None:
    found = policy('<xi:include href="policy.xml" xpointer="xpointer(/policy/enclaves/enclave/profiles/profile/*)"/>')
    assert messages(found) == ["policy.xml:3 Inclusions are nested too deeply; this one was not read."]


def test_files_that_include_each_other_without_end_are_read_in_bounded_time() -> None:
    include = '<xi:include href="policy.xml" xpointer="xpointer(/policy/enclaves/enclave/profiles/profile/*)"/>\n'
    found = policy(include * 30)
    assert len(found.findings) <= 201
    assert "There are more than 200 inclusions; this one and those after it were not read." in [
        f.message for f in found.findings
    ]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("<policy", "policy.xml:1 The file is not well-formed XML: unclosed token."),
        ("", "policy.xml:1 The file is not well-formed XML: no element found."),
        (
            '<!DOCTYPE x [<!ENTITY a "a">]><policy/>',
            "policy.xml:1 The file has a document type declaration; entities are not supported.",
        ),
        ("<a>" * 100, "policy.xml:1 The file is nested too deeply."),
        ("<package/>", "policy.xml:1 <package> is neither an SROS2 policy (<policy>) nor DDS permissions (<dds>)."),
        ('<policy version="0.2.0"/>', "policy.xml:1 It has no enclave."),
        ('<policy version="0.1.0"/>', "policy.xml:1 This policy has version 0.1.0, but sros2 requires 0.2.0."),
        ("<dds/>", "policy.xml:1 It has no grant."),
        ("<policy>" + "<a/>" * 20_001, "policy.xml:1 The policy has more than 20,000 elements."),
    ],
)
def test_what_is_no_policy_is_told(text: str, message: str) -> None:
    assert messages(read_policy([written(text)])) == [message]


@pytest.mark.parametrize(
    ("rules", "message"),
    [
        ('<topics publish="allow"/>', 'policy.xml:3 publish="allow" has no meaning for <topics>.'),
        ('<topics reply="ALLOW"/>', 'policy.xml:3 reply="ALLOW" has no meaning for <topics>.'),
        ("<topic>x</topic>", "policy.xml:3 <topic> is not allowed in <profile>: sros2 rejects the policy."),
        (
            '<topics publish="ALLOW"><topic>/[[:alpha:]]</topic></topics>',
            "policy.xml:3 The character class in /[[:alpha:]] could not be parsed.",
        ),
        (
            f'<topics publish="ALLOW"><topic>/{"x" * 600}</topic></topics>',
            "policy.xml:3 A name of more than 512 characters matches nothing on DDS.",
        ),
    ],
)
def test_a_rule_that_means_nothing_is_told(rules: str, message: str) -> None:
    assert messages(policy(rules)) == [message]


def test_rules_that_sros2_loses_are_told() -> None:
    text = '<policy version="0.2.0"><enclaves><enclave path="/e"><profiles/><profiles/></enclave>\n<enclave path="/e"/></enclaves></policy>'
    assert messages(read_policy([written(text)])) == [
        "policy.xml:1 Enclave /e already has <profiles>; DDS uses the first ones and ignores these.",
        "policy.xml:2 Enclave /e is already defined; sros2 uses the first one and ignores the rules here.",
    ]


def test_of_permissions_the_first_rule_that_matches_decides() -> None:
    rules = """<allow_rule><domains><id>0</id></domains><publish><topics><topic>rt/a</topic></topics></publish></allow_rule>
<deny_rule><domains><id>5</id></domains><publish><partitions><partition>p</partition></partitions><topics><topic>rt/*</topic></topics></publish></deny_rule>
<allow_rule><domains><id>0</id></domains><publish><topics><topic>rt/b</topic></topics></publish></allow_rule>"""
    found = read_policy([written(GRANT.format(subject="CN=/e", rules=rules, default="ALLOW"))])
    judge = Judge(found.enclaves[0])
    verdicts = {n: judge(Right(Direction.PUBLISH, n)).verdict for n in ("rt/a", "rt/b", "rq/x", "rt/*", "r*")}
    assert verdicts == {
        "rt/a": Verdict.ALLOWED,
        "rt/b": Verdict.REFUSED,
        "rq/x": Verdict.ALLOWED,
        "rt/*": Verdict.IN_PART,
        "r*": Verdict.IN_PART,
    }
    assert found.notes == ("policy.xml:3: domains were not compared: 5", "policy.xml:3: partitions were not compared")


@pytest.mark.parametrize(
    ("subject", "paths"), [("CN=/e", ["/e"]), ("C=DE, CN=/a/b", ["/a/b"]), ("/CN=/e", ["/e"]), ("O=x", [])]
)
def test_the_enclave_of_a_grant_is_its_subject(subject: str, paths: list[str]) -> None:
    found = read_policy([written(GRANT.format(subject=subject, rules="", default="DENY"))])
    assert [e.path for e in found.enclaves] == paths
    assert bool(found.findings) is not bool(paths)


def test_several_files_say_it_together() -> None:
    one = written(POLICY.format(ns="/", rules='<topics publish="ALLOW"><topic>a</topic></topics>'), "one.xml")
    two = written(POLICY.format(ns="/", rules='<topics publish="DENY"><topic>b</topic></topics>'), "two.xml")
    found = read_policy([one, two])
    assert names(found) == ["deny topics publish /b", "topics publish /a"]
    assert [e.profiles for e in found.enclaves] == [("/n", "/n")]


def test_an_action_is_three_services_and_two_topics() -> None:
    server = {str(r) for r in rights_of(EntityKind.ACTION_SERVER, "/a")}
    client = {str(r) for r in rights_of(EntityKind.ACTION_CLIENT, "/a")}
    assert len(server) == len(client) == 8
    assert {"subscribe rq/a/_action/send_goalRequest", "publish rt/a/_action/feedback"} < server
    assert {"publish rq/a/_action/send_goalRequest", "subscribe rt/a/_action/status"} < client
