# SPDX-License-Identifier: Apache-2.0
"""Promise: a graph that did not change is not drawn again, and one that is too large not with another caption; the pictures are the same."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosward.cache.store import Store
from rosward.network.connect import connect
from rosward.network.graph import Network
from rosward.outputs.graphs import svg
from rosward.outputs.graphs.dot_language import Drawing
from rosward.outputs.graphs.svg import graph_svg
from rosward.outputs.pictures import Pictures

from .networks import node, pub, stack, sub, talker_and_listener


@pytest.fixture
def drawn(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """What was drawn so far."""
    found: list[str] = []
    real = svg._drawn_by

    def noted(program: str, drawing: Drawing, told: list[str]) -> str | None:
        found.append(drawing.text)
        return real(program, drawing, told)

    monkeypatch.setattr(svg, "_drawn_by", noted)
    return found


@pytest.mark.parametrize("network", [talker_and_listener(), stack(190)])
def test_it_is_drawn_once_for_all_runs(network: Network, drawn: list[str], tmp_path: Path) -> None:
    fresh = graph_svg(network)
    shapes = len(drawn)
    assert graph_svg(network, pictures=Pictures(Store(str(tmp_path)))) == fresh
    assert len(drawn) == 2 * shapes
    assert graph_svg(network, pictures=Pictures(Store(str(tmp_path)))) == fresh
    assert len(drawn) == 2 * shapes
    graph_svg(stack(30), pictures=Pictures(Store(str(tmp_path))))
    assert len(drawn) > 2 * shapes


def test_another_program_draws_again(drawn: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    network = talker_and_listener()
    graph_svg(network, pictures=Pictures(Store(str(tmp_path))))
    monkeypatch.setattr("rosward.source.disk.note_program", lambda _: "newer")
    graph_svg(network, pictures=Pictures(Store(str(tmp_path))))
    assert len(drawn) == 2


def test_what_failed_is_tried_again(drawn: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    network = talker_and_listener()
    monkeypatch.setattr(svg, "_program", lambda: "/nowhere/graphviz")
    assert "could not draw" in graph_svg(network, pictures=Pictures(Store(str(tmp_path))))
    graph_svg(network, pictures=Pictures(Store(str(tmp_path))))
    assert len(drawn) == 2


def test_a_forged_drawing_is_drawn_again(drawn: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    network, store = talker_and_listener(), Store(str(tmp_path))
    real = store.keep
    other = {b"0": b"1"}  # the first letter is one of a digest
    monkeypatch.setattr(
        store, "keep", lambda kind, question, answer: real(kind, question, other.get(answer[:1], b"0") + answer[1:])
    )
    fresh = graph_svg(network, pictures=Pictures(store))
    assert graph_svg(network, pictures=Pictures(store)) == fresh
    assert len(drawn) == 2


def test_the_same_shapes_are_not_drawn_under_another_caption(drawn: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    network = connect("jazzy", [node(f"/ns/n{i}", pub(f"/t{i}"), sub(f"/t{i - 1}")) for i in range(6)])
    monkeypatch.setattr(svg, "_WIDEST", 10)
    monkeypatch.setattr(svg, "_HIGHEST", 10)
    graph_svg(network)
    lines = [tuple(line for line in text.split("\n") if "graph [label=" not in line) for text in drawn]
    directions = [text.count("rankdir=TB") for text in drawn]
    assert len(set(zip(lines, directions, strict=True))) == len(drawn) > 2
