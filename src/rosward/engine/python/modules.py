# SPDX-License-Identifier: Apache-2.0
"""Modules: importing them, their variables, and the builtins behind them.

A module is a source file of the analysis, else a model (a stub file), else external: known by its dotted name only.
"""

from __future__ import annotations

import builtins
from typing import TYPE_CHECKING, Final

from rosward.domain.certain import text_of
from rosward.domain.choice import join_all, options
from rosward.domain.compound import External, Native, Tuple
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause
from rosward.domain.values import UNBOUND, Const, ModuleValue, Ref, Unknown, Value
from rosward.engine.calls.alternatives import each_apart
from rosward.engine.python import import_path
from rosward.engine.python.relative_imports import Relative, main_package, relative
from rosward.engine.running.frame import Frame
from rosward.engine.sources.found import FoundModule
from rosward.engine.throwing import note_import
from rosward.ir import ops
from rosward.models.failures import fail

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

_STARS: Final = "*"
"""The variable of a module that lists the external modules of which it took everything."""


def import_module(machine: Engine, op: ops.Import, frame: Frame) -> Value:
    """import a.b.c [as d]."""
    leaf = load_asked(machine, op.module, frame)
    if leaf is UNBOUND or op.leaf or "." not in op.module:
        return leaf
    return load(machine, op.module.partition(".")[0], frame)


def load_asked(machine: Engine, name: str, frame: Frame | None, level: int = 0) -> Value:
    """The module of a name that the program asks for; a handler of ImportError may be reached where it may not be there."""
    module = load(machine, name, frame, level)
    if module is not UNBOUND and not _surely_there(machine, module):
        note_import(machine)
    return module


def import_from(machine: Engine, op: ops.ImportFrom, frame: Frame) -> Value:
    """from a.b import c."""
    module = load(machine, op.module, frame, op.level)
    if module is UNBOUND:
        return UNBOUND
    if module.__class__ is not ModuleValue:
        note_import(machine)
        return machine.load_attr(module, op.name)
    value = attribute(machine, module, op.name, importing=True)
    defined = machine.at(module.address).attrs.get(op.name, UNBOUND) is not UNBOUND
    if _surely_there(machine, module) and (defined or value.__class__ is ModuleValue):
        return value
    if value.__class__ is External:
        machine.library.expect(frame.module, module, op.name, value)
    note_import(machine)
    if machine.catchers and _surely_there(machine, module) and value.__class__ is Unknown:
        machine.throw(Native("builtins.ImportError"))
        return UNBOUND
    return value


def _surely_there(machine: Engine, module: Value) -> bool:
    """Whether the import of a module cannot fail: it is among the sources. What is modelled may be of another version."""
    return module.__class__ is ModuleValue and not machine.library.is_model_file(module.file)


def import_star(machine: Engine, op: ops.ImportStar, frame: Frame) -> bool:
    """from a.b import *; False where no execution goes on."""
    module = load(machine, op.module, frame, op.level)
    if module is UNBOUND:
        return False
    if not _surely_there(machine, module):
        note_import(machine)
    here = machine.at(frame.module.address)
    if module.__class__ is not ModuleValue:
        stars = here.attrs.get(_STARS, Tuple(()))
        assert isinstance(stars, Tuple)
        machine.put(frame.module.address, here.with_attr(_STARS, Tuple((*stars.items, module))))
        return True
    names, more = _exported(machine, module)
    taken = {n: attribute(machine, module, n) for n in names}
    for name in more:
        _import_perhaps(machine, module, name, frame.module)
    record = machine.at(module.address)
    here = machine.at(frame.module.address)
    attrs = {**here.attrs, **taken}
    theirs = record.attrs.get(_STARS)
    further = (*(theirs.items if isinstance(theirs, Tuple) else ()), *_also_beyond(machine, module))
    if further:
        before = here.attrs.get(_STARS)
        attrs[_STARS] = Tuple((*(before.items if isinstance(before, Tuple) else ()), *further))
    machine.put(frame.module.address, here.replace(attrs=attrs))
    return True


