# SPDX-License-Identifier: Apache-2.0
"""What do rosward's own models make? They were all run once for one installed rosward (`source/kept.py`); here is what that left.

Each record of their heap, each class and the body of each function is read where a program leads to it: no stub is read, lowered or run, and what
is not imported costs nothing. A model is the same whatever is run before it, so it is also the one that `ModelLibrary` would make.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Final, final

from rosward.domain.heap import Obj
from rosward.domain.values import Class, Function, ModuleValue, Value
from rosward.engine.libraries.model_library import NOTHING, PROCESS_ADDRESSES, ModelLibrary, classes_of
from rosward.engine.libraries.stub_files import StubFiles, own_names
from rosward.engine.libraries.written import Lines, NotWrittenError, Reader, Writer
from rosward.engine.sources.found import FoundModule
from rosward.findings import Findings
from rosward.ir.program import Module
from rosward.models.stub_marks import StubMarks
from rosward.models.tables import Models, own_models
from rosward.source.kept import kept

__all__ = ["KeptModels", "kept_models"]


@final
class KeptModels:
    """The models of a library, as `ModelLibrary` has them; nothing is missing, and nothing is ever run."""

    def __init__(self, models: Models, lines: Lines) -> None:
        head = json.loads(lines[-1])
        self.facts = models.facts
        self.findings: Final = Findings()
        self.at_rest: Final = True
        self.marks: Final = StubMarks(())
        self._reader = Reader(lines)
        self._modules: Mapping[str, tuple[int, str]] = head["modules"]
        self._packages = {name.partition(".")[0] for name in self._modules}
        self._records: Mapping[str, int] = head["records"]
        self._objects: dict[int, Obj | None] = {}
        self._stubs = StubFiles(())
        self._node_classes: tuple[Class, ...] | None = None

    def is_of(self, models: Models, *, net: bool) -> bool:  # noqa: ARG002  nothing can fail in it
        """Whether it holds these models and no others."""
        return models == own_models()

    def at(self, address: int) -> Obj:
        """A record of the models' heap; an empty one where there is none."""
        return self._objects.get(address) or self._record(address) or NOTHING

    def ground(self, address: int) -> Obj | None:
        """What stands at an address before a process writes to it: a model's record, or that of a function without attributes."""
        if address >= PROCESS_ADDRESSES:
            return None
        return NOTHING if address < -1 else self._record(address)

    def _record(self, address: int) -> Obj | None:
        try:
            return self._objects[address]
        except KeyError:
            line = self._records.get(str(address))
            found = self._objects[address] = None if line is None else self._reader.line(line)
            return found

    def known_function(self, _function: Function) -> int | None:
        """No model writes attributes to a function."""
        return None

    @property
    def node_classes(self) -> tuple[Class, ...]:
        """The models of the classes of nodes."""
        if self._node_classes is None:
            self._node_classes = classes_of(self, self.facts.node_classes)
        return self._node_classes

    def model(self, name: str) -> FoundModule | None:
        """The model of a module."""
        known = self._modules.get(name)
        return None if known is None else FoundModule(name, name, known[1], True)

    def describes(self, package: str) -> bool:
        """Whether there is any model of a top-level package."""
        return package in self._packages

    def load_model(self, found: FoundModule) -> ModuleValue:
        """The module value of a model."""
        address, file = self._modules[found.name]
        return ModuleValue(address, found.name, file)

    def expect(self, importer: ModuleValue, module: ModuleValue, name: str, stand_in: Value) -> None:
        """All models are complete."""

    def module(self, file: str) -> Module | None:
        """The lowered file of a model: nothing of it is run any more, but somebody may want to read it."""
        name = next((n for n, (_, known) in self._modules.items() if known == file), "")
        return self._stubs.module(file) if name and self._stubs.find(name) == file else None


def kept_models(models: Models) -> KeptModels | None:
    """rosward's own models; None where others are asked for, or nothing can be kept."""
    if models != own_models():
        return None
    content = kept("models", lambda: _content(models))
    return None if content is None else KeptModels(models, content.split(b"\n"))


def _content(models: Models) -> bytes | None:
    """All models as lines, of which the last says where each is."""
    library = ModelLibrary(models)
    modules: dict[str, tuple[int, str]] = {}
    for name in own_names():
        found = library.model(name)
        if found is not None:
            modules[name] = (library.load_model(found).address, found.file)
    if not library.is_written_by_records:
        return None
    writer = Writer()
    try:
        records = {address: writer.line(record) for address, record in library.records()}
    except NotWrittenError:
        return None
    return b"\n".join([*writer.lines, json.dumps({"modules": modules, "records": records}).encode()])
