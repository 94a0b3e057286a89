# SPDX-License-Identifier: Apache-2.0
"""What do the patterns of `match` ask of a value? Whether it is a sequence or mapping, how long it is, its attributes by position, its rest."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import External, Native, Tuple
from rosward.domain.unknown import Cause
from rosward.domain.values import FALSE, TRUE, UNBOUND, Class, Const, Ref, Unknown, Value
from rosward.engine.python import members
from rosward.models.python.containers import dicts
from rosward.models.python.contents import bare
from rosward.models.python.plain import unknown_from

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

_SEQUENCES: Final = frozenset({"list", "tuple", "deque", "Sequence", "MutableSequence", "_NamedTuple"})
_MAPPINGS: Final = frozenset({"dict", "Mapping", "MutableMapping", "_Dict"})


def ask(machine: Engine, name: str, arguments: list[Value]) -> Value | None:
    """What an intrinsic of a pattern gives; None where it is none."""
    question = _QUESTIONS.get(name)
    return None if question is None else question(machine, name, arguments)


def _is_instance(machine: Engine, _name: str, arguments: list[Value]) -> Value:
    return _answer(machine, machine.is_instance(arguments[0], arguments[1]))


def _answer(machine: Engine, answer: bool | None) -> Value:
    if answer is None:
        return machine.unknown(Cause.OPERATION, "match", "bool")
    return TRUE if answer else FALSE


def _is_kind(machine: Engine, name: str, arguments: list[Value]) -> Value:
    wanted = _SEQUENCES if name == "is_sequence" else _MAPPINGS
    answers = {_is_one(machine, option, wanted) for option in options(bare(machine, arguments[0]))}
    return _answer(machine, answers.pop() if len(answers) == 1 else None)


def _is_one(machine: Engine, value: Value, wanted: frozenset[str]) -> bool | None:
    if isinstance(value, Ref):
        obj = machine.obj(value)
        return _derives(obj.cls, wanted) if obj.kind == "instance" else obj.kind in wanted
    if isinstance(value, Tuple):
        return "tuple" in wanted
    return None if isinstance(value, Unknown) else False


def _derives(cls: Value, wanted: frozenset[str]) -> bool | None:
    """Whether a class derives from one that patterns take for a sequence (or mapping)."""
    if not isinstance(cls, Class):
        return None
    if any(isinstance(b, Class) and b.stub and b.name in wanted for b in cls.mro):
        return True
    return None if any(isinstance(b, (External, Unknown)) for b in cls.mro) else False


def _length(machine: Engine, name: str, arguments: list[Value]) -> Value:
    series, wanted = machine.series(arguments[0]), arguments[1]
    if not isinstance(wanted, Const) or not isinstance(wanted.value, int):
        return machine.unknown(Cause.OPERATION, "match", "bool")
    count = wanted.value
    if series.exact:
        return TRUE if (series.least == count if name == "length_is" else series.least >= count) else FALSE
    if name == "length_at_least" and series.least >= count:
        return TRUE
    return FALSE if name == "length_is" and series.least > count else machine.unknown(Cause.OPERATION, "match", "bool")


def _match_args(machine: Engine, _name: str, arguments: list[Value]) -> Value:
    cls = arguments[0]
    found = members.lookup(machine, cls, "__match_args__") if isinstance(cls, Class) else None
    if found is None and _derives(cls, frozenset({"_NamedTuple"})):
        found = machine.call_native("collections._keys", (cls,))
    return found if isinstance(found, Tuple) else machine.unknown(Cause.OPERATION, "match")


_ABSENT: Final = Native("match.absent")
"""What stands for the value of an attribute that is not there."""


def _attribute(machine: Engine, _name: str, arguments: list[Value]) -> Value:
    found = machine.call_native("builtins.getattr", (*arguments, _ABSENT))
    if any(
        o.__class__ is External for o in options(arguments[0])
    ):  # whether a library has such an attribute is not known
        return join_all((found, machine.unknown(Cause.OPERATION, "match")))
    return found


def _is_there(machine: Engine, _name: str, arguments: list[Value]) -> Value:
    found = options(arguments[0])
    if any(o.__class__ is Unknown for o in found) or (_ABSENT in found and len(found) > 1):
        return machine.unknown(Cause.OPERATION, "match", "bool")
    return FALSE if _ABSENT in found else TRUE


def _there(_machine: Engine, _name: str, arguments: list[Value]) -> Value:
    return join_all([o for o in options(arguments[0]) if o != _ABSENT] or [UNBOUND])


def _rest(machine: Engine, _name: str, arguments: list[Value]) -> Value:
    """A new dict of what a mapping pattern names no key of."""
    subject, keys = bare(machine, arguments[0]), arguments[1:]
    found: list[Value] = []
    for number, option in enumerate(options(subject)):
        if isinstance(option, Ref) and machine.obj(option).kind == "instance":
            option = machine.call_native("builtins.dict", (option,))  # noqa: PLW2901 - what it is a mapping of
        if isinstance(option, Ref) and machine.obj(option).kind == "dict":
            obj = machine.obj(option)
            made = machine.allocate(obj.replace(many=False, cls=Native("builtins.dict")), ("rest", number))
            for key in keys:
                dicts.take(machine, made, key)
            found.append(made)
        elif isinstance(option, Unknown):
            found.append(unknown_from(machine, "match", "dict", option))
    return join_all(found) if found else UNBOUND


_QUESTIONS: Final[dict[str, Callable[[Engine, str, list[Value]], Value]]] = {
    "isinstance": _is_instance,
    "is_sequence": _is_kind,
    "is_mapping": _is_kind,
    "length_is": _length,
    "length_at_least": _length,
    "match_args": _match_args,
    "attribute": _attribute,
    "is_there": _is_there,
    "there": _there,
    "mapping_rest": _rest,
}
