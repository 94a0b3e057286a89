# SPDX-License-Identifier: Apache-2.0
"""What all processes of an analysis share: lowered sources, library models, natives, constants."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import final

from rosward.domain.compound import External
from rosward.domain.values import Class, Const, Function, ModuleValue, Value
from rosward.effects.shell import Shell, usual_shell
from rosward.engine.languages import LANGUAGES, Languages
from rosward.engine.libraries.model_library import PROCESS_ADDRESSES, Constants, ModelLibrary, file_value
from rosward.engine.libraries.model_units import absolute
from rosward.engine.libraries.spare import borrowed, given_back
from rosward.engine.machine import Language
from rosward.engine.sources.found import FoundModule, Sources
from rosward.engine.sources.reads import Reading, RecordedSources
from rosward.engine.sources.remembered import Memory, memory_here
from rosward.findings import Findings
from rosward.ir import ops
from rosward.ir.program import MODEL_PREFIX, Module
from rosward.models.interfaces import message_name
from rosward.models.native import NativeFunction
from rosward.models.tables import Models
from rosward.source.definitions import Definition
from rosward.source.standard_library import STANDARD_LIBRARY


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
        languages: Mapping[str, Callable[[], Language]] = LANGUAGES,
    ) -> None:
        self.sources: Sources = RecordedSources(sources, self._note)
        self._sources = sources  # for what is asked once for all processes
        self._reading: Reading | None = None
        self._memory = memory_here() if not folders else None  # what the user's own models say, no question asks
        self.languages = Languages(languages)
        # of every process, unless it is given another
        self.environment = usual_shell() if environment is None else environment
        self.nowhere = ModuleValue(-1, "", "")
        self.first_address = PROCESS_ADDRESSES
        self.has_further_models = bool(folders)
        is_usual = not folders and languages is LANGUAGES
        self._models = (
            borrowed(models, net=net) if is_usual else ModelLibrary(models, folders, net=net, languages=languages)
        )
        self.at = self._models.at
        self.ground = self._models.ground
        self.facts = self._models.facts
        self.creating = self.facts.creating
        self.marks = self._models.marks
        self._natives = models.natives
        self._further: dict[str, NativeFunction] = {}
        self._constants = Constants()
        self._found: dict[tuple[str, int, str], FoundModule | None] = {}
        self._definitions: dict[str, Definition | None] = {}
        self._lowered: dict[str, Module | None] = {}
        self._function_addresses: dict[Function, int] = {}  # odd ones, but for functions of models that have their own

    @property
    def memory(self) -> Memory | None:
        """What is known of earlier processes; None where nothing is remembered."""
        return self._memory

    @property
    def plain_sources(self) -> Sources:
        """The sources, where nobody notes what is asked."""
        return self._sources

    @property
    def findings(self) -> Findings:
        """What is wrong with the stub files that were asked for."""
        return self._models.findings

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
        if self._memory is not None:
            self._memory.touch(question)

    # Values

    def constant(self, op: ops.Const) -> Const:
        """The constant of an operation, made once."""
        return self._constants.of(op)

    def native(self, name: str) -> NativeFunction | None:
        """The model in code of a dotted name."""
        return self._further.get(name) or self._natives.get(name)

    def add_natives(self, natives: Mapping[str, NativeFunction]) -> None:
        """Further models in code: of a language that not every analysis has."""
        self._further = {**self._further, **natives}

    def function_address(self, function: Function) -> int:
        """Where the attributes of a function object are kept."""
        found = self._function_addresses.get(function)
        if found is None:
            known = self._models.known_function(function)
            found = -3 - 2 * len(self._function_addresses) if known is None else known
            self._function_addresses[function] = found
        return found

    @property
    def node_classes(self) -> tuple[Class, ...]:
        """The models of the classes of nodes."""
        return self._models.node_classes

    def file_value(self, module: ModuleValue) -> Value:
        """`__file__` of a module."""
        return file_value(module, self.sources.shared(module.file))

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
        return self._models.model(name)

    def describes(self, package: str) -> bool:
        """Whether there is any model of a top-level package."""
        return self._models.describes(package)

    @staticmethod
    def is_model_file(file: str) -> bool:
        """Whether a file name is that of a model."""
        return file.startswith(MODEL_PREFIX)

    def load_model(self, found: FoundModule) -> ModuleValue:
        """The module value of a model, run once: with all that it needs, in an order that does not depend on who asks."""
        if self._reading is not None:
            self._reading.models.add(found.name)
        return self._models.load_model(found)

    def load_again(self, name: str) -> None:
        """Load what another process has loaded: what is wrong with a stub is told of all that use it."""
        found = self._model(name)
        if found is not None:
            self._models.load_model(found)

    def expect(self, importer: ModuleValue, module: ModuleValue, name: str, stand_in: Value) -> None:
        """A model imports a name from one that is still running and does not have it yet: it is looked up when both are complete."""
        self._models.expect(importer, module, name, stand_in)

    def given_back(self) -> None:
        """The analysis is over: the next one may take over the models."""
        given_back(self._models)

    def module(self, file: str) -> Module | None:
        """The lowered file of a module."""
        if file:
            self._note("module", file)
        if file not in self._lowered:
            if self.is_model_file(file):
                self._lowered[file] = self._models.module(file)
            else:
                self._lowered[file] = self._sources.module(file) if file else None
        return self._lowered[file]

    def language_of(self, module: ModuleValue) -> Language:
        """That of the file of a module; of one without a file, that of the models."""
        file = module.file
        lowered = None if self.is_model_file(file) else self.module(file)
        return self.languages[next(iter(self.languages))] if lowered is None else self.languages[lowered.code.language]

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
