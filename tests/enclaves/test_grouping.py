# SPDX-License-Identifier: Apache-2.0
"""The price of a grouping is what a count by hand says, and the ladder goes one way."""

from __future__ import annotations

import json
from importlib import resources
from itertools import pairwise

import jsonschema
from hypothesis import given, settings
from hypothesis import strategies as st
from laws import examples
from outputs.networks import entity, node, pub, sub

from rosward.enclaves.grouping import cut_at
from rosward.enclaves.price import Price
from rosward.enclaves.privileges import privileges
from rosward.enclaves.suggestion import Suggestion, Wish, suggest
from rosward.outputs.documents.enclaves_json import enclaves_json
from rosward.outputs.terminal.enclaves_text import enclaves_text
from rosward.policies.match import Pattern
from rosward.ros.entities import EntityKind, Node, Resolution

from .systems import nodes

SCHEMA = json.loads((resources.files("rosward.outputs") / "schemas" / "enclaves.schema.json").read_text("utf-8"))


def counted(suggestion: Suggestion, all_nodes: tuple[Node, ...]) -> Price:
    """The price, counted one right at a time: for each process, each right of its enclave that none of its own covers."""
    rights = {p: privileges(n for n in all_nodes if n.process == p) for p in {n.process for n in all_nodes}}
    application = system = 0
    for enclave in suggestion.enclaves:
        members = [process.process for process in enclave.processes]
        held = {right for process in members for right in rights[process]}
        for process in members:
            for right in held:
                covered = any(
                    (own.kind, own.ros) == (right.kind, right.ros) and Pattern(own.name).covers(Pattern(right.name))
                    for own in rights[process]
                )
                if covered:
                    continue
                if all(needed.get(right, True) for needed in rights.values()):
                    system += 1
                else:
                    application += 1 if right.kind is EntityKind.SUBSCRIPTION else 2
    return Price(application, system)


@given(nodes(), st.integers(1, 9), st.booleans())
@settings(max_examples=examples(1.6))
def test_the_price_is_what_a_count_by_hand_says(made: tuple[Node, ...], most: int, ignore_given: bool) -> None:
    found = suggest(made, Wish.MOST, most, ignore_given=ignore_given)
    assert found.ladder.totals[found.cut.steps] == counted(found, made)
    for enclave in found.enclaves:
        weights = [1 if r.kind is EntityKind.SUBSCRIPTION else 2 for p in enclave.processes for r in p.application]
        assert enclave.price == Price(sum(weights), sum(len(p.system) for p in enclave.processes))


@given(nodes())
@settings(max_examples=examples(1.6))
def test_each_step_costs_and_saves_an_enclave(made: tuple[Node, ...]) -> None:
    found = suggest(made)
    for before, after in pairwise(found.ladder.totals):
        assert before.application <= after.application
        assert before.system <= after.system
    assert [step.enclaves for step in found.ladder.steps] == [
        len(found.ladder.units) - n for n in range(1, len(found.ladder.steps) + 1)
    ]
    fixed = sum(unit.fixed for unit in found.ladder.units)
    assert len(cut_at(found.ladder, len(found.ladder.steps)).groups) == fixed + (len(found.ladder.units) > fixed)


@given(nodes(), st.randoms(use_true_random=False))
@settings(max_examples=examples(1.2))
def test_the_order_of_nodes_does_not_matter(made: tuple[Node, ...], random: object) -> None:
    shuffled = list(made)
    random.shuffle(shuffled)  # type: ignore[attr-defined]
    assert enclaves_text(suggest(made)) == enclaves_text(suggest(shuffled))


@given(nodes(), st.integers(1, 9))
@settings(max_examples=examples(1.2))
def test_every_process_is_in_one_enclave_and_paths_differ(made: tuple[Node, ...], most: int) -> None:
    found = suggest(made, Wish.MOST, most)
    processes = [process.process for enclave in found.enclaves for process in enclave.processes]
    assert sorted(processes) == sorted({n.process for n in made})
    assert len({enclave.path for enclave in found.enclaves}) == len(found.enclaves)
    jsonschema.Draft202012Validator(SCHEMA).validate(json.loads(enclaves_json(found)))
    assert found.met == (len(found.enclaves) <= most)


def test_what_is_given_stays_unless_it_is_ignored() -> None:
    made = (node("/a", enclave="/given", given_enclave="/given"), node("/b"), node("/c"))
    assert [e.path for e in suggest(made, Wish.MOST, 2).enclaves] == ["/b_and_c", "/given"]
    found = suggest(made, Wish.MOST, 1)
    assert (found.met, len(found.enclaves)) == (False, 2)
    assert [e.path for e in suggest(made, Wish.MOST, 1, ignore_given=True).enclaves] == ["/a_and_2_more"]


def test_an_example_by_hand() -> None:
    """camera publishes /image, viewer listens, recorder too: viewer and recorder together cost nothing but system rights."""
    made = (node("/camera", pub("/image")), node("/viewer", sub("/image")), node("/recorder", sub("/image")))
    found = suggest(made)
    assert [e.path for e in found.enclaves] == ["/camera", "/recorder_and_viewer"]
    assert [step.price for step in found.ladder.steps] == [Price(0, 14), Price(1 + 2 + 2, 14 + 7 + 7)]
    assert "1 step costs only permissions of the client library." in enclaves_text(found)


def test_a_name_with_a_hole_covers_what_it_matches() -> None:
    fleet = pub("/robot_*/cmd", resolution=Resolution.PATTERN)
    made = (node("/fleet", fleet, system=False), node("/one", pub("/robot_1/cmd"), system=False))
    (enclave,) = suggest(made, Wish.MOST, 1).enclaves
    assert [[str(r) for r in p.application] for p in enclave.processes] == [[], ["publisher /robot_*/cmd"]]
    assert "publisher /robot_*/cmd (a pattern)" in enclaves_text(suggest(made, Wish.MOST, 1))


def test_a_budget_is_not_overdrawn() -> None:
    made = (
        node("/a", pub("/x")),
        node("/b", pub("/x")),
        node("/c", pub("/y")),
        node("/d", entity(EntityKind.ACTION_SERVER, "/do")),
    )
    for budget in range(30):
        found = suggest(made, Wish.BUDGET, budget)
        assert found.ladder.totals[found.cut.steps].application <= budget
        further = found.ladder.totals[found.cut.steps + 1 :]
        assert all(total.application > budget for total in further)


def test_paths_fit_a_certificate_and_are_nobody_elses() -> None:
    long = "x" * 50
    names = (f"/{long}/alpha_alpha", f"/{long}/beta_beta", "/a_and_b", "/a", "/b")
    made = tuple(node(name) for name in names)
    for most in range(1, 6):
        paths = [e.path for e in suggest(made, Wish.MOST, most).enclaves if len(e.processes) > 1]
        assert all(len(path) <= 64 for path in paths)
        assert "/a_and_b" not in paths
