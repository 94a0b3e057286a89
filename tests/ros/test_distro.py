# SPDX-License-Identifier: Apache-2.0
"""Promise: each distribution's implicit endpoints are listed, no more and no fewer (tests/live: the real ones)."""

from __future__ import annotations

import itertools
import re
from pathlib import Path
from typing import Any

import pytest

from rosward.ros.distro import DISTROS, Distro
from rosward.ros.entities import EntityKind, Qos
from rosward.ros.implicit import implicit_entities, parameter_client_services, service_event_topic

PARAMETER_SERVICES = {
    "describe_parameters",
    "get_parameter_types",
    "get_parameters",
    "list_parameters",
    "set_parameters",
    "set_parameters_atomically",
}


def names(distro: Distro, **switches: Any) -> set[str]:
    return {entity.name for entity in implicit_entities(distro, node_fqn="/n", **switches)}


def test_a_plain_node() -> None:
    humble = {"/rosout", "/parameter_events"} | {f"/n/{service}" for service in PARAMETER_SERVICES}
    assert names(Distro.HUMBLE) == humble
    for distro in list(Distro)[1:]:
        assert names(distro) == humble | {"/n/get_type_description"}


@pytest.mark.parametrize(
    ("switch", "value", "added", "removed"),
    [
        ("enable_rosout", False, set(), {"/rosout"}),
        ("start_parameter_services", False, set(), {f"/n/{service}" for service in PARAMETER_SERVICES}),
        ("type_description", False, set(), {"/n/get_type_description"}),
        ("logger_service", True, {"/n/get_logger_levels", "/n/set_logger_levels"}, set()),
        ("use_sim_time", True, {"/clock"}, set()),
        ("lifecycle_services", False, set(), set()),
    ],
)
def test_switches(switch: str, value: bool, added: set[str], removed: set[str]) -> None:
    assert names(Distro.JAZZY, **{switch: value}) == names(Distro.JAZZY) - removed | added


def test_humble_has_neither_logger_nor_type_description_services() -> None:
    assert names(Distro.HUMBLE, logger_service=True, type_description=True) == names(Distro.HUMBLE)


def test_lifecycle_nodes() -> None:
    services = {
        "change_state",
        "get_state",
        "get_available_states",
        "get_available_transitions",
        "get_transition_graph",
    }
    added = names(Distro.JAZZY, lifecycle=True) - names(Distro.JAZZY)
    assert added == {f"/n/{service}" for service in services} | {"/n/transition_event"}
    # measured: without its services a lifecycle node still publishes its transitions
    assert names(Distro.JAZZY, lifecycle=True, lifecycle_services=False) - names(Distro.JAZZY) == {
        "/n/transition_event"
    }


def test_every_entity_is_complete_and_sorted() -> None:
    for distro, rosout, sim in itertools.product(Distro, (True, False), (True, False)):
        found = implicit_entities(
            distro, node_fqn="/ns/*", enable_rosout=rosout, use_sim_time=sim, lifecycle=True, logger_service=True
        )
        assert list(found) == sorted(found, key=lambda entity: (entity.kind.value, entity.name))
        for entity in found:
            assert entity.system
            assert entity.qos is not None
            assert None not in (entity.type, entity.qos.reliability, entity.qos.durability, entity.qos.depth)
            assert entity.name.startswith(("/ns/*/", "/rosout", "/parameter_events", "/clock"))


def test_qos() -> None:
    found = {e.name: e.qos for e in implicit_entities(Distro.HUMBLE, node_fqn="/n", use_sim_time=True)}
    assert found["/rosout"] == Qos("reliable", "transient_local", "keep_last", 1000)
    assert found["/clock"] == Qos("best_effort", "volatile", "keep_last", 1)


def test_service_events() -> None:
    assert service_event_topic(Distro.HUMBLE, "/a", "std_srvs/srv/Empty") is None
    found = service_event_topic(Distro.IRON, "/a", "std_srvs/srv/Empty")
    assert found is not None
    assert (found.kind, found.name, found.type) == (
        EntityKind.PUBLISHER,
        "/a/_service_event",
        "std_srvs/srv/Empty_Event",
    )
    assert service_event_topic(Distro.JAZZY, "/a", None, action=True) is None
    assert service_event_topic(Distro.KILTED, "/a", None, action=True) is not None


def test_parameter_client() -> None:
    assert {name for name, _ in parameter_client_services("arm")} == {
        f"arm/{service}" for service in PARAMETER_SERVICES
    }


def test_between_kilted_and_lyrical_nothing_changed_that_a_policy_grants() -> None:
    kilted, lyrical = (
        implicit_entities(distro, node_fqn="/n", logger_service=True, use_sim_time=True, lifecycle=True)
        for distro in (Distro.KILTED, Distro.LYRICAL)
    )
    assert lyrical == kilted
    assert service_event_topic(Distro.LYRICAL, "/a", None, action=True) is not None
    assert Distro.LYRICAL.facts.actions_are_remapped


def test_a_distribution_is_named_in_one_place() -> None:
    """Whoever lists them, reads the list: a new one is a row of the table."""
    root = Path(__file__).parents[2]
    every = re.compile(r"\b(" + "|".join(DISTROS) + r")\b")
    files = [p for p in root.joinpath("src").rglob("*") if p.suffix in {".py", ".json", ".j2", ".js", ".html"}]
    listing = {
        path.relative_to(root).as_posix()
        for path in [*files, root / "docs/configuration.md", root / "docs/library.md", root / "action.yml"]
        if any(len(set(every.findall(line))) > 2 for line in path.read_text(encoding="utf-8").splitlines())
    }
    assert listing == {"src/rosward/ros/distro.py"}


def test_order_of_distributions() -> None:
    assert Distro.ROLLING.has(Distro.HUMBLE)
    assert Distro.IRON.has(Distro.IRON)
    assert not Distro.HUMBLE.has(Distro.IRON)
    assert Distro("jazzy") is Distro.JAZZY
