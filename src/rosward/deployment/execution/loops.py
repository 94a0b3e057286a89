# SPDX-License-Identifier: Apache-2.0
"""Which turns does a ForEach or ForLoop make, and what are its variables in each?

values "{name: a, id: 1};{name: b, id: 2}"   ->   {name: 'a', id: 1}, {name: 'b', id: 2}
a number of turns that is not known          ->   one turn with an index that is not known, which may not happen
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.deployment.execution.conditions import YES, Truth
from rosward.deployment.execution.yaml_values import load_yaml, plain_text, value_of
from rosward.deployment.tree import ForEach
from rosward.domain.choice import options, reasons_of
from rosward.domain.text import origins_of
from rosward.domain.unknown import Cause, Origins, Reason
from rosward.domain.values import Const, Unknown, Value
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.deployment.execution.scene import Scene

MAX_TURNS: Final = 1_000


class Turn(NamedTuple):
    """One turn: its variables, and whether it surely happens."""

    variables: dict[str, Value]
    verdict: Truth = YES


def turns(action: ForEach, scene: Scene) -> list[Turn]:
    """The turns of a loop."""
    found: list[Turn] = []
    values = options(scene.text(action.values))
    for option in values:
        plain = plain_text(option)
        if plain is None:
            found.append(_unknown_turn(action, option, scene))
            continue
        several = len(values) > 1 or not all(o.settled for o in origins_of(option))
        verdict = Truth(why="the iterations of a loop") if several else YES
        rows = _indices(plain, action, scene) if action.count else _rows(plain, origins_of(option), action, scene)
        found += [Turn(row, verdict) for row in rows]
    if len(found) > MAX_TURNS:
        scene.findings.tell(
            "RW201", f"A loop of more than {MAX_TURNS} iterations is not analysed to its end.", action.place
        )
    return found[:MAX_TURNS]


def _unknown_turn(action: ForEach, value: Value, scene: Scene) -> Turn:
    reasons = reasons_of(value) or (Reason(Cause.LOOP, "", action.place),)
    why = "; ".join(str(r) for r in reasons[:3])
    scene.findings.tell("RW313", f"The iterations of the loop are unknown: {why}.", action.place)
    hint = "int" if action.count else ""
    names = [action.index_name or "i"] if action.count else []
    return Turn({name: Unknown(reasons, hint) for name in names}, Truth(why=why))


def _indices(text: str, action: ForEach, scene: Scene) -> list[dict[str, Value]]:
    try:
        count = int(text)
    except ValueError:
        scene.fails(f"{text[:40]!r} is not a number of iterations", action.place)
        return []
    return [{action.index_name or "i": Const(i)} for i in range(min(count, MAX_TURNS + 1))]


def _rows(text: str, origins: Origins, action: ForEach, scene: Scene) -> list[dict[str, Value]]:
    """Each row is a YAML mapping; `{}` is a turn without variables, a blank row none."""
    found: list[dict[str, Value]] = []
    for part in text.strip().split(";"):
        row = load_yaml(part.strip())
        if not row.error and row.value is None:
            continue
        if not isinstance(row.value, dict) or not all(isinstance(name, str) for name in row.value):
            scene.fails(f"{part.strip()[:40]!r} does not give names and values to a loop", action.place)
            continue
        found.append({name: value_of(value, origins) for name, value in row.value.items()})
    return found
