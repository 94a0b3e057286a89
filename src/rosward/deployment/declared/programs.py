# SPDX-License-Identifier: Apache-2.0
"""Programs whose interface stands in their arguments or in a file, in a form that the notation cannot say.

    parameter_bridge /scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan    a publisher /scan of that type
    rviz2 -d view.rviz                                                    what the displays and tools of the file need (declared_rviz)

A declaration names one by `reader:`. Each gives endpoints, or says what it could not find out.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Final

from rosward.deployment.declared.found import FilesRead, FoundEndpoint, Open, Reader, constant
from rosward.deployment.declared.rviz import rviz
from rosward.deployment.declared.text import TemplateScope, as_text
from rosward.domain.choice import options, reasons_of
from rosward.domain.text import concat, origins_of, parts_of
from rosward.domain.values import EMPTY, Const, Unknown, Value
from rosward.ros.entities import Qos
from rosward.source.yaml_nodes import Item, Malformed

_QUEUE: Final = 10


def gz_bridge(scope: TemplateScope, files: FilesRead) -> Iterator[FoundEndpoint | Open]:
    """ros_gz_bridge's parameter_bridge: `/topic@type@gz_type`, `/topic@type[gz_type`, `/topic@type]gz_type`, `/service@type`; its config_file.

    Read from gazebosim/ros_gz (ros2 a4d00a9, October 2024): parameter_bridge.cpp, ros_gz_bridge.cpp, bridge_config.cpp.
    """
    for word in scope.arguments:
        for option in options(word):
            found = _bridged(option)
            if not found:
                why = "; ".join(str(r) for r in reasons_of(option))
                yield Open(f"one of its arguments does not name a bridge{f' ({why})' if why else ''}")
            for each in found:
                yield each._replace(certain=len(options(word)) == 1)
    path = scope.parameters.value("config_file")
    if path == EMPTY or (isinstance(path, Const) and not path.value):
        return
    try:
        document = files.yaml(path)
        if document is None:
            yield Open("the file named by its parameter config_file is not among the sources")
        else:
            yield from _configured(document)
    except Malformed as error:
        yield Open(f"the file named by its parameter config_file cannot be read: {error.message}")


def _bridged(word: Value) -> list[FoundEndpoint]:
    name, mark, rest = _cut(word, "@")
    if not mark or name == EMPTY:
        return []
    type_, mark, _ = _cut(rest, "@[]")
    text = constant(type_)
    if text is not None and "/srv/" in text:
        return [FoundEndpoint("service_server", name, type_, None)]
    if not mark:
        return []
    subscription, publisher = FoundEndpoint("subscription", name, type_), FoundEndpoint("publisher", name, type_)
    return {"@": [publisher, subscription], "[": [publisher], "]": [subscription]}[mark]


def _cut(value: Value, marks: str) -> tuple[Value, str, Value]:
    """A text before and behind the first of some characters, and which it was."""
    parts = parts_of(value)
    for at, part in enumerate(parts):
        if not isinstance(part, str):
            continue
        places = [p for p in (part.find(m) for m in marks) if p >= 0]
        if places:
            first = min(places)
            origins = origins_of(value)
            before = [*_values(parts[:at]), Const(part[:first], origins)]
            behind = [Const(part[first + 1 :], origins), *_values(parts[at + 1 :])]
            return concat(before), part[first], concat(behind)
    return value, "", EMPTY


def _values(parts: tuple[object, ...]) -> list[Value]:
    return [Const(p) if isinstance(p, str) else Unknown(getattr(p, "reasons", ()), "str") for p in parts]


def _configured(file: Item) -> Iterator[FoundEndpoint | Open]:
    """The entries of the YAML file of a bridge."""
    for entry in file.items():
        shape = entry.mapping()
        words = {k: str(v.value) for k, v in shape.items() if v.value is not None}
        type_ = Const(words.get("ros_type_name", ""))
        if "service_name" in words:
            yield FoundEndpoint("service_server", Const(words["service_name"]), type_, None)
            continue
        name = Const(words.get("topic_name") or words.get("ros_topic_name") or words.get("gz_topic_name", ""))
        direction = words.get("direction", "BIDIRECTIONAL")
        if not name.value or not type_.value:
            continue  # the bridge leaves it out, too
        if direction in ("BIDIRECTIONAL", "GZ_TO_ROS"):
            yield FoundEndpoint("publisher", name, type_, _depth(words.get("publisher_queue")))
        if direction in ("BIDIRECTIONAL", "ROS_TO_GZ"):
            yield FoundEndpoint("subscription", name, type_, _depth(words.get("subscriber_queue")))


def _depth(text: str | None) -> Qos:
    return Qos("reliable", "volatile", "keep_last", int(text) if text and text.isdigit() else _QUEUE)


def gz_image_bridge(scope: TemplateScope, files: FilesRead) -> Iterator[FoundEndpoint | Open]:  # noqa: ARG001 (the shape of a Reader)
    """ros_gz_image's image_bridge: each argument is a topic, published by image_transport.

    Read from gazebosim/ros_gz (ros2 a4d00a9, October 2024): image_bridge.cpp.
    """
    for word in scope.arguments:
        for topic in options(word):
            yield from published_images(scope.resolve(as_text(topic), True), certain=len(options(word)) == 1)


def published_images(topic: Value, *, certain: bool = True) -> Iterator[FoundEndpoint]:
    """What image_transport advertises for a topic: one topic of each transport that is installed."""
    qos = Qos("reliable", "volatile", "keep_last", 1)
    yield FoundEndpoint("publisher", topic, Const("sensor_msgs/msg/Image"), qos, certain)
    for transport, type_ in (
        ("compressed", "sensor_msgs/msg/CompressedImage"),
        ("compressedDepth", "sensor_msgs/msg/CompressedImage"),
        ("theora", "theora_image_transport/msg/Packet"),
        ("zstd", "sensor_msgs/msg/CompressedImage"),
    ):
        yield FoundEndpoint("publisher", concat((topic, Const(f"/{transport}"))), Const(type_), qos, certain=False)


READERS: Final[Mapping[str, Reader]] = MappingProxyType(
    {"rviz": rviz, "gz_bridge": gz_bridge, "gz_image_bridge": gz_image_bridge}
)
