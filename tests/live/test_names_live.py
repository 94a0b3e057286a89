# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="arg-type, list-item"
"""Promise: names, remap rules, command lines and implicit entities are those of the real rclpy (kilted)."""

from __future__ import annotations

import itertools
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

os.environ.setdefault("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")
rclpy = pytest.importorskip("rclpy")
ActionClient = pytest.importorskip("rclpy.action").ActionClient
expand_topic_name = pytest.importorskip("rclpy.expand_topic_name").expand_topic_name
LifecycleNode = pytest.importorskip("rclpy.lifecycle").LifecycleNode
Node = pytest.importorskip("rclpy.node").Node
AsyncParameterClient = pytest.importorskip("rclpy.parameter_client").AsyncParameterClient
qos_profile_system_default = pytest.importorskip("rclpy.qos").qos_profile_system_default
ServiceIntrospectionState = pytest.importorskip("rclpy.service_introspection").ServiceIntrospectionState
validate_full_topic_name = pytest.importorskip("rclpy.validate_full_topic_name").validate_full_topic_name
validate_namespace = pytest.importorskip("rclpy.validate_namespace").validate_namespace
validate_node_name = pytest.importorskip("rclpy.validate_node_name").validate_node_name
validate_topic_name = pytest.importorskip("rclpy.validate_topic_name").validate_topic_name
SetBool = pytest.importorskip("std_srvs.srv").SetBool
Fibonacci = pytest.importorskip("test_msgs.action").Fibonacci

from rosward.ros import names, validation  # noqa: E402
from rosward.ros.arguments import key_fits_node, parameters_of_node, parse_arguments  # noqa: E402
from rosward.ros.distro import Distro  # noqa: E402
from rosward.ros.entities import EntityKind  # noqa: E402
from rosward.ros.implicit import (  # noqa: E402
    implicit_entities,
    parameter_client_services,
    service_event_topic,
)
from rosward.ros.names import RemapKind  # noqa: E402

REAL = settings(max_examples=200, suppress_health_check=list(HealthCheck))


@contextmanager
def real_context(*words: str) -> Iterator[Any]:
    context = rclpy.Context()
    rclpy.init(args=["program", *words], context=context)
    try:
        yield context
    finally:
        context.try_shutdown()


@contextmanager
def real_node(context: Any, name: str = "node", cls: Any = None, **options: Any) -> Iterator[Any]:
    node = (cls or Node)(name, context=context, **options)
    try:
        yield node
    finally:
        node.destroy_node()


def accepts(check: Callable[[str], object], name: str) -> bool:
    try:
        check(name)
    except Exception:
        return False
    return True


# Expansion and validation

NAMES = """
chatter /chatter ~ ~/chatter ~x ~xy ~/ {node} {ns} {namespace} {node}/x {ns}/x x/{node} x_{node}_y {ns}{node}
/{node} ~/{node} {other} {} { } {{node}} x{ }x {1} {n/s} a/b a//b //a /a/ a/ / a__b _a __a 1a a/1 a1 a-b a.b a~b a/~
ä {node /a/{ns} ~{node} ~/~ a/{ns} /1 ~1 ~/1 {_} {a1} {1a} x/{namespace}/y
""".split()  # noqa: SIM905

NODES = (("node", "/"), ("node", "/ns"), ("arm_1", "/left/side"))


@pytest.mark.parametrize("where", NODES)
@pytest.mark.parametrize("name", ["", *NAMES, "x" * 246, "x" * 247, "x" * 248])
def test_expand(name: str, where: tuple[str, str]) -> None:
    compare_expand(name, *where)


def compare_expand(name: str, node_name: str, namespace: str) -> None:
    try:
        expected = expand_topic_name(name, node_name, namespace)
    except Exception:
        expected = None
    try:
        found = names.expand(name, node_name, namespace)
    except names.InvalidName:
        found = None
    assert found == expected


