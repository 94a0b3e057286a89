# SPDX-License-Identifier: Apache-2.0
"""Which rights of an enclave does a pattern stand for, and what more does it allow?

Widened(SERVICE_SERVER, /a/*_parameter*, members={/a/get_parameters, /a/set_parameters, …}, more=())
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TypeAlias

from rosward.records import NamedTuple
from rosward.ros.entities import EntityKind

__all__ = ["Widened", "Widenings"]


class Widened(NamedTuple):
    """A pattern in place of the names `members`; `more` are the names of the network that it allows and nobody in the enclave needs."""

    kind: EntityKind
    name: str
    members: frozenset[str]
    more: tuple[str, ...]

    def also(self, most: int) -> str:
        """What it allows besides, for a person; `most` names are listed."""
        plain = [name for name in self.more if "*" not in name]
        holes = len(self.more) - len(plain)
        parts = [_some(plain, most)] if plain else []
        if holes:
            parts.append(
                f"{holes} {'name' if holes == 1 else 'names'} with unknown parts, where they turn out to match"
            )
        return f"also allows {', '.join([*parts, 'and any other name of this form' if parts else 'any other name of this form'])}"


def _some(names: Sequence[str], most: int) -> str:
    rest = f" and {len(names) - most} more existing ones" if len(names) > most else ""
    return ", ".join(names[:most]) + rest


Widenings: TypeAlias = Mapping[str, tuple[Widened, ...]]
"""By the path of the enclave."""