def _exported(machine: Engine, module: ModuleValue) -> tuple[list[str], list[str]]:
    """The names that `import *` takes of a module, and those of modules in it that `__all__` may have, too.

    Where `__all__` is not wholly known, each public name counts as one of it.
    """
    attrs = machine.at(module.address).attrs
    public = [n for n in attrs if not n.startswith("_") and n != _STARS]
    listed = attrs.get("__all__")
    if listed is None:
        return public, []
    known, rest = machine.iterate(listed)
    sure = [text_of(k) for k in known]
    if rest is None and all(sure):
        return sure, []
    meant = [text_of(option) for value in (*known, rest) if value is not None for option in options(value)]
    if not all(meant) and _may_load_more(machine, module):
        machine.report("RW203", f"which modules of {module.name} a star import loads is not known: __all__ is not")
    return list(dict.fromkeys([*public, *filter(None, sure)])), [
        n for n in dict.fromkeys(meant) if n and n not in attrs
    ]


def _may_load_more(machine: Engine, module: ModuleValue) -> bool:
    """Whether there are modules in a package that have not been imported."""
    if not module.file.endswith("__init__.py"):
        return False
    inside = machine.call_native("pkgutil._modules", machine.iterate(_path_of(machine, module)).known)
    names = {
        text_of(pair.items[0])
        for pair in (inside.items if isinstance(inside, Tuple) else ())
        if isinstance(pair, Tuple)
    }
    return bool(names - machine.at(module.address).attrs.keys())


def _import_perhaps(machine: Engine, package: ModuleValue, name: str, importer: ModuleValue) -> None:
    """Import a module of a package, and give it its name in the one that asks; or not."""

    def way(imported: bool) -> Value:
        found = attribute(machine, package, name, importing=True) if imported else Const(None)
        if found.__class__ is ModuleValue:
            store_global(machine, importer, name, found)
        return found

    each_apart(machine, (True, False), way)


def _also_beyond(machine: Engine, module: ModuleValue) -> tuple[Value, ...]:
    """The module itself where it is a model: the library has more names than that says."""
    return (module,) if machine.library.is_model_file(module.file) else ()


def load(machine: Engine, name: str, frame: Frame | None, level: int = 0) -> Value:
    """The module of a name as written in `frame`, run if it has not been; UNBOUND where no execution goes on."""
    return load_for(machine, name, frame.module if frame is not None else None, level)


def load_for(machine: Engine, name: str, importer: ModuleValue | None, level: int = 0) -> Value:
    """The module of a name as written in the module `importer`; the packages around it are run first."""
    for_models = level == 0 and name.startswith("_rosward")
    if for_models and (importer is None or machine.library.is_model_file(importer.file)):
        return External(name)
    meant = Relative(name)
    if level and importer is not None and not machine.library.is_model_file(importer.file):
        meant = relative(machine, importer, name, level)
        if meant.refused and not meant.may:
            return fail(
                machine, Native("builtins.ImportError"), f"ImportError: {meant.refused}", (Const(meant.refused),)
            )
        if meant.may:
            note_import(machine)
        if importer.name == "__main__" and machine.library.find(meant.name, 0, importer) is not None:
            name, level = meant.name, 0
    own = not level and (importer is None or not machine.library.is_model_file(importer.file))
    if own and (given := import_path.registered(machine, name)) is not None:
        return given
    found = machine.library.find(name, level, importer)
    if not own:
        return _load_found(machine, meant, name, importer, level, found)
    ways = import_path.on_path(machine, name, importer, found)
    return each_apart(machine, ways, lambda way: _load_found(machine, meant, name, importer, level, way))


