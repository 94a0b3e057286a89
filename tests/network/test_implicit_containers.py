# SPDX-License-Identifier: Apache-2.0
"""Which services are the plumbing of a container of components, and which only resemble it?"""

from __future__ import annotations

import pytest

from rosward.naming.implicit import is_of_container
from rosward.ros.entities import EntityKind

SERVER, CLIENT = EntityKind.SERVICE_SERVER, EntityKind.SERVICE_CLIENT
LOAD = "composition_interfaces/srv/LoadNode"


@pytest.mark.parametrize(
    ("kind", "name", "type_", "expected"),
    [
        (SERVER, "/box/_container/load_node", LOAD, True),
        (SERVER, "/a/*/_container/list_nodes", "composition_interfaces/srv/ListNodes", True),
        (SERVER, "/box/_container/unload_node", LOAD, False),
        (SERVER, "/box/_container/other", LOAD, False),
        (SERVER, "/load_node", LOAD, False),
        (SERVER, "/box/_container/load_node", None, False),
        (CLIENT, "/box/_container/load_node", LOAD, False),
    ],
)
def test_a_service_of_a_container(kind: EntityKind, name: str, type_: str | None, expected: bool) -> None:
    assert is_of_container(kind, name, type_) is expected
