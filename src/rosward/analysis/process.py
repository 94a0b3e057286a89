# SPDX-License-Identifier: Apache-2.0
"""What runs: the processes of a set of sources, and the interpretation of each.

A process is a console script, a script with a `__main__` block, a file that does something when run, or a file with node classes that
nothing instantiates. Each of those is instantiated with unknown arguments, and its nodes are assumed: nothing is known to make them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.state import join_states
from rosward.domain.text import make
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import UNBOUND, Class, Function, Hole, ModuleValue, Unknown, Value
from rosward.effects.configuration import Configuration
from rosward.effects.entry import Entry
from rosward.effects.flows import ProcessFlows
from rosward.effects.log import EffectLog, EntityEffect, NodeEffect
from rosward.engine.arguments import ANY
from rosward.engine.budget import Budget, LimitReachedError
from rosward.engine.interpreter import Interpreter
from rosward.engine.libraries.library import Library
from rosward.engine.running.frame import Frame
from rosward.engine.sources.reads import Reads
from rosward.engine.sources.shared import Shared
from rosward.engine.unknown import assumed, handed, outside
from rosward.findings import Finding
from rosward.guard import internal_error
from rosward.ir.op import Op
from rosward.ir.program import OpKey
from rosward.location import Place
from rosward.records import NamedTuple, dataclass

if TYPE_CHECKING:
    from collections.abc import Callable

    from rosward.engine.watching.watch import Watch


@dataclass(slots=True)
class _Imported:
    """What the import of a file has made before a class of it is instantiated: that is told of the process that runs the file."""

    nodes: tuple[NodeEffect, ...] = ()
    entities: frozenset[EntityEffect] = frozenset()


class Run(NamedTuple):
    """What the interpretation of a process gave."""

    entry: Entry
    log: EffectLog
    done: frozenset[tuple[object, ...]]
    entered: frozenset[str]
    instantiated: frozenset[Place]
    reached: frozenset[OpKey]
    asked: frozenset[tuple[str, str, str]] = frozenset()
    hurried: frozenset[str] = frozenset()  # what was followed in haste, as `BeginAnewError` has it
    relied: tuple[
        tuple[object, frozenset[str]], ...
    ] = ()  # what the main body creates behind parts of that, and behind which
    hides: bool = False  # something unknown was done in haste
    reads: Reads | None = None


def follow(
    library: Library,
    entry: Entry,
    budget: Budget,
    configuration: Configuration | None,
    careful: frozenset[str] | None,
    judge: Callable[[Run], None] | None = None,
) -> Run:
    """Interpret a process to its end. `careful`: what is not to be followed in haste, as `BeginAnewError` tells it; None: nothing is.

    `judge` raises that error where the process is to be followed anew, before anything is found out of how information flows through it.
    """
    watch = _watch() if budget.flow else None
    machine = Interpreter(library, budget, EffectLog(configuration), watch, careful)
    # Nobody knows who lets a class work; programs in C++ are taken to have several threads, as containers of components may.
    machine.schedule_book.parallel = bool(entry.classes or entry.program)
    try:
        imported = _Imported()
        found = _to_its_end(machine, imported, entry, budget, configuration)
        if judge is not None:
            judge(found)
        if watch is not None:
            found.log.flows = _flows(machine, watch, entry, net=budget.net)
        found.log.leave_out(imported.nodes, imported.entities)
        return found
    finally:
        if watch is not None:
            watch.close()


def _to_its_end(
    machine: Interpreter, imported: _Imported, entry: Entry, budget: Budget, configuration: Configuration | None
) -> Run:
    log = machine.log
    try:
        if entry.program:
            _start_linked(machine, entry, configuration)
        else:
            _give_words(machine, entry, configuration)
            _main(machine, entry, imported)
    except LimitReachedError as limit:
        place = limit.place
        log.findings.add(
            Finding(
                "RW201",
                f"{limit.what}: what the program does after this is missing",
                place if place.file else Place(entry.file),
            )
        )
    except Exception as error:
        log.findings.add(_failed(entry, error, "what the program does after this is missing", net=budget.net))
    done = log.final(machine.state)
    if machine.ends is not None:
        machine.state = join_states(machine.state, machine.ends, machine.fresh_version)
    machine.frames.clear()
    machine.catchers.clear()
    try:
        if not entry.program:
            _schedule_hook(machine)
        machine.spin()
        handed.follow(machine)
        log.tell_spun()
        outside.tell(machine)
    except LimitReachedError as limit:
        log.findings.add(Finding("RW201", f"{limit.what}: some callbacks were not analysed", Place(entry.file)))
    except Exception as error:
        log.findings.add(_failed(entry, error, "some callbacks were not analysed", net=budget.net))
    return Run(
        entry,
        log,
        done,
        frozenset(machine.trace.entered),
        frozenset(machine.trace.instantiated),
        frozenset(machine.trace.reached),
        frozenset(machine.trace.asked),
        machine.precision.haste.hurried,
        tuple(machine.precision.haste.relied.items()),
        machine.precision.haste.hides,
    )


def _watch() -> Watch:
    """Who watches where flow is asked for; what most runs do not need is not loaded."""
    from rosward.engine.watching.watch import Watch

    return Watch()


def _flows(machine: Interpreter, watch: Watch, entry: Entry, *, net: bool) -> ProcessFlows:
    """What flows through the process; where that fails, nothing is known of it."""
    from rosward.flow.process import flows_of

    try:
        return flows_of(machine, watch)
    except Exception as error:
        machine.log.findings.add(_failed(entry, error, "any output may hold any input", net=net))
        return ProcessFlows(complete=False)


def _failed(entry: Entry, error: Exception, missing: str, *, net: bool) -> Finding:
    """RW299 where the program stands; without the net, the error itself."""
    if not net:
        raise error
    return internal_error(error, _reached(error) or Place(entry.file), missing)


def _reached(error: Exception) -> Place | None:
    """Where in the analysed program the interpreter was when it failed: its own frames are gone by now, those of Python tell."""
    found: Place | None = None
    step = error.__traceback__
    while step is not None:
        frame = step.tb_frame.f_locals.get("frame")
        if isinstance(frame, Frame) and not frame.stub:
            found = frame.place
        step = step.tb_next
    return found


def _start_linked(machine: Interpreter, entry: Entry, configuration: Configuration | None) -> None:
    """Of a language with a linker; what runs it is loaded where there is such a program."""
    from rosward.analysis.linked import start

    start(machine, entry, configuration)


def _give_words(machine: Interpreter, entry: Entry, configuration: Configuration | None) -> None:
    """`sys.argv`: the path of the program, as `ros2 run` starts it, then the words of its command line, or what somebody types."""
    module = machine.load_module("sys")
    if isinstance(module, ModuleValue):
        folder = Hole((Reason(Cause.FILE, "folder of the executable", Place(entry.file)),))
        name = entry.executable or entry.file.rpartition("/")[2]
        program = make((folder, f"/{name}")) if name and not entry.classes else Unknown(folder.reasons, "str")
        if configuration is not None:
            words = machine.new_list((program, *configuration.words))
        else:
            words = machine.new_list((program,), machine.unknown(Cause.ARGUMENT, "sys.argv", "str"))
        machine.put(module.address, machine.at(module.address).with_attr("argv", words))


def _schedule_hook(machine: Interpreter) -> None:
    """`sys.excepthook` of the program, if it has one, may run at its end."""
    module = machine.load_module("sys")
    if isinstance(module, ModuleValue):
        hooks = [machine.load_attr(module, name) for name in ("excepthook", "__excepthook__")]
        if hooks[0] != hooks[1]:
            machine.schedule(machine.load_attr(module, "_end"), (), "uncaught exception")


def _main(machine: Interpreter, entry: Entry, imported: _Imported) -> None:
    """The main body of a process."""
    plain = not entry.function and not entry.classes
    name = "__main__" if plain else entry.module
    address = machine.place_key(("module", "__main__" if plain else entry.file))
    module = ModuleValue(address, name, entry.file)
    language = machine.library.language_of(module)
    alive = (plain or language.run_packages(machine, module)) and machine.run_module(module, name)
    if entry.function and alive:
        function: Value = module
        for part in entry.function.split("."):
            function = language.load_attr(machine, function, part)
        machine.call(function, (), {} if _needs_nothing(function) else {ANY: UNBOUND})
    if entry.classes:
        imported.nodes, imported.entities = tuple(machine.log.nodes), frozenset(machine.log.entities)
    for qualname in entry.classes:
        found = machine.at(address).attrs.get(qualname)
        if isinstance(found, Class) and _is_node(found, machine.library):
            assumed.make(machine, found)
        elif isinstance(found, Class) and (loader := loader_of(found, machine.library)) is not None:
            _load(machine, module, found, loader)
        elif isinstance(found, Class):
            machine.trace.handed[found] = found.place  # whoever calls it from outside has it


def _needs_nothing(function: Value) -> bool:
    """Whether a function can be called as a console script does, without arguments."""
    return isinstance(function, Function) and (
        len(function.code.parameters.positional) == len(function.defaults)
        and len(function.code.parameters.kwonly) == len(function.kwdefaults)
    )


def _load(machine: Interpreter, module: ModuleValue, cls: Class, loader: str) -> None:
    """Let a library load a plugin: what its model makes stands where the class does."""
    read = machine.library.module(module.file)
    if read is None:
        return
    frame = Frame(read.code, [], (), module, 0, stub=False)
    frame.op = Op(cls.place.line, cls.place.column)
    machine.frames.append(frame)
    package, _, name = loader.rpartition(".")
    machine.call(machine.load_attr(machine.load_module(package), name), (cls,), {})
    machine.frames.pop()


def loader_of(cls: Class, library: Shared) -> str | None:
    """The function of a model that loads a class where the program does not, by its dotted name: of a plugin alone."""
    above = {base.dotted for base in cls.mro if isinstance(base, Class) and base.stub}
    return next((loader for base, loader in library.facts.plugin_classes if base in above), None)


def _is_node(cls: Class, library: Shared) -> bool:
    """Whether a class derives from one of nodes."""
    return any(node in cls.mro for node in library.node_classes)
