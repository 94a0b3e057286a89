# SPDX-License-Identifier: Apache-2.0
"""A deadline in CPU time is over when so much CPU time has passed, however much real time did."""

from __future__ import annotations

import time

import pytest

from rosward.deadline import Deadline


class Clocks:
    """Both clocks, and how often the slow one was asked."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.real = self.cpu = 100.0
        self.asked = 0
        monkeypatch.setattr(time, "monotonic", lambda: self.real)
        monkeypatch.setattr(time, "thread_time", self._thread_time)

    def _thread_time(self) -> float:
        self.asked += 1
        return self.cpu

    def passes(self, real: float, cpu: float) -> None:
        self.real += real
        self.cpu += cpu


def test_cpu_time_decides(monkeypatch: pytest.MonkeyPatch) -> None:
    clocks = Clocks(monkeypatch)
    end = Deadline(10)
    clocks.passes(real=1000, cpu=9)
    assert not end.is_over()
    clocks.passes(real=0.9, cpu=0.9)
    assert not end.is_over()
    clocks.passes(real=0.2, cpu=0.2)
    assert end.is_over()
    assert end.is_over()


def test_the_slow_clock_is_asked_where_it_may_be_over(monkeypatch: pytest.MonkeyPatch) -> None:
    clocks = Clocks(monkeypatch)
    end = Deadline(10)
    for _ in range(1000):
        clocks.passes(real=0.01, cpu=0.005)
        end.is_over()
    assert clocks.asked < 5