@REAL
@given(
    st.text("ab1_/~{}-é", max_size=8) | st.lists(st.sampled_from([*"/~a{}", "{node}", "{ns}"]), max_size=8).map("".join)
)
@example("~a")
def test_any_name(name: str) -> None:
    compare_expand(name, "n", "/s")
    for real, ours in (
        (validate_topic_name, validation.validate_name),
        (validate_full_topic_name, validation.validate_full),
        (validate_namespace, validation.validate_namespace),
        (validate_node_name, validation.validate_node_name),
    ):
        assert (ours(name) is None) == accepts(real, name), real


@pytest.mark.parametrize("length", [244, 245, 246, 247, 248, 254, 255, 256])
def test_lengths(length: int) -> None:
    full, name = "/".ljust(length, "x"), "x" * length
    for real, ours, text in (
        (validate_full_topic_name, validation.validate_full, full),
        (validate_namespace, validation.validate_namespace, full),
        (validate_node_name, validation.validate_node_name, name),
    ):
        assert (ours(text) is None) == accepts(real, text), real


@pytest.mark.parametrize("namespace", ["", "/", "hub", "/hub", "relative/ns", "/a/b"])
def test_namespace_of_a_node(namespace: str) -> None:
    with real_context() as context, real_node(context, namespace=namespace) as node:
        assert node.get_namespace() == names.full_namespace(namespace)
        assert node.get_fully_qualified_name() == names.fully_qualified(names.full_namespace(namespace), "node")


# Command lines

RULES = r"""
chatter:=x chatter:=/x chatter:=~/x chatter:=a/b /chatter:=x ~/chatter:=x rostopic://chatter:=x
rosservice://chatter:=x rostopic:///ns/chatter:=x node:chatter:=x other:chatter:=x node:rostopic://chatter:=x
rostopic:/chatter:=x rostopic:=x __node:=other __name:=other __ns:=/other __ns:=/ __ns:=/a/b node:__node:=q
other:__node:=q node:__ns:=/q chatter:=a_/_b a__b:=c chatter:=a__b chatter:=__x __ns:=x __ns:=// __ns:=/a__b
__node:=a__b chatter:=~ chatter:={node} {node}:=x chatter chatter:= :=x chatter:=1 chatter:=x/ /:=x _:=x _a:=x
chatter:=_a node::chatter:=x node:node:chatter:=x x:y chatter:=a.b a.b:=c a:=b:=c /ns/chatter:=x /ns/node:chatter:=x
chatter:=rostopic://x \1:=x chatter:=\1 chatter/:=x //chatter:=x rosservice:=x
""".split()  # noqa: SIM905

VALUES = r"""
1 -1 +5 010 08 0x1F 0X1f 0x 0b11 1_000 1. .5 1.5 5e3 1e400 1e-400 1e-310 99999999999999999999 9223372036854775807
9223372036854775808 -9223372036854775808 0x1p3 inf -inf infinity nan NaN .inf -.inf +.INF .nan -.nan true True tRUE
yes y Y on off N no null ~ hello "5" '5' !!str\x205 !!int\x205 "" '' [] [1,2] [1,2.0] [true,yes] [a,b] ["1",'2']
[[1,2],[3]] [1,[2]] {a:\x201} a:\x20b &a\x205 1\x20#c \x201 |\n\x205 1\n---\nx - -\x201 -\x201\n-\x202 0 -0
0.0 -0.0 00 0e0 0.0e-999 1e0x 0x1.8 0x.8p1 '0x1' ===  [1,] [,] a,b @a [1\x20] #
""".split()  # noqa: SIM905

