# SPDX-License-Identifier: Apache-2.0
"""Classes: made of their symbols when they are first asked for, templates once for each list of arguments.

Box<int>, Box<int>, Box<String>      two classes
template <> struct Topic<Imu>        is chosen for Topic<Imu>, the general one for any other
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Final

from rosward.domain.compound import Tuple
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Class, Const, ModuleValue, Unknown, Value
from rosward.engine.cpp import names
from rosward.engine.cpp.linked import INSTANCES, Info, linked
from rosward.engine.cpp.patterns import type_of_pattern
from rosward.engine.cpp.specialising import meant_for
from rosward.engine.cpp.thunks import evaluate
from rosward.engine.cpp.types import flat
from rosward.ir.program import MODEL_PREFIX
from rosward.ir.symbols import Symbol, SymbolKind, TemplateParameter
from rosward.models.cpp.values.copies import ASSIGN, COPY, REFERENCES
from rosward.models.cpp.values.shared_storage import UNION

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["bind_template", "class_of", "copies", "instance_of", "is_copied"]

_DEPTH: Final = 60
_TOLD: Final = 3
"""So often a base is counted, with its bases."""
_ALIASES: Final = 8
"""How many aliases of aliases are followed."""


def class_of(machine: Engine, found: names.Found, types: tuple[Value, ...] | None) -> Value:
    """The class that a name stands for, with these template arguments."""
    symbols = [s for s in found.symbols if s.kind is SymbolKind.CLASS]
    general = [s for s in symbols if s.specialises is None]
    defined = [s for s in general if s.defined] or general
    if not defined:
        return machine.unknown(Cause.ERROR, f"class {found.symbols[0].name}")
    first = defined[0]
    if first.template is None:
        return instance_of(machine, first, found.env, (), {})
    bindings = bind_template(machine, first.template, types or (), found.env)
    given = tuple(bindings[p.name] for p in first.template)
    for symbol in sorted((s for s in symbols if s.specialises is not None and s.defined), key=_how_special):
        written = _without_defaults(machine, first, symbol, found.env, given)
        special = None if written is None else meant_for(machine, symbol, found.env, written)
        if isinstance(special, Unknown):
            return special
        if special is not None and _is_qualified(symbol):
            return machine.unknown(Cause.CALL, f"{symbol.name} of what may be constant, or a reference")
        if special is not None:
            return instance_of(machine, symbol, found.env, given, special)
    made = instance_of(machine, first, found.env, given, bindings)
    info = linked(machine).info(made)
    if info is not None and types is None:
        info.open = True
    return made


def _without_defaults(
    machine: Engine, general: Symbol, symbol: Symbol, env: ModuleValue, given: tuple[Value, ...]
) -> tuple[Value, ...] | None:
    """The arguments that a specialisation writes; the others have to be the defaults of the template: `template <> struct Topic<Imu>`."""
    parameters, count = general.template or (), len(symbol.specialises or ())
    if count >= len(given) or any(p.pack for p in parameters):
        return given
    written = given[:count]
    whole = bind_template(machine, parameters, written, env)
    return written if tuple(whole[p.name] for p in parameters) == given else None


def _is_qualified(symbol: Symbol) -> bool:
    """Whether a specialisation is for references or constants: `Box<T &>`. That is not told of types."""
    return any((p.reference or p.const) and not p.pointers for p in symbol.specialises or ())


def _how_special(symbol: Symbol) -> int:
    return len(symbol.template or ())


def bind_template(
    machine: Engine,
    parameters: Sequence[TemplateParameter],
    types: tuple[Value, ...],
    env: ModuleValue,
    deduced: dict[str, Value] | None = None,
) -> dict[str, Value]:
    """What each parameter of a template stands for: what is given, else deduced, else its default, else not known."""
    bindings: dict[str, Value] = {}
    for index, parameter in enumerate(parameters):
        if parameter.pack:
            rest = types[index:]
            known = deduced.get(parameter.name) if deduced and not rest else None
            bindings[parameter.name] = known if isinstance(known, (Tuple, Unknown)) else Tuple(rest)
        elif index < len(types):
            bindings[parameter.name] = types[index]
        elif deduced and parameter.name in deduced:
            bindings[parameter.name] = deduced[parameter.name]
        elif parameter.default is not None:
            before = tuple(bindings[p.name] for p in parameters[:index])
            bindings[parameter.name] = evaluate(machine, parameter.default, env, types=before)
        elif parameter.name:
            bindings[parameter.name] = machine.unknown(Cause.CALL, f"template argument {parameter.name}")
        else:
            bindings[parameter.name] = Const(None)
    return bindings


def _by_other_names(machine: Engine, info: Info) -> dict[str, Value]:
    """The arguments of a class template by the names that definitions of its members elsewhere give them, where each means one."""
    meant: dict[str, set[int]] = {}
    for several in linked(machine).symbols.called(info.scope) if info.symbol.specialises is None else ():
        for number, name in enumerate(several):
            meant.setdefault(name, set()).add(number)
    found = {name: info.argument(numbers.pop()) for name, numbers in meant.items() if len(numbers) == 1}
    return {name: value for name, value in found.items() if value is not None}


def instance_of(
    machine: Engine,
    symbol: Symbol,
    env: ModuleValue,
    types: tuple[Value, ...],
    bindings: dict[str, Value],
    around: dict[str, Value] | None = None,
    *,
    apart: tuple[Value, ...] = (),
) -> Value:
    """The class of a symbol in a scope, for these arguments of its template.

    `around`: what names mean that a function has which declares it; those that tell one instance from another are `apart`.
    """
    program = linked(machine)
    address = machine.place_key(("class", symbol.key, env.address, (*types, *apart)))
    known = program.infos.get(address)
    if known is not None and known.cls is not None:
        if around:
            known.around = around
        return known.cls
    if types:
        count = program.instances[symbol.key] = program.instances.get(symbol.key, 0) + 1
        if count > INSTANCES or len(machine.frames) > machine.budget.depth * 2:
            machine.report(
                "RW201", f"more than {INSTANCES} instances of the template {symbol.name}; the rest is missing"
            )
            return machine.unknown(Cause.LIMIT, f"instances of {symbol.name}")
    outer = ".".join(n for n in symbol.scope if n)
    name = f"{outer}.{symbol.name}" if outer else symbol.name
    scope = ModuleValue(address, name, symbol.place.file)
    info = program.infos[address] = Info(symbol, env, scope, symbol.inner, types, bindings)
    info.around = around or {}
    info.elsewhere = _by_other_names(machine, info) if types else {}
    program.scopes[address] = symbol.inner
    stub = symbol.place.file.startswith(MODEL_PREFIX)
    # its bases may name it (`class Unit : public Reports<Unit>`)
    info.cls = Class(address, symbol.name, symbol.name, outer, (), (), symbol.place, stub)
    found = len(program.found)
    given = tuple(bindings[p.name] for p in symbol.template or ())
    marked = _bases(machine, symbol, scope, given)
    bases = tuple(base for base, _ in marked)
    cls = Class(address, symbol.name, symbol.name, outer, bases, _order(bases), symbol.place, stub)
    info.cls = cls
    for key in list(program.found)[found:]:  # what was looked up before its bases were known
        del program.found[key]
    fields: dict[str, Symbol] = {}
    for member in symbol.members:
        if member.kind is SymbolKind.VARIABLE and not member.static:
            fields.setdefault(member.name or member.key, member)  # one of several that the preprocessor chooses from
    info.fields = tuple(fields.values())
    info.references = frozenset(f.name for f in info.fields if is_reference(machine, f, scope))
    for name, several in program.symbols.of_instances(symbol.inner).items() if types else ():
        own = [s for s in several if _is_for(machine, s, env, types)]
        if own:
            info.special[name] = own
    inherited = [i for b in cls.mro[1:] if (i := program.info(b)) is not None]
    above = [v for b in bases if (i := program.info(b)) is not None for v in i.virtual]
    info.virtual = tuple(dict.fromkeys((*above, *(base for base, virtual in marked if virtual))))
    taken = {key for i in inherited for key in i.keys.values()}
    for i in reversed(inherited):
        info.keys.update(i.keys)
    if inherited:
        info.hidden = _repeated(f.name for i in (info, *inherited) for f in i.fields)
    if len(inherited) > 1:
        info.clashing = _repeated(i.keys[f.name] for i in inherited for f in i.fields)
        info.doubled = _doubled(machine, info, bases, inherited)
        program.clashes = program.clashes or bool(info.clashing)
    info.shares = any(f.overlaps for f in info.fields) or any(i.shares for i in inherited)
    info.keys.update((f.name, f"{f.name} of {name}" if f.name in taken else f.name) for f in info.fields)
    program.buffers.update((address, info.keys[f.name]) for f in info.fields if is_text_array(f))
    for base in cls.mro[1:] if program.buffers else ():
        program.buffers |= {
            (address, key) for key in info.keys.values() if (getattr(base, "address", None), key) in program.buffers
        }
    if machine.own(address) is None:
        machine.put(address, Obj("class", cls, _rules(machine, info, cls)))
    if not stub:
        machine.log.defined(cls)
    return cls


def is_text_array(symbol: Symbol) -> bool:
    """Whether a variable is declared as `char x[n]`, of which the characters may change."""
    pattern = symbol.pattern
    return (
        pattern.array
        and pattern.builtin == "char"
        and pattern.pointers == 1
        and not symbol.constant
        and not symbol.reference
    )


def is_reference(machine: Engine, symbol: Symbol, env: ModuleValue, depth: int = 0) -> bool:
    """Whether a variable, or an alias, is a reference by its type, or by what this is an alias of."""
    if symbol.reference or depth > _ALIASES:
        return symbol.reference
    pattern = symbol.pattern
    if len(pattern.names) != 1 or pattern.pointers:
        return False
    found = names.unqualified(machine, ModuleValue(env.address, env.name, symbol.place.file), pattern.names[0])
    first = found.symbols[0] if isinstance(found, names.Found) else None
    if first is None or first.kind is not SymbolKind.ALIAS or not isinstance(found, names.Found):
        return False
    return is_reference(machine, first, found.env, depth + 1)


def _repeated(names_: Iterable[str]) -> frozenset[str]:
    """Those that are there several times."""
    counted = Counter(names_)
    return frozenset(name for name, count in counted.items() if count > 1)


def _doubled(machine: Engine, info: Info, bases: tuple[Value, ...], inherited: list[Info]) -> frozenset[str]:
    """The fields of a base that is there several times, since it is no virtual one, nor a base of one: of these an object has several."""
    counted: Counter[Class] = Counter()
    waiting = [*bases]
    while waiting:
        cls = waiting.pop()
        if isinstance(cls, Class) and not (cls in info.virtual and counted[cls]):
            counted[cls] += 1
            waiting += cls.bases if counted[cls] < _TOLD else ()
    twice = [i for cls, count in counted.items() if count > 1 and (i := linked(machine).info(cls)) is not None]
    return frozenset(key for i in (*inherited, *twice) for key in (i.doubled if i not in twice else i.keys.values()))


def _is_for(machine: Engine, symbol: Symbol, env: ModuleValue, types: tuple[Value, ...]) -> bool:
    """Whether a member is one of the instance with these arguments."""
    env = ModuleValue(env.address, env.name, symbol.place.file)
    return tuple(type_of_pattern(machine, env, pattern) for pattern in symbol.instance) == flat(types)


def _rules(machine: Engine, info: Info, cls: Class) -> dict[str, Value]:
    """What copies of objects have to know of the class."""
    symbol = info.symbol
    rules: dict[str, Value] = {}
    references = tuple(Const(info.keys[f.name]) for f in info.fields if f.name in info.references)
    if references:
        rules[REFERENCES] = Tuple(references)
    shared = tuple(Const(info.keys[f.name]) for f in info.fields if f.overlaps)
    if shared:
        rules[UNION] = Tuple(shared)
    if "node_class" in symbol.marks or "unique" in symbol.marks:
        rules[COPY] = NONE
    elif copies(machine, info) or any(is_copied(machine, base) for base in cls.bases):
        rules[COPY] = cls
    assigning = _assigning(machine, info)
    if assigning != NONE:
        rules[ASSIGN] = Tuple((assigning, Tuple(tuple(map(Const, info.keys.values())))))
    return rules


def _assigning(machine: Engine, info: Info) -> Value:
    """The functions by which a class says itself how an object of it is assigned to another; NONE where it has none."""
    program = linked(machine)
    found = [s for s in program.members(info, "operator=") if _takes_itself(info, s)]
    return program.value_of(machine, names.Found(tuple(found), info.env, info), ()) if found else NONE


def _takes_itself(info: Info, symbol: Symbol) -> bool:
    first = symbol.parameters[0].type if symbol.kind is SymbolKind.FUNCTION and len(symbol.parameters) == 1 else None
    return first is not None and first.names[-1:] == (info.symbol.name,) and "default" not in symbol.marks


def is_copied(machine: Engine, base: Value) -> bool:
    """Whether a class says how it, or a base of it, is copied."""
    obj = machine.own(base.address) if isinstance(base, Class) else None
    return obj is not None and obj.attrs.get(COPY, NONE) != NONE


def copies(machine: Engine, info: Info) -> bool:
    """Whether a class says itself how it is copied: `Label(const Label & other) : text_(other.text_ + "_copy") {}`.

    Or moved, where it cannot be copied otherwise: whether an argument is one that may be moved from is not known.
    """
    found = dict(_of_itself(machine, info))
    return found["&"] if "&" in found else found.get("&&", False)


def _of_itself(machine: Engine, info: Info) -> Iterator[tuple[str, bool]]:
    """The constructors that take an object of the class: by which reference, and whether somebody has written the body."""
    name = info.symbol.name
    for symbol in linked(machine).members(info, name):
        first = symbol.parameters[0].type if symbol.kind is SymbolKind.FUNCTION and symbol.parameters else None
        if first is None or first.names[-1:] != (name,) or first.reference not in ("&", "&&"):
            continue
        if all(p.default for p in symbol.parameters[1:]):
            yield first.reference, symbol.defined and "default" not in symbol.marks


def _bases(machine: Engine, symbol: Symbol, scope: ModuleValue, types: tuple[Value, ...]) -> list[tuple[Value, bool]]:
    """The bases of a class, and which of them are virtual."""
    found: list[tuple[Value, bool]] = []
    for base in symbol.bases:
        value = evaluate(machine, base.type, scope, types=types)
        found += [(each, base.virtual) for each in (value.items if isinstance(value, Tuple) else (value,))]
    return found


def _order(bases: Sequence[Value]) -> tuple[Value, ...]:
    """Depth first: the first base, its bases, the next one; each once."""
    order: dict[Value, None] = {}
    for base in bases:
        order |= dict.fromkeys(base.mro if isinstance(base, Class) else (base,))
    return tuple(b for b in order if not isinstance(b, Unknown) or len(order) < _DEPTH)
