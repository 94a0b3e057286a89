# SPDX-License-Identifier: Apache-2.0
"""Why something is not known, and what a known value was computed from.

topic = self.get_parameter('topic').value   # no default: Unknown because of Reason(PARAMETER, 'topic', place)
topic = os.environ.get('TOPIC', '/scan')    # '/scan', from Origin('environment variable', 'TOPIC')
"""

from __future__ import annotations

import enum
from collections.abc import Iterable
from typing import Final

from rosward.location import Place
from rosward.records import NamedTuple
from rosward.rules import MADE_ANEW
from rosward.source.standard_library import STANDARD_LIBRARY


class Cause(enum.Enum):
    """What keeps a value from being known; the value is a phrase that completes "unknown because of"."""

    PARAMETER = "parameter without a value"
    ARGUMENT = "command-line argument"
    LAUNCH_ARGUMENT = "launch argument without a value"
    ENVIRONMENT = "environment variable"
    FILE = "content of a file"
    SHARE = "share folder of the package"
    PREFIX = "install folder of the package"
    SOURCES = "folder of the sources"
    BESIDE = "folder of a module"
    INPUT = "run-time input"
    MESSAGE = "content of a message"
    CALL = "unmodelled call"
    MODULE = "module not among the sources"
    CALLER = "argument that no caller in the sources passes"
    RANDOM = "time, randomness or host"
    ANEW = MADE_ANEW
    OPERATION = "operation on an unknown value"
    LOOP = "value that changes in a loop"
    MANY = "too many alternatives"
    LIMIT = "limit of the analysis"
    LIVE = "state of the running system"
    OTHER = "value that is not the default"
    ELEMENT = "value that is not the default, in a list"
    SET = "environment variable, where it is set"
    ERROR = "expression that fails at run time"

    __hash__ = object.__hash__  # that of `Enum` hashes the name, in Python


FOLDERS: Final = frozenset((Cause.SHARE, Cause.PREFIX, Cause.SOURCES, Cause.BESIDE))
"""Unknown folders that are known for what they are: a text that begins with one of them is a path below it."""


class Reason(NamedTuple):
    """One cause, of what (`topic`, `cv2.VideoCapture`), and where."""

    cause: Cause
    subject: str
    place: Place

    def __str__(self) -> str:
        text = f"{self.cause.value}: {self.subject}" if self.subject else self.cause.value
        return f"{text} ({self.place})" if self.place.file else text


def of_library(name: str) -> Reason:
    """Why it is not known what a library holds under a name: its module is not among the sources, unless it is one of Python itself."""
    own = name.partition(".")[0] in STANDARD_LIBRARY
    return Reason(Cause.CALL if own else Cause.MODULE, name, Place("", 0))


OUTSIDE: Final = "any that is set from outside"
"""What the parameters are said to be that nobody here sets, and anybody may set who starts the process."""
OTHERS: Final = frozenset((Cause.OTHER, Cause.ELEMENT))
"""What somebody gives who changes a default; an element of a list stands beside whatever the program itself puts there."""
INSTEAD: Final = frozenset((Cause.OTHER, Cause.SET))
"""What somebody gives where the program itself has a value otherwise: beside that, it is one instance of many."""
TAKEN_FOR_NOTHING: Final = INSTEAD | {Cause.ARGUMENT, Cause.ELEMENT}
"""What, where it alone is why something is not known, is not always told."""
_SET_BY_NAME: Final = frozenset((Cause.LAUNCH_ARGUMENT, Cause.ENVIRONMENT, Cause.SET))


def causes_of(reasons: Iterable[Reason], place: Place) -> tuple[str, ...]:
    """By what findings with these reasons are put together; `place` is where they are told.

    What is given by name from outside is one cause wherever it is asked for; all else is one at its own place, or at that where it is told.
    """
    found: set[str] = set()
    for each in reasons:
        if each.cause in _SET_BY_NAME:
            found.add(f"{each.cause.value}: {each.subject}")
        elif each.place.file or each.cause is Cause.ANEW:
            found.add(str(each))
        else:
            found.add(f"{each} ({place})")
    return tuple(sorted(found))


class Origin(NamedTuple):
    """A source outside the program that a known value was computed from.

    `kind` is 'parameter', 'argument', 'environment variable' or 'launch argument'. `settled`: in the execution that is analysed it has this
    value, so conditions on it are decided; otherwise it is a default that someone may change. `given`: someone set it (the value is bound),
    rather than leaving it at its default.
    """

    kind: str
    name: str
    settled: bool = False
    given: bool = False


COMPARED: Final = "comparison"
"""The kind of origin that says of a value that it is what a test found, whatever somebody gives the source of that name."""


def derived(reasons: tuple[Reason, ...]) -> tuple[Reason, ...]:
    """The reasons of what is computed from a value: a piece of the path of a folder, or another text made of it, is not that folder any more."""
    for reason in reasons:
        if reason.cause in FOLDERS:
            break
    else:
        return reasons
    return tuple(
        Reason(Cause.OPERATION, f"path of {reason.subject}", reason.place) if reason.cause in FOLDERS else reason
        for reason in reasons
    )


Origins = frozenset[Origin]
NO_ORIGINS: Final[Origins] = frozenset()