LINES: list[list[str]] = [
    *[["--ros-args", "-r", rule] for rule in RULES],
    *[[rule] for rule in RULES],
    *[["--ros-args", "-p", "x:=" + value.replace(r"\x20", " ").replace(r"\n", "\n")] for value in VALUES],
    *[
        ["--ros-args", "-p", rule]
        for rule in (
            *("a.b:=1", "a/b:=1", "a__b:=1", "__x:=1", "_x:=1", "/n:x:=1", "node:x:=1", "other:x:=1", "x", "1x:=2"),
            *(
                "a..b:=1",
                "a-b:=1",
                "x:y:z:=1",
                "a.:=1",
                ".a:=1",
                "~/a:=1",
                "/a:=1",
                "a//b:=1",
                "x:=a:=b",
                "rostopic:=1",
            ),
            *(
                "node::x:=1",
                "__ns:=1",
                "x:= 1",
                " x:=1",
                "rostopic://x:=1",
                "a.1:=2",
                "qos_overrides./q.publisher.depth:=1",
            ),
        )
    ],
    ["--ros-args", "-p", "x:=1", "-p", "x:=hello"],
    ["--ros-args", "-p", "x:=hello", "-p", "x:=1"],
    ["--ros-args", "-p", "x:=1", "-p", "x:=[1]"],
    ["--ros-args", "-p", "x:=1", "-p", "x:=2"],
    ["--ros-args", "-p", "x:=[]", "-p", "x:=2"],
    ["--ros-args", "-p", "x:=1", "-p", "node:x:=2"],
    ["--ros-args", "-p", "node:x:=2", "-p", "x:=1"],
    ["--ros-args", "-p", "node:x:=2", "-p", "x:=1", "-p", "node:x:=3"],
    ["--ros-args", "-r", "chatter:=a", "-r", "chatter:=b"],
    ["--ros-args", "-r", "chatter:=a", "-r", "a:=b"],
    ["--ros-args", "-r", "__node:=q", "-r", "q:chatter:=x", "-p", "q:x:=1"],
    ["--ros-args", "-r", "__node:=q", "-r", "node:chatter:=x", "-p", "node:x:=1"],
    ["--ros-args", "-r", "__node:=q", "-r", "q:__ns:=/x"],
    ["--ros-args", "-r", "__node:=q", "-r", "node:__ns:=/x"],
    ["--ros-args", "-r", "__node:=a", "-r", "__node:=b", "-r", "a:__node:=c"],
    ["--ros-args", "-r", "__ns:=/q", "-r", "chatter:=~/x"],
    ["--ros-args", "-r", "__ns:=/q", "-r", "/chatter:=x", "-p", "node:x:=1"],
    ["word", "--flag", "--ros-args", "-r", "chatter:=x", "--", "more", "--", "a:=b", "-r"],
    ["--", "chatter:=x"],
    ["-p", "x:=1"],
    ["-r", "chatter:=x"],
    ["--ros-args", "chatter:=x"],
    ["--ros-args", "word"],
    ["--ros-args", "--ros-args", "-r", "chatter:=x", "--ros-args"],
    ["--ros-args", "--", "--ros-args", "-r", "chatter:=x"],
    *[
        ["--ros-args", flag]
        for flag in ("-r", "-p", "-e", "--params-file", "--log-level", "--log-config-file", "--foo")
    ],
    *[["--ros-args", f"--{what}-{x}-logs"] for what in ("en", "enable", "disable") for x in ("rosout", "stdout", "x")],
    ["--ros-args", "--disable-external-lib-logs", "--enable-external-lib-logs"],
    ["--ros-args", "--disable-rosout-logs", "--enable-rosout-logs"],
    ["--ros-args", "--enable-rosout-logs", "--disable-rosout-logs"],
    ["--disable-rosout-logs"],
    *[
        ["--ros-args", "--log-level", level]
        for level in (
            "info",
            "WARN",
            "Fatal",
            "bogus",
            "a:=info",
            "a.b:=info",
            "a:=b:=info",
            ":=info",
            "a:=x",
            "unset",
            "",
        )
    ],
    ["--ros-args", "--log-file-name", "x"],
    *[["--ros-args", flag, value] for flag in ("-e", "--enclave") for value in ("/", "/a/b", "a", "/a/", "/1", "//")],
    ["--ros-args", "-e", "bad", "-e", "/good"],
    ["--ros-args", "-e", "/good", "-e", "bad"],
    ["--ros-args", "-e", "/" + "x" * 254],
    ["--ros-args", "-e", "/" + "x" * 255],
    ["--ros-args", "--remap", "chatter:=x", "--param", "x:=1"],
    ["--ros-args", "-p", "-r"],
]

