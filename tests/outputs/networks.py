# SPDX-License-Identifier: Apache-2.0
"""Small networks, made by hand, that the tests of the outputs share."""

from __future__ import annotations

from typing import Any, Final

from rosward.findings import Finding
from rosward.location import Place
from rosward.network.connect import connect
from rosward.network.graph import Network
from rosward.ros.entities import Entity, EntityKind, Node, Parameter, Qos, Resolution

SYSTEM_SERVICES = (
    "describe_parameters",
    "get_parameter_types",
    "get_parameters",
    "get_type_description",
    "list_parameters",
    "set_parameters",
    "set_parameters_atomically",
)


def entity(
    kind: EntityKind, name: str, type_: str | None = "std_msgs/msg/String", line: int = 1, **more: Any
) -> Entity:
    more.setdefault("created_at", (Place("src/demo/demo/node.py", line, 9),))
    return Entity(kind, name, type_, **more)


def pub(name: str, type_: str | None = "std_msgs/msg/String", line: int = 1, **more: Any) -> Entity:
    return entity(EntityKind.PUBLISHER, name, type_, line, **more)


def sub(name: str, type_: str | None = "std_msgs/msg/String", line: int = 1, **more: Any) -> Entity:
    return entity(EntityKind.SUBSCRIPTION, name, type_, line, **more)


def system_entities(fqn: str) -> list[Entity]:
    made = [
        pub("/rosout", "rcl_interfaces/msg/Log", system=True, created_at=()),
        pub("/parameter_events", "rcl_interfaces/msg/ParameterEvent", system=True, created_at=()),
    ]
    for name in SYSTEM_SERVICES:
        type_ = "rcl_interfaces/srv/" + "".join(word.title() for word in name.split("_"))
        made.append(entity(EntityKind.SERVICE_SERVER, f"{fqn}/{name}", type_, system=True, created_at=()))
    return made


def node(fqn: str, *entities: Entity, system: bool = True, **more: Any) -> Node:
    namespace, _, name = fqn.rpartition("/")
    record: dict[str, Any] = {
        "namespace": namespace or "/",
        "name": name,
        "resolution": Resolution.PATTERN if "*" in fqn else Resolution.EXACT,
        "enclave": fqn,
        "package": "demo",
        "executable": name,
        "process": f"demo{fqn}",
        "launched_by": None,
        "defined_at": Place(f"src/demo/demo/{name.replace('*', 'any')}.py", 7, 1),
        **more,
    }
    record["entities"] = (*entities, *(system_entities(fqn) if system else ()))
    return Node(**record)


def talker_and_listener() -> Network:
    """Two nodes, one topic, one service, one action; a pattern, a default, an unknown name, a doubt."""
    talker = node(
        "/robot1/talker",
        pub("/robot1/chatter", line=20, qos=Qos("reliable", "volatile", "keep_last", 10)),
        pub(
            "/robot_*/cmd_vel",
            "geometry_msgs/msg/Twist",
            line=31,
            resolution=Resolution.PATTERN,
            conditional=True,
            depends_on=("robot_id",),
            reasons=("parameter 'robot_id' has no default (src/demo/demo/node.py:12)",),
        ),
        entity(
            EntityKind.SERVICE_CLIENT, "/add", "example_interfaces/srv/AddTwoInts", 40, resolution=Resolution.DEFAULT
        ),
        parameters=(Parameter("rate", "double", 10.0, 10.0, Place("src/demo/demo/node.py", 11)),),
    )
    listener = node(
        "/robot1/listener",
        sub("/robot1/chatter", line=50, callback="Listener.on_message"),
        entity(EntityKind.SERVICE_SERVER, "/add", "example_interfaces/srv/AddTwoInts", 52, callback="Listener.on_add"),
        entity(
            EntityKind.ACTION_SERVER, "/robot1/dock", "demo_interfaces/action/Dock", 54, callback="Listener.on_dock"
        ),
        pub(
            "/robot1/*", None, line=60, resolution=Resolution.UNKNOWN, reasons=("sys.argv[1] is not known (main.py:3)",)
        ),
    )
    findings = [
        Finding(
            "RW101",
            "publisher of node /robot1/listener: sys.argv[1] is not known (main.py:3)",
            Place("src/demo/demo/node.py", 60, 9),
        ),
        Finding(
            "RW102",
            "publisher /robot_*/cmd_vel: parameter 'robot_id' has no default",
            Place("src/demo/demo/node.py", 31, 9),
        ),
    ]
    return connect("jazzy", [talker, listener], findings, files=2, lines=120, processes=2)


