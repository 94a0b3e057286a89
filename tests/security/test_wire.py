# SPDX-License-Identifier: Apache-2.0
"""Promise: the real rclpy makes what our permissions allow: each endpoint is allowed, and each right is used.

Each program of `programs.md` is read by rosward and run by the real rclpy (kilted, Fast DDS), without security, in a
process of its own. A participant of Cyclone DDS, another implementation, sees on the wire which writers and readers
there are, hidden ones too. A secured participant then tries them with our permissions.
"""

from __future__ import annotations

import contextlib
import os
import select
import subprocess
import xml.etree.ElementTree as ET
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path
from typing import Final

import pytest
from casefile import Case

from rosward.outputs.policies.permissions import permissions_xml

from .cyclone import Cyclone
from .endpoints import Endpoint, endpoints_of, turned
from .host import MARK
from .keystore import Keystore
from .systems import PROGRAMS, network_of

_HOST: Final = Path(__file__).with_name("host.py")
_PATIENCE: Final = 300.0
_AT_A_TIME: Final = 5
_LOOPBACK: Final = """\
<dds xmlns="http://www.eprosima.com"><profiles>
  <transport_descriptors><transport_descriptor>
    <transport_id>loopback</transport_id>
    <type>UDPv4</type>
    <interfaceWhiteList><address>127.0.0.1</address></interfaceWhiteList>
  </transport_descriptor></transport_descriptors>
  <participant profile_name="loopback" is_default_profile="true"><rtps>
    <userTransports><transport_id>loopback</transport_id></userTransports>
    <useBuiltinTransports>false</useBuiltinTransports>
  </rtps></participant>
</profiles></dds>
"""


@contextlib.contextmanager
def running(python: str, program: Path, domain: int) -> Iterator[None]:
    """The program, with all that it makes before it would spin."""
    profiles = program.with_name("loopback.xml")
    profiles.write_text(_LOOPBACK, encoding="utf-8")
    without = ("CYCLONEDDS_URI", "RMW_IMPLEMENTATION", "ROS_SECURITY_ENABLE", "FASTDDS_BUILTIN_TRANSPORTS")
    environment = {name: value for name, value in os.environ.items() if name not in without}
    environment |= {
        "ROS_DOMAIN_ID": str(domain),
        "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
        "ROS_LOG_DIR": str(program.parent),
        "FASTDDS_DEFAULT_PROFILES_FILE": str(profiles),
    }
    words = [python, str(_HOST), str(program)]
    errors = program.with_name("errors.txt")
    with (
        errors.open("w") as stderr,
        subprocess.Popen(
            words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=stderr, env=environment
        ) as process,
    ):
        assert process.stdout
        assert process.stdin
        try:
            ready, _, _ = select.select([process.stdout], [], [], _PATIENCE)
            assert ready, "the program does not come to spin"
            assert process.stdout.readline().decode().strip() == MARK, errors.read_text()
            yield
        finally:
            process.stdin.close()
            try:
                process.wait(_PATIENCE)
            finally:
                process.kill()


def made(dds: Cyclone, python: str, program: Path, domain: int) -> frozenset[Endpoint]:
    """What the real node makes, seen on the wire."""
    marks = {("write", f"rt{MARK}"), ("read", f"rt{MARK}")}
    with running(python, program, domain), dds.participant(domain) as watcher:
        seen = watcher.watch(lambda endpoints: marks <= {e[:2] for e in endpoints}, _PATIENCE)
    assert seen, "the node was not discovered"
    return frozenset(e for e in seen if e[:2] not in marks)


def rights(permissions: str) -> set[tuple[str, str]]:
    """Each right of the document: the way and the topic."""
    root = ET.fromstring(permissions)
    ways = (("write", "publish"), ("read", "subscribe"))
    return {(way, topic.text or "") for way, element in ways for topic in root.iterfind(f".//{element}/topics/topic")}


@pytest.fixture(scope="module")
def wires(
    dds: Cyclone, live_python: str, domains: Iterator[int], tmp_path_factory: pytest.TempPathFactory
) -> Iterator[dict[str, Future[frozenset[Endpoint]]]]:
    """What each program makes, by its title: discovery is mostly waiting, so several run at a time."""
    with ThreadPoolExecutor(_AT_A_TIME) as pool:
        started = {}
        for program in PROGRAMS:
            file = tmp_path_factory.mktemp("program") / "main.py"
            file.write_text(program.files["main.py"], encoding="utf-8")
            started[program.title] = pool.submit(made, dds, live_python, file, next(domains))
        yield started


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda program: program.title)
def test_a_real_node_makes_what_it_may(
    program: Case,
    wires: dict[str, Future[frozenset[Endpoint]]],
    dds: Cyclone,
    keystore: Keystore,
    tmp_path: Path,
    tally: Counter[str],
) -> None:
    network = network_of(program, tmp_path, "kilted")
    (enclave,) = {node.enclave for node in network.nodes}
    document = permissions_xml(network, enclave, keystore.domain)
    wire = wires[program.title].result()
    assert endpoints_of(*network.nodes) == wire
    assert rights(document) == {e[:2] for e in wire}
    with dds.participant(keystore.domain, keystore.enclave(enclave, document)) as secured:
        assert {e for e in wire if not secured.may(e)} == set()
        assert {e for e in map(turned, wire) if secured.may(e)} == {e for e in wire if turned(e) in wire}
    tally["real nodes"] += 1
    tally["endpoints on the wire, each allowed and no other"] += len(wire)
