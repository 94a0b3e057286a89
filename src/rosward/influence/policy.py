# SPDX-License-Identifier: Apache-2.0
"""The rules of a project about its flows, as rosward.toml has them.

    [[flow.rule]]                              [[flow.rule]]                          [[flow.release]]
    name = "pictures stay on the robot"        name = "only planning drives"          through = ["/camera/blurred"]
    from = ["/camera/**"]                      to = ["/cmd_vel"]                      of = ["/camera/**"]
    not-to = ["network", "file"]               only-from = ["/plan", "/odom"]         because = "faces are blurred"

`by` is the weakest strength that counts: `data` (where it is not said), `control` or `trigger`.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from rosward.influence.select import KINDS, Selection
from rosward.records import NamedTuple
from rosward.ros.flows import STRENGTHS

_MOST: Final = 1_000
"""So many rules and words there may be."""


class PolicyError(Exception):
    """A rule that nobody can follow; the message says why."""


class Rule(NamedTuple):
    """What must not reach what (`sources`, `not_to`), or what alone may reach something (`to`, `only_from`)."""

    name: str
    sources: tuple[Selection, ...] = ()
    not_to: tuple[Selection, ...] = ()
    to: tuple[Selection, ...] = ()
    only_from: tuple[Selection, ...] = ()
    by: str = "data"


class Release(NamedTuple):
    """What passes `through` is no longer `of` the sources: a function gives a clean result, a topic or a node passes clean content on."""

    through: tuple[Selection, ...]
    of: tuple[Selection, ...]
    because: str

    @property
    def functions(self) -> tuple[str, ...]:
        """The functions among the words of `through`, by their dotted names."""
        return tuple(s.word for s in self.through if is_function(s.word))


class Policy(NamedTuple):
    """All rules and releases of a project."""

    rules: tuple[Rule, ...] = ()
    releases: tuple[Release, ...] = ()

    @property
    def functions(self) -> tuple[str, ...]:
        """All functions that release something."""
        return tuple(sorted({f for release in self.releases for f in release.functions}))


def is_function(word: str) -> bool:
    """Whether a word of `through` names a function: `perception.blur_faces`."""
    return "." in word and "/" not in word and ":" not in word


def read_policy(table: object) -> Policy:
    """The value of `flow` in a configuration file. Raises PolicyError."""
    if not isinstance(table, Mapping) or not set(table) <= {"rule", "release"}:
        raise PolicyError("flow has only the tables [[flow.rule]] and [[flow.release]]")
    rules = [_rule(each, number) for number, each in enumerate(_tables(table, "rule"), 1)]
    names = [rule.name for rule in rules]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise PolicyError(f"two flow rules are called {twice!r}")
    return Policy(tuple(rules), tuple(_release(each) for each in _tables(table, "release")))


def _tables(table: Mapping[object, object], key: str) -> list[Mapping[object, object]]:
    found = table.get(key, [])
    if not isinstance(found, list) or not all(isinstance(each, Mapping) for each in found) or len(found) > _MOST:
        raise PolicyError(f"[[flow.{key}]] must be a table, and there may be {_MOST:,} at most")
    return found


def _rule(table: Mapping[object, object], number: int) -> Rule:
    name = table.get("name", f"rule {number}")
    if not isinstance(name, str) or not name:
        raise PolicyError("the `name` of a flow rule must be a string")
    about = f"the flow rule {name!r}"
    _only(table, ("name", "from", "not-to", "to", "only-from", "by"), about)
    by = table.get("by", "data")
    if by not in STRENGTHS:
        raise PolicyError(f"{about}: `by` must be one of {', '.join(STRENGTHS)}")
    given = {key for key in ("from", "not-to", "to", "only-from") if key in table}
    if given not in ({"from", "not-to"}, {"to", "only-from"}):
        raise PolicyError(f"{about} needs either `from` and `not-to`, or `to` and `only-from`")
    return Rule(
        name,
        _selections(table, "from", about),
        _selections(table, "not-to", about),
        _selections(table, "to", about),
        _selections(table, "only-from", about),
        str(by),
    )


def _release(table: Mapping[object, object]) -> Release:
    through = table.get("through")
    about = f"the flow release through {', '.join(map(str, through)) if isinstance(through, list) else through}"
    _only(table, ("through", "of", "because"), about)
    because = table.get("because")
    if not isinstance(because, str) or not because.strip():
        raise PolicyError(f"{about} needs `because`: why is it safe?")
    if "through" not in table or "of" not in table:
        raise PolicyError(f"{about} needs `through` and `of`")
    return Release(_selections(table, "through", about), _selections(table, "of", about), because)


def _only(table: Mapping[object, object], keys: tuple[str, ...], about: str) -> None:
    wrong = [key for key in table if key not in keys]
    if wrong:
        raise PolicyError(f"{about} has no key {wrong[0]!r}; its keys are {', '.join(keys)}")


def _selections(table: Mapping[object, object], key: str, about: str) -> tuple[Selection, ...]:
    words = table.get(key, ())
    if isinstance(words, str):
        words = [words]
    if not isinstance(words, (list, tuple)) or not all(isinstance(w, str) and w for w in words) or len(words) > _MOST:
        raise PolicyError(f"{about} needs a list of names in `{key}`")
    for word in words:
        kind, colon, _ = word.partition(":")
        if colon and kind not in KINDS:
            raise PolicyError(f"{about}: {kind!r} in `{key}` is not a kind; kinds are {', '.join(KINDS)}")
    return tuple(Selection(word) for word in words)
