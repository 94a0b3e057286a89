# SPDX-License-Identifier: Apache-2.0
"""What is in the graph of the running robot? One plain file: it needs rclpy, the standard library and nothing else.

    python3 snapshot.py -o robot.json    ->  {"schema_version": 1, "looks": 10, "nodes": [{"name": "talker", "publishers": […], …}], …}

The graph is looked at several times and the looks are united, so what only sometimes exists is there as well, with how often it was seen.
Nothing is changed in the graph but that for these seconds it has one more, hidden node, which is not in the document. Written for Python
3.8 and later, and for the rclpy of humble and later: what an older one does not tell is left out.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import sys
import time
import uuid
from collections import Counter
from collections.abc import Sequence
from typing import Any, NamedTuple

try:
    import rclpy
    import rclpy.parameter
except ImportError:  # `take` tells it
    rclpy = None

SCHEMA_VERSION = 1
VERSION = "1"
NODE_PREFIX = "_rosward_snapshot_"

KINDS = ("publishers", "subscriptions", "service_servers", "service_clients", "action_servers", "action_clients")
_BY_NODE = (
    ("publishers", "get_publisher_names_and_types_by_node"),
    ("subscriptions", "get_subscriber_names_and_types_by_node"),
    ("service_servers", "get_service_names_and_types_by_node"),
    ("service_clients", "get_client_names_and_types_by_node"),
)
_BY_TOPIC = (("publishers", "get_publishers_info_by_topic"), ("subscriptions", "get_subscriptions_info_by_topic"))
_WHO_REQUESTS = {"publishers": "service_clients", "subscriptions": "service_servers"}
_NO_NODE = ("_NODE_NAME_UNKNOWN_", "_CREATED_BY_BARE_DDS_APP_")
_OF_MIDDLEWARE = ("ros_discovery_info",)
_NOT_KNOWN = ("unknown", "system_default", "best_available")
_GOAL = "/_action/send_goal"
_DDS_TYPE = re.compile(r"(\w+)::(\w+)::dds_::(\w+)_")
_PAUSE = 0.5
_MOST_PROBLEMS = 100


class SnapshotItem(NamedTuple):
    """One entity: in which list of the document it is, its name and type, and whether its topic keeps ROS's conventions for names."""

    kind: str
    name: str
    type: str
    ros_prefix: bool = True


class Sighting:
    """In how many looks something was seen, and with which QoS."""

    def __init__(self) -> None:
        self.looks = 0
        self.qos: set[tuple[tuple[str, object], ...]] = set()


class SeenNode:
    """What was seen of the nodes of one full name. `asked` counts the looks in which the middleware told what they have."""

    def __init__(self) -> None:
        self.looks = 0
        self.asked = 0
        self.count = 1
        self.enclaves: set[str] = set()
        self.items: dict[SnapshotItem, Sighting] = {}


