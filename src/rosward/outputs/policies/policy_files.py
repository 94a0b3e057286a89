# SPDX-License-Identifier: Apache-2.0
"""Which files does a policy make? The whole one, one for each enclave, and how to start with them."""

from __future__ import annotations

from collections.abc import Iterator

from rosward.outputs.policies.policy import policies, policy_xml
from rosward.outputs.policies.starts import starts_text
from rosward.outputs.writing import File, Material, of_enclaves

__all__ = ["files"]


def files(material: Material) -> Iterator[File]:
    """The files of the format `policy`."""
    network, unknown, widened = material.network, material.unknown, material.widened
    yield "policy.xml", policy_xml(network, unknown=unknown, widened=widened)
    yield from of_enclaves("policies", policies(network, unknown=unknown, widened=widened), "policy.xml")
    yield "enclaves.txt", starts_text(network)
