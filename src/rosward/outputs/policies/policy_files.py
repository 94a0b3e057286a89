# SPDX-License-Identifier: Apache-2.0
"""Which files does a policy make? The whole one, one for each enclave, and how to start with them."""

from __future__ import annotations

from collections.abc import Iterator

from rosward.outputs.policies.policy import whole_and_single
from rosward.outputs.policies.starts import starts_text
from rosward.outputs.writing import File, Material, of_enclaves

__all__ = ["files"]


def files(material: Material) -> Iterator[File]:
    """The files of the format `policy`."""
    network = material.network
    whole, single = whole_and_single(network, material.unknown, material.widened)
    yield "policy.xml", whole
    yield from of_enclaves("policies", single, "policy.xml")
    yield "enclaves.txt", starts_text(network)
