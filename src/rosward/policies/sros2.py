# SPDX-License-Identifier: Apache-2.0
"""What does an SROS2 policy (version 0.2.0) say?

    <profile ns="/robot" node="arm"> <services request="ALLOW"> <service>~/home</service>
      ->  PolicyRule("services request", "/robot/arm/home", rights=(publish rq/robot/arm/homeRequest, subscribe rr/…Reply))

Names are completed as `permissions.xsl` of sros2 does it: `/x` is absolute, `~x` is namespace, node and `x` without a `/` between, all
else is in the namespace; white space belongs to the name. All denials of an enclave come before all allowances. Of two enclaves of one
path sros2 takes the first, of two `<profiles>` DDS does.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final, final

from rosward.findings import Finding
from rosward.policies.document import Element
from rosward.policies.elements import ELEMENTS
from rosward.policies.records import EnclavePolicy, PolicyRule
from rosward.policies.rights import rights_of

__all__ = ["read_sros2"]

_VERSION: Final = "0.2.0"
_KINDS: Final = {(words.outer, words.verb): kind for kind, words in ELEMENTS.items()}
_CHILD: Final = {words.outer: words.inner for words in ELEMENTS.values()}
_BASE: Final = "http://www.w3.org/XML/1998/namespace base"


def read_sros2(root: Element) -> tuple[list[EnclavePolicy], list[Finding]]:
    """The enclaves of a document `<policy>`, and what is wrong in it."""
    reader = _Reader()
    version = root.attributes.get("version")
    if version != _VERSION:
        reader.tell(f"This policy has version {version}, but sros2 requires {_VERSION}.", root)
    enclaves: dict[str, EnclavePolicy] = {}
    for element in (e for all_ in reader.children(root, "enclaves") for e in reader.children(all_, "enclave")):
        path = element.attributes.get("path", "")
        if not path:
            reader.tell("An enclave needs a path.", element)
        elif path in enclaves:
            reader.tell(
                f"Enclave {path} is already defined; sros2 uses the first one and ignores the rules here.", element
            )
        else:
            enclaves[path] = reader.enclave(path, element)
    if not enclaves and not reader.findings:
        reader.tell("It has no enclave.", root)
    return list(enclaves.values()), reader.findings


@final
class _Reader:
    """Reads elements and keeps what is wrong."""

    def __init__(self) -> None:
        self.findings: list[Finding] = []

    def tell(self, message: str, element: Element) -> None:
        self.findings.append(Finding("RW403", message, element.place))

    def children(self, parent: Element, *tags: str) -> Iterator[Element]:
        for child in parent.children:
            if child.tag in tags:
                yield child
            elif child.tag != "metadata" or parent.tag != "enclave":
                self.tell(f"<{child.tag}> is not allowed in <{parent.tag}>: sros2 rejects the policy.", child)

    def enclave(self, path: str, element: Element) -> EnclavePolicy:
        rules: list[PolicyRule] = []
        names: list[str] = []
        for number, profiles in enumerate(self.children(element, "profiles")):
            if number:
                self.tell(
                    f"Enclave {path} already has <profiles>; DDS uses the first ones and ignores these.", profiles
                )
                continue
            for profile in self.children(profiles, "profile"):
                namespace, node = profile.attributes.get("ns"), profile.attributes.get("node")
                if namespace is None or node is None:
                    self.tell("A profile needs the attributes ns and node.", profile)
                    continue
                names.append(_ended(namespace) + node)
                rules += self._profile(profile, namespace, node)
        rules.sort(key=lambda rule: rule.allow)
        return EnclavePolicy(path, element.place, tuple(rules), tuple(names))

    def _profile(self, profile: Element, namespace: str, node: str) -> Iterator[PolicyRule]:
        for group in self.children(profile, *_CHILD):
            names = list(self.children(group, _CHILD[group.tag]))
            for attribute, value in group.attributes.items():
                kind = _KINDS.get((group.tag, attribute))
                if kind is None or value not in ("ALLOW", "DENY"):
                    if attribute != _BASE:
                        self.tell(f'{attribute}="{value}" has no meaning for <{group.tag}>.', group)
                    continue
                for each in names:
                    name = _full(each.text, namespace, node)
                    yield PolicyRule(
                        value == "ALLOW",
                        f"{group.tag} {attribute}",
                        name,
                        rights_of(kind, name),
                        each.place,
                        _ended(namespace) + node,
                    )


def _full(text: str, namespace: str, node: str) -> str:
    if text.startswith("/"):
        return text
    if text.startswith("~"):
        return _ended(namespace) + node + text[1:]
    return _ended(namespace) + text


def _ended(namespace: str) -> str:
    return namespace if namespace.endswith("/") else namespace + "/"
