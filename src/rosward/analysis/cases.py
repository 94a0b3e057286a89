# SPDX-License-Identifier: Apache-2.0
"""What does a launch file start, where environment variables decide it that nobody gave?

    LDS_MODEL, compared with 'LDS-01' and 'LDS-02'    ->  it is executed for 'LDS-01', for 'LDS-02', and for any other value

One execution would take each comparison both ways, and mix what a variable decides at several places: here each execution has one value of it, as
every real one has. What all of them start is started, what only some start is conditional.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import product
from typing import Any, Final

from rosward.deployment.started import Started
from rosward.domain.unknown import Origin
from rosward.domain.values import Choice, Const, Text
from rosward.effects.shell import ORIGIN, Shell
from rosward.effects.variables import Variables, listed
from rosward.findings import Finding
from rosward.records import NamedTuple
from rosward.ros.entities import Node

__all__ = ["Executed", "in_each_case"]

MOST: Final = 16
"""So many executions; variables that would make more of them stay unknown in each."""

MOST_STARTS: Final = 1_000
"""And so many starts in all of them: a system of hundreds of nodes is executed a few times only."""

_OTHER: Final = None


class Executed(NamedTuple):
    """What one execution of a launch file gave; `unread`: arguments that nobody asked for; `known`: the names that somebody did.

    `nodes` are those that launch files in Python make themselves.
    """

    started: tuple[Started, ...]
    findings: tuple[Finding, ...]
    unread: tuple[str, ...]
    known: frozenset[str] = frozenset()
    nodes: tuple[Node, ...] = ()


Execute = Callable[[Shell, Variables], Executed]


class _Case(NamedTuple):
    """One value for each of some variables; None stands for any that they are not compared with."""

    values: tuple[tuple[str, str | None], ...]

    def shell(self, shell: Shell) -> Shell:
        """The environment of this case."""
        given = {name: _assumed(name, value) for name, value in self.values if value is not _OTHER}
        return {**shell, **given}


class _Result(NamedTuple):
    case: _Case
    executed: Executed


def in_each_case(execute: Execute, shell: Shell, asked: Variables) -> Executed:
    """What is started in an environment. `asked` learns of which variables it depends that are not given."""
    whole = execute(shell, asked)
    wanted = {name: values for name in asked.required if (values := asked.candidates(name))}
    chosen: dict[str, tuple[str, ...]] = {}
    number, most = 1, min(MOST, MOST_STARTS // max(1, len(whole.started)))
    for name, values in wanted.items():
        if number * (len(values) + 1) <= most:
            number *= len(values) + 1
            chosen[name] = values
    if not chosen:
        return whole
    results: list[_Result] = []
    for combination in product(*([*values, _OTHER] for values in chosen.values())):
        case = _Case(tuple(zip(chosen, combination, strict=True)))
        excluded = {name: frozenset(chosen[name]) for name, value in case.values if value is _OTHER}
        results.append(_Result(case, execute(case.shell(shell), Variables(excluded))))
    return Executed(
        tuple(_started(whole.started, results)),
        tuple(_findings(results)),
        tuple(name for name in whole.unread if all(name in r.executed.unread for r in results)),
        whole.known.union(*(r.executed.known for r in results)),
        whole.nodes,
    )


def _assumed(name: str, value: str) -> Const:
    return Const(value, frozenset({Origin(ORIGIN, name, settled=True)}))


def _findings(results: Sequence[_Result]) -> Iterator[Finding]:
    """What each case has to tell, with the case where it is not so in all of them."""
    cases: dict[Finding, list[_Case]] = {}
    for result in results:
        for each in dict.fromkeys(result.executed.findings):
            cases.setdefault(each, []).append(result.case)
    for each, where in cases.items():
        words = _words(where, results)
        yield each._replace(message=f"{each.message.rstrip('.')} (where {words}).") if words else each


def _words(where: Sequence[_Case], results: Sequence[_Result]) -> str:
    """The values of variables by which some cases are told from the others; '' where they are not, or are many."""
    told: list[str] = []
    for index, (name, _) in enumerate(results[0].case.values):
        every = dict.fromkeys(r.case.values[index][1] for r in results)
        own = [value for value in every if any(case.values[index][1] == value for case in where)]
        if len(own) == len(every):
            continue
        if _OTHER in own:
            rest = [value for value in every if value is not None and value not in own]
            told.append(f"{name} is not {rest[0]!r}" if len(rest) == 1 else f"{name} is none of {listed(rest)}")
        else:
            told.append(f"{name} is {' or '.join(map(repr, own))}")
    return " and ".join(told)


# What is started


def _started(whole: Iterable[Started], results: Sequence[_Result]) -> Iterator[Started]:
    """Each start, in the order of the execution in which the variables are not known; that is also asked where cases differ in the details."""
    found: dict[object, dict[_Content, list[tuple[_Case, Started]]]] = {}
    for result in results:
        turns: Counter[_Content] = Counter()
        for each in result.executed.started:
            content = _content(each)
            turns[content] += 1  # the same again is a second process
            numbered = content._replace(turn=turns[content])
            found.setdefault(_place(each), {}).setdefault(numbered, []).append((result.case, each))
    mixed: dict[object, list[Started]] = {place: [] for place in found}
    for each in whole:
        mixed.setdefault(_place(each), []).append(each)
    order = dict.fromkeys((*(_place(each) for each in whole), *found))
    for place in order:
        contents = found.get(place, {})
        if _are_apart(list(contents)) or not mixed[place]:
            yield from (_in(starts, results) for starts in contents.values())
        else:
            yield from mixed[place]


def _place(started: Started) -> object:
    return started.kind, started.place, started.event, tuple(inclusion.place for inclusion in started.trail)


class _Content(NamedTuple):
    """What one start says: who it is, and all the rest."""

    identity: tuple[object, ...]
    details: tuple[object, ...]
    turn: int = 0


def _content(started: Started) -> _Content:
    identity = (started.package, started.executable, started.plugin, started.name, started.namespace)
    configuration = started.configuration
    maps: tuple[Mapping[str, object], ...] = (configuration.files, configuration.missing, configuration.environment)
    details = (
        configuration.words,
        tuple(tuple(sorted(each.items(), key=lambda item: item[0])) for each in maps),
        started.container,
        started.remaps,
        started.settings,
        started.command,
    )
    return _Content(_bare(identity), _bare(details))


def _bare(value: Any) -> Any:
    """The same without origins: what is made of the variable in one case may be written down in another."""
    if isinstance(value, Const):
        return Const(value.value)
    if isinstance(value, Text):
        return Text(value.parts)
    if isinstance(value, Choice):
        return frozenset(map(_bare, value.options))
    return tuple(map(_bare, value)) if isinstance(value, tuple) else value


def _are_apart(contents: Sequence[_Content]) -> bool:
    """Whether the starts at one place are different programs or nodes, and not one that is started in different ways."""
    plain = all(value is None or isinstance(value, Const) for c in contents for value in c.identity)
    ways = {(c.identity, c.details) for c in contents}
    return len(ways) == 1 or (plain and len({c.identity for c in contents}) == len(ways))


def _in(starts: Sequence[tuple[_Case, Started]], results: Sequence[_Result]) -> Started:
    """A start as some cases have it: conditional, unless all have it; what they have in common, the program has in its environment."""
    started = starts[0][1]
    where = list(dict.fromkeys(case for case, _ in starts))
    words = _words(where, results)
    common = [
        (name, value)
        for index, (name, value) in enumerate(where[0].values)
        if value is not None and all(case.values[index][1] == value for case in where)
    ]
    configuration = started.configuration
    given = {name: _assumed(name, value) for name, value in common if name not in configuration.environment}
    return replace(
        started,
        conditional=len(where) < len(results) or any(each.conditional for _, each in starts),
        why=(*dict.fromkeys(why for _, each in starts for why in each.why), *([words] if words else [])),
        configuration=replace(configuration, environment={**configuration.environment, **given}),
    )