def fleet(robots: int = 8, each: int = 6) -> Network:
    """A fleet with about robots * each + 2 nodes: what a graph of fifty nodes looks like."""
    nodes = []
    kind = EntityKind
    for index in range(1, robots + 1):
        ns = f"/robot{index}"
        nodes += [
            node(f"{ns}/lidar_driver", pub(f"{ns}/scan", "sensor_msgs/msg/LaserScan")),
            node(
                f"{ns}/localization",
                sub(f"{ns}/scan", "sensor_msgs/msg/LaserScan"),
                sub(f"{ns}/odom", "nav_msgs/msg/Odometry"),
                sub("/map", "nav_msgs/msg/OccupancyGrid"),
                pub(f"{ns}/pose", "geometry_msgs/msg/PoseStamped"),
                pub("/tf", "tf2_msgs/msg/TFMessage", via="tf2_ros.TransformBroadcaster"),
            ),
            node(
                f"{ns}/planner",
                sub(f"{ns}/pose", "geometry_msgs/msg/PoseStamped"),
                entity(kind.ACTION_SERVER, f"{ns}/navigate", "demo/action/Navigate"),
                pub(f"{ns}/plan", "nav_msgs/msg/Path"),
            ),
            node(
                f"{ns}/controller",
                sub(f"{ns}/plan", "nav_msgs/msg/Path"),
                pub(f"{ns}/cmd_vel", "geometry_msgs/msg/Twist"),
                entity(kind.SERVICE_SERVER, f"{ns}/stop", "std_srvs/srv/Trigger", conditional=index % 3 == 0),
            ),
            node(
                f"{ns}/base_driver",
                sub(f"{ns}/cmd_vel", "geometry_msgs/msg/Twist"),
                pub(f"{ns}/odom", "nav_msgs/msg/Odometry"),
                pub(f"{ns}/battery", "sensor_msgs/msg/BatteryState"),
            ),
            node(
                f"{ns}/delivery",
                entity(kind.ACTION_CLIENT, f"{ns}/navigate", "demo/action/Navigate"),
                entity(kind.SERVICE_CLIENT, f"{ns}/stop", "std_srvs/srv/Trigger", conditional=True),
                sub("/orders", "demo/msg/Order"),
                pub("/order_state", "demo/msg/OrderState"),
            ),
        ][:each]
    nodes += [
        node("/map_server", pub("/map", "nav_msgs/msg/OccupancyGrid")),
        node(
            "/dispatcher",
            pub("/orders", "demo/msg/Order"),
            sub("/order_state", "demo/msg/OrderState"),
            sub("/robot*/battery", "sensor_msgs/msg/BatteryState", resolution=Resolution.PATTERN),
            pub("/*", None, resolution=Resolution.UNKNOWN, reasons=("environment variable TOPIC",)),
        ),
    ]
    return connect("jazzy", nodes, [], files=len(nodes), lines=4000, processes=len(nodes))


_AREAS: Final = (
    "/sensing/lidar/top", "/sensing/lidar/left", "/sensing/camera0", "/localization", "/localization/util",
    "/perception/object_recognition/detection", "/perception/object_recognition/tracking", "/perception/traffic_light_recognition/camera0",
    "/planning/mission_planning", "/planning/scenario_planning/lane_driving/behavior_planning", "/planning/scenario_planning/parking",
    "/control", "/control/trajectory_follower", "/system", "/vehicle", "/map", "/",
)  # fmt: skip


def stack(count: int) -> Network:
    """So many nodes in the namespaces of a self-driving car: chains within, containers, and what goes across."""
    nodes = []
    for index in range(count):
        area = index % len(_AREAS)
        space, number = _AREAS[area].rstrip("/"), index // len(_AREAS)
        process = f"rclcpp_components/component_container_mt#{area}" if area % 3 == 0 else f"stack/node_{index}"
        before = f"{space}/{'points' if number else 'raw'}_{number}"
        entities = [
            sub(before, "demo/msg/Points"),
            pub(f"{space}/points_{number + 1}", "demo/msg/Points"),
            pub("/diagnostics", "diagnostic_msgs/msg/DiagnosticArray"),
            sub("/clock", "rosgraph_msgs/msg/Clock"),
        ]
        if number == 0:
            entities += [sub(f"{_AREAS[area - 1].rstrip('/')}/points_1"), sub("/map/points_1"), pub("/tf"), sub("/tf")]
        if number % 4 == 1:
            entities.append(entity(EntityKind.SERVICE_SERVER, f"{space}/stage_{number}/reset", "std_srvs/srv/Trigger"))
        nodes.append(node(f"{space}/stage_{number}_of_filter", *entities, process=process, package=f"stack_{area}"))
    return connect("jazzy", nodes, [], files=count, lines=100 * count, processes=count)


def hostile(text: str) -> Network:
    """A node whose every text is the same one."""
    bad = node(
        "/a",
        pub(
            "/" + text, text, callback=text, reasons=(text,), depends_on=(text,), via=text, created_at=(Place(text, 1),)
        ),
        name=text,
        namespace="/" + text,
        process=text,
        reasons=(text,),
        defined_at=Place(text, 2),
        parameters=(Parameter(text, text, text, [text], Place(text, 4)),),
    )
    return connect("jazzy", [bad], [Finding("RW101", text, Place(text, 3))])