def _load_found(
    machine: Engine, meant: Relative, name: str, importer: ModuleValue | None, level: int, found: FoundModule | None
) -> Value:
    """The module that an import of a name leads to."""
    if found is None and not level and name.startswith("_rosward"):  # a program's own, and not among the sources
        return machine.unknown(Cause.MODULE, name)
    if found is None and not level and machine.own(space := machine.place_key(("module", name))) is not None:
        return ModuleValue(space, name, "")
    if found is None:
        ours = machine.library.sources.belongs(name) if not level else name and not machine.catchers
        if ours and not _is_interface_module(name):
            missing = f"{'.' * level}{name}"
            machine.report("RW207", f"{missing} is not among the sources", (f"module {missing}",))
        return External(name or "." * level)
    if found.model:
        return machine.library.load_model(found)
    whole = meant.name if level and meant.name else found.name
    parts = whole.split(".")
    parent: Value | None = None
    if len(parts) > 1 and whole == meant.name:
        above = name.rpartition(".")[0] if name else ""
        parent = load_for(machine, above, importer, level if name or not level else level + 1)
        if parent is UNBOUND:
            return UNBOUND
        if parent.__class__ is External and not found.guess:  # a namespace package of folders alone
            parent = ModuleValue(machine.place_key(("module", above)), ".".join(parts[:-1]), "")
            machine.run_module(parent, parent.name)
    address = machine.place_key(("module", found.key))
    if machine.own(address) is not None:
        address = import_path.imported(machine, whole, found, address)
    module = ModuleValue(address, whole, found.file)
    if machine.own(address) is None:
        if not machine.run_module(module, whole):
            return UNBOUND
        given = None if level else import_path.registered(machine, whole)
        if given is not None:
            return given
    if parent.__class__ is ModuleValue and parent != module:
        record = machine.at(parent.address)
        if record.attrs.get(parts[-1]) != module:
            machine.put(parent.address, record.with_attr(parts[-1], module))
    return module


def run_packages(machine: Engine, module: ModuleValue) -> bool:
    """Run the packages around a module that an entry point names, from the outermost; False where one does not come to its end."""
    parts = module.name.split(".")
    for number in range(1, len(parts)):
        name = ".".join(parts[:number])
        found = machine.library.find(name, 0, module)
        if found is None or found.model or not found.file:
            continue
        address = machine.place_key(("module", found.key))
        package = ModuleValue(address, name, found.file)
        if machine.own(address) is None and not machine.run_module(package, name):
            return False
    return True


def _is_interface_module(name: str) -> bool:
    """Whether a module name is that of generated interfaces: `package.msg`, `package.srv.…`."""
    parts = name.split(".")
    return len(parts) > 1 and parts[1] in ("msg", "srv", "action")


def run_module(machine: Engine, module: ModuleValue, name: str, turn: int = 0) -> bool:
    """Run the top level of a module; False where it does not come to its end. `turn` tells apart that a file is run again."""
    package = name if module.file.endswith(("__init__.py", "__init__.pyi")) else name.rpartition(".")[0]
    attrs: dict[str, Value] = {
        "__name__": Const(name),
        "__file__": machine.library.file_value(module),
        "__package__": join_all(main_package(machine, module.file)) if name == "__main__" else Const(package),
        "__doc__": machine.unknown(Cause.OPERATION, "doc", "str"),
    }
    lowered = machine.library.module(module.file)
    if lowered is not None:
        attrs["__doc__"] = Const(lowered.code.doc)
    machine.put(module.address, Obj("module", Native("builtins.module"), attrs=attrs))
    ours = not machine.library.is_model_file(module.file)
    if ours:
        import_path.register(machine, name, module)
    if lowered is None:
        return True
    code = lowered.code
    context = machine.context("module", module.file, turn)
    frame = Frame(code, [UNBOUND] * code.registers, (), module, context, not ours)
    frame.cells = tuple(machine.new_cells(code, context))
    frames, machine.frames = machine.frames, [frame]
    machine.trace.entered.add(code.key)
    try:
        return machine.run(code.ops, frame)
    finally:
        machine.frames = frames


