# SPDX-License-Identifier: Apache-2.0
"""Promise: a text is read once, what was read longest ago is forgotten first, and what is wrong with a text is said each time."""

from __future__ import annotations

import pytest

from rosward.source import yaml_documents
from rosward.source.yaml_documents import YamlDocuments
from rosward.source.yaml_nodes import Item, Malformed, read_yaml


@pytest.fixture
def reads(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """What was read so far."""
    found: list[str] = []

    def noted(text: str, file: str, *, repeated: bool) -> Item:
        found.append(text)
        return read_yaml(text, file, repeated=repeated)

    monkeypatch.setattr(yaml_documents, "read_yaml", noted)
    return found


def test_a_text_is_read_once(reads: list[str]) -> None:
    documents = YamlDocuments()
    first = documents.read("a: [1, x]", "a.yaml")
    assert documents.read("a: [1, x]", "a.yaml") is first
    assert first == read_yaml("a: [1, x]", "a.yaml")
    assert documents.read("a: [1, x]", "b.yaml").place.file == "b.yaml"
    assert documents.read("a: [1, y]", "a.yaml") != first
    assert len(reads) == 3


def test_what_is_wrong_is_said_each_time(reads: list[str]) -> None:
    documents = YamlDocuments()
    told = []
    for _ in range(2):
        with pytest.raises(Malformed) as error:
            documents.read("a: *b", "a.yaml")
        told.append((error.value.message, error.value.place))
    assert told[0] == told[1]
    assert len(reads) == 1


def test_there_is_room_for_some(reads: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(yaml_documents, "_MOST_CHARACTERS", 20)
    documents = YamlDocuments()
    for text in ("a: 11111", "b: 11111", "a: 11111", "c: 11111", "a: 11111", "b: 11111"):
        documents.read(text, "")
    assert reads == ["a: 11111", "b: 11111", "c: 11111", "b: 11111"]
    documents.read(f"d: {'1' * 30}", "")  # alone larger than that
    assert documents.read("e: 1", "").mapping()["e"].value == 1