TYPES = {"BOOL": "bool", "INTEGER": "integer", "DOUBLE": "double", "STRING": "string"}
TYPES |= {f"{real}_ARRAY": f"{ours}_array" for real, ours in TYPES.items()} | {"NOT_SET": "not_set"}


@pytest.mark.parametrize("line", LINES, ids=repr)
def test_command_line(line: list[str], capfd: pytest.CaptureFixture[str]) -> None:
    compare_line(line, "")
    capfd.readouterr()


@pytest.mark.parametrize("line", [line for line in LINES if "-r" in line], ids=repr)
def test_command_line_of_a_node_in_a_namespace(line: list[str], capfd: pytest.CaptureFixture[str]) -> None:
    compare_line(line, "ns")
    capfd.readouterr()


@REAL
@given(
    st.lists(
        st.sampled_from(
            [*":/~_*.", ":=", "a", "chatter", "node", "__ns", "__node", "__name", "rostopic://", "r", "1", "~/"]
        ),
        max_size=7,
    ).map("".join)
)
def test_any_rule(rule: str) -> None:
    if "*" not in rule:
        compare_line(["--ros-args", "-r", rule], "ns")


@REAL
@given(
    st.lists(
        st.sampled_from([*"0123456789.eExXpP+-_ infatyINF[],'\"~", "0x", "inf", "nan", "true"]), min_size=1, max_size=6
    ).map("".join)
)
def test_any_value(value: str) -> None:
    compare_line(["--ros-args", "-p", f"x:={value}"], "")


def compare_line(line: list[str], namespace: str) -> None:
    ours = parse_arguments(["program", *line])
    try:
        rclpy.utilities.remove_ros_args(["program", *line])
    except Exception:
        assert ours.errors
    else:
        removed = rclpy.utilities.remove_ros_args(["program", *line])
        assert removed == list(ours.user_arguments)
    try:
        with real_context(*line) as context:
            assert not ours.errors
            assert not ours.unknown
            compare_node(context, ours, namespace)
    except AssertionError:
        raise
    except Exception:
        if not ours.errors:
            raise


def compare_node(context: Any, ours: Any, namespace: str) -> None:
    name, full = names.remap_node("node", namespace, ours.remaps)
    if validation.validate_node_name(name) or validation.validate_namespace(full):
        with pytest.raises(Exception, match="invalid"), real_node(context, namespace=namespace):
            pass
        return
    with real_node(context, namespace=namespace) as node:
        fqn = names.fully_qualified(full, name)
        assert node.get_fully_qualified_name() == fqn
        for written in ("chatter", "/chatter", "~/chatter", "/ns/chatter", "a", "rostopic", "_a", "_", "r", "~"):
            for kind, real in (
                (RemapKind.TOPIC, node.resolve_topic_name),
                (RemapKind.SERVICE, node.resolve_service_name),
            ):
                assert names.resolve(written, kind, ours.remaps, name, full) == (real(written),)
        real_values = {key: (TYPES[p.type_.name], p.value) for key, p in node._parameter_overrides.items()}
        our_values = {
            key: (value.type, list(value.value) if isinstance(value.value, tuple) else value.value)
            for key, value in parameters_of_node(ours.parameters, fqn).items()
        }
        assert repr(our_values) == repr(real_values)  # of two nans, too
        enclaves = {(n, e) for n, _, e in node.get_node_names_and_namespaces_with_enclaves()}
        assert (name, ours.enclave or "/") in enclaves
        publishers = {topic for topic, _ in node.get_publisher_names_and_types_by_node(name, full)}
        rosout = names.resolve("/rosout", RemapKind.TOPIC, ours.remaps, name, full)[0]
        assert (rosout in publishers) == ours.rosout_logs


