# SPDX-License-Identifier: Apache-2.0
"""What does the engine ask of what all processes share: sources, models, natives, constants? `library.py` answers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from rosward.domain.heap import Obj
    from rosward.domain.values import Class, Const, Function, ModuleValue, Value
    from rosward.engine.sources.found import FoundModule, Sources
    from rosward.ir import ops
    from rosward.ir.program import Module
    from rosward.models.facts import LibraryFacts
    from rosward.models.native import NativeFunction
    from rosward.models.stub_marks import StubMarks
    from rosward.source.definitions import Definition


class Shared(Protocol):
    """What all processes of an analysis share, as the engine asks for it."""

    @property
    def sources(self) -> Sources:
        """The files of the analysis."""

    @property
    def environment(self) -> Mapping[str, Value | None]:
        """What is known of the environment of every process that is not given another."""

    @property
    def first_address(self) -> int:
        """The first address of the heap of a process; those below are of the models."""

    @property
    def nowhere(self) -> ModuleValue:
        """The module of what no code of the program calls."""

    @property
    def facts(self) -> LibraryFacts:
        """What the marks of stubs say of libraries."""

    @property
    def marks(self) -> StubMarks:
        """What stubs say of how information flows through functions of libraries."""

    @property
    def creating(self) -> frozenset[str]:
        """The names of methods that create entities."""

    @property
    def node_classes(self) -> tuple[Class, ...]:
        """The models of the classes of nodes."""

    def constant(self, op: ops.Const) -> Const:
        """The constant of an operation, made once."""

    def at(self, address: int) -> Obj:
        """A record of the models' heap; an empty one where there is none."""

    def ground(self, address: int) -> Obj | None:
        """What stands at an address before a process writes to it."""

    def native(self, name: str) -> NativeFunction | None:
        """The model in code of a dotted name."""

    def add_natives(self, natives: Mapping[str, NativeFunction]) -> None:
        """Further models in code: of a language that not every analysis has."""

    def function_address(self, function: Function) -> int:
        """Where the attributes of a function object are kept."""

    def file_value(self, module: ModuleValue) -> Value:
        """`__file__` of a module."""

    def find(self, name: str, level: int, importer: ModuleValue | None) -> FoundModule | None:
        """The module of a name as written in the module `importer`."""

    def is_model_file(self, file: str) -> bool:
        """Whether a file name is that of a model."""

    def load_model(self, found: FoundModule) -> ModuleValue:
        """The module value of a model, run once."""

    def expect(self, importer: ModuleValue, module: ModuleValue, name: str, stand_in: Value) -> None:
        """A model imports a name from one that is still running and does not have it yet: it is looked up when both are complete."""

    def module(self, file: str) -> Module | None:
        """The lowered file of a module."""

    def interface_has(self, module: str, name: str) -> bool | None:
        """Whether an interface package has an interface of that name; None where the package is not known."""

    def interface_definition(self, dotted: str) -> Definition | None:
        """The fields of a message by the dotted name of its class."""

    def missing(self, dotted: str) -> Value:
        """Something of a package that is not there."""