def attribute(machine: Engine, module: ModuleValue, name: str, *, importing: bool = False) -> Value:
    """module.name."""
    record = machine.at(module.address)
    found = record.attrs.get(name)
    if found is not None and found is not UNBOUND:
        return found
    if name == "__path__" and module.file.endswith("__init__.py"):
        return _path_of(machine, module)
    dotted = f"{module.name}.{name}"
    importer = module if module.file or not machine.frames else machine.frames[-1].module
    if machine.library.find(dotted, 0, importer) is not None or (module.file.endswith("__init__.py") and importing):
        sub = load_below(machine, module, name)
        if sub is not None:
            return sub
    if machine.library.native(dotted):
        return Native(dotted)
    if machine.library.is_model_file(module.file):
        return External(dotted)
    star = _from_stars(machine, record, name)
    if star is not None:
        return star
    fallback = record.attrs.get("__getattr__")
    if fallback is not None:
        return machine.call(fallback, (Const(name),))
    if not module.file:
        return machine.library.missing(dotted)
    return machine.unknown(Cause.ERROR, f"no name {name} in {module.file}")


def _path_of(machine: Engine, package: ModuleValue) -> Value:
    """`__path__` of a package: a list with its folder."""
    folder = machine.call_native("os.path.dirname", (machine.load_attr(package, "__file__"),))
    made = Ref(machine.place_at(("path", package.address), Obj("list", Native("builtins.list"), items=(folder,))))
    machine.put(package.address, machine.at(package.address).with_attr("__path__", made))
    return made


def load_below(machine: Engine, module: ModuleValue, name: str) -> Value | None:
    """The submodule of a package, if there is one."""
    found = machine.library.find(name, 1, module) if not machine.library.is_model_file(module.file) else None
    if found is None:
        importer = module if module.file or not machine.frames else machine.frames[-1].module
        found = machine.library.find(f"{module.name}.{name}", 0, importer)
    if found is None:
        return None
    if found.model:
        return machine.library.load_model(found)
    address = machine.place_key(("module", found.key))
    value = ModuleValue(address, f"{module.name}.{name}", found.file)
    if machine.own(address) is None and not machine.run_module(value, value.name):
        return UNBOUND
    return value


def _from_stars(machine: Engine, record: Obj, name: str, *, sure: bool = False) -> Value | None:
    """A name that came by `from package import *` from an external module; where `sure`, only from one that is known to have it."""
    stars = record.attrs.get(_STARS)
    if not isinstance(stars, Tuple) or not stars.items or name.startswith("_"):
        return None
    models = [m.name for m in stars.items if m.__class__ is ModuleValue]
    found = next((f"{m}.{name}" for m in models[::-1] if machine.library.native(f"{m}.{name}")), None)
    if found is not None:
        return Native(found)
    modules = [m.name for m in stars.items if isinstance(m, External)]
    knowing = [m for m in modules if machine.library.interface_has(m, name)]
    open_ = [*(m for m in modules if machine.library.interface_has(m, name) is None), *models]
    if knowing:
        return External(f"{knowing[0]}.{name}")
    if sure:
        return None
    if len(open_) == 1:
        return External(f"{open_[0]}.{name}")
    if open_:
        return machine.unknown(Cause.MODULE, f"{' or '.join(open_)}: {name}")
    return None


def load_global(machine: Engine, module: ModuleValue, name: str, *, quiet: bool = False) -> Value:
    """A name that is not (or not yet) a variable of the module: from a star import, or a builtin."""
    builtin = hasattr(builtins, name)
    star = _from_stars(machine, machine.at(module.address), name, sure=builtin)
    if star is not None:
        return star
    if name == "__builtins__":
        return machine.unknown(Cause.LIVE, name)
    if name == "__path__" and module.file.endswith("__init__.py"):
        return _path_of(machine, module)
    if builtin or machine.library.native(f"builtins.{name}"):
        return Native(f"builtins.{name}")
    if quiet:
        return machine.unknown(Cause.ERROR, name)
    return machine.unknown(Cause.ERROR, f"name {name} is not defined")


def load_quietly(machine: Engine, module: ModuleValue, name: str) -> Value:
    """A name in an annotation of a model, which need not be defined."""
    return load_global(machine, module, name, quiet=True)


def store_global(machine: Engine, module: ModuleValue, name: str, value: Value) -> None:
    """Assign a variable of a module."""
    record = machine.at(module.address)
    if record.attrs.get(name) is not value or machine.summaries.epoch:  # as in `assignment.keep`
        machine.update(Ref(module.address), record.with_attr(name, value))