def test_rules_of_a_node_come_before_those_of_the_process() -> None:
    with real_context("--ros-args", "-r", "chatter:=process", "-r", "cmd:=process_cmd") as context:
        words = ["--ros-args", "-r", "chatter:=local", "-r", "__ns:=/n"]
        rules = (
            parse_arguments(words).remaps
            + parse_arguments(["--ros-args", "-r", "chatter:=process", "-r", "cmd:=process_cmd"]).remaps
        )
        with real_node(context, cli_args=words) as node:
            assert names.remap_node("node", "", rules) == ("node", "/n")
            for written in ("chatter", "cmd"):
                real = node.resolve_topic_name(written)
                assert names.resolve(written, RemapKind.TOPIC, rules, "node", "/n") == (real,)


@pytest.mark.parametrize(
    "key", ["/**", "/*", "node", "/node", "/ns/node", "/ns/*", "/*/node", "/**/node", "/ns/**", "x/node"]
)
@pytest.mark.parametrize("namespace", ["", "ns", "/a/b", "x"])
def test_keys_of_parameter_files(key: str, namespace: str, tmp_path: Any) -> None:
    file = tmp_path / "params.yaml"
    file.write_text(f"{key}:\n  ros__parameters:\n    x: 1\n")
    with (
        real_context("--ros-args", "--params-file", str(file)) as context,
        real_node(context, namespace=namespace) as node,
    ):
        assert ("x" in node._parameter_overrides) == key_fits_node(key, node.get_fully_qualified_name())


# Actions and implicit entities


def endpoints(node: Any) -> set[tuple[EntityKind, str, str]]:
    where = node.get_name(), node.get_namespace()
    answers = (
        (EntityKind.PUBLISHER, node.get_publisher_names_and_types_by_node(*where)),
        (EntityKind.SUBSCRIPTION, node.get_subscriber_names_and_types_by_node(*where)),
        (EntityKind.SERVICE_SERVER, node.get_service_names_and_types_by_node(*where)),
        (EntityKind.SERVICE_CLIENT, node.get_client_names_and_types_by_node(*where)),
    )
    return {(kind, name, type_) for kind, found in answers for name, types in found for type_ in types}


def test_actions_are_remapped_like_topics() -> None:
    assert Distro.KILTED.facts.actions_are_remapped
    for rule, expected in (("fib:=seq", "/seq"), ("rosservice://fib:=seq", "/fib"), ("rostopic://fib:=seq", "/seq")):
        with real_context("--ros-args", "-r", rule) as context, real_node(context) as node:
            client = ActionClient(node, Fibonacci, "fib")
            rules = parse_arguments(["--ros-args", "-r", rule]).remaps
            assert names.resolve("fib", RemapKind.TOPIC, rules, "node", "/") == (expected,)
            services = {name for kind, name, _ in endpoints(node) if kind is EntityKind.SERVICE_CLIENT}
            assert f"{expected}/_action/send_goal" in services
            client.destroy()


SERIAL = itertools.count()  # a node of its own name for each: the graph keeps what others of that name had
OPTIONS: list[tuple[dict[str, Any], dict[str, Any], list[str]]] = [
    ({}, {}, []),
    ({"enable_rosout": False}, {"enable_rosout": False}, []),
    ({"start_parameter_services": False}, {"start_parameter_services": False}, []),
    ({"enable_logger_service": True}, {"logger_service": True}, []),
    ({}, {"use_sim_time": True}, ["--ros-args", "-p", "use_sim_time:=true"]),
    ({}, {"type_description": False}, ["--ros-args", "-p", "start_type_description_service:=false"]),
    ({}, {"enable_rosout": False}, ["--ros-args", "--disable-rosout-logs"]),
    (
        {"enable_rosout": False, "start_parameter_services": False},
        {"enable_rosout": False, "start_parameter_services": False, "type_description": False},
        ["--ros-args", "-p", "start_type_description_service:=false"],
    ),
]


