# SPDX-License-Identifier: Apache-2.0
"""What did a running program put into the graph? The graph itself is asked, after each thing that the program creates.

    node = rclpy.create_node("n")
    node.destroy_publisher(node.create_publisher(String, "gone", 10))    -> the fact ("/n", "pub", "/gone", "std_msgs/msg/String")

Facts are never removed: what is destroyed later has been there. No name is computed here: the answers of the middleware count.
"""

from __future__ import annotations

import re
import threading
from collections.abc import Callable
from typing import Any, Final

from rclpy.impl.implementation_singleton import rclpy_implementation as _rclpy

Fact = tuple[str, str, str, str]
"""The full name of a node, the word for the kind, the full name of the entity, its type."""

_ENDPOINTS: Final = (
    *("Publisher", "Subscription", "Service", "Client", "ActionServer", "ActionClient"),
    *("TypeDescriptionService", "LifecycleStateMachine"),
)
_PART_OF_ACTION: Final = re.compile(r"(.*)/_action/(?:feedback|status|send_goal|cancel_goal|get_result)")


class Recorder:
    """Watches the constructors of everything that shows in the graph."""

    def __init__(self) -> None:
        self.facts: set[Fact] = set()
        self.nodes: set[str] = set()
        self._handles: list[Any] = []
        self._lock = threading.RLock()

    def install(self) -> None:
        """From now on each new node and endpoint is noted."""
        _rclpy.Node = self._watched(_rclpy.Node, self._new_node)
        for name in _ENDPOINTS:
            setattr(_rclpy, name, self._watched(getattr(_rclpy, name), self._new_endpoint))

    def _watched(self, make: Callable[..., Any], note: Callable[..., None]) -> Callable[..., Any]:
        def made(*args: Any, **options: Any) -> Any:
            result = make(*args, **options)
            note(result, *args)
            return result

        return made

    def _new_node(self, handle: Any, *_: Any) -> None:
        with self._lock:
            self._handles.append(handle)
        self._read(handle)

    def _new_endpoint(self, _result: Any, node: Any, *_: Any) -> None:
        self._read(node)

    def read_all(self) -> None:
        """Ask for what every node has now."""
        for handle in list(self._handles):
            self._read(handle)

    def _read(self, handle: Any) -> None:
        try:
            with handle, self._lock:
                where = (handle.get_node_name(), handle.get_namespace())
                answers = {
                    "pub": _rclpy.rclpy_get_publisher_names_and_types_by_node(handle, False, *where),
                    "sub": _rclpy.rclpy_get_subscriber_names_and_types_by_node(handle, False, *where),
                    "ss": _rclpy.rclpy_get_service_names_and_types_by_node(handle, *where),
                    "sc": _rclpy.rclpy_get_client_names_and_types_by_node(handle, *where),
                    "as": handle.get_action_server_names_and_types_by_node(*where),
                    "ac": handle.get_action_client_names_and_types_by_node(*where),
                }
        except (_rclpy.InvalidHandle, _rclpy.RCLError, _rclpy.NodeNameNonExistentError, RuntimeError):
            return  # destroyed, or the context was shut down: what was there before has been read
        name, namespace = where
        fqn = f"{namespace.rstrip('/')}/{name}"
        self.nodes.add(fqn)
        for kind, found in answers.items():
            self.facts.update((fqn, kind, entity, type_) for entity, types in found for type_ in types)

    def told(self) -> list[Fact]:
        """All facts, in order; the topics and services that an action is made of are left to the action."""
        actions = {(node, name) for node, kind, name, _ in self.facts if kind in {"as", "ac"}}
        return sorted(fact for fact in self.facts if not self._part(fact, actions))

    @staticmethod
    def _part(fact: Fact, actions: set[tuple[str, str]]) -> bool:
        found = _PART_OF_ACTION.fullmatch(fact[2])
        return found is not None and (fact[0], found[1]) in actions