class Observer:
    """Unites the looks at a graph through one node of rclpy."""

    def __init__(self, node: Any) -> None:
        self.node = node
        self.own = (node.get_name(), node.get_namespace())
        self.looks = 0
        self.nodes: dict[tuple[str, str], SeenNode] = {}
        self.loose: dict[SnapshotItem, Sighting] = {}
        self.problems: dict[str, None] = {}
        self._owned: set[tuple[int, ...]] = set()
        self._unowned: dict[tuple[int, ...], set[SnapshotItem]] = {}

    def look(self) -> None:
        """Look once."""
        self.looks += 1
        found: dict[tuple[str, str], set[SnapshotItem]] = {}
        for key, number in self._names().items():
            found[key] = set()
            self.nodes[key].count = max(self.nodes[key].count, number)
        for key, items in found.items():
            self.nodes[key].asked += self._ask(key, items)
        loose: set[SnapshotItem] = set()
        self._endpoints(found, loose)
        for key, items in found.items():
            self.nodes[key].looks += 1
            for item in items | _actions(items):
                self.nodes[key].items.setdefault(item, Sighting()).looks += 1
        for item in loose:
            self.loose.setdefault(item, Sighting()).looks += 1

    def _names(self) -> Counter[tuple[str, str]]:
        """Names and namespaces of all nodes but the own one, with the number of nodes that have them."""
        if hasattr(self.node, "get_node_names_and_namespaces_with_enclaves"):
            rows = list(self.node.get_node_names_and_namespaces_with_enclaves())
        else:
            rows = [(*row, None) for row in self.node.get_node_names_and_namespaces()]
        names: Counter[tuple[str, str]] = Counter()
        for name, space, enclave in rows:
            if (name, space) != self.own and not name.startswith(_NO_NODE):
                names[name, space] += 1
                seen = self.nodes.setdefault((name, space), SeenNode())
                seen.enclaves.update([] if enclave is None else [enclave])
        return names

    def _ask(self, key: tuple[str, str], found: set[SnapshotItem]) -> bool:
        """What a node has, by its name; of several nodes of one name the middleware tells of one."""
        try:
            for kind, method in _BY_NODE:
                for name, types in getattr(self.node, method)(*key):
                    found.update(SnapshotItem(kind, name, type_) for type_ in types)
        except Exception as error:  # it has just gone, or has a name that rclpy does not take
            self._tell(f"node {key[0]} in {key[1]}: {error}")
            return False
        return True

    def _endpoints(self, found: dict[tuple[str, str], set[SnapshotItem]], loose: set[SnapshotItem]) -> None:
        """Each endpoint by its topic: for QoS, endpoints of a second node of one name, endpoints of no node."""
        topics = {name for name, _ in self.node.get_topic_names_and_types()}
        for name in sorted(topics):
            self._at(name, SnapshotItem("", name, ""), found, loose)
        for raw, _ in self.node.get_topic_names_and_types(no_demangle=True):
            if raw.startswith("rq/") and raw.endswith("Request"):
                self._at(raw, SnapshotItem("service", raw[2 : -len("Request")], ""), found, loose)
            elif not raw.startswith(("rt/", "rq/", "rr/")) and raw not in topics and raw not in _OF_MIDDLEWARE:
                self._at(raw, SnapshotItem("", raw, "", ros_prefix=False), found, loose)

    def _at(
        self, topic: str, of: SnapshotItem, found: dict[tuple[str, str], set[SnapshotItem]], loose: set[SnapshotItem]
    ) -> None:
        """The endpoints at one topic; `of` says what it stands for."""
        service = of.kind == "service"
        for kind, method in _BY_TOPIC:
            try:
                endpoints = getattr(self.node, method)(topic, no_mangle=service or not of.ros_prefix)
            except Exception as error:
                self._tell(f"topic {topic}: {error}")
                continue
            for endpoint in endpoints:
                item = of._replace(kind=_WHO_REQUESTS[kind] if service else kind, type=_ros_type(endpoint.topic_type))
                if service and item.type.endswith("_Request"):
                    item = item._replace(type=item.type[: -len("_Request")])
                self._endpoint(endpoint, item, found, loose)

    def _endpoint(
        self,
        endpoint: Any,
        item: SnapshotItem,
        found: dict[tuple[str, str], set[SnapshotItem]],
        loose: set[SnapshotItem],
    ) -> None:
        key = (endpoint.node_name, endpoint.node_namespace)
        gid = tuple(endpoint.endpoint_gid)
        if key == self.own:
            return
        if key[0].startswith(_NO_NODE):
            self._unowned.setdefault(gid, set()).add(item)
            loose.add(item)
            return
        self._owned.add(gid)
        found.setdefault(key, set()).add(item)  # a node that has come since it was asked for names is new here
        seen = self.nodes.setdefault(key, SeenNode())
        if item.kind in {"publishers", "subscriptions"}:
            seen.items.setdefault(item, Sighting()).qos.add(_qos(endpoint.qos_profile))

    def _tell(self, problem: str) -> None:
        if len(self.problems) < _MOST_PROBLEMS:
            self.problems[problem] = None

    def document(self, seconds: float, about: dict[str, object]) -> dict[str, object]:
        """All looks as one document."""
        known = {item for gid, items in self._unowned.items() if gid in self._owned for item in items}
        known -= {item for gid, items in self._unowned.items() if gid not in self._owned for item in items}
        return {
            "schema_version": SCHEMA_VERSION,
            "generator": {"name": "rosward snapshot", "version": VERSION},
            **about,
            "seconds": round(seconds, 1),
            "looks": self.looks,
            "nodes": [_node(key, self.nodes[key]) for key in sorted(self.nodes, key=lambda key: key[::-1])],
            "without_node": [
                {"kind": item.kind, **_item(item, seen)}
                for item, seen in sorted(self.loose.items(), key=lambda pair: pair[0])
                if item not in known  # its node was only told later
            ],
            "problems": list(self.problems),
        }


def _node(key: tuple[str, str], seen: SeenNode) -> dict[str, object]:
    items = sorted(seen.items.items(), key=lambda pair: pair[0])
    return {
        "name": key[0],
        "namespace": key[1],
        "enclaves": sorted(seen.enclaves),
        "seen": seen.looks,
        "asked": seen.asked,
        "count": seen.count,
        **{kind: [_item(item, one) for item, one in items if item.kind == kind] for kind in KINDS},
    }


def _item(item: SnapshotItem, seen: Sighting) -> dict[str, object]:
    profiles = [dict(profile) for profile in sorted(seen.qos, key=repr)]
    document: dict[str, object] = {"name": item.name, "type": item.type, "seen": seen.looks, "qos": profiles}
    return document if item.ros_prefix else {**document, "ros_prefix": False}