@pytest.mark.parametrize("lifecycle", [None, True, False])
@pytest.mark.parametrize(("real", "ours", "words"), OPTIONS)
def test_implicit_entities(
    real: dict[str, Any], ours: dict[str, Any], words: list[str], lifecycle: bool | None
) -> None:
    cls = None
    if lifecycle is not None:
        cls = LifecycleNode
        real = {**real, "enable_communication_interface": lifecycle}
        ours = {**ours, "lifecycle": True, "lifecycle_services": lifecycle}
    name = f"node_{next(SERIAL)}"
    with real_context(*words) as context, real_node(context, name, cls, namespace="ns", **real) as node:
        expected = implicit_entities(Distro.KILTED, node_fqn=f"/ns/{name}", **ours)
        assert {(e.kind, e.name, e.type) for e in expected} == endpoints(node)
        for entity in expected:
            assert entity.qos is not None
            if entity.kind is EntityKind.PUBLISHER:
                infos = node.get_publishers_info_by_topic(entity.name)
            elif entity.kind is EntityKind.SUBSCRIPTION:
                infos = node.get_subscriptions_info_by_topic(entity.name)
            else:
                continue
            qos = infos[0].qos_profile
            assert (qos.reliability.name.lower(), qos.durability.name.lower()) == (
                entity.qos.reliability,
                entity.qos.durability,
            )


def test_implicit_names_are_remapped() -> None:
    words = ["--ros-args"]
    for rule in ("/rosout:=/log", "/parameter_events:=events", "~/get_parameters:=gp", "named/list_parameters:=lp"):
        words += ["-r", rule]
    rules = parse_arguments(words).remaps
    with real_context(*words) as context, real_node(context, "named", namespace="ns") as node:
        found = set()
        for entity in implicit_entities(Distro.KILTED, node_fqn="/ns/named"):
            kind = RemapKind.SERVICE if entity.kind is EntityKind.SERVICE_SERVER else RemapKind.TOPIC
            found.add((entity.kind, *names.resolve(entity.name, kind, rules, "named", "/ns"), entity.type))
        assert found == endpoints(node)


@pytest.mark.parametrize("rule", ["x:=y", "srv:=renamed", "srv/_service_event:=event", "renamed/_service_event:=event"])
def test_service_events(rule: str) -> None:
    words = ["--ros-args", "-r", rule, "-r", "srv:=renamed"]
    rules = parse_arguments(words).remaps
    with real_context(*words) as context, real_node(context) as node:
        before = endpoints(node)
        service = node.create_service(SetBool, "srv", lambda _, response: response)
        full = names.resolve("srv", RemapKind.SERVICE, rules, "node", "/")[0]
        event = service_event_topic(Distro.KILTED, full, "std_srvs/srv/SetBool")
        assert event is not None
        state = ServiceIntrospectionState
        service.configure_introspection(node.get_clock(), qos_profile_system_default, state.OFF)
        assert endpoints(node) - before == {(EntityKind.SERVICE_SERVER, full, "std_srvs/srv/SetBool")}
        service.configure_introspection(node.get_clock(), qos_profile_system_default, state.METADATA)
        topic = names.resolve(event.name, RemapKind.TOPIC, rules, "node", "/")[0]
        assert (EntityKind.PUBLISHER, topic, event.type) in endpoints(node)


@pytest.mark.parametrize("remote", ["controller", "/controller", "sub/controller"])
def test_parameter_client(remote: str) -> None:
    with real_context() as context, real_node(context, namespace="ns") as node:
        AsyncParameterClient(node, remote)
        clients = {(name, type_) for kind, name, type_ in endpoints(node) if kind is EntityKind.SERVICE_CLIENT}
        assert clients == {(names.expand(n, "node", "/ns"), t) for n, t in parameter_client_services(remote)}
