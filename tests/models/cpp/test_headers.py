# SPDX-License-Identifier: Apache-2.0
"""The headers that stand for libraries: all of them are C++ that is understood, and ask only for natives that there are."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from casefile import read_cases, run_case

import rosward.models.cpp
from rosward.frontends.cpp import model_headers as reading
from rosward.frontends.cpp.model_headers import YIELDING, library_of, model_headers, modelled
from rosward.frontends.cpp.parse import CppParser
from rosward.models.flow_marks import MARKS as FLOW_MARKS
from rosward.models.tables import cpp_natives
from rosward.ros.distro import Distro

HEADERS = sorted((Path(rosward.models.cpp.__file__).parent / "headers").rglob("*.hpp"))
ASKED = re.compile(r"\brosward::(\w+)\b")
MARKS = {"node_class", "creator", "apart", *FLOW_MARKS}


def test_each_header_is_cpp_without_an_error() -> None:
    files = model_headers({}, CppParser())
    assert len(files) == len(HEADERS)
    assert [t for f in files for t in f.parsed.troubles] == []
    assert {library_of(f) for f in files} == {h.parent.name for h in HEADERS}


def test_what_may_be_replaced_by_its_sources_is_modelled() -> None:
    assert modelled() >= YIELDING - {"nav2"}


@pytest.mark.parametrize("header", HEADERS, ids=lambda h: f"{h.parent.name}/{h.name}")
def test_a_header_says_what_it_was_read_from_and_asks_for_natives_that_there_are(header: Path) -> None:
    text = header.read_text(encoding="utf-8")
    assert text.startswith("// SPDX-License-Identifier: Apache-2.0\n// ")
    assert {n for n in ASKED.findall(text) if n not in MARKS and f"rosward.{n}" not in cpp_natives()} == set()


def test_headers_are_read_once_for_each_version_of_a_library() -> None:
    versions = [{}, {"RCLCPP_VERSION_GTE": (16, 0, 0)}]
    old, new = (model_headers(each, CppParser()) for each in versions)
    assert old is not new
    assert [model_headers(each, CppParser()) for each in versions] == [old, new]


@pytest.mark.parametrize("distro", Distro)
def test_what_the_preprocessor_leaves_of_them_is_kept(
    distro: Distro, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROSWARD_CACHE", str(tmp_path))
    versions = {"RCLCPP_VERSION_GTE": distro.facts.rclcpp}
    made = list(reading._prepare(versions))
    first = reading._prepared(versions)
    monkeypatch.setattr(reading, "_prepare", None)
    assert made == first == reading._prepared(versions)


def test_a_program_leaves_nothing_behind_in_them(tmp_path: Path) -> None:
    """Headers are shared by all analyses of a process: each says what it says when it is the first."""
    cases = read_cases(Path(__file__).parents[2] / "cases" / "cpp_libraries.md")[:6]
    for number, case in enumerate([*cases, *reversed(cases)]):
        assert run_case(case, tmp_path / str(number)) == case.expected
