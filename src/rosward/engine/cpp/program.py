# SPDX-License-Identifier: Apache-2.0
"""How does a C++ program begin? Static variables get their first values, then `main` runs, or a component is made and spun."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.slots import Pointer, Slot
from rosward.domain.unknown import Cause
from rosward.domain.values import Class, Const, ModuleValue, Ref, Value
from rosward.engine.cpp import calls, names
from rosward.engine.cpp.linked import Linked, linked
from rosward.engine.cpp.names import Found, Part
from rosward.engine.cpp.thunks import evaluate
from rosward.engine.cpp.values import function_of, value_of, variable
from rosward.engine.running.frame import Frame
from rosward.ir.cpp import Invoke, InvokeMember
from rosward.ir.op import walk
from rosward.ir.program import CPP, MODEL_PREFIX, Code, CodeKind, Parameters
from rosward.models.tables import cpp_natives

if TYPE_CHECKING:
    from rosward.engine.machine import Engine
    from rosward.ir.symbols import Symbol, Symbols
    from rosward.location import Place

__all__ = ["start_component", "start_main"]

_NOTHING: Final = Parameters((), 0, None, (), None)


def start_main(machine: Engine, symbols: Symbols, words: Value, place: Place) -> bool:
    """Run a program from its static variables to the end of `main`; False where it has no `main`. `words` are those of its command line."""
    _link(machine, symbols, place)
    _first_values(machine)
    main = symbols.main
    if main is None:
        return False
    program = linked(machine)
    function = function_of(machine, main, program.namespace(machine, (), main.place.file))
    argv = Pointer(Slot(words, "item", Const(0))) if isinstance(words, Ref) else words
    calls.call_function(machine, function, (_count(machine, words), argv), {})
    return True


def _count(machine: Engine, words: Value) -> Value:
    """`argc`: how many words there are, the path of the program among them."""
    series = machine.obj(words).series() if isinstance(words, Ref) else None
    if series is not None and series.exact:
        return Const(len(series.head))
    return machine.unknown(Cause.ARGUMENT, "argc", "int")


def start_component(
    machine: Engine, symbols: Symbols, plugin: str, host: str, given: tuple[Value, ...], place: Place
) -> bool:
    """Make a component and let it work, as the function template `host` of a model does with what is given; False where there is no such class."""
    _link(machine, symbols, place)
    _first_values(machine)
    cls = _registered(machine, plugin)
    if not isinstance(cls, Class):
        return False
    calls.invoke(machine, named(machine, host), given, (cls,))
    return True


def _registered(machine: Engine, plugin: str) -> Value:
    """The class of the name under which it is registered: what that means where the macro stands, else outside of any namespace."""
    program = linked(machine)
    within = program.symbols.registered.get(plugin)
    if within is not None:
        scope, file = within
        parts = [Part(word) for word in plugin.removeprefix("::").split("::")]
        absolute = plugin.startswith("::")
        found = names.resolve(machine, program.namespace(machine, scope, file), parts, absolute=absolute)
        cls = value_of(machine, found, None) if isinstance(found, Found) else found
        if isinstance(cls, Class):
            return cls
    return named(machine, plugin)


def named(machine: Engine, written: str) -> Value:
    """The class of a qualified name."""
    program = linked(machine)
    parts = [Part(word) for word in written.removeprefix("::").split("::")]
    found = names.resolve(machine, program.namespace(machine, ()), parts, absolute=len(parts) > 1)
    return value_of(machine, found, None) if isinstance(found, Found) else found


def _link(machine: Engine, symbols: Symbols, place: Place) -> None:
    """The program belongs to the process from now on; what runs before `main` runs in a frame of its own."""
    machine.library.add_natives(cpp_natives())
    machine.linked = Linked(symbols, value_of)
    program = linked(machine)
    scope = program.namespace(machine, (), place.file)
    code = Code(
        CodeKind.FUNCTION, "", "", place.file, place.line, _NOTHING, [], 0, (), (), (), language=CPP, unit="start"
    )
    machine.frames.append(Frame(code, [], (), scope, 0, False))
    machine.language = machine.languages[CPP]


def _first_values(machine: Engine) -> None:
    """Static initialisation: what calls something may do more than give a value. Constants that call nothing, and are no objects of classes
    of the program, are computed when they are asked for."""
    program = linked(machine)
    for symbol in program.symbols.variables:
        if symbol.template or (symbol.code is None and not _may_be_object(symbol)):
            continue
        scope = symbol.scope
        env = program.namespace(machine, scope, symbol.place.file)
        if (symbol.constant or symbol.code is None) and not _calls(symbol) and not _is_object(machine, symbol, env):
            continue
        cls = _class_at(machine, scope) if scope else None
        info = program.info(cls) if cls is not None else None
        variable(machine, Found((symbol,), info.env if info is not None else env, info))

    _of_instances(machine)


def _of_instances(machine: Engine) -> None:
    """The static members of class templates that a class of the program derives from: it registers itself before `main`."""
    program = linked(machine)
    used = program.symbols.statics_used
    for symbol in program.symbols.derived if used else ():
        around = _class_at(machine, symbol.scope) if symbol.scope else None
        outer = program.info(around) if around is not None else None
        env = program.namespace(machine, symbol.scope, symbol.unit) if outer is None else outer.env
        cls = value_of(machine, Found((symbol,), env, outer), None)
        for base in cls.mro if isinstance(cls, Class) else ():
            info = program.info(base)
            if info is not None:
                found = (names.in_class(machine, info, name) for name in used.get(info.scope, ()))
                for each in filter(None, found):
                    variable(machine, each)


def _may_be_object(symbol: Symbol) -> bool:
    """Whether what is declared without a first value may be an object: `static Registrar<Mop> registrar;`."""
    names_ = symbol.pattern.names
    return bool(names_) and not symbol.pattern.pointers and names_[0] != "std"


def _calls(symbol: Symbol) -> bool:
    """Whether the first value of a constant comes of a call: `const bool registered = registry().add("mop", make);`."""
    if symbol.code is None or symbol.place.file.startswith(MODEL_PREFIX):
        return False
    return any(isinstance(op, (Invoke, InvokeMember)) for op in walk(symbol.code.ops))


def _is_object(machine: Engine, symbol: Symbol, env: ModuleValue) -> bool:
    """Whether a constant is an object whose constructor may do something: `const Registrar registrar("mop");`."""
    if symbol.type is None or symbol.place.file.startswith(MODEL_PREFIX):
        return False
    return isinstance(evaluate(machine, symbol.type, env), Class)


def _class_at(machine: Engine, scope: tuple[str, ...]) -> Value | None:
    """The class whose static member a variable is, if it is one that is no template."""
    program = linked(machine)
    if program.symbols.is_namespace(scope):
        return None
    found = names.resolve(machine, program.namespace(machine, ()), [Part(n) for n in scope if n])
    value = value_of(machine, found, None) if isinstance(found, Found) else found
    return value if isinstance(value, Class) else None
