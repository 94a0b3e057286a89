# SPDX-License-Identifier: Apache-2.0
"""What rclcpp gives a node by itself, and how it differs from rclpy. Derived from node.cpp, time_source.cpp and lifecycle_node.cpp."""

from __future__ import annotations

import pytest

from rosward.ros.distro import Distro
from rosward.ros.entities import Entity
from rosward.ros.implicit import ClientLibrary, implicit_entities

PARAMETERS = (
    "describe_parameters",
    "get_parameter_types",
    "get_parameters",
    "list_parameters",
    "set_parameters",
    "set_parameters_atomically",
)


def told(entities: tuple[Entity, ...]) -> set[str]:
    return {f"{e.kind.value} {e.name}" for e in entities}


def cpp(distro: Distro, **options: bool) -> set[str]:
    return told(implicit_entities(distro, node_fqn="/n", client_library=ClientLibrary.RCLCPP, **options))


HUMBLE = {"publisher /rosout", "publisher /parameter_events", "subscription /parameter_events"} | {
    f"service server /n/{name}" for name in PARAMETERS
}


@pytest.mark.parametrize("distro", list(Distro))
def test_a_plain_node(distro: Distro) -> None:
    later = {"service server /n/get_type_description"} if distro.has(Distro.IRON) else set()
    assert cpp(distro) == HUMBLE | later


@pytest.mark.parametrize("distro", list(Distro))
@pytest.mark.parametrize("options", [{}, {"use_sim_time": True}, {"lifecycle": True}, {"logger_service": True}])
def test_the_subscription_to_parameter_events_is_all_the_difference(distro: Distro, options: dict[str, bool]) -> None:
    python = told(implicit_entities(distro, node_fqn="/n", **options))  # type: ignore[arg-type]
    assert cpp(distro, **options) - python == {"subscription /parameter_events"}
    assert python <= cpp(distro, **options)


def test_a_component_container_has_no_parameter_services_and_no_publisher_of_parameter_events() -> None:
    found = cpp(Distro.HUMBLE, start_parameter_services=False, start_parameter_event_publisher=False)
    assert found == {"publisher /rosout", "subscription /parameter_events"}


def test_rclpy_has_no_such_switch() -> None:
    found = told(implicit_entities(Distro.HUMBLE, node_fqn="/n", start_parameter_event_publisher=False))
    assert "publisher /parameter_events" in found


def test_the_qos_of_parameter_events() -> None:
    (both,) = {
        e.qos
        for e in implicit_entities(Distro.JAZZY, node_fqn="/n", client_library=ClientLibrary.RCLCPP)
        if e.name == "/parameter_events"
    }
    assert both is not None
    assert (both.reliability, both.durability, both.history, both.depth) == ("reliable", "volatile", "keep_last", 1000)
