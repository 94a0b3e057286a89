# SPDX-License-Identifier: Apache-2.0
"""What the environments of the cases use of gymnasium, of which the tests need no more: a registry of names, and a base class."""

from __future__ import annotations

import importlib
from typing import Any

_REGISTERED: dict[str, Any] = {}


class Env:
    """The base class of environments."""

    @property
    def unwrapped(self) -> Any:
        return self

    def reset(self, *, seed: int | None = None, options: Any = None) -> Any:
        raise NotImplementedError

    def step(self, action: Any) -> Any:
        raise NotImplementedError

    def close(self) -> None:
        pass


def register(id: str, entry_point: Any = None) -> None:  # noqa: A002
    """An environment can be made by this name from now on."""
    _REGISTERED[id] = entry_point


def make(id: str, **kwargs: Any) -> Any:  # noqa: A002
    """An environment of this name; what stands before a colon is imported first."""
    module, _, name = id.rpartition(":")
    if module:
        importlib.import_module(module)
    found = _REGISTERED[name]
    if isinstance(found, str):
        where, _, attribute = found.partition(":")
        found = getattr(importlib.import_module(where), attribute)
    return found(**kwargs)
