# SPDX-License-Identifier: Apache-2.0
"""What all processes of an analysis share: lowered sources, library models, natives, constants.

Models are run once, in an interpreter of their own; its heap is the ground on which every process stands.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Final, final

from rosward.domain.compound import External
from rosward.domain.heap import Obj
from rosward.domain.text import make
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Class, Const, Function, Hole, ModuleValue, Value
from rosward.effects.log import EffectLog
from rosward.effects.shell import Shell, usual_shell
from rosward.engine.budget import Budget, LimitReachedError
from rosward.engine.declared import MODEL_PREFIX
from rosward.engine.found import FoundModule, Sources
from rosward.engine.interpreter import Interpreter
from rosward.engine.languages import LANGUAGES
from rosward.engine.machine import Language
from rosward.engine.model_units import absolute, units
from rosward.engine.reads import Reading, RecordedSources
from rosward.engine.stub_files import StubFiles
from rosward.findings import Finding, Findings
from rosward.guard import internal_error
from rosward.ir import ops
from rosward.ir.program import Module
from rosward.models.facts import marked
from rosward.models.native import NativeFunction
from rosward.models.ros.interfaces import message_name
from rosward.models.tables import Models
from rosward.source.definitions import Definition
from rosward.source.location import Place
from rosward.source.standard_library import STANDARD_LIBRARY

_NUMBERS: Final = (int, float)
_SMALL: Final = 1 << 60
_PROCESS_ADDRESSES: Final = 10_000_000


@final
class Library:
    """Shared by all processes; everything in it is computed at most once."""

    def __init__(
        self,
        sources: Sources,
        models: Models,
        folders: tuple[Path, ...] = (),
        environment: Shell | None = None,
        *,
        net: bool = True,
        languages: Iterable[Language] = LANGUAGES,
    ) -> None:
        self.sources: Sources = RecordedSources(sources, self._note)
        self._sources = sources  # for what is asked once for all processes
        self._reading: Reading | None = None
        self.languages = {language.name: language for language in languages}
        # of every process, unless it is given another
        self.environment = usual_shell() if environment is None else environment
        self.nowhere = ModuleValue(-1, "", "")
        self.first_address = 1
        self.facts = models.facts
        for folder in folders:
            self.facts = self.facts.joined(marked(folder))
        self.creating = self.facts.creating
        self._natives = models.natives
        self._stubs = StubFiles(folders, net=net)
        self._net = net
        self._constants: dict[tuple[type, object], Const] = {}
        self._found: dict[tuple[str, int, str], FoundModule | None] = {}
        self._definitions: dict[str, Definition | None] = {}
        self._lowered: dict[str, Module | None] = {}
        self._models: dict[str, ModuleValue] = {}
        self._waiting: set[str] = set()  # models of the units that are being loaded, which have not begun to run
        self._running: set[str] = set()  # models that have begun to run, and have not ended
        self._awaited: list[tuple[ModuleValue, ModuleValue, str, Value]] = []  # importer, module, name, its stand-in
        self._function_addresses: dict[Function, int] = {}
        self._node_classes: tuple[Class, ...] | None = None
        self._loader = Interpreter(self, Budget(steps=200_000, seconds=3600.0), EffectLog())
        self.first_address = _PROCESS_ADDRESSES

    @property
    def findings(self) -> Findings:
        """What is wrong with the stub files that were asked for."""
        return self._stubs.findings

    # What a process reads

    @contextmanager
    def reading(self) -> Iterator[Reading]:
        """Notes what is asked meanwhile."""
        outer, self._reading = self._reading, Reading()
        try:
            yield self._reading
        finally:
            self._reading = outer

    def _note(self, *question: str | int) -> None:
        if self._reading is not None:
            self._reading.questions.add(question)

    # Values

    def constant(self, op: ops.Const) -> Const:
        """The constant of an operation, made once."""
        value = op.value
        if value.__class__ is complex or (value.__class__ in _NUMBERS and not -_SMALL < value < _SMALL):
            return Const(value)  # endlessly many of these have one hash
        key = (value.__class__, value)
        found = self._constants.get(key)
        if found is None:
            found = Const(value)
            if value != 0:  # 0.0 and -0.0 are equal
                self._constants[key] = found
        return found

    def at(self, address: int) -> Obj:
        """A record of the models' heap; an empty one where there is none."""
        return self._loader.state.heap.get(address) or _NOTHING

    def ground(self, address: int) -> Obj | None:
        """What stands at an address before a process writes to it: a model's record, or that of a function without attributes."""
        if address >= self.first_address:
            return None
        return _NOTHING if address < -1 else self._loader.state.heap.get(address)

    def native(self, name: str) -> NativeFunction | None:
        """The model in code of a dotted name."""
        return self._natives.get(name)

    def function_address(self, function: Function) -> int:
        """Where the attributes of a function object are kept."""
        return self._function_addresses.setdefault(function, -2 - len(self._function_addresses))

    @property
    def node_classes(self) -> tuple[Class, ...]:
        """The models of the classes of nodes."""
        if self._node_classes is None:
            self._node_classes = tuple(self._classes(sorted(self.facts.node_classes)))
        return self._node_classes

    def _classes(self, names: Iterable[str]) -> Iterator[Class]:
        for name in names:
            package, _, leaf = name.rpartition(".")
            model = self._model(package)
            found = None if model is None else self.at(self._load(model).address).attrs.get(leaf)
            if isinstance(found, Class):
                yield found

    def file_value(self, module: ModuleValue) -> Value:
        """`__file__`: of a launch file in the share folder of its package; else where the module is installed, which is beside what it is beside
        in the sources."""
        shared = self.sources.shared(module.file)
        if shared is not None:
            cause = Cause.SHARE if shared[0] else Cause.SOURCES
            return make((Hole((Reason(cause, shared[0], Place(module.file)),)), "/" + shared[1]))
        folder, _, name = module.file.rpartition("/")
        return make((Hole((Reason(Cause.BESIDE, folder or ".", Place(module.file)),)), "/" + name))

    # Modules

    def find(self, name: str, level: int, importer: ModuleValue | None) -> FoundModule | None:
        """The module of a name as written in the module `importer`."""
        file = importer.file if importer is not None else ""
        self._note("find", name, level, file)
        key = (name, level, file)
        if key not in self._found:
            self._found[key] = self._look_up(name, level, importer)
        return self._found[key]

    def _look_up(self, name: str, level: int, importer: ModuleValue | None) -> FoundModule | None:
        file = importer.file if importer is not None else ""
        if importer is not None and self.is_model_file(file):
            return self._model(absolute(name, level, importer.name, importer.file))
        top = name.partition(".")[0]
        found = self._sources.find(name, level, file)
        if level:
            return found
        # A library whose model says so is never read: what it does is more than its Python says, or is asked for by name. Any other
        # that stands among the sources is read, unless it is only a guess, or a folder without a file of its own: an installed
        # package goes before that (the folder `launch` of a package, say).
        weak = found is None or found.guess or not found.file
        model = self._model(name) if weak or top in self.facts.before_sources else None
        if model is not None:
            return model
        return None if found is not None and found.guess and top in STANDARD_LIBRARY else found

    def _model(self, name: str) -> FoundModule | None:
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
        if self._reading is not None:
            self._reading.models.add(found.name)
        return self._load(found)

    def _load(self, found: FoundModule) -> ModuleValue:
        known = self._models.get(found.name)
        if known is not None:
            return known
        if found.name in self._waiting:  # it is imported by one that it needs itself
            return self._run_model(found.name)
        reading, self._reading = self._reading, None  # what models ask is not of the process that needs them first
        try:
            for unit in units(self._stubs, found.name):
                if unit[0] not in self._models:
                    self._load_unit(unit)
        finally:
            self._reading = reading
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
        parent = self._model(package) if package else None
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
        """The lowered file of a module."""
        if file:
            self._note("module", file)
        if file not in self._lowered:
            if self.is_model_file(file):
                self._lowered[file] = self._stubs.module(file)
            else:
                self._lowered[file] = self._sources.module(file) if file else None
        return self._lowered[file]

    def language_of(self, module: ModuleValue) -> Language:
        """That of the file of a module; of one without a file, that of the models."""
        lowered = self.module(module.file)
        return next(iter(self.languages.values())) if lowered is None else self.languages[lowered.code.language]

    def interface_has(self, module: str, name: str) -> bool | None:
        """Whether an interface package has an interface of that name; None where the package is not known."""
        return self.sources.interface_has(module, name)

    def interface_definition(self, dotted: str) -> Definition | None:
        """The fields of a message by the dotted name of its class; None where they are not known."""
        self._note("interface_definition", dotted)
        if dotted not in self._definitions:
            named = message_name(dotted)
            self._definitions[dotted] = None if named is None else self._sources.interface_definition(*named)
        return self._definitions[dotted]

    def missing(self, dotted: str) -> Value:
        """Something of a package that is not there."""
        return External(dotted)


_NOTHING: Final = Obj("instance", Const(None))
