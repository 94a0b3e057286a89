# SPDX-License-Identifier: Apache-2.0
"""What arrives at a program: messages, requests and values, the same for the same name, round and variant.

Contents({"topic:/in": 2}).filled("topic:/in", 0, Float64)    the third content of the first message on /in; all else is as ever
"""

from __future__ import annotations

import importlib
import random
from collections.abc import Mapping
from typing import Any, Final, final

_FLOATS: Final = (-3.0, -1.0, 0.0, 0.5, 1.0, 2.0, 4.0, 7.5, 20.0)
_TEXTS: Final = ("a", "b", "go", "stop", "left", "7", "2.5", "red")
_MOST: Final = 6


@final
class Contents:
    """The contents of one run. `variants`: which inputs differ, and how; `values`: what is to be delivered in turn."""

    def __init__(self, variants: Mapping[str, int], values: Mapping[str, list[str]]) -> None:
        self._variants, self._values = variants, values

    def _source(self, name: str, when: object) -> _Source:
        variant = self._variants.get(name, 0)
        chosen = random.Random(f"{name} {when} {variant}")
        known = self._values.get(name)
        if known is None:
            return _Source(chosen, None)
        turn = when if isinstance(when, int) else 0
        return _Source(chosen, known[(turn + variant) % len(known)])

    def filled(self, name: str, when: object, kind: type) -> Any:
        """A message of a type."""
        return self._source(name, when).fill(kind())

    def like(self, name: str, when: object, value: Any) -> Any:
        """A value of the same type."""
        return self._source(name, when).like(value)


@final
class _Source:
    """Chooses; where a word is given, that one as far as it fits."""

    def __init__(self, chosen: random.Random, word: str | None) -> None:
        self._random, self._word = chosen, word

    def fill(self, message: Any) -> Any:
        """Write all fields."""
        for field, kind in message.get_fields_and_field_types().items():
            setattr(message, field, self._of_type(kind, getattr(message, field)))
        return message

    def _of_type(self, kind: str, value: Any) -> Any:
        if hasattr(value, "get_fields_and_field_types"):
            return self.fill(value)
        if isinstance(value, (bool, int, float, str)):
            return self.like(value)
        if kind.startswith("sequence<"):
            inner = kind.removeprefix("sequence<").rstrip(">").partition(",")[0]
            return [self._element(inner) for _ in range(3 if inner == "double" else self._random.randint(1, 4))]
        element = self._element(kind.partition("[")[0])
        return [element] + [self._element(kind.partition("[")[0]) for _ in value[1:]]

    def _element(self, kind: str) -> Any:
        if "/" in kind:
            package, _, name = kind.partition("/")
            return self.fill(getattr(importlib.import_module(f"{package}.msg"), name)())
        return self.like(_PLAIN.get(kind.partition("<")[0], 0))

    def like(self, value: Any) -> Any:
        """A value of the type of another one."""
        if isinstance(value, (list, tuple)):
            return [self.like(value[0] if value else "") for _ in range(self._random.randint(1, 4))]
        if self._word is not None:
            return self._word == "true" if isinstance(value, bool) else _number(type(value), self._word)
        if isinstance(value, bool):
            return self._random.random() < 0.5
        if isinstance(value, int):
            return self._random.randint(0, _MOST)
        return self._random.choice(_FLOATS if isinstance(value, float) else _TEXTS)


_PLAIN: Final[Mapping[str, Any]] = {"double": 0.0, "float": 0.0, "boolean": False, "string": ""}


def _number(kind: type, word: str) -> Any:
    try:
        return kind(word)
    except ValueError:
        return kind()
