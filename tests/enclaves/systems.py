# SPDX-License-Identifier: Apache-2.0
"""Systems of any shape for the laws: few names, so that they meet; some with holes, some that ROS cannot hold."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from hypothesis import strategies as st
from outputs.networks import entity, node

from rosward.network.connect import connect
from rosward.network.contexts import with_enclaves
from rosward.network.enclave_mode import EnclaveMode
from rosward.ros.entities import Entity, EntityKind, Node, Resolution

__all__ = ["nodes"]

_NAMES: Final = (
    *(f"/robot{n}/{name}" for n in (1, 2) for name in ("odom", "cmd_vel", "camera_left", "camera_right/image")),
    "/map",
    "/dock",
    "/robot1/dock",
    "/robot_*/odom",
    "/robot1/*",
    "/a[b]",
)


@st.composite
def _entities(draw: st.DrawFn) -> Entity:
    name = draw(st.sampled_from(_NAMES))
    kind = draw(st.sampled_from(list(EntityKind)))
    made = entity(kind, name, system=draw(st.sampled_from((False, False, True))))
    if "*" in name:
        return replace(made, resolution=draw(st.sampled_from((Resolution.PATTERN, Resolution.UNKNOWN))))
    topic = kind in (EntityKind.PUBLISHER, EntityKind.SUBSCRIPTION)
    return replace(made, ros_prefix=not topic or draw(st.integers(0, 9)) > 0)


@st.composite
def nodes(draw: st.DrawFn, enclave: str | None = None) -> tuple[Node, ...]:
    """Up to eight nodes in up to eight processes, each in an enclave of its own; or most of them in this one."""
    made = []
    for number in range(draw(st.integers(1, 8))):
        fqn = f"/robot{draw(st.integers(1, 2))}/n{number}"
        own = draw(st.lists(_entities(), max_size=6))
        more = {} if enclave is None or draw(st.integers(0, 4)) == 0 else {"enclave": enclave}
        given = draw(st.sampled_from((None, None, None, "/given", "/other")))
        process = f"demo/p{draw(st.integers(0, 7))}"
        made.append(node(fqn, *own, system=draw(st.booleans()), process=process, given_enclave=given, **more))
    placed = made if enclave is not None else with_enclaves(made, EnclaveMode.PROCESS)[0]
    return connect("jazzy", placed).nodes
