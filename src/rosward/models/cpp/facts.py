# SPDX-License-Identifier: Apache-2.0
"""What must be known of the client library in C++ before any of its headers is read?"""

from __future__ import annotations

from typing import Final

ASSUMED_NODE: Final = ("rclcpp", "AssumedNode")
"""The class that stands for a node of which nothing is known but that entities are created on it."""
ADAPTED: Final = "rclcpp.TypeAdapter"
"""How the classes begin that say for a type of a program which interface it is sent as."""
TYPED: Final = frozenset({"create_client", "create_publisher", "create_service", "create_subscription"})
"""Methods that create an entity of the interface that is their first template argument."""
GENERIC: Final = frozenset(
    {"create_generic_client", "create_generic_publisher", "create_generic_service", "create_generic_subscription"}
)
"""Methods that are given the interface as a text; nothing but a node has methods of these names."""
