# SPDX-License-Identifier: Apache-2.0
"""What do DDS permissions say?

    <grant><subject_name>CN=/talker</subject_name> <allow_rule> <publish> <topic>rt/chatter</topic>
      ->  EnclavePolicy("/talker", rules=(publish rt/chatter,))

The rules stay in their order. The first grant of a subject is the one that counts, as for Fast DDS. Domains, partitions, data tags and
validity are not compared, which is told.
"""

from __future__ import annotations

import re
from typing import Final

from rosward.findings import Finding
from rosward.policies.document import Element, elements
from rosward.policies.records import EnclavePolicy, PolicyRule
from rosward.policies.rights import Direction, Right

__all__ = ["read_permissions"]

_SUBJECT: Final = re.compile(r"(?:^|[,/])[^\S,/]*CN[^\S=]*=([^,]*)")
"""Nothing in it matches a text in two ways, so that no name takes long."""

_NOT_COMPARED: Final = {"partitions": "partitions", "data_tags": "data tags"}


def read_permissions(root: Element) -> tuple[list[EnclavePolicy], list[Finding], list[str]]:
    """The grants of a document `<dds>`, what is wrong in it, and what is not compared."""
    enclaves: dict[str, EnclavePolicy] = {}
    findings: list[Finding] = []
    notes: dict[str, None] = {}
    for grant in (g for p in elements(root, "permissions") for g in elements(p, "grant")):
        name = "".join(s.text for s in elements(grant, "subject_name"))
        subject = _SUBJECT.search(name)
        if subject is None:
            findings.append(
                Finding("RW403", f"The subject {name.strip()!r} does not name an enclave (CN=/…).", grant.place)
            )
        elif (path := subject[1].strip()) in enclaves:
            message = f"There is an earlier grant for {path}; DDS uses the first one and ignores this one."
            findings.append(Finding("RW403", message, grant.place))
        else:
            enclaves[path] = _enclave(path, grant, notes)
    if not enclaves and not findings:
        findings.append(Finding("RW403", "It has no grant.", root.place))
    return list(enclaves.values()), findings, list(notes)


def _enclave(path: str, grant: Element, notes: dict[str, None]) -> EnclavePolicy:
    rules: list[PolicyRule] = []
    for element in grant.children:
        if element.tag in ("allow_rule", "deny_rule"):
            rules += _rules(element, notes)
    default = "".join(e.text for e in elements(grant, "default")).strip()
    return EnclavePolicy(path, grant.place, tuple(rules), (), default == "ALLOW", adds_discovery=False)


def _rules(element: Element, notes: dict[str, None]) -> list[PolicyRule]:
    allow = element.tag == "allow_rule"
    rules: list[PolicyRule] = []
    for part in element.children:
        if part.tag == "domains":
            ids = " ".join(word for e in _below(part) for word in e.text.split())
            if ids != "0":
                notes[f"{part.place}: domains were not compared: {ids}"] = None
        if part.tag not in ("publish", "subscribe"):
            continue
        direction = Direction(part.tag)
        for inner in _below(part):
            if inner.tag in _NOT_COMPARED:
                notes[f"{inner.place}: {_NOT_COMPARED[inner.tag]} were not compared"] = None
            if inner.tag == "topic":
                right = Right(direction, inner.text.strip())
                rules.append(PolicyRule(allow, direction.value, right.name, (right,), inner.place))
    return rules


def _below(element: Element) -> list[Element]:
    """The elements in it, at any depth, in order; the depth is bounded by the reader."""
    return [e for child in element.children for e in (child, *_below(child))]
