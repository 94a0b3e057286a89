# SPDX-License-Identifier: Apache-2.0
"""Which topics does rviz2 use, given its configuration file?

    rviz2 -d view.rviz, with a display LaserScan of topic /scan    a subscription to /scan
    a tool SetGoal of topic /goal_pose                             a publisher of it

Read from ros2/rviz (rolling f7112b1, October 2024): rviz_default_plugins/plugins_description.xml and the displays and tools themselves
(message_filter_display.hpp, image_transport_display.hpp, get_transport_from_topic.cpp, camera_display.cpp, depth_cloud_display.cpp,
effort_display.cpp, map_display.cpp, marker_display.cpp, robot_model_display.cpp, goal_tool.cpp, point_tool.cpp, initial_pose_tool.cpp),
rviz_common (visualizer_app.cpp, view_controller.cpp) and interactive_markers (interactive_marker_client.cpp).
A display that is switched off subscribes when somebody switches it on.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Final

from rosward.deployment.declared.found import FilesRead, FoundEndpoint, Open
from rosward.deployment.declared.text import TemplateScope, argument
from rosward.domain.choice import reasons_of
from rosward.domain.values import EMPTY, Const
from rosward.ros.entities import Qos
from rosward.source.yaml_nodes import Item, Malformed

_SUBSCRIBED: Final[Mapping[str, str]] = {
    "AccelStamped": "geometry_msgs/msg/AccelStamped",
    "CameraInfo": "sensor_msgs/msg/CameraInfo",
    "Effort": "sensor_msgs/msg/JointState",
    "FluidPressure": "sensor_msgs/msg/FluidPressure",
    "GridCells": "nav_msgs/msg/GridCells",
    "Illuminance": "sensor_msgs/msg/Illuminance",
    "LaserScan": "sensor_msgs/msg/LaserScan",
    "Map": "nav_msgs/msg/OccupancyGrid",
    "Marker": "visualization_msgs/msg/Marker",
    "MarkerArray": "visualization_msgs/msg/MarkerArray",
    "Odometry": "nav_msgs/msg/Odometry",
    "Path": "nav_msgs/msg/Path",
    "PointCloud": "sensor_msgs/msg/PointCloud",
    "PointCloud2": "sensor_msgs/msg/PointCloud2",
    "PointStamped": "geometry_msgs/msg/PointStamped",
    "Polygon": "geometry_msgs/msg/PolygonStamped",
    "Pose": "geometry_msgs/msg/PoseStamped",
    "PoseArray": "geometry_msgs/msg/PoseArray",
    "PoseWithCovariance": "geometry_msgs/msg/PoseWithCovarianceStamped",
    "Range": "sensor_msgs/msg/Range",
    "RelativeHumidity": "sensor_msgs/msg/RelativeHumidity",
    "Temperature": "sensor_msgs/msg/Temperature",
    "TwistStamped": "geometry_msgs/msg/TwistStamped",
    "Wrench": "geometry_msgs/msg/WrenchStamped",
}
_OF_OTHERS: Final[Mapping[str, str]] = {"nav2_rviz_plugins/ParticleCloud": "nav2_msgs/msg/ParticleCloud"}
"""Displays of other packages that subscribe to their topic and do nothing else (nav2: src/particle_cloud_display)."""

_TOOLS: Final[Mapping[str, tuple[str, str]]] = {
    "SetInitialPose": ("initialpose", "geometry_msgs/msg/PoseWithCovarianceStamped"),
    "SetGoal": ("goal_pose", "geometry_msgs/msg/PoseStamped"),
    "PublishPoint": ("clicked_point", "geometry_msgs/msg/PointStamped"),
}
_SILENT: Final = frozenset(
    ("Axes", "Grid", "TF", "MoveCamera", "Select", "Measure", "FocusCamera", "Interact", "FPS", "Orbit", "TopDownOrtho")
) | {"XYOrbit", "ThirdPersonFollower"}
_IMAGES: Final[Mapping[str, str]] = {
    "raw": "sensor_msgs/msg/Image",
    "compressed": "sensor_msgs/msg/CompressedImage",
    "compressedDepth": "sensor_msgs/msg/CompressedImage",
    "theora": "theora_image_transport/msg/Packet",
}
_STRING: Final = "std_msgs/msg/String"
_INFO: Final = "sensor_msgs/msg/CameraInfo"
_LATCHED: Final = Qos("reliable", "transient_local", "keep_last", 1)
_SENSOR: Final = Qos("best_effort", "volatile", "keep_last", 5)
_DEFAULT: Final = Qos("reliable", "volatile", "keep_last", 5)
_DEEPEST: Final = 20

Found_ = Iterator["FoundEndpoint | Open"]


def rviz(scope: TemplateScope, files: FilesRead) -> Found_:
    """What the configuration of rviz2 makes it subscribe to and publish."""
    path = argument("-d", scope)
    path = argument("--display-config", scope) if path == EMPTY else path
    if path == EMPTY:
        yield from (_endpoint("publisher", name, type_, _DEFAULT) for name, type_ in _TOOLS.values())
        yield Open("without -d it loads the user's own ~/.rviz2/default.rviz")
        return
    try:
        document = files.yaml(path, repeated=True)
    except Malformed as error:
        yield Open(f"its configuration file cannot be read: {error.message}")
        return
    if document is None:
        why = "; ".join(str(r) for r in reasons_of(path))
        yield Open(f"its configuration file is not among the sources{f' ({why})' if why else ''}")
        return
    manager = _child(document, "Visualization Manager")
    yield from _displays(_child(manager, "Displays"), 0, shown=True)
    yield from _tools(_child(manager, "Tools"))
    yield from _panels(_child(document, "Panels"))


def _child(item: Item | None, key: str) -> Item | None:
    return item.value.get(key) if item is not None and isinstance(item.value, dict) else None


def _list(item: Item | None) -> list[Item]:
    return item.value if item is not None and isinstance(item.value, list) else []


def _word(item: Item | None, key: str) -> str:
    """The text of a property, written plainly or as the `Value` of a mapping."""
    found = _child(item, key)
    if found is not None and isinstance(found.value, dict):
        found = found.value.get("Value")
    return found.value if found is not None and isinstance(found.value, str) else ""


def _endpoint(kind: str, name: str, type_: str, qos: Qos | None, *, certain: bool = True) -> FoundEndpoint:
    return FoundEndpoint(kind, Const(name), Const(type_), qos, certain)


def _panels(panels: Item | None) -> Found_:
    for panel in _list(panels):
        name = _word(panel, "Class")
        if name and not name.startswith(("rviz_common/", "rviz/")):
            yield Open(f"its panel {name} is unknown")


def _tools(tools: Item | None) -> Found_:
    for tool in _list(tools):
        library, _, name = _word(tool, "Class").partition("/")
        if library not in ("rviz_default_plugins", "rviz") or (name not in _TOOLS and name not in _SILENT):
            if f"{library}/{name}" != "nav2_rviz_plugins/GoalTool":  # it hands the goal to a panel
                yield Open(f"its tool {library}/{name} is unknown")
        elif name in _TOOLS:
            default, type_ = _TOOLS[name]
            yield _endpoint("publisher", _word(tool, "Topic") or default, type_, _profile(tool, "Topic"))


def _displays(displays: Item | None, depth: int, *, shown: bool) -> Found_:
    for display in _list(displays):
        library, _, name = _word(display, "Class").partition("/")
        enabled = _child(display, "Enabled")
        certain = shown and not (enabled is not None and enabled.value is False)
        if (library, name) == ("rviz_common", "Group") and depth < _DEEPEST:
            yield from _displays(_child(display, "Displays"), depth + 1, shown=certain)
        elif library in ("rviz_default_plugins", "rviz"):
            for found in _display(display, name):
                yield found._replace(certain=certain) if isinstance(found, FoundEndpoint) else found
        elif f"{library}/{name}" in _OF_OTHERS:
            topic, type_ = _word(display, "Topic"), _OF_OTHERS[f"{library}/{name}"]
            if topic:
                yield _endpoint("subscription", topic, type_, _profile(display, "Topic"), certain=certain)
        else:
            yield Open(f"its display {library}/{name} is unknown")


def _display(display: Item, name: str) -> Found_:
    if name in ("Image", "Camera"):
        yield from _image(_word(display, "Topic") or _word(display, "Image Topic"), _profile(display, "Topic"))
        if name == "Camera":
            yield from _camera_info(_word(display, "Topic"))
    elif name == "DepthCloud":
        for key, hint in (
            ("Depth Map Topic", "Depth Map Transport Hint"),
            ("Color Image Topic", "Color Transport Hint"),
        ):
            transport = _word(display, hint) or "raw"
            base = _word(display, key)
            yield from _image(base if transport == "raw" or not base else f"{base}/{transport}", _profile(display, key))
        yield from _camera_info(_word(display, "Depth Map Topic"))
    elif name == "InteractiveMarkers":
        yield from _interactive(_word(display, "Interactive Markers Namespace"))
    elif name == "RobotModel":
        topic = _word(display, "Description Topic")
        if topic and _word(display, "Description Source") in ("", "Topic"):
            yield _endpoint("subscription", topic, _STRING, _LATCHED)
    elif name in _SUBSCRIBED:
        yield from _subscribed(display, name)
    elif name not in _SILENT:
        yield Open(f"its display {name} is unknown")


def _subscribed(display: Item, name: str) -> Found_:
    topic = _word(display, "Topic")
    if topic:
        yield _endpoint("subscription", topic, _SUBSCRIBED[name], _profile(display, "Topic"))
    if name == "Map" and (_word(display, "Update Topic") or topic):
        updates = _word(display, "Update Topic") or f"{topic}_updates"
        yield _endpoint("subscription", updates, "map_msgs/msg/OccupancyGridUpdate", _profile(display, "Update Topic"))
    if name == "Marker" and topic:
        type_ = "visualization_msgs/msg/MarkerArray"
        yield _endpoint("subscription", f"{topic}_array", type_, _profile(display, "Topic"))
    if name == "Effort" and _word(display, "Robot Description"):
        yield _endpoint("subscription", _word(display, "Robot Description"), _STRING, _LATCHED)


def _image(topic: str, qos: Qos) -> Found_:
    """The last part of a topic names its transport, where it is one."""
    last = topic.rpartition("/")[2]
    if topic:
        yield _endpoint("subscription", topic, _IMAGES[last if last in _IMAGES else "raw"], qos)


def _camera_info(topic: str) -> Found_:
    if topic:
        yield _endpoint("subscription", f"{topic.rpartition('/')[0]}/camera_info", _INFO, _SENSOR)


def _interactive(namespace: str) -> Found_:
    if not namespace:
        return
    base = "visualization_msgs"
    yield _endpoint("subscription", f"{namespace}/update", f"{base}/msg/InteractiveMarkerUpdate", _DEFAULT)
    yield _endpoint("publisher", f"{namespace}/feedback", f"{base}/msg/InteractiveMarkerFeedback", _DEFAULT)
    yield _endpoint("service_client", f"{namespace}/get_interactive_markers", f"{base}/srv/GetInteractiveMarkers", None)


def _profile(display: Item, key: str) -> Qos:
    """The QoS that stands beside the topic."""
    topic = _child(display, key)
    words = [
        _word(topic, policy).lower().replace(" ", "_") or default
        for policy, default in (
            ("Reliability Policy", "reliable"),
            ("Durability Policy", "volatile"),
            ("History Policy", "keep_last"),
        )
    ]
    depth = _child(topic, "Depth")
    return Qos(words[0], words[1], words[2], depth.value if depth is not None and isinstance(depth.value, int) else 5)