def _actions(items: set[SnapshotItem]) -> set[SnapshotItem]:
    """An action is where its service for goals is. Its topics and services stay in the document as they are."""
    sides = {"service_servers": "action_servers", "service_clients": "action_clients"}
    return {
        SnapshotItem(sides[item.kind], item.name[: -len(_GOAL)], item.type[: -len("_SendGoal")])
        for item in items
        if item.kind in sides and item.name.endswith(_GOAL) and item.type.endswith("_SendGoal")
    }


def _ros_type(type_: str) -> str:
    """The type in the words of ROS: `std_msgs::msg::dds_::String_` is std_msgs/msg/String."""
    found = _DDS_TYPE.fullmatch(type_)
    return "/".join(found.groups()) if found else type_


def _qos(profile: Any) -> tuple[tuple[str, object], ...]:
    """What the middleware tells of a QoS profile; None for what it does not, as DDS does not of history and depth."""
    words: dict[str, object] = {}
    for policy in ("reliability", "durability", "history"):
        word = str(getattr(getattr(profile, policy, None), "name", "unknown")).lower()
        words[policy] = None if word in _NOT_KNOWN else word
    depth = getattr(profile, "depth", None)
    words["depth"] = depth if words["history"] == "keep_last" and depth else None
    return tuple(words.items())


def take(seconds: float, domain: int | None = None, enclave: str | None = None) -> dict[str, object]:
    """Look at the graph for so many seconds, twice a second, and once at least. Raises RuntimeError."""
    if rclpy is None:
        raise RuntimeError("rclpy cannot be imported: source the setup file of ROS 2 first")
    if domain is not None:
        os.environ["ROS_DOMAIN_ID"] = str(domain)
    options: dict[str, object] = {"args": ["--ros-args", "--enclave", enclave] if enclave else []}
    signals: Any = getattr(rclpy, "signals", None)
    if hasattr(signals, "SignalHandlerOptions"):
        options["signal_handler_options"] = signals.SignalHandlerOptions.NO  # so that Ctrl-C ends the looks only
    rclpy.init(**options)
    try:
        return _watch(seconds)
    finally:
        rclpy.shutdown()


def _watch(seconds: float) -> dict[str, object]:
    domain = os.environ.get("ROS_DOMAIN_ID", "")
    about: dict[str, object] = {
        "taken_at": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime()),
        "ros_distro": os.environ.get("ROS_DISTRO") or None,
        "rmw": rclpy.get_rmw_implementation_identifier(),
        "domain_id": int(domain) if domain.isdigit() else 0,
        "security": os.environ.get("ROS_SECURITY_ENABLE", "").lower() == "true",
    }
    node = rclpy.create_node(
        NODE_PREFIX + uuid.uuid4().hex[:12],
        enable_rosout=False,
        start_parameter_services=False,
        parameter_overrides=[rclpy.parameter.Parameter("start_type_description_service", value=False)],
    )
    observer = Observer(node)
    start = time.monotonic()
    try:
        while not observer.looks or time.monotonic() - start + _PAUSE / 2 < seconds:
            time.sleep(_PAUSE)
            observer.look()
    except KeyboardInterrupt:
        pass  # what was seen so far counts
    document = observer.document(time.monotonic() - start, about)
    node.destroy_node()
    return document


def write(document: dict[str, object], path: str) -> None:
    """Write a document to a file, or to the standard output for `-`."""
    text = json.dumps(document, indent=1) + "\n"
    if path == "-":
        sys.stdout.write(text)
        return
    with open(path, "w", encoding="utf-8") as stream:  # noqa: PTH123
        stream.write(text)


def main(arguments: Sequence[str] | None = None) -> int:
    """Take a snapshot and write it; 0 done, 2 not possible."""
    parser = argparse.ArgumentParser(description="Record the graph of the running ROS 2 system.")
    parser.add_argument(
        "-o", "--output", metavar="FILE", required=True, help="output file; - writes to standard output"
    )
    parser.add_argument("--seconds", type=float, default=5.0, help="how long to observe (default: %(default)s)")
    parser.add_argument("--domain-id", type=int, metavar="N", help="DDS domain (default: ROS_DOMAIN_ID)")
    parser.add_argument("--enclave", metavar="PATH", help="enclave to join with, if the graph is secured")
    options = parser.parse_args(arguments)
    return run(options.output, options.seconds, options.domain_id, options.enclave)


def run(output: str, seconds: float, domain: int | None, enclave: str | None) -> int:
    """Take a snapshot, write it and say so; the exit status."""
    try:
        document = take(seconds, domain, enclave)
        write(document, output)
    except (OSError, RuntimeError) as error:
        print(f"snapshot: {error}", file=sys.stderr)  # noqa: T201
        return 2
    nodes = document["nodes"]
    number = len(nodes) if isinstance(nodes, list) else 0
    print(f"{number} node{'' if number == 1 else 's'} seen in {document['looks']} looks", file=sys.stderr)  # noqa: T201
    return 0


if __name__ == "__main__":
    sys.exit(main())
