# SPDX-License-Identifier: Apache-2.0
"""How many bytes do the signed permissions of an enclave come to, and can DDS carry them?

    31 nodes of the usual kind in one enclave  ->  67,000  ->  RW304

The participants of DDS show each other their permissions in the handshake, in one message of at most 64 KB: in it are also their
certificate, their description and the secrets (1.4 KB with Cyclone DDS and the certificates of sros2). What is counted here is the
document as `ros2 security create_permission` writes it, one line for each right, the carriage return that S/MIME puts into
each, and a signature as sros2 makes it, by a key on an elliptic curve (1.5 KB; by RSA of 4096 bits it is 3.8 KB).
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

from rosward.enclaves.privileges import Privilege, by_enclave, on_dds, privileges
from rosward.findings import Finding
from rosward.network.checks import UnknownNames
from rosward.policies.rights import Direction, Right
from rosward.ros.entities import Node

__all__ = ["LARGEST", "privilege_size", "signed_size", "size_findings", "size_of_rights", "too_large"]

LARGEST: Final = 60 * 1024
"""What is taken for safe: a UDP packet has 65,507 bytes, and the rest of the handshake has 4 KB of them."""

_SIGNATURE: Final = 2048
_DOCUMENT: Final = 861  # the lines that all permissions have, with a domain of one digit
_RULE: Final = 102  # <allow_rule> with its domain
_LIST: Final = {Direction.PUBLISH: 80, Direction.SUBSCRIBE: 84}
_TOPIC: Final = 29


def size_of_rights(rights: Iterable[Right]) -> int:
    """The lines of these rights, each of which is written once."""
    return sum(_TOPIC + len(right.name) for right in set(rights))


def privilege_size(privilege: Privilege) -> int:
    """The lines of a privilege."""
    return size_of_rights(on_dds(privilege))


def signed_size(path: str, rights: Iterable[Right]) -> int:
    """At most so many bytes have the signed permissions of an enclave with these rights."""
    once = set(rights)
    ways = {right.direction for right in once}
    frame = sum(_LIST[way] for way in ways) + (_RULE if ways else 0)
    return _DOCUMENT + _SIGNATURE + 2 * len(path) + frame + size_of_rights(once)


def too_large(path: str, size: int, place_of: Node, more: str = "") -> Finding:
    """RW304."""
    message = f"the signed permissions of enclave {path} take about {_kilobytes(size)} KB, but at most {LARGEST // 1024} KB are safe"
    return Finding("RW304", message + more, place_of.defined_at)


def size_findings(nodes: Iterable[Node], unknown: UnknownNames = "deny") -> list[Finding]:
    """RW304 for each enclave whose permissions, signed, would be larger than the DDS handshake can carry."""
    found = []
    for path, members in by_enclave(nodes):
        size = signed_size(path, (right for each in privileges(members, unknown) for right in on_dds(each)))
        if size > LARGEST:
            found.append(too_large(path, size, members[0]))
    return found


def _kilobytes(size: int) -> int:
    return -(-size // 1024)
