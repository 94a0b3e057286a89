# SPDX-License-Identifier: Apache-2.0
"""Which calls are recalled while a test runs?"""

from __future__ import annotations

import pytest

from rosward.domain.values import Value
from rosward.engine.calls import recalled
from rosward.engine.machine import Engine
from rosward.engine.running.summaries import Call


def noted_recalls(monkeypatch: pytest.MonkeyPatch) -> list[Call]:
    """The calls that are recalled from now on."""
    found: list[Call] = []
    repeated = recalled.repeated

    def noting(machine: Engine, key: str, call: Call) -> Value:
        found.append(call)
        return repeated(machine, key, call)

    monkeypatch.setattr(recalled, "repeated", noting)
    return found
