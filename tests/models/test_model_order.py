# SPDX-License-Identifier: Apache-2.0
"""Promise: what a model is does not depend on which models were asked for before it.

The heap of the models is compared as a graph that is followed from the variables of a module: addresses are numbered as they are met.
ROSWARD_ORDER=1 tries every pair of libraries in both orders.
"""

from __future__ import annotations

import itertools
import os
import random
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from casefile import read_cases, run_case

from rosward.analysis.source_tree import SourceTree
from rosward.domain.compound import Tuple
from rosward.domain.heap import Obj
from rosward.domain.values import Choice, Class, Const, Function, ModuleValue, Ref, Text, Unknown
from rosward.engine.libraries import spare
from rosward.engine.libraries.kept_models import KeptModels, kept_models
from rosward.engine.libraries.library import Library
from rosward.engine.libraries.model_library import ModelLibrary
from rosward.engine.libraries.model_units import units
from rosward.engine.libraries.stub_files import STUBS, StubFiles
from rosward.models.tables import own_models
from rosward.source.discover import discover

CASES = Path(__file__).parents[1] / "cases"

MODELS = sorted(
    ".".join(path.relative_to(STUBS).with_suffix("").parts).removesuffix(".__init__") for path in STUBS.rglob("*.pyi")
)
LIBRARIES = [name for name in MODELS if "." not in name]
_READ = StubFiles(())  # every stub is read once: what is tried is in which order they are run


def _library(names: Iterable[str]) -> ModelLibrary:
    """A library that was asked for models in this order."""
    library = ModelLibrary(own_models())
    library._stubs = _READ
    for name in names:
        _module(library, name)
    return library


def _module(library: ModelLibrary | KeptModels, name: str) -> ModuleValue:
    found = library.model(name)
    assert found is not None
    return library.load_model(found)


@cache
def _needed(name: str) -> tuple[str, ...]:
    """The modules that are there when a model is."""
    return tuple(sorted({member for unit in units(_READ, name) for member in unit}))


def _shape(library: ModelLibrary | KeptModels, name: str) -> object:
    """All that can be reached from a module."""
    numbers: dict[int, int] = {}
    shapes: list[object] = []
    pending: list[int] = []

    def address(of: int) -> int:
        if of not in numbers:
            numbers[of] = len(numbers)
            pending.append(of)
        return numbers[of]

    def value(of: Any) -> object:
        if isinstance(of, Ref):
            return "ref", address(of.address)
        if isinstance(of, Class):
            return "class", of.dotted, address(of.address), value(of.bases), of.place, value(of.mro[1:])
        if isinstance(of, ModuleValue):
            return "module", of.name, of.file, address(of.address)
        if isinstance(of, Function):
            cells = tuple(address(c) for c in of.cells)
            given = (value(of.defaults), value(of.kwdefaults), value(of.effects))
            return "function", of.code.key, value(of.module), cells, given
        if isinstance(of, (Choice, Tuple)):
            return type(of).__name__, value(of.options if isinstance(of, Choice) else of.items)
        if isinstance(of, (Const, Text, Unknown)):
            return repr(of)
        if isinstance(of, tuple):
            return type(of).__name__, tuple(value(each) for each in of)
        return repr(of)

    def record(of: Obj) -> object:
        entries = [(value(k), value(v)) for k, v in of.entries.items()]
        attrs = [(k, value(v)) for k, v in of.attrs.items()]
        parts = tuple(value(p) for p in (of.cls, of.items, of.rest, of.rest_key, of.payload))
        return of.kind, parts, attrs, entries, of.many, sorted(of.partial), sorted(map(repr, of.maybe))

    address(_module(library, name).address)
    while pending:
        shapes.append(record(library.at(pending.pop(0))))
    return shapes


@pytest.fixture(scope="module")
def alone() -> dict[str, object]:
    """Each model in a library in which nothing else was asked for."""
    return {name: _shape(_library(()), name) for name in MODELS}


@pytest.mark.slow
def test_the_last_first_gives_the_same_models() -> None:
    forward, backward = _library(MODELS), _library(reversed(MODELS))
    assert [name for name in MODELS if _shape(forward, name) != _shape(backward, name)] == []


@pytest.mark.slow
def test_no_program_changes_a_model(tmp_path: Path) -> None:
    """The next analysis takes over the models that the one before has used."""
    cases = [c for name in ("builtin_subclasses", "classes", "functions") for c in read_cases(CASES / f"{name}.md")]
    for number, case in enumerate(cases):
        assert run_case(case, tmp_path / str(number)) == case.expected
    (used,) = spare._SPARE
    fresh = _library(MODELS)
    assert [name for name in MODELS if _shape(used, name) != _shape(fresh, name)] == []


@pytest.mark.slow
def test_models_that_are_kept_are_those_that_are_run() -> None:
    kept = kept_models(own_models())
    assert kept is not None
    fresh = _library(MODELS)
    assert [name for name in MODELS if _shape(kept, name) != _shape(fresh, name)] == []
    assert [c.dotted for c in kept.node_classes] == [c.dotted for c in fresh.node_classes]


