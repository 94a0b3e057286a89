# SPDX-License-Identifier: Apache-2.0
"""Promise: the nodes of `examples/` have, under the real rclpy, the graph that rosward says they have, both as `ros2 run` starts them
and as the launch file of the fleet does.

For a launched process the command line is the one that the analysis says launch would give it, with real parameter files. Each process
runs by itself; its callbacks, transitions and goals happen to it (see `world.py`), so that what only comes later shows, too. What the
example imports and no wheel is made of stands in `standins`: own interfaces borrow the types of others, and the libraries have the same
endpoints as the real ones.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Final, NamedTuple

import pytest

pytest.importorskip("rclpy")

import rosward
from rosward.analysis.deep_stack import with_deep_stack
from rosward.analysis.read import SourcesRead, read_sources
from rosward.analysis.systems import Outset, systems_of
from rosward.deployment.request import LaunchRequest, Request
from rosward.domain.compound import Tuple
from rosward.domain.text import pattern
from rosward.domain.values import Const, Value
from rosward.effects.configuration import Configuration, Given
from rosward.effects.entry import Entry
from rosward.ros.distro import Distro

from .agreement import claims_of
from .harness import Fact, Program, RealRclpy, Seen

ROBOT: Final = Path(__file__).parents[2] / "examples" / "delivery_robot"
STAND_INS: Final = Path(__file__).parent / "standins"
FLEET: Final = Request(launches=(LaunchRequest("fleet.launch.py", "delivery_bringup"),))

BORROWED: Final = {
    "test_msgs/action/Fibonacci": "delivery_interfaces/action/Deliver",
    "test_msgs/msg/Arrays": "diagnostic_msgs/msg/DiagnosticArray",
    "test_msgs/msg/BasicTypes": "delivery_interfaces/msg/DeliveryStatus",
    "test_msgs/msg/Nested": "tf2_msgs/msg/TFMessage",
    "test_msgs/srv/Arrays": "delivery_interfaces/srv/RequestDelivery",
    "test_msgs/srv/BasicTypes": "delivery_interfaces/srv/OpenDoor",
}
"""The types of the stand-ins, and what they stand for."""

IN_CPP: Final = ("delivery_cargo/", "delivery_drivers/", "rclcpp_components/", "tf2_ros/")
"""The beginnings of the labels of processes that are no Python: they are not run here."""


class Start(NamedTuple):
    """A process of the system: its label in the network, and how it starts."""

    process: str
    entry: Entry
    configuration: Configuration


class System(NamedTuple):
    """One system in both views."""

    result: rosward.Result
    runs: dict[str, Seen]


def starts_of(request: Request) -> list[Start]:
    """Every process of the example that a request starts, without a command line where nothing is launched."""

    def work() -> list[Start]:
        read = _read(request)
        if not request.deploys:
            entries = [e for e in read.plan.entries if e.executable is not None and not e.program]
            return [Start(e.label, e, Configuration()) for e in entries]
        (system,) = systems_of(request, Outset.of(read)).systems
        started = [(p, p.entry) for p in system.programs]
        return [Start(p.process, e, p.configuration) for p, e in started if e is not None and not e.program]

    return with_deep_stack(work)


def _read(request: Request) -> SourcesRead:
    return read_sources([ROBOT], Distro.KILTED, request=request)


def program_of(start: Start, folder: Path) -> Program:
    """What is to be run: the function behind the executable, with the command line and its files."""
    folder.mkdir()
    words = [
        str(_written(word, start.configuration.files[word], folder)) if word in start.configuration.files else word
        for word in map(pattern, start.configuration.words)
    ]
    assert not [word for word in words if "*" in word]
    packages = sorted(str(setup.parent) for setup in ROBOT.glob("*/setup.py"))
    path = (str(STAND_INS), *packages)
    return Program(folder, f"{start.entry.module}:{start.entry.function}", path=path, arguments=tuple(words))


def _written(name: str, rows: tuple[Given, ...] | None, folder: Path) -> Path:
    """A parameter file: the one of the bringup package as it stands, or one that launch makes of a dictionary (JSON is YAML)."""
    file = folder / Path(name).name
    if name.startswith("*/"):
        file.write_bytes((ROBOT / "delivery_bringup" / name[2:]).read_bytes())
        return file
    assert rows is not None
    nodes: dict[str, dict[str, dict[str, object]]] = {}
    for row in rows:
        nodes.setdefault(row.node, {"ros__parameters": {}})["ros__parameters"][row.name] = _plain(row.value)
    file.write_text(json.dumps(nodes), encoding="utf-8")
    return file


def _plain(value: Value) -> object:
    if isinstance(value, Tuple):
        return [_plain(item) for item in value.items]
    assert isinstance(value, Const)
    return value.value


@pytest.fixture(scope="module", params=[(Request(), 11), (FLEET, 17)], ids=["by ros2 run", "by the launch file"])
def system(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[System]:
    wanted, processes = request.param
    starts = starts_of(wanted)
    assert len(starts) == processes
    folder = tmp_path_factory.mktemp("example")
    with RealRclpy() as real:
        for number, start in enumerate(starts):
            real.send(program_of(start, folder / str(number)))
        result = rosward.extract(ROBOT, distro="kilted", request=wanted)
        yield System(result, {start.process: real.receive() for start in starts})


def real_facts(system: System) -> set[Fact]:
    """What was seen, under the names of the types that were meant."""
    facts = {fact for seen in system.runs.values() for fact in seen.facts}
    return {(node, kind, name, BORROWED.get(type_, type_)) for node, kind, name, type_ in facts}


def python_nodes(system: System) -> dict[str, str]:
    """The nodes that are run here, each with its process."""
    nodes = system.result.network.nodes
    return {node.fqn: node.process for node in nodes if not node.process.startswith(IN_CPP)}


def test_every_process_runs_to_its_end(system: System) -> None:
    assert {process: seen.output for process, seen in system.runs.items() if not seen.whole} == {}


def test_every_process_has_the_node_that_we_say(system: System) -> None:
    said: dict[str, set[str]] = {}
    for fqn, process in python_nodes(system).items():
        said.setdefault(process, set()).add(fqn)
    assert said == {process: set(seen.nodes) for process, seen in system.runs.items()}


def test_the_graphs_are_equal(system: System) -> None:
    """Also what is conditional is there: the doors are opened, and the camera is configured."""
    python = python_nodes(system)
    claims = [claim for claim in claims_of(system.result) if claim.node in python]
    assert all(claim.exact for claim in claims)
    assert {(c.node, c.kind, c.name, c.type) for c in claims} == real_facts(system)
