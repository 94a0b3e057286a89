# SPDX-License-Identifier: Apache-2.0
"""Interfaces that no wheel is made of, on the type support of others.

    class Deliver(Fibonacci):                                             DDS sees test_msgs/action/Fibonacci,
        Goal = message(Fibonacci.Goal, doors=lambda: ["lobby"])           the program an action with `goal.doors`

The fields are there in Python only: what goes over the middleware has those of the other type.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any


def message(real: Any, **fields: Callable[[], Any]) -> Any:
    """A type of messages with further fields, each with its default."""

    def start(self: Any, **values: Any) -> None:
        real.__init__(self)
        for name, default in fields.items():
            setattr(self, name, values.pop(name) if name in values else default())
        if values:
            raise AttributeError(f"no such fields: {', '.join(values)}")

    # the converter to C looks at the class by its module and name
    return type(real)(real.__name__, (real,), {"__init__": start, "__module__": real.__module__})
