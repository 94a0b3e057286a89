# SPDX-License-Identifier: Apache-2.0
"""What of a process is of interest once it has ended, beside its nodes? Plain records, which can be sent and kept; no value of the engine is in them.

Which code was entered, which classes there are and which of them have objects: by that, `of_classes.py` and `unreached.py` tell what no process runs.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final, NamedTuple

from rosward.analysis.process import Run, loader_of
from rosward.domain.compound import External
from rosward.domain.values import Class, Unknown, Value
from rosward.effects.log import EffectLog
from rosward.effects.variables import Variables
from rosward.engine.sources.shared import Shared
from rosward.engine.unknown.escape import name_of
from rosward.ir.program import MODEL_PREFIX, OpKey
from rosward.location import Place
from rosward.models.readers import creates_nothing
from rosward.source.standard_library import STANDARD_LIBRARY

__all__ = ["NOTED_METHODS", "AskedVariable", "ClassSeen", "Method", "Seen", "note_variables", "seen_of"]

NOTED_METHODS: Final = frozenset({"init", "step"})
"""The names of methods of which it is noted how many parameters they have: those that Webots calls."""


class ClassSeen(NamedTuple):
    """A class of the program. `bases` are the places of its bases, as far as they are classes; `outside`: the first class above it that is not known.

    `is_node`: it derives from one of nodes; `is_plugin`: from one of plugins; `from_library`: from one of a library that is not read and may
    know ROS.
    """

    place: Place
    name: str
    qualname: str
    bases: tuple[Place, ...]
    outside: str | None
    is_node: bool
    from_library: bool
    is_plugin: bool


class Method(NamedTuple):
    """A method with one of the `NOTED_METHODS` as its name: the file, its class, and how many parameters it has."""

    file: str
    owner: str
    name: str
    parameters: int


class AskedVariable(NamedTuple):
    """A variable of the environment that the program needs: where it is read, and with what it is compared.

    One that is read with a default is none: that it is compared is in the nature of options.
    """

    name: str
    places: tuple[Place, ...]
    values: tuple[str, ...]


class Seen(NamedTuple):
    """What the interpretation of one process came by; each part as `engine/running/trace.py` and `effects/log.py` have it, without code of models."""

    program: str
    entered: frozenset[str]
    instantiated: frozenset[Place]
    reached: frozenset[OpKey]
    asked: frozenset[tuple[str, str, str]]
    classes: tuple[ClassSeen, ...]
    methods: tuple[Method, ...]
    variables: tuple[AskedVariable, ...]


def seen_of(run: Run, library: Shared) -> Seen:
    """What a run came by."""
    log = run.log
    return Seen(
        run.entry.program,
        frozenset(key for key in run.entered if not key.startswith(MODEL_PREFIX)),
        run.instantiated,
        frozenset(key for key in run.reached if not key[0].startswith(MODEL_PREFIX)),
        run.asked,
        tuple(_classes(log, library)),
        tuple(
            Method(code.file, code.qualname.rpartition(".")[0], code.name, len(code.parameters.positional))
            for code in log.functions.values()
            if code.name in NOTED_METHODS
        ),
        tuple(_variables(log.variables)),
    )


def _variables(asked: Variables) -> Iterator[AskedVariable]:
    for name in asked.required:
        yield AskedVariable(name, tuple(asked.places[name]), tuple(asked.values[name]))


def note_variables(seen: Seen, asked: Variables) -> None:
    """Add the variables that a process needs to those that are asked for."""
    for variable in seen.variables:
        for place in variable.places:
            asked.compared(variable.name, variable.values, place)


class _Above(NamedTuple):
    """What is known of the classes above a class, itself included."""

    outside: Value | None
    is_node: bool
    from_library: bool
    is_plugin: bool


def _classes(log: EffectLog, library: Shared) -> Iterator[ClassSeen]:
    """The classes, each asked for what is above it once: the order of one with a single base is that of the base."""
    known: dict[Value, _Above] = {}
    for cls in log.classes:
        single = cls.bases[0] if len(cls.bases) == 1 else None
        above = known[cls] = known[single] if single in known else _above(cls, library)
        yield ClassSeen(
            cls.place,
            cls.name,
            cls.qualname,
            tuple(base.place for base in cls.bases if isinstance(base, Class)),
            None if above.outside is None else name_of(above.outside),
            above.is_node,
            above.from_library,
            above.is_plugin,
        )


def _above(cls: Class, library: Shared) -> _Above:
    outside = next((b for b in cls.mro if b.__class__ in (External, Unknown)), None)
    of_models = any(isinstance(b, Class) and b.place.file.startswith(MODEL_PREFIX) for b in cls.mro)
    return _Above(
        outside,
        # the models of nodes are not run for programs that leave no class to ask about
        of_models and any(node in cls.mro for node in library.node_classes),
        any(
            isinstance(b, External) and b.name.partition(".")[0] not in STANDARD_LIBRARY and not creates_nothing(b)
            for b in cls.mro
        ),
        of_models and loader_of(cls, library) is not None,
    )
