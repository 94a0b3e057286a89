# SPDX-License-Identifier: Apache-2.0
"""How is a JSON document of another program, or of an earlier run, read strictly?

    Fields({"nodes": [{"name": 3}]}, "the document").objects("nodes", 10)[0].text("name")
      ->  UnreadableError: nodes[0].name must be a string of at most 1000 characters

What is not of the form that is asked for is refused with the place of it, and size is bounded.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import TypeVar

from rosward.findings import Finding
from rosward.source import limits
from rosward.source.text import read_bytes

__all__ = ["Fields", "UnreadableError", "json_document"]


T = TypeVar("T")


class UnreadableError(Exception):
    """What was given cannot be read; the message says why."""


def json_document(path: str) -> object:
    """The JSON in a file. Raises UnreadableError."""
    data = read_bytes(path, path, limits.JSON_FILE)
    if isinstance(data, Finding):
        raise UnreadableError(f"{path}: {data.message}")
    try:
        return json.loads(data)
    except (ValueError, RecursionError) as error:
        raise UnreadableError(f"{path}: not valid JSON: {error}") from error


class Fields:
    """An object of JSON whose fields are asked for by their kind; one of another kind is told with its place."""

    def __init__(self, value: object, where: str) -> None:
        if not isinstance(value, dict):
            raise UnreadableError(f"{where} must be an object")
        self._value = value
        self.where = where

    def __contains__(self, key: str) -> bool:
        return self._value.get(key) is not None

    def text(self, key: str) -> str:
        """A text."""
        found = self._value.get(key)
        if not isinstance(found, str) or len(found) > limits.JSON_NAME:
            raise UnreadableError(f"{self.where}.{key} must be a string of at most {limits.JSON_NAME} characters")
        return found

    def long_text(self, key: str) -> str:
        """A text of any length."""
        found = self._value.get(key)
        if not isinstance(found, str):
            raise UnreadableError(f"{self.where}.{key} must be a string")
        return found

    def one_of(self, key: str, known: Mapping[str, T]) -> T:
        """What a text stands for that is one of those that are known."""
        text = self.text(key)
        if text not in known:
            raise UnreadableError(f"{self.where}.{key} has an unknown value")
        return known[text]

    def inner(self, key: str) -> Fields:
        """An object in it."""
        return Fields(self._value.get(key), f"{self.where}.{key}")

    def text_or_none(self, key: str) -> str | None:
        """A text, or nothing."""
        return self.text(key) if key in self else None

    def number(self, key: str) -> int:
        """A natural number."""
        found = self._value.get(key)
        if not isinstance(found, int) or isinstance(found, bool) or not 0 <= found < 1 << 31:
            raise UnreadableError(f"{self.where}.{key} must be a non-negative integer")
        return found

    def flag(self, key: str, default: bool) -> bool:
        """True or false."""
        found = self._value.get(key, default)
        if not isinstance(found, bool):
            raise UnreadableError(f"{self.where}.{key} must be true or false")
        return found

    def integer_or_none(self, key: str) -> int | None:
        """A whole number, or nothing."""
        found = self._value.get(key)
        if found is not None and (not isinstance(found, int) or isinstance(found, bool)):
            raise UnreadableError(f"{self.where}.{key} must be an integer")
        return found

    def version(self, *known: int) -> int:
        """The version of the document; one that is not known is refused. Without `known` that is the first."""
        found = self._value.get("schema_version")
        if isinstance(found, bool) or not isinstance(found, int) or found not in (known or (1,)):
            raise UnreadableError(f"schema_version must be {' or '.join(map(str, known or (1,)))}")
        return found

    def texts_by_name(self, key: str, most: int) -> dict[str, str]:
        """An object of texts."""
        inner = self.inner(key)
        if len(inner._value) > most:
            raise UnreadableError(f"{inner.where} has more than {most:,} items")
        return {name: inner.long_text(name) for name in inner._value}

    def names(self) -> list[str]:
        """The names of its fields."""
        return list(self._value)

    def option(self, key: str, most: int) -> bool | float | str | tuple[str, ...] | None:
        """A value as options have it."""
        found = self._value.get(key)
        if found is None or isinstance(found, (bool, int, float)):
            return found
        return tuple(self.texts(key, most)) if isinstance(found, list) else self.long_text(key)

    def objects(self, key: str, most: int) -> list[Fields]:
        """A list of objects."""
        return [Fields(value, f"{self.where}.{key}[{n}]") for n, value in enumerate(self._list(key, most))]

    def texts(self, key: str, most: int) -> list[str]:
        """A list of texts."""
        found = self._list(key, most)
        texts = [value for value in found if isinstance(value, str) and len(value) <= limits.JSON_NAME]
        if len(texts) < len(found):
            raise UnreadableError(
                f"{self.where}.{key} must be a list of strings of at most {limits.JSON_NAME} characters"
            )
        return texts

    def _list(self, key: str, most: int) -> list[object]:
        found = self._value.get(key)
        if not isinstance(found, list):
            raise UnreadableError(f"{self.where}.{key} must be a list")
        if len(found) > most:
            raise UnreadableError(f"{self.where}.{key} has more than {most:,} items")
        return found
