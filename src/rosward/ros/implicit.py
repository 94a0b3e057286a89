# SPDX-License-Identifier: Apache-2.0
"""What does a node have that nobody wrote, in which distribution of ROS 2?

    implicit_entities(Distro.HUMBLE, node_fqn="/talker")  -> /rosout, /parameter_events and six parameter services
    implicit_entities(Distro.JAZZY, node_fqn="/talker")   -> the same and /talker/get_type_description

One table for each client library: a row is an endpoint, and the switch of the node that makes it. Which of them a
distribution has stands in `distro.py`. The rows of rclpy are read from rclpy (node.py, parameter_service.py, logging_service.py,
type_description_service.py, time_source.py, lifecycle/node.py) and rcl (logging_rosout.h, com_interface.c,
service_event_publisher.c), oldest to newest, and compared with the real rclpy of kilted in tests/live.
Those of rclcpp are read from rclcpp and rclcpp_lifecycle (node.cpp, lifecycle_node.cpp, time_source.cpp,
node_logging.cpp, node_type_descriptions.cpp, parameter_service.cpp). The time source of a C++ node
subscribes to /parameter_events, and where a node measures its subscriptions, it measures this one, too.
"""

from __future__ import annotations

import enum
from typing import Final

from rosward.records import NamedTuple
from rosward.ros.distro import Distro
from rosward.ros.entities import Entity, EntityKind, Qos

__all__ = ["ClientLibrary", "implicit_entities", "parameter_client_services", "service_event_topic"]


class ClientLibrary(enum.Enum):
    """The library that a node is written with."""

    RCLPY = "rclpy"
    RCLCPP = "rclcpp"


class _Switch(enum.Enum):
    """What decides whether a node has an implicit endpoint."""

    ALWAYS = enum.auto()
    ROSOUT = enum.auto()
    PARAMETER_EVENTS = enum.auto()
    PARAMETER_SERVICES = enum.auto()
    TYPE_DESCRIPTION = enum.auto()
    LOGGER_SERVICE = enum.auto()
    TOPIC_STATISTICS = enum.auto()
    SIM_TIME = enum.auto()
    LIFECYCLE = enum.auto()
    LIFECYCLE_SERVICES = enum.auto()


class _Row(NamedTuple):
    """One implicit endpoint. A `name` that begins with `~` is private to the node."""

    switch: _Switch
    kind: EntityKind
    name: str
    type: str
    qos: Qos


def _reliable(depth: int, durability: str = "volatile") -> Qos:
    return Qos("reliable", durability, "keep_last", depth)


_SERVICE: Final = _reliable(10)  # rmw_qos_profile_services_default
_PARAMETERS: Final = _reliable(1000)  # rmw_qos_profile_parameters

_PARAMETER_SERVICES: Final = (
    ("describe_parameters", "rcl_interfaces/srv/DescribeParameters"),
    ("get_parameter_types", "rcl_interfaces/srv/GetParameterTypes"),
    ("get_parameters", "rcl_interfaces/srv/GetParameters"),
    ("list_parameters", "rcl_interfaces/srv/ListParameters"),
    ("set_parameters", "rcl_interfaces/srv/SetParameters"),
    ("set_parameters_atomically", "rcl_interfaces/srv/SetParametersAtomically"),
)

_LIFECYCLE_SERVICES: Final = (
    ("change_state", "lifecycle_msgs/srv/ChangeState"),
    ("get_available_states", "lifecycle_msgs/srv/GetAvailableStates"),
    ("get_available_transitions", "lifecycle_msgs/srv/GetAvailableTransitions"),
    ("get_state", "lifecycle_msgs/srv/GetState"),
    ("get_transition_graph", "lifecycle_msgs/srv/GetAvailableTransitions"),  # the same type, really
)

_LOGGER_SERVICES: Final = (
    ("get_logger_levels", "rcl_interfaces/srv/GetLoggerLevels"),
    ("set_logger_levels", "rcl_interfaces/srv/SetLoggerLevels"),
)

_PUBLISHER, _SUBSCRIPTION, _SERVER = EntityKind.PUBLISHER, EntityKind.SUBSCRIPTION, EntityKind.SERVICE_SERVER

_EVENTS: Final = "rcl_interfaces/msg/ParameterEvent"

_BOTH: Final = (
    _Row(_Switch.ROSOUT, _PUBLISHER, "/rosout", "rcl_interfaces/msg/Log", _reliable(1000, "transient_local")),
    _Row(
        _Switch.SIM_TIME,
        _SUBSCRIPTION,
        "/clock",
        "rosgraph_msgs/msg/Clock",
        Qos("best_effort", "volatile", "keep_last", 1),
    ),
    *(_Row(_Switch.PARAMETER_SERVICES, _SERVER, f"~/{n}", t, _PARAMETERS) for n, t in _PARAMETER_SERVICES),
    _Row(
        _Switch.TYPE_DESCRIPTION,
        _SERVER,
        "~/get_type_description",
        "type_description_interfaces/srv/GetTypeDescription",
        _SERVICE,
    ),
    *(_Row(_Switch.LOGGER_SERVICE, _SERVER, f"~/{n}", t, _SERVICE) for n, t in _LOGGER_SERVICES),
    _Row(_Switch.LIFECYCLE, _PUBLISHER, "~/transition_event", "lifecycle_msgs/msg/TransitionEvent", _reliable(10)),
    *(_Row(_Switch.LIFECYCLE_SERVICES, _SERVER, f"~/{n}", t, _SERVICE) for n, t in _LIFECYCLE_SERVICES),
)

