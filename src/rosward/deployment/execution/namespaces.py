# SPDX-License-Identifier: Apache-2.0
"""Which namespace and full name does a node get from what is pushed and what it says itself?

/left pushed, node says 'arm' -> /left/arm      says '/top' -> /top      says '' -> /left      says nothing -> /left
nothing pushed, node says '' -> /               says nothing -> None: launch passes no namespace at all
"""

from __future__ import annotations

from typing import Final

from rosward.deployment.execution.yaml_values import plain_text
from rosward.domain.choice import lift, lift2, options
from rosward.domain.text import concat, make, origins_of, parts_of
from rosward.domain.values import Const, Value
from rosward.naming import final_name

_SLASH: Final = Const("/")


def prefixed(base: Value | None, namespace: Value | None) -> Value | None:
    """The namespace that launch passes, absolute; None where none is given and none is pushed."""
    if namespace is None:
        return base if base is None else lift(_absolute, base)
    if base is None:
        return lift(_absolute, namespace)
    return lift2(_below, base, namespace)


def _absolute(namespace: Value) -> Value:
    """With a slash in front, and none behind. An unknown beginning may be absolute: `/` and anything covers both."""
    first = parts_of(namespace)[0]
    if isinstance(first, str) and first.startswith("/"):
        return _stripped(namespace)
    return _stripped(concat((_SLASH, namespace)))


def _stripped(namespace: Value) -> Value:
    parts = parts_of(namespace)
    last = parts[-1]
    if not isinstance(last, str) or not last.endswith("/"):
        return namespace
    found = make((*parts[:-1], last.rstrip("/")), origins_of(namespace))
    return Const("/", origins_of(namespace)) if plain_text(found) == "" else found


def _below(base: Value, namespace: Value) -> Value:
    first = parts_of(namespace)[0]
    if isinstance(first, str):
        if first.startswith("/"):
            return _stripped(namespace)
    elif not first.shape:
        return _absolute(namespace)  # it may be absolute, and then replace what is pushed
    if plain_text(base) in ("", "/"):
        return _absolute(namespace)
    return _absolute(concat((base, _SLASH, namespace)))


def full_name(namespace: Value | None, name: Value | None) -> Value | None:
    """The full name, None unless launch gives both parts."""
    if namespace is None or name is None:
        return None
    return lift2(final_name.full_name, namespace, name)


def scopes(namespace: Value | None, name: Value | None) -> tuple[str, ...]:
    """The keys under which the dicts of `parameters` are written: the full name, or all nodes where that is not known."""
    full = full_name(namespace, name)
    names = [plain_text(option) for option in options(full)] if full is not None else [None]
    return tuple(n for n in names if n is not None) if None not in names else ("/**",)
