# SPDX-License-Identifier: Apache-2.0
"""What do marks say of how information flows through a function of a library? Those of a stub, and those of a header, come to the same.

@sink("network")                 [[rosward::sink("network")]]      what it gets leaves ROS
@source("file")                  [[rosward::source("file")]]       what it gives comes from outside
@pure                            [[rosward::pure]]                 it only computes: it keeps nothing, and writes to nothing that it gets
@changes("out")                  [[rosward::changes]]              it writes to what it gets
@stops, @stops("timer")          [[rosward::stops]]                what it is called on, or gets, runs no more, or again
@releases("why")                 [[rosward::releases("why")]]      what it gives tells nothing of what it gets
@hands("lib.Link")                                                 what it is given to call is called with this: `Link` of `lib`
                                 [[rosward::holds]]                what it makes, or is called on, holds all that it gets
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Final, NamedTuple

SINKS: Final = ("code", "device", "file", "log", "network", "pickle", "process", "stdout", "tf")
"""Where something may go; `code` and `pickle`: it decides what is executed."""
SOURCES: Final = ("argv", "clock", "device", "env", "file", "network", "process", "random", "stdin", "tf")
"""Where something may come from."""
MARKS: Final = ("sink", "source", "pure", "changes", "stops", "releases", "holds", "hands")
_KINDS: Final = {"sink": SINKS, "source": SOURCES}


class FlowMark(NamedTuple):
    """All marks of one function. `stops` and `changes` are its parameters; `self` is what it is called on, `*` any of them.

    `parameters`: those that are given by their places, where `changes` names some.
    `hands`: the classes of the arguments with which it calls what it is given, by their dotted names.
    `attribute`: it is a property: to read it is to call it.
    """

    sinks: tuple[str, ...] = ()
    sources: tuple[str, ...] = ()
    pure: bool = False
    releases: bool = False
    holds: bool = False
    stops: tuple[str, ...] = ()
    changes: tuple[str, ...] = ()
    hands: tuple[str, ...] = ()
    attribute: bool = False
    parameters: tuple[str, ...] = ()

    @property
    def is_known(self) -> bool:
        """Whether it is said what becomes of what the function gets: it keeps none of it."""
        return self.pure or self.releases or bool(self.sinks or self.sources)


NO_MARK: Final = FlowMark()


def mark_of(said: Mapping[str, tuple[str, ...]]) -> FlowMark | None:
    """The marks of a function, by their names, with their words; None where none of them is about flow."""
    if said.keys().isdisjoint(MARKS):
        return None
    return FlowMark(
        said.get("sink", ()),
        said.get("source", ()),
        "pure" in said,
        "releases" in said,
        "holds" in said,
        said["stops"] or ("self",) if "stops" in said else (),
        said["changes"] or ("*",) if "changes" in said else (),
        said.get("hands", ()),
    )


def wrong(mark: str, words: Iterable[str | None], parameters: Iterable[str] | None = None) -> Iterator[str]:
    """What is wrong with one mark: None stands for a word that is no text; `parameters` are those of its function, if it stands on one."""
    given = list(words)
    if None in given:
        yield f"{mark} takes words in quotes"
        return
    kinds = _KINDS.get(mark)
    if kinds is not None:
        if not given:
            yield f"{mark} names no kind; kinds are {', '.join(kinds)}"
        for word in given:
            if word not in kinds:
                yield f"{word!r} is no kind of {mark}; kinds are {', '.join(kinds)}"
    elif mark in ("stops", "changes"):
        if parameters is None:
            yield f"{mark} marks a function"
        known = set(parameters or ())
        for word in given if parameters is not None else ():
            if word not in known:
                yield f"{mark} names {word!r}, which is no parameter"
    elif mark == "hands" and not all(word and word.replace(".", "_").isidentifier() for word in given):
        yield "hands takes dotted names of classes"
    elif mark == "releases" and (len(given) != 1 or not given[0]):
        yield "releases says in one text why nothing of what it gets can be told from what it gives"
