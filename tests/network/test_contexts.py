# SPDX-License-Identifier: Apache-2.0
"""The enclave of each process: chosen, or named by its start."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from outputs.networks import node

from rosward.network.contexts import with_enclaves
from rosward.network.enclave_mode import EnclaveMode
from rosward.ros.entities import Node


def started(fqn: str, process: str, given: str | None = None) -> Node:
    return replace(node(fqn, system=False), process=process, given_enclave=given, enclave="")


def enclaves(nodes: list[Node], mode: EnclaveMode) -> list[str]:
    return [n.enclave for n in with_enclaves(nodes, mode)[0]]


PAIR = [started("/ns/a", "demo/pair"), started("/ns/b", "demo/pair")]


@pytest.mark.parametrize(
    ("mode", "expected"),
    [
        (EnclaveMode.NODE, ["/ns/a", "/ns/b"]),
        (EnclaveMode.PROCESS, ["/ns/pair", "/ns/pair"]),
        (EnclaveMode.LAUNCH, ["/", "/"]),
    ],
)
def test_two_nodes_of_a_process(mode: EnclaveMode, expected: list[str]) -> None:
    assert enclaves(PAIR, mode) == expected


def test_a_node_alone_has_its_own_enclave() -> None:
    assert enclaves([started("/ns/a", "demo/a")], EnclaveMode.PROCESS) == ["/ns/a"]


def test_two_processes_never_share_by_chance() -> None:
    """The enclave made for the pair is the name of a node that runs alone: it gets another."""
    nodes = [*PAIR, started("/ns/pair", "other/pair")]
    found = enclaves(nodes, EnclaveMode.PROCESS)
    assert found[0] == found[1] != found[2]
    assert found[2] == "/ns/pair"


def test_a_second_process_of_one_program_is_numbered() -> None:
    nodes = [*PAIR, *(replace(n, process="demo/pair#2") for n in PAIR)]
    assert enclaves(nodes, EnclaveMode.PROCESS) == ["/ns/pair", "/ns/pair", "/ns/pair_2", "/ns/pair_2"]


def test_what_the_start_names_counts_for_the_whole_process() -> None:
    nodes = [started("/a", "demo/pair", "/x"), started("/b", "demo/pair")]
    for mode in (EnclaveMode.PROCESS, EnclaveMode.LAUNCH):
        assert enclaves(nodes, mode) == ["/x", "/x"]


def test_several_named_enclaves_conflict() -> None:
    nodes = [started("/a", "demo/pair", "/x"), started("/b", "demo/pair", "/y")]
    findings = with_enclaves(nodes, EnclaveMode.PROCESS)[1]
    assert [f.message for f in findings] == ["process demo/pair is started with several enclaves: /x, /y"]


def test_a_named_enclave_that_nodes_have_to_share_is_told() -> None:
    nodes = [started("/a", "demo/pair", "/x"), started("/b", "demo/pair", "/x")]
    placed, findings = with_enclaves(nodes, EnclaveMode.NODE)
    assert {n.enclave for n in placed} == {"/x"}
    assert [f.code for f in findings] == ["RW308"]


@pytest.mark.parametrize("enclave", ["x", "/x/", "/1x", "/x//y", "/x-y", ""])
def test_an_enclave_that_rcl_refuses_is_told(enclave: str) -> None:
    _, findings = with_enclaves([started("/a", "demo/a", enclave)], EnclaveMode.LAUNCH)
    assert [f.code for f in findings] == ["RW308"]


NODES = st.lists(
    st.builds(
        started,
        st.sampled_from(["/a", "/b", "/ns/a", "/ns/pair", "/pair"]),
        st.sampled_from(["demo/pair", "demo/pair#2", "demo/other"]),
        st.sampled_from([None, None, "/x", "/ns/pair"]),
    ),
    max_size=6,
)


@given(NODES)
def test_a_process_has_one_enclave(nodes: list[Node]) -> None:
    """Where enclaves are those of processes, and no two processes share one that nobody named."""
    for mode in (EnclaveMode.PROCESS, EnclaveMode.LAUNCH):
        placed, _ = with_enclaves(nodes, mode)
        assert len(placed) == len(nodes)
        by_process = {n.process: {m.enclave for m in placed if m.process == n.process} for n in placed}
        assert all(len(found) == 1 for found in by_process.values())
