# SPDX-License-Identifier: Apache-2.0
"""Which enclave path a policy can be written for, where the path that was found holds what no path may hold.

    /robot1/talker  ->  /robot1/talker
    /robot_*/talker ->  /robot_unknown/talker      (the user has to start it in that enclave)

An enclave is a directory and the name in a certificate: rcl takes only letters, digits, `_` and `/`, and matches it
literally. So a hole cannot stay. What takes its place never meets the path of another enclave, since two enclaves in
one would share their rights.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Final

from rosward.network.free import free
from rosward.ros.entities import Node

__all__ = ["LONGEST_ENCLAVE", "enclave_paths"]

LONGEST_ENCLAVE: Final = 64
"""A certificate's common name holds 64 characters at most."""

_VALID: Final = re.compile(r"/|(/[A-Za-z_][A-Za-z0-9_]*)+")
_FORBIDDEN: Final = re.compile(r"[^A-Za-z0-9_]")


def enclave_paths(nodes: Iterable[Node]) -> dict[str, str]:
    """For each enclave of the nodes, as it was found, the path to write: itself where it is valid."""
    found = sorted({node.enclave for node in nodes})
    paths = {enclave: enclave for enclave in found if _VALID.fullmatch(enclave)}
    taken = set(paths)
    for enclave in found:
        if enclave not in paths:
            paths[enclave] = free(_without_holes(enclave), taken, "_")
            taken.add(paths[enclave])
    return paths


def _without_holes(enclave: str) -> str:
    tokens = [_FORBIDDEN.sub("_", token.replace("*", "unknown")) for token in enclave.split("/") if token]
    return "".join("/_" + token if token[0].isdigit() else "/" + token for token in tokens) or "/unknown"
