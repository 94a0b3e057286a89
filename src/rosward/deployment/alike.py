# SPDX-License-Identifier: Apache-2.0
"""Which starts of a program are the same?

--params-file /tmp/launch_params_7       the seventh file that this launch writes, and with the same content
--params-file /tmp/launch_params_2       the second of another one: the number tells the program nothing

Launch gives the files that it writes random names. Each process numbers its own, in the order in which its words name them.
"""

from __future__ import annotations

from rosward.deployment.execution.generated import STEM
from rosward.domain.choice import options
from rosward.domain.text import readable
from rosward.domain.values import Const, Value
from rosward.effects.configuration import Configuration

__all__ = ["renumbered"]


def renumbered(configuration: Configuration) -> Configuration:
    """The configuration with the files that launch wrote numbered from 1; those of unknown content keep their names, by which they are told."""
    component = configuration.component
    words = (*(component or ()), *configuration.words)
    written = {n for n, content in configuration.files.items() if content is not None and n.startswith(STEM)}
    named = [text for w in words if isinstance(w, Const) and (text := readable(w)) in written]
    names = {name: f"{STEM}{number}" for number, name in enumerate(dict.fromkeys(named), 1)}
    others = {readable(option) for w in words if not isinstance(w, Const) for option in options(w)}
    taken = others | (configuration.files.keys() - names)
    if all(old == new for old, new in names.items()) or not taken.isdisjoint((*names, *names.values())):
        return configuration

    def renamed(word: Value) -> Value:
        new = names.get(readable(word)) if isinstance(word, Const) else None
        return Const(new, word.origins) if new is not None and isinstance(word, Const) else word

    return Configuration(
        words=tuple(map(renamed, configuration.words)),
        files={names.get(name, name): content for name, content in configuration.files.items()},
        missing=configuration.missing,
        environment=configuration.environment,
        component=None if component is None else tuple(map(renamed, component)),
    )
