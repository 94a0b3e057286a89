# SPDX-License-Identifier: Apache-2.0
"""Enclaves that the user assigns: what a file may say, what follows, and that a suggestion can be read back."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from laws import examples
from outputs.networks import node

from rosward.enclaves.suggestion import Wish, suggest
from rosward.network.assigned import Assignment, AssignmentError, read_assignment
from rosward.network.contexts import with_enclaves
from rosward.network.enclave_mode import EnclaveMode
from rosward.outputs.policies.enclaves_toml import enclaves_toml
from rosward.ros.entities import Node

from .systems import nodes


@given(nodes(), st.integers(1, 9), st.booleans())
@settings(max_examples=examples(2))
def test_a_suggestion_that_is_written_and_read_is_what_was_suggested(
    tmp_path_factory: pytest.TempPathFactory, made: tuple[Node, ...], most: int, ignore_given: bool
) -> None:
    found = suggest(made, Wish.MOST, most, ignore_given=ignore_given)
    file = tmp_path_factory.mktemp("assigned") / "enclaves.toml"
    file.write_text(enclaves_toml(found), encoding="utf-8")
    placed, findings = with_enclaves(made, EnclaveMode.PROCESS, read_assignment(file))
    enclave_of = {p.process: e.path for e in found.enclaves for p in e.processes}
    assert {n.process: n.enclave for n in placed} == enclave_of
    assert ignore_given or not [f for f in findings if f.code == "RW341"]


def test_a_process_follows_its_node_and_its_label_first() -> None:
    made = [node("/a", process="demo/pair"), node("/b", process="demo/pair"), node("/c", process="demo/one")]
    placed, findings = with_enclaves(
        made, EnclaveMode.PROCESS, Assignment({"/b": "/joint", "/c": "/x"}, {"demo/one": "/y"})
    )
    assert ([n.enclave for n in placed], findings) == (["/joint", "/joint", "/y"], [])


def test_conflicts_are_told() -> None:
    made = [
        node("/a", process="demo/pair"),
        node("/b", process="demo/pair"),
        node("/c", given_enclave="/mine"),
    ]
    assignment = Assignment({"/a": "/x", "/b": "/y", "/c": "/z", "/nobody": "/z"}, file="enclaves.toml")
    placed, findings = with_enclaves(made, EnclaveMode.PROCESS, assignment)
    assert [n.enclave for n in placed] == ["/x", "/x", "/z"]
    assert [f"{f.code} {f.message}" for f in findings] == [
        "RW341 there is no node /nobody",
        "RW308 process demo/pair is assigned to several enclaves: /x, /y",
        "RW308 process demo/c is assigned to /z, but it is started with /mine: change one of them",
    ]


def test_what_is_not_assigned_never_meets_what_is() -> None:
    made = [node("/pair", process="demo/other"), node("/a", process="demo/pair"), node("/b", process="demo/pair")]
    placed, _ = with_enclaves(made, EnclaveMode.PROCESS, Assignment({"/pair": "/pair_2"}))
    assert len({n.enclave for n in placed}) == 2
    assert placed[1].enclave not in ("/pair_2",)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("enclave = 3", "only [[enclave]] tables are allowed"),
        ("[other]\nx = 1", "only [[enclave]] tables are allowed, not: other"),
        ("[[enclave]]\nnodes = []", 'each [[enclave]] needs a path = "/…"'),
        ('[[enclave]]\npath = "/a"\nnode = []', "has an unknown key 'node'; expected one of: nodes, path, processes"),
        ('[[enclave]]\npath = "a b"', "is rejected by rcl"),
        ('[[enclave]]\npath = "/a*"', "* is not allowed in it"),
        ('[[enclave]]\npath = "/a"\nnodes = "/x"', "nodes of enclave /a must be a list of strings"),
        (
            '[[enclave]]\npath = "/a"\nnodes = ["/x"]\n[[enclave]]\npath = "/b"\nnodes = ["/x"]',
            "/x is assigned to /a and to /b",
        ),
        ("[[", "not valid TOML"),
        ("a = " + "[" * 5_000, "not valid TOML"),
    ],
)
def test_what_is_no_assignment(text: str, message: str, tmp_path: Path) -> None:
    file = tmp_path / "enclaves.toml"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(AssignmentError) as error:
        read_assignment(file)
    assert message in str(error.value)
