# SPDX-License-Identifier: Apache-2.0
"""What all processes of an analysis share: lowered sources, library models, natives, constants.

Models are run once, in an interpreter of their own; its heap is the ground on which every process stands.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Final, NamedTuple, Protocol, final

from rosward.domain.heap import Obj
from rosward.domain.text import make
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Class, Const, External, Function, Hole, ModuleValue, Value
from rosward.engine import modules
from rosward.engine.budget import Budget, LimitReachedError
from rosward.engine.declared import MODEL_PREFIX
from rosward.engine.interpreter import Interpreter
from rosward.engine.stub_files import StubFiles
from rosward.findings import Finding
from rosward.guard import internal_error
from rosward.ir import ops
from rosward.ir.program import Module
from rosward.models.effects import EffectLog
from rosward.models.file_paths import Files
from rosward.models.native import NativeFunction
from rosward.source.location import Place

_NUMBERS: Final = (int, float)
_SMALL: Final = 1 << 60
_PROCESS_ADDRESSES: Final = 10_000_000
_MODELLED_FIRST: Final = frozenset({"rclpy", "launch", "launch_ros", "launch_xml", "launch_yaml", "nav2_common"})
"""Libraries whose models go before their sources: what they do is more than their Python says, or is asked for by name."""


class Found(NamedTuple):
    """Where a module name leads: its full dotted name, a key that identifies it, its file ('' for a folder), whether it is a model."""

    name: str
    key: str
    file: str
    model: bool = False
    guess: bool = False


class Sources(Protocol):
    """The files of the analysis, as the engine sees them."""

    @property
    def files(self) -> Files:
        """What is installed into the share folders of packages, as data."""

    def find(self, name: str, level: int, importer: str) -> Found | None:
        """The module of a name as written in the file `importer`."""

    def module(self, file: str) -> Module | None:
        """The lowered file; None where it cannot be read (a finding has said so)."""

    def interface_has(self, module: str, name: str) -> bool | None:
        """Whether `package.msg` (srv, action) has an interface of that name; None where the package is not known."""

    def belongs(self, name: str) -> bool:
        """Whether the first part of a dotted name is a package of the analysis."""

    def shared(self, file: str) -> tuple[str, str] | None:
        """The package and the path in it of a file that is installed into the package's share folder; None for any other.

        The package is '' for a launch file outside of packages; its path is then that below the folder of all sources.
        """


@final
class Library:
    """Shared by all processes; everything in it is computed at most once."""

    def __init__(
        self,
        sources: Sources,
        natives: Mapping[str, NativeFunction],
        models: tuple[Path, ...] = (),
        *,
        net: bool = True,
    ) -> None:
        self.sources = sources
        self.nowhere = ModuleValue(-1, "", "")
        self.first_address = 1
        self._natives = natives
        self._stubs = StubFiles(models, net=net)
        self._net = net
        self._constants: dict[tuple[type, object], Const] = {}
        self._found: dict[tuple[str, int, str], Found | None] = {}
        self._lowered: dict[str, Module | None] = {}
        self._models: dict[str, ModuleValue] = {}
        self._function_addresses: dict[Function, int] = {}
        self._node: Class | None = None
        self._loader = Interpreter(self, Budget(steps=200_000, seconds=3600.0), EffectLog())
        self.first_address = _PROCESS_ADDRESSES

    @property
    def findings(self) -> dict[Finding, None]:
        """What is wrong with the stub files that were asked for."""
        return self._stubs.findings

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

    def native(self, name: str) -> NativeFunction | None:
        """The model in code of a dotted name."""
        return self._natives.get(name)

    def function_address(self, function: Function) -> int:
        """Where the attributes of a function object are kept."""
        return self._function_addresses.setdefault(function, -2 - len(self._function_addresses))

    def node_class(self, _machine: object) -> Class | None:
        """The model of rclpy.node.Node."""
        if self._node is None:
            module = self.load_model(Found("rclpy.node", "rclpy.node", "", True))
            found = self.at(module.address).attrs.get("Node")
            self._node = found if isinstance(found, Class) else None
        return self._node

    def file_value(self, _machine: object, module: ModuleValue) -> Value:
        """`__file__`: of a launch file in the share folder of its package; else only the file's own name is known."""
        shared = self.sources.shared(module.file)
        if shared is not None:
            cause = Cause.SHARE if shared[0] else Cause.SOURCES
            return make((Hole((Reason(cause, shared[0], Place(module.file)),)), "/" + shared[1]))
        reason = Reason(Cause.FILE, "place of installation", Place(module.file))
        return make((Hole((reason,)), "/" + module.file.rpartition("/")[2]))

    # Modules

    def find(self, name: str, level: int, importer: ModuleValue | None) -> Found | None:
        """The module of a name as written in the module `importer`."""
        file = importer.file if importer is not None else ""
        key = (name, level, file)
        if key not in self._found:
            self._found[key] = self._look_up(name, level, importer)
        return self._found[key]

    def _look_up(self, name: str, level: int, importer: ModuleValue | None) -> Found | None:
        file = importer.file if importer is not None else ""
        if importer is not None and self.is_model_file(file):
            return self._model(_absolute(name, level, importer))
        top = name.partition(".")[0]
        found = self.sources.find(name, level, file)
        if level:
            return found
        # The client library itself is modelled, never read. Any other library that stands among the sources is read, unless it is only a
        # guess, or a folder without a file of its own: an installed package goes before that (the folder `launch` of a package, say).
        weak = found is None or found.guess or not found.file
        model = self._model(name) if weak or top in _MODELLED_FIRST else None
        if model is not None:
            return model
        return None if found is not None and found.guess and top in sys.stdlib_module_names else found

    def _model(self, name: str) -> Found | None:
        path = self._stubs.find(name)
        return None if path is None else Found(name, name, path, True)

    @staticmethod
    def is_model_file(file: str) -> bool:
        """Whether a file name is that of a model."""
        return file.startswith(MODEL_PREFIX)

    def load_model(self, found: Found) -> ModuleValue:
        """The module value of a model, run once."""
        known = self._models.get(found.name)
        if known is not None:
            return known
        loader = self._loader
        package, _, leaf = found.name.rpartition(".")
        file = found.file or self._stubs.find(found.name) or ""
        address = loader.place_key(("module", found.name))
        module = self._models[found.name] = ModuleValue(address, found.name, file)
        catchers = loader.catchers
        try:
            modules.run_module(loader, module, found.name)
        except LimitReachedError as limit:
            self._stubs.findings[
                Finding("RW201", f"This stub is read to its limit only: {limit.what}.", limit.place)
            ] = None
            loader.catchers, loader.steps = catchers, 0
        except Exception as error:
            if not self._net:
                raise
            self._stubs.findings[internal_error(error, Place(file), "this stub was read to this point only")] = None
            loader.catchers = catchers
        parent = self._model(package) if package else None
        if parent is not None:
            above = self.load_model(parent)
            loader.put(above.address, loader.at(above.address).with_attr(leaf, module))
        return module

    def module(self, file: str) -> Module | None:
        """The lowered file of a module."""
        if file not in self._lowered:
            if self.is_model_file(file):
                self._lowered[file] = self._stubs.module(file)
            else:
                self._lowered[file] = self.sources.module(file) if file else None
        return self._lowered[file]

    def interface_has(self, module: str, name: str) -> bool | None:
        """Whether an interface package has an interface of that name; None where the package is not known."""
        return self.sources.interface_has(module, name)

    def missing(self, machine: Interpreter, dotted: str) -> Value:
        """Something of a package that is not there."""
        del machine
        return External(dotted)


_NOTHING: Final = Obj("instance", Const(None))


def _absolute(name: str, level: int, importer: ModuleValue) -> str:
    """The absolute form of a relative import in a model."""
    if not level:
        return name
    parts = importer.name.split(".")
    keep = len(parts) - level + (1 if importer.file.endswith("__init__.pyi") else 0)
    return ".".join([*parts[:keep], *([name] if name else [])])
