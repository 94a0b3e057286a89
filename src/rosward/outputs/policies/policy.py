# SPDX-License-Identifier: Apache-2.0
"""The SROS2 policy (version 0.2.0, grammar in `schemas/policy.xsd`) that lets each node do what its source does, and no
more.

    Node /robot1/talker publishes /robot1/chatter at src/talker.py:20
      ->  <profile ns="/robot1" node="talker">
            <topics publish="ALLOW">
              <topic>/robot1/chatter</topic>  <!-- src/talker.py:20 -->

Names are absolute, each element has one attribute, everything is in the order in which sros2 itself sorts when it
merges into a file. Where a rule comes from stands in comments, never in `<metadata>`: sros2 moves that before the
profiles and then refuses its own file. A rule without a place is needed by the client library. For what is left out
there is a comment with the reason.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final

from rosward.enclaves.grants import NOT_WIDENED, Enclave, Grant, Omission, Profile, enclave_named, enclaves
from rosward.enclaves.widened import Widened, Widenings
from rosward.network.checks import UnknownNames
from rosward.network.counts import listed
from rosward.network.graph import Network
from rosward.policies.elements import ELEMENTS
from rosward.records import NamedTuple
from rosward.ros.entities import Entity, Interface
from rosward.safe import xml_attribute, xml_comment, xml_text

__all__ = ["Line", "policies", "policy_lines", "policy_xml", "whole_and_single"]

_MOST_PLACES: Final = 5
_HEADER: Final = (
    "Written by rosward from the source of the system.",
    "The comment after each rule says where it comes from; a rule without a comment is needed by the client library.",
)
_LAST: Final = ("  </enclaves>", "</policy>", "")


class Line(NamedTuple):
    """One line of a policy, and the right that it gives, if it gives one."""

    text: str
    grant: Grant | None = None


def policy_xml(
    network: Network,
    enclave: str | None = None,
    unknown: UnknownNames = "deny",
    widened: Widenings = NOT_WIDENED,
) -> str:
    """The policy of the whole network, or of one enclave of it (ValueError if there is no such enclave).

    `unknown="wildcard"` writes `/*` for a name of which nothing is known, so that the node works but is hardly
    confined. A network without nodes gives a policy without enclaves, which sros2 rightly refuses: there is nothing to
    write a policy for.
    """
    if enclave is None:
        return _document(enclaves(network, unknown, widened))
    return _document([enclave_named(network, enclave, unknown, widened)])


def policies(network: Network, unknown: UnknownNames = "deny", widened: Widenings = NOT_WIDENED) -> dict[str, str]:
    """The policy of each enclave alone, by its path, which is absolute and has only letters, digits, `_` and `/`."""
    return {enclave.path: _document([enclave]) for enclave in enclaves(network, unknown, widened)}


def whole_and_single(
    network: Network, unknown: UnknownNames = "deny", widened: Widenings = NOT_WIDENED
) -> tuple[str, dict[str, str]]:
    """What `policy_xml` gives of the whole network, and `policies`."""
    written = [
        (enclave.path, [line.text for line in _enclave(enclave)]) for enclave in enclaves(network, unknown, widened)
    ]
    whole = _framed(text for _, lines in written for text in lines)
    return whole, {path: _framed(lines) for path, lines in written}


def policy_lines(chosen: Iterable[Enclave]) -> Iterator[Line]:
    """The policy of these enclaves line by line; the last line is empty, so that joined by line ends they are the file."""
    yield from map(Line, _first())
    for enclave in chosen:
        yield from _enclave(enclave)
    yield from map(Line, _LAST)


def _document(chosen: Iterable[Enclave]) -> str:
    return _framed(line.text for enclave in chosen for line in _enclave(enclave))


def _framed(lines: Iterable[str]) -> str:
    """The policy with these lines of enclaves."""
    return "\n".join((*_first(), *lines, *_LAST))


def _first() -> Iterator[str]:
    yield '<?xml version="1.0" encoding="UTF-8"?>'
    yield from map(xml_comment, _HEADER)
    yield '<policy version="0.2.0">'
    yield "  <enclaves>"


def _enclave(enclave: Enclave) -> Iterator[Line]:
    yield Line(f'    <enclave path="{xml_attribute(enclave.path)}">')
    yield Line("      <profiles>")
    for profile in enclave.profiles:
        yield from _profile(profile, enclave)
    yield Line("      </profiles>")
    yield Line("    </enclave>")


def _profile(profile: Profile, enclave: Enclave) -> Iterator[Line]:
    notes = list(_notes(profile, enclave))
    attributes = f'ns="{xml_attribute(profile.namespace)}" node="{xml_attribute(profile.name)}"'
    if not notes and not profile.grants:
        yield Line(f"        <profile {attributes}/>")
        return
    yield Line(f"        <profile {attributes}>")
    for note in notes:
        yield Line(f"          {xml_comment(note)}")
    for kind, (element, attribute, child) in ELEMENTS.items():
        grants = [grant for grant in profile.grants if grant.kind is kind]
        if grants:
            yield Line(f'          <{element} {attribute}="ALLOW">')
            for grant in grants:
                origin = _origin(grant)
                comment = f"  {xml_comment(origin)}" if origin else ""
                yield Line(f"            <{child}>{xml_text(grant.name)}</{child}>{comment}", grant)
            yield Line(f"          </{element}>")
    yield Line("        </profile>")


def _notes(profile: Profile, enclave: Enclave) -> Iterator[str]:
    for node in profile.nodes:
        if node.label is not None:
            yield f"The node of {node.label}, whose name is unknown"
        if node.interface is Interface.UNKNOWN:
            yield f"Unknown interface, so only what every node needs is allowed: {'; '.join(node.lacks)}"
    if enclave.path != enclave.found:
        yield (
            f"The enclave was determined as {enclave.found}, which is not a valid enclave name: "
            f"start the node with ROS_SECURITY_ENCLAVE_OVERRIDE={enclave.path} in its environment"
        )
    for process in sorted({node.process for node in profile.nodes if node.assumed}):
        yield f"Assumed: nothing in the sources creates {process}"
    if len(profile.nodes) > 1:
        places = ", ".join(str(node.defined_at) for node in profile.nodes)
        yield f"{len(profile.nodes)} nodes have this full name and share this profile: {places}"
    for omission in profile.omissions:
        yield _omission(omission)


def _omission(omission: Omission) -> str:
    entity = omission.entity
    reasons = "".join(f"; {reason}" for reason in entity.reasons)
    return f"Not granted: {entity.kind.value} {entity.name}{_at(entity)}: {omission.why}{reasons}"


def _origin(grant: Grant) -> str:
    """`src/talker.py:20, conditional`; empty for what the client library needs at each node."""
    own = [entity for entity in grant.entities if not entity.system]
    if grant.widened is not None:
        return _compacted(grant.widened, _places(own))
    if not own:
        return ""
    parts = [_places(own)]
    vias = sorted({entity.via for entity in own if entity.via})
    if vias:
        parts.append("by " + ", ".join(vias))
    if all(entity.conditional for entity in own):
        parts.append("conditional")
    if not all(entity.resolution.whole for entity in own):
        parts.append(
            "partially known name: * also matches /" if grant.name != "/*" else "unknown name: everything is allowed"
        )
    return ", ".join(part for part in parts if part)


def _compacted(widened: Widened, places: str) -> str:
    """What a pattern stands for, and what more it allows."""
    own = f"compacted: {listed(sorted(widened.members), _MOST_PLACES)}"
    return "; ".join(part for part in (own, widened.also(_MOST_PLACES), places) if part)


def _at(entity: Entity) -> str:
    places = _places([entity])
    return f" at {places}" if places else ""


def _places(entities: Iterable[Entity]) -> str:
    places = sorted(
        {f"{place.file}:{place.line}" if place.line else place.file for e in entities for place in e.created_at}
    )
    more = [f"{len(places) - _MOST_PLACES} more places"] if len(places) > _MOST_PLACES else []
    return ", ".join(places[:_MOST_PLACES] + more)
