# SPDX-License-Identifier: Apache-2.0
"""What do the models of libraries make, whoever asks for them?

Models are run once, in an interpreter of their own; its heap is the ground on which every process stands. They see no source: what they make
depends on the stubs alone, so an analysis takes over what was run for an earlier one (`spare.py`, `kept_models.py`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import Final, Protocol, final

from rosward.domain.compound import External
from rosward.domain.heap import Obj
from rosward.domain.text import make
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Class, Const, Function, Hole, ModuleValue, Value
from rosward.effects.log import EffectLog
from rosward.effects.shell import Shell, usual_shell
from rosward.engine.budget import Budget, LimitReachedError
from rosward.engine.interpreter import Interpreter
from rosward.engine.languages import LANGUAGES, Languages
from rosward.engine.libraries.model_units import absolute, units
from rosward.engine.libraries.stub_files import StubFiles
from rosward.engine.machine import Language
from rosward.engine.sources.found import FoundModule, Sources
from rosward.engine.sources.no_sources import NO_SOURCES
from rosward.findings import Finding, Findings
from rosward.guard import internal_error
from rosward.ir import ops
from rosward.ir.program import MODEL_PREFIX, Module
from rosward.location import Place
from rosward.models.facts import LibraryFacts, marked
from rosward.models.native import NativeFunction
from rosward.models.stub_marks import StubMarks, wrong_marks
from rosward.models.tables import Models
from rosward.source.definitions import Definition

__all__ = ["NOTHING", "PROCESS_ADDRESSES", "Constants", "ModelLibrary", "classes_of", "file_value"]

PROCESS_ADDRESSES: Final = 10_000_000
"""The first address of the heap of a process."""

_NUMBERS: Final = (int, float)
_SMALL: Final = 1 << 60


@final
class Constants:
    """The constants of operations, each made once."""

    __slots__ = ("_known", "_of")

    def __init__(self) -> None:
        self._known: dict[tuple[type, object], Const] = {}
        self._of: dict[ops.Const, Const] = {}  # operations are compared by identity

    def of(self, op: ops.Const) -> Const:
        """The constant of an operation."""
        found = self._of.get(op)
        if found is None:
            found = self._of[op] = self._made(op)
        return found

    def _made(self, op: ops.Const) -> Const:
        value = op.value
        if value.__class__ is complex or (value.__class__ in _NUMBERS and not -_SMALL < value < _SMALL):
            return Const(value)  # endlessly many of these have one hash
        key = (type(value), value)
        found = self._known.get(key)
        if found is None:
            found = Const(value)
            if value != 0:  # 0.0 and -0.0 are equal
                self._known[key] = found
        return found


@final
class ModelLibrary:
    """Implements `machine.SharedLanguages` for the interpreter of the models; everything in it is computed at most once."""

    def __init__(
        self,
        models: Models,
        folders: tuple[Path, ...] = (),
        *,
        net: bool = True,
        languages: Mapping[str, Callable[[], Language]] = LANGUAGES,
    ) -> None:
        self.sources: Sources = NO_SOURCES
        self.environment: Shell = usual_shell()
        self.languages = Languages(languages)
        self.nowhere = ModuleValue(-1, "", "")
        self.first_address = 1
        self.facts: LibraryFacts = models.facts
        for folder in folders:
            self.facts = self.facts.joined(marked(folder))
        self.creating = self.facts.creating
        self._natives = models.natives
        self._folders = folders
        self._stubs = StubFiles(folders, net=net)
        self.marks = StubMarks(folders)
        for folder in folders:
            self._stubs.findings.update(
                wrong_marks(folder, MODEL_PREFIX, lambda name: f"_rosward.{name}" in models.natives)
            )
        self._net = net
        self._constants = Constants()
        self._models: dict[str, ModuleValue] = {}
        self._waiting: set[str] = set()  # models of the units that are being loaded, which have not begun to run
        self._running: set[str] = set()  # models that have begun to run, and have not ended
        self._awaited: list[tuple[ModuleValue, ModuleValue, str, Value]] = []  # importer, module, name, its stand-in
        self._function_addresses: dict[Function, int] = {}
        self._node_classes: tuple[Class, ...] | None = None
        self._loader = Interpreter(self, Budget(steps=200_000, seconds=3600.0), EffectLog())
        self.first_address = PROCESS_ADDRESSES

    @property
    def findings(self) -> Findings:
        """What is wrong with the stub files that were asked for."""
        return self._stubs.findings

    @property
    def at_rest(self) -> bool:
        """Whether no model is being loaded."""
        return not (self._waiting or self._running or self._awaited or self._loader.frames)

    def is_of(self, models: Models, *, net: bool) -> bool:
        """Whether it holds these models and no others."""
        return not self._folders and net == self._net and models.natives == self._natives and models.facts == self.facts

    @property
    def is_written_by_records(self) -> bool:
        """Whether what was run went well, and has left nothing but records."""
        return self.at_rest and not self.findings and not self._function_addresses

    def records(self) -> Iterator[tuple[int, Obj]]:
        """All records with their addresses."""
        return self._loader.state.heap.items()

    # Values

    def constant(self, op: ops.Const) -> Const:
        """The constant of an operation, made once."""
        return self._constants.of(op)

    def at(self, address: int) -> Obj:
        """A record of the models' heap; an empty one where there is none."""
        return self._loader.state.heap.get(address) or NOTHING

    def ground(self, address: int) -> Obj | None:
        """What stands at an address before a process writes to it: a model's record, or that of a function without attributes."""
        if address >= self.first_address:
            return None
        return NOTHING if address < -1 else self._loader.state.heap.get(address)

    def native(self, name: str) -> NativeFunction | None:
        """The model in code of a dotted name."""
        return self._natives.get(name)

    def add_natives(self, natives: Mapping[str, NativeFunction]) -> None:
        """Models need no others than those they began with."""

    def function_address(self, function: Function) -> int:
        """Where the attributes of a function object are kept: at even addresses, for a process has others."""
        return self._function_addresses.setdefault(function, -2 - 2 * len(self._function_addresses))

    def known_function(self, function: Function) -> int | None:
        """The same, where it was asked for before."""
        return self._function_addresses.get(function)

    @property
    def node_classes(self) -> tuple[Class, ...]:
        """The models of the classes of nodes."""
        if self._node_classes is None:
            self._node_classes = classes_of(self, self.facts.node_classes)
        return self._node_classes

    def file_value(self, module: ModuleValue) -> Value:
        """`__file__`."""
        return file_value(module, None)

    # Modules

    def find(self, name: str, level: int, importer: ModuleValue | None) -> FoundModule | None:
        """The module of a name as written in a model."""
        return self.model(absolute(name, level, importer.name, importer.file) if importer is not None else name)

    def model(self, name: str) -> FoundModule | None:
        """The model of a module."""
        path = self._stubs.find(name)
        return None if path is None else FoundModule(name, name, path, True)

    def describes(self, package: str) -> bool:
        """Whether there is any model of a top-level package."""
        return self._stubs.describes(package)

    @staticmethod
    def is_model_file(file: str) -> bool:
        """Whether a file name is that of a model."""
        return file.startswith(MODEL_PREFIX)

    def load_model(self, found: FoundModule) -> ModuleValue:
        """The module value of a model, run once: with all that it needs, in an order that does not depend on who asks."""
        known = self._models.get(found.name)
        if known is not None:
            return known
        if found.name in self._waiting:  # it is imported by one that it needs itself
            return self._run_model(found.name)
        for unit in units(self._stubs, found.name):
            if unit[0] not in self._models:
                self._load_unit(unit)
        return self._models[found.name]

    def _load_unit(self, unit: tuple[str, ...]) -> None:
        """Run models that need each other. They change nothing of those that were there before."""
        loader = self._loader
        frames, catchers, steps = loader.frames, loader.catchers, loader.precision.steps
        loader.frames, loader.catchers, loader.precision.steps = [], [], 0
        before = loader.state.heap.copy()
        self._waiting.update(unit)
        for name in unit:
            if name in self._waiting:
                self._run_model(name)
        self._give_awaited(unit)
        loader.state.heap.restore(before)
        loader.state.version = loader.fresh_version()
        loader.frames, loader.catchers, loader.precision.steps = frames, catchers, steps

    def _run_model(self, name: str) -> ModuleValue:
        """Run one model of a unit; the package around it goes first."""
        self._waiting.discard(name)
        package, _, leaf = name.rpartition(".")
        parent = self.model(package) if package else None
        above = None if parent is None else self.load_model(parent)
        known = self._models.get(name)
        if known is not None:  # the package has imported it
            return known
        loader = self._loader
        module = ModuleValue(loader.place_key(("module", name)), name, self._stubs.find(name) or "")
        self._models[name] = module
        self._running.add(name)
        catchers = loader.catchers
        try:
            loader.run_module(module, name)
        except LimitReachedError as limit:
            self._stubs.findings.add(
                Finding("RW201", f"This stub was read only up to a limit: {limit.what}.", limit.place)
            )
            loader.catchers, loader.precision.steps = catchers, 0
        except Exception as error:
            if not self._net:
                raise
            place = Place(module.file)
            self._stubs.findings.add(internal_error(error, place, "this stub was read only up to this point"))
            loader.catchers = catchers
        self._running.discard(name)
        if above is not None and leaf not in loader.at(above.address).attrs:
            loader.put(above.address, loader.at(above.address).with_attr(leaf, module))
        return module

    def expect(self, importer: ModuleValue, module: ModuleValue, name: str, stand_in: Value) -> None:
        """A model imports a name from one that is still running and does not have it yet: it is looked up when both are complete."""
        if module.name in self._running:
            self._awaited.append((importer, module, name, stand_in))

    def _give_awaited(self, unit: tuple[str, ...]) -> None:
        """Put what was imported too early in the place of what stood in for it."""
        awaited, self._awaited = self._awaited, []
        for importer, module, name, stand_in in awaited:
            if importer.name not in unit:
                self._awaited.append((importer, module, name, stand_in))
                continue
            value = self._loader.language.load_attr(self._loader, module, name)
            record = self._loader.at(importer.address)
            attrs: dict[str, Value] = {n: value if v == stand_in else v for n, v in record.attrs.items()}
            self._loader.put(importer.address, record.replace(attrs=attrs))

    def module(self, file: str) -> Module | None:
        """The lowered file of a model."""
        return self._stubs.module(file)

    def language_of(self, module: ModuleValue) -> Language:
        """That of the file of a module; of one without a file, that of the models."""
        lowered = self.module(module.file)
        return self.languages[next(iter(self.languages))] if lowered is None else self.languages[lowered.code.language]

    def interface_has(self, _module: str, _name: str) -> bool | None:
        """Nothing is known of interfaces: those of the sources are not the models' affair."""
        return None

    def interface_definition(self, _dotted: str) -> Definition | None:
        """Nothing is known of them."""
        return None

    def missing(self, dotted: str) -> Value:
        """Something of a package that is not there."""
        return External(dotted)