_ASKED: Final = frozenset({_Switch.ALWAYS, _Switch.SIM_TIME, _Switch.PARAMETER_SERVICES, _Switch.LOGGER_SERVICE})
"""What rclpy makes by `create_publisher`, `create_subscription` and `create_service` of the node; the rest rcl makes itself."""

_RCLPY: Final = (*_BOTH, _Row(_Switch.ALWAYS, _PUBLISHER, "/parameter_events", _EVENTS, _reliable(1000)))

_RCLCPP: Final = (
    *_BOTH,
    _Row(_Switch.PARAMETER_EVENTS, _PUBLISHER, "/parameter_events", _EVENTS, _reliable(1000)),
    _Row(_Switch.ALWAYS, _SUBSCRIPTION, "/parameter_events", _EVENTS, _reliable(1000)),
    _Row(  # of that subscription
        _Switch.TOPIC_STATISTICS,
        _PUBLISHER,
        "/statistics",
        "statistics_msgs/msg/MetricsMessage",
        Qos("system_default", "system_default", "keep_last", 10),
    ),
)


def _rows(client_library: ClientLibrary) -> tuple[_Row, ...]:
    return _RCLPY if client_library is ClientLibrary.RCLPY else _RCLCPP


def implicit_entities(
    distro: Distro,
    *,
    node_fqn: str,
    enable_rosout: bool = True,
    start_parameter_services: bool = True,
    start_parameter_event_publisher: bool = True,
    type_description: bool = True,
    logger_service: bool = False,
    use_sim_time: bool = False,
    lifecycle: bool = False,
    lifecycle_services: bool = True,
    asked: bool = False,
    topic_statistics: bool = False,
    client_library: ClientLibrary = ClientLibrary.RCLPY,
) -> tuple[Entity, ...]:
    """The endpoints that the client library gives the node `node_fqn` by itself, sorted by kind and name.

    `enable_rosout` is the option of the node and the absence of `--disable-rosout-logs`; `type_description` the
    parameter `start_type_description_service`; `lifecycle_services` the option `enable_communication_interface` of a
    lifecycle node, without which `~/transition_event` remains (rcl_lifecycle.c). With `asked`, only those that rclpy makes
    through methods of the node, which a program may override; without, all of them. rclpy has no switch for the publisher
    of parameter events. The names are those before remapping:
    rcl remaps them like any other (`/rosout:=/log` works).
    """
    on = {_Switch.ALWAYS}
    on |= {_Switch.ROSOUT} if enable_rosout else set()
    on |= {_Switch.PARAMETER_EVENTS} if start_parameter_event_publisher else set()
    on |= {_Switch.PARAMETER_SERVICES} if start_parameter_services else set()
    on |= {_Switch.TYPE_DESCRIPTION} if type_description and distro.facts.type_description else set()
    on |= {_Switch.LOGGER_SERVICE} if logger_service and distro.facts.logger_services else set()
    on |= {_Switch.TOPIC_STATISTICS} if topic_statistics else set()
    on |= {_Switch.SIM_TIME} if use_sim_time else set()
    on |= {_Switch.LIFECYCLE} if lifecycle else set()
    on |= {_Switch.LIFECYCLE_SERVICES} if lifecycle and lifecycle_services else set()
    entities = [
        Entity(row.kind, row.name.replace("~", node_fqn, 1), row.type, system=True, qos=row.qos)
        for row in _rows(client_library)
        if row.switch in on and (not asked or row.switch in _ASKED)
    ]
    return tuple(sorted(entities, key=lambda entity: (entity.kind.value, entity.name)))


def service_event_topic(
    distro: Distro, service: str, service_type: str | None, *, action: bool = False
) -> Entity | None:
    """The hidden publisher that `configure_introspection` gives a server or a client of the service `service`.

    `service` is its full name after remapping; the topic may be remapped in turn. None where the distribution has
    none; those for the services of an action (`action`) came later. The state OFF makes none, METADATA and CONTENTS do.
    The QoS is an argument of `configure_introspection`.
    """
    if not (distro.facts.action_service_events if action else distro.facts.service_events):
        return None
    event_type = None if service_type is None else f"{service_type}_Event"
    return Entity(EntityKind.PUBLISHER, f"{service}/_service_event", event_type, system=True)


def parameter_client_services(remote: str) -> tuple[tuple[str, str], ...]:
    """Names, unexpanded, and types of the clients of `AsyncParameterClient(node, remote)` (rclpy parameter_client.py).

    They are the same in each distribution that has the class (iron and later). A relative `remote` makes relative
    names, which belong to the namespace of the node that has the clients, not of the remote one.
    """
    return tuple((f"{remote}/{name}", service_type) for name, service_type in _PARAMETER_SERVICES)
