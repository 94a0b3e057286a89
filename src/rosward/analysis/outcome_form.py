# SPDX-License-Identifier: Apache-2.0
"""The form in which what a process adds is sent and kept: each record with its fields in their order, as in `cache/records.py`."""

from __future__ import annotations

from typing import Final, NamedTuple

from rosward.analysis.outcome import Outcome, Task
from rosward.analysis.seen import AskedVariable, ClassSeen, Method, Seen
from rosward.cache.codec import (
    FLAG,
    LINES,
    NUMBER,
    TEXT,
    Codec,
    Json,
    MalformedError,
    mapping,
    maybe,
    pair,
    record,
    sequence,
    several,
    triple,
)
from rosward.cache.records import FINDINGS, NODES, PLACE, PLACES
from rosward.domain.compound import Range, Slice, Tuple
from rosward.domain.unknown import Origin, Reason
from rosward.domain.values import Choice, Hole, Text, Unknown
from rosward.effects.configuration import Configuration, Given
from rosward.effects.entry import Entry
from rosward.engine.libraries.written import NotWrittenError, Reader, Writer
from rosward.engine.sources.reads import Question
from rosward.findings import Finding
from rosward.location import Place

__all__ = ["ANSWER", "ENTRY", "OUTCOME", "QUESTIONS", "SEEN", "TASK", "Answer", "configuration_form"]

ENTRY: Final = record(
    Entry, TEXT, TEXT, TEXT, LINES, maybe(TEXT), maybe(TEXT), TEXT, FLAG, FLAG, TEXT, TEXT
)  # file, module, function, classes, package, executable, label, probe, assumed, program, host

_OF_CONFIGURATION: Final = frozenset({Choice, Given, Hole, Origin, Place, Range, Reason, Slice, Text, Tuple, Unknown})
"""What a command line and parameters are made of beside constants. Of anything else, what stands there is not all that it is."""


def configuration_form(configuration: Configuration | None) -> str | None:
    """How a process is started, in one line: the same for the same. Raises NotWrittenError where that cannot be said."""
    if configuration is None:
        return None
    parts = [getattr(configuration, name) for name in Configuration.__match_args__]
    writer = Writer(_OF_CONFIGURATION)
    try:
        writer.line(parts)
    except (ValueError, RecursionError) as error:  # a number of thousands of digits, say
        raise NotWrittenError from error
    return writer.lines[0].decode("ascii")


def _read_configuration(line: Json) -> Configuration | None:
    return None if line is None else Configuration(*Reader([TEXT.read(line).encode("ascii")]).line(0))


TASK: Final = record(Task, ENTRY, Codec(configuration_form, _read_configuration))
"""Written for a worker only, and read by one: nobody else can have written it."""

CLASS: Final = record(ClassSeen, PLACE, TEXT, TEXT, PLACES, maybe(TEXT), FLAG, FLAG, FLAG)
METHOD: Final = record(Method, TEXT, TEXT, TEXT, NUMBER)
VARIABLE: Final = record(AskedVariable, TEXT, PLACES, LINES)
SEEN: Final = record(
    Seen,
    TEXT,  # program
    several(TEXT),  # entered
    several(PLACE),  # instantiated
    several(pair(TEXT, NUMBER)),  # reached
    several(triple(TEXT, TEXT, TEXT)),  # asked
    sequence(CLASS),
    sequence(METHOD),
    sequence(VARIABLE),
)
OUTCOME: Final = record(Outcome, NODES, FINDINGS, FLAG, SEEN)


def _read_question(value: Json) -> Question:
    if value.__class__ is not list or not value or any(each.__class__ not in (str, int) for each in value):
        raise MalformedError
    return tuple(value)


QUESTIONS: Final = sequence(Codec(list, _read_question))


class Answer(NamedTuple):
    """What a worker answers: what a process adds and what it asked, and what the worker has read of the sources that nobody had read before.

    `python`, `cpp`: files with the number of their lines; `findings` are of the sources, `stubs` of the library. `looks`: what it saw of the disk.
    """

    outcome: Outcome
    questions: tuple[Question, ...]
    python: dict[str, int]
    cpp: dict[str, int]
    findings: tuple[Finding, ...]
    stubs: tuple[Finding, ...]
    looks: dict[str, dict[str, str]]


ANSWER: Final = record(
    Answer, OUTCOME, QUESTIONS, mapping(NUMBER), mapping(NUMBER), FINDINGS, FINDINGS, mapping(mapping(TEXT))
)
