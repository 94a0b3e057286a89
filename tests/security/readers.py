# SPDX-License-Identifier: Apache-2.0
"""What do the programs that read a policy make of it? Their rules, written down again for the tests.

`sros2` translates a policy into permissions, and merges what it sees in a running system into it (`ros2 security
generate_policy`). The tool of rmw_zenoh reads a policy more narrowly: one enclave, one attribute for each list, no
actions, and names that it does not resolve.

    rights('<policy …><topic>chatter</topic> …')   ->  {"/ns/talker": {("write", "rt/ns/chatter"), …}}
    zenoh_rights('<policy …>')                     ->  {"talker": {("publish", "ns/chatter"), …}}
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterator
from typing import Final, NamedTuple

__all__ = ["Seen", "UnreadableError", "comments", "merged", "rights", "zenoh_rights"]

Right = tuple[str, str]

_SERVICES: Final = ("cancel_goal", "get_result", "send_goal")
_TOPICS: Final = ("feedback", "status")
_DISCOVERY: Final = frozenset({("write", "ros_discovery_info"), ("read", "ros_discovery_info")})


class Seen(NamedTuple):
    """One name in the graph of a running system, as generate_policy asks for it: `topic` `publish` /x, and so on."""

    namespace: str
    node: str
    enclave: str
    element: str
    way: str
    name: str


def rights(policy: str) -> dict[str, set[Right]]:
    """The permissions of each enclave: of the first one of its path, and of the first profiles in it."""
    found: dict[str, set[Right]] = {}
    for enclave in ET.fromstring(policy).iter("enclave"):
        profiles = enclave.find("profiles")
        assert profiles is not None
        lists = [(profile, each) for profile in profiles.iter("profile") for each in profile]
        own = {right for profile, each in lists for right in _rights(profile, each)}
        found.setdefault(enclave.get("path", ""), own | _DISCOVERY)
    return found


def _rights(profile: ET.Element, each: ET.Element) -> Iterator[Right]:
    for way, qualifier in each.attrib.items():
        assert qualifier == "ALLOW"
        for item in each:
            yield from _on_dds(way, _absolute(profile, item.text or ""))


def _absolute(profile: ET.Element, text: str) -> str:
    """No trimming, and what follows a `~` follows the name of the node as it stands."""
    if text.startswith("/"):
        return text
    namespace = profile.get("ns", "")
    below = namespace if namespace.endswith("/") else f"{namespace}/"
    return below + profile.get("node", "") + text[1:] if text.startswith("~") else below + text


def _on_dds(way: str, name: str) -> Iterator[Right]:
    match way:
        case "publish" | "subscribe":
            yield ("write" if way == "publish" else "read"), f"rt{name}"
        case "request" | "reply":
            asks, answers = ("write", "read") if way == "request" else ("read", "write")
            yield asks, f"rq{name}Request"
            yield answers, f"rr{name}Reply"
        case "call" | "execute":
            for service in _SERVICES:
                yield from _on_dds("request" if way == "call" else "reply", f"{name}/_action/{service}")
            for topic in _TOPICS:
                yield from _on_dds("subscribe" if way == "call" else "publish", f"{name}/_action/{topic}")


def merged(policy: str, graph: list[Seen]) -> str:
    """The policy with what was seen added, everything in the order of tag, text, node and path, nothing twice."""
    root = ET.fromstring(policy, ET.XMLParser(target=ET.TreeBuilder(insert_comments=True)))
    for seen in graph:
        _add(root, seen)
    _sort(root)
    return ET.tostring(root, "unicode")


def _add(root: ET.Element, seen: Seen) -> None:
    enclaves = root.find("enclaves")
    assert enclaves is not None
    enclave = _child(enclaves, "enclave", {"path": seen.enclave})
    profile = _child(_child(enclave, "profiles", {}), "profile", {"ns": seen.namespace, "node": seen.node})
    names = _child(profile, f"{seen.element}s", {seen.way: "ALLOW"})
    ET.SubElement(names, seen.element).text = _shortened(seen)


def _child(parent: ET.Element, tag: str, attributes: dict[str, str]) -> ET.Element:
    for each in parent.iter(tag):
        if all(each.get(name) == value for name, value in attributes.items()):
            return each
    return ET.SubElement(parent, tag, attributes)


def _shortened(seen: Seen) -> str:
    node = seen.namespace.rstrip("/") + "/" + seen.node
    if seen.name.startswith(f"{node}/"):
        return "~" + seen.name.removeprefix(node)
    if seen.name.startswith(f"{seen.namespace}/"):
        return seen.name.removeprefix(f"{seen.namespace}/")
    return seen.name[1:] if seen.namespace == "/" and seen.name.count("/") == 1 else seen.name


def _sort(element: ET.Element) -> None:
    kept: dict[tuple[str, ...], ET.Element] = {}
    for number, child in enumerate(element):
        _sort(child)
        child.tail = None
        named: object = child.tag
        tag = named if isinstance(named, str) else ""  # a comment has a function there
        own = ("ns", "node"), ("path",)
        key = (tag, *("".join(child.get(name, "") for name in names) for names in own), (child.text or "").strip())
        leaf = tag in {"topic", "service", "action"}
        kept.setdefault(key if leaf else (*key, str(number).zfill(6)), child)
    element[:] = [kept[key] for key in sorted(kept, key=lambda key: (key[0], key[3], key[1], key[2], *key[4:]))]


def comments(policy: str) -> list[str]:
    """What the comments say, sorted."""
    root = ET.fromstring(policy, ET.XMLParser(target=ET.TreeBuilder(insert_comments=True)))
    return sorted((each.text or "") for each in root.iter(ET.Comment))  # type: ignore[arg-type]


class UnreadableError(Exception):
    """The tool ends with an error."""


def zenoh_rights(policy: str) -> dict[str, set[Right]]:
    """What zenoh_security_tools reads for each node: of the first enclave, no namespaces, no `<actions>`."""
    enclave = ET.fromstring(policy).find("enclaves/enclave")
    if enclave is None or not len(enclave):
        raise UnreadableError("no enclave")
    found: dict[str, set[Right]] = {}
    for profiles in enclave:
        if profiles.tag != "profiles":
            raise UnreadableError(f"<{profiles.tag}> in an enclave")
        for profile in profiles.iter("profile"):
            if not len(profile):
                raise UnreadableError("a profile without rules")
            node = profile.get("node", "")
            found[node] = {right for each in profile for right in _zenoh_list(each, node)}  # the last of a name stays
    return found


def _zenoh_list(each: ET.Element, node: str) -> Iterator[Right]:
    looked_at = {"topics": ("subscribe", "publish"), "services": ("reply", "request")}.get(each.tag)
    if looked_at is None:
        return
    way = next((name for name in looked_at if name in each.attrib), None)
    if way is None:
        raise UnreadableError(f"<{each.tag}> without permission")
    for item in each:
        if f"{item.tag}s" != each.tag:
            raise UnreadableError(f"<{item.tag}> in <{each.tag}>")
        yield way, (item.text or "").replace("~", node, 1).removeprefix("/")