def file_value(module: ModuleValue, shared: tuple[str, str] | None) -> Value:
    """`__file__`: of a launch file in the share folder of its package; else where the module is installed, which is beside what it is beside
    in the sources."""
    if shared is not None:
        cause = Cause.SHARE if shared[0] else Cause.SOURCES
        return make((Hole((Reason(cause, shared[0], Place(module.file)),)), "/" + shared[1]))
    folder, _, name = module.file.rpartition("/")
    return make((Hole((Reason(Cause.BESIDE, folder or ".", Place(module.file)),)), "/" + name))


NOTHING: Final = Obj("instance", Const(None))
"""What stands where nothing was put."""


class Loaded(Protocol):
    """Models that can be loaded."""

    def model(self, name: str) -> FoundModule | None:
        """The model of a module."""

    def load_model(self, found: FoundModule) -> ModuleValue:
        """The module value of a model."""

    def at(self, address: int) -> Obj:
        """A record of the models' heap."""


def classes_of(library: Loaded, names: Iterable[str]) -> tuple[Class, ...]:
    """The models of classes, by their dotted names."""
    return tuple(_classes(library, sorted(names)))


def _classes(library: Loaded, names: Iterable[str]) -> Iterator[Class]:
    for name in names:
        package, _, leaf = name.rpartition(".")
        model = library.model(package)
        found = None if model is None else library.at(library.load_model(model).address).attrs.get(leaf)
        if isinstance(found, Class):
            yield found