def test_models_in_use_are_nobody_elses(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def library(*, net: bool = True) -> Library:
        return Library(SourceTree(discover([tmp_path])), own_models(), net=net)

    monkeypatch.setenv("ROSWARD_CACHE", "")  # so that they are run here
    spare._SPARE.clear()
    first, second = library(), library()
    assert first._models is not second._models
    first.given_back()
    assert library(net=False)._models is not first._models  # and the spare one is gone
    second.given_back()
    third = library()
    assert third._models is second._models
    assert isinstance(third._models, ModelLibrary)
    third._models._waiting.add("left in the middle")
    third.given_back()
    assert library()._models is not third._models


@pytest.mark.slow
@pytest.mark.parametrize("order", ["forward", "backward", "inner first", *range(4)])
def test_any_order_gives_the_same_models(order: str | int, alone: dict[str, object]) -> None:
    """Whatever was loaded before, a model is what it is alone."""
    names = sorted(MODELS, reverse=order == "backward", key=lambda n: (n.count("."), n))
    if order == "inner first":
        names.sort(key=lambda n: -n.count("."))
    if isinstance(order, int):
        random.Random(order).shuffle(names)
    library = _library(names)
    assert [name for name in MODELS if _shape(library, name) != alone[name]] == []


def _pairs() -> list[tuple[str, str]]:
    """Two libraries each; without ROSWARD_ORDER those that launch files import together."""
    every = LIBRARIES if os.environ.get("ROSWARD_ORDER") else [n for n in LIBRARIES if "launch" in n or n == "rclpy"]
    return [(one, other) for one in every for other in every if one < other]


@pytest.mark.slow
def test_two_libraries_in_both_orders(alone: dict[str, object]) -> None:
    """Each pair of libraries is the same in both orders."""
    for one, other in _pairs():
        for names in ((one, other), (other, one)):
            library = _library(names)
            assert _shape(library, one) == alone[one], names
            assert _shape(library, other) == alone[other], names


def test_no_model_needs_what_is_not_there_yet(monkeypatch: pytest.MonkeyPatch) -> None:
    """None of our stubs imports a name from one that has not come so far."""
    early = []
    monkeypatch.setattr(
        ModelLibrary, "expect", lambda _self, importer, module, name, _value: early.append((importer, module, name))
    )
    library = _library(MODELS)
    running = {name for _, module, name in early if name in library.at(module.address).attrs}
    assert not running


def test_names_of_a_cycle_come_later(tmp_path: Path) -> None:
    """Two stubs that import each other: what is not there yet is looked up when both are complete."""
    (tmp_path / "ring").mkdir()
    (tmp_path / "ring/__init__.pyi").write_text("from .one import One\nfrom .two import Two\n")
    (tmp_path / "ring/one.pyi").write_text("from ring.two import Two\nclass One: ...\ndef other() -> Two: ...\n")
    (tmp_path / "ring/two.pyi").write_text("from ring.one import One\nclass Two: ...\ndef other() -> One: ...\n")
    shapes = []
    for first in ("ring", "ring.one", "ring.two"):
        library = ModelLibrary(own_models(), (tmp_path,))
        _module(library, first)
        shapes.append([_shape(library, name) for name in ("ring", "ring.one", "ring.two")])
        for name, imported in (("ring.one", "Two"), ("ring.two", "One")):
            assert isinstance(library.at(_module(library, name).address).attrs[imported], Class)
    assert shapes[0] == shapes[1] == shapes[2]


def test_a_model_changes_no_other(tmp_path: Path) -> None:
    """What a stub writes into another library is not seen: else the order of imports would be."""
    (tmp_path / "base.pyi").write_text("names = ['a']\nclass Base: ...\n")
    (tmp_path / "more.pyi").write_text("import base\nbase.names.append('b')\nbase.Base.extra = 1\n")
    shapes = []
    for order in (("base", "more"), ("more", "base"), ("base",)):
        library = ModelLibrary(own_models(), (tmp_path,))
        for name in order:
            _module(library, name)
        shapes.append(_shape(library, "base"))
    assert shapes[0] == shapes[1] == shapes[2]


def test_what_a_function_imports_comes_when_it_is_called(tmp_path: Path) -> None:
    """A stub that a function imports is loaded by its call, also where the function is called while its own stub is loaded."""
    (tmp_path / "late.pyi").write_text("import given\nclass Late(given.Given): ...\n")
    (tmp_path / "given.pyi").write_text(
        "class Given: ...\ndef make():\n    from late import Late\n    return Late()\ndef uncalled():\n    import more\n"
    )
    (tmp_path / "called.pyi").write_text("import given\nmade = given.make()\n")
    (tmp_path / "more.pyi").write_text("MORE = 1\n")
    shapes = []
    for order in itertools.permutations(("late", "given", "called")):
        library = ModelLibrary(own_models(), (tmp_path,))
        for name in order:
            _module(library, name)
        assert "more" not in library._models
        shapes.append([_shape(library, name) for name in ("late", "given", "called")])
    assert all(shape == shapes[0] for shape in shapes)
