# SPDX-License-Identifier: Apache-2.0
"""Whether something has arrived is no content of it; how much there is in a container, or what a method of its class says, is."""

from __future__ import annotations

from pathlib import Path

import pytest

from .reported import Said, reported, said_of
from .robots import SEND, write

CLASSES = """
import acme


class Row(list):
    pass


class Level:
    def __init__(self, height):
        self.height = height

    def __bool__(self):
        return self.height > 1.0
"""


def _said(folder: Path, keeps: str, does: str, condition: str, top: str = "") -> Said:
    program = folder / "robot.py"
    write(program, keeps, does, f"if {condition}:\n    {SEND.format('1.0')}", top)
    said = said_of(reported(program), "topic:/out")
    assert said is not None
    assert said.data == frozenset()
    return said


@pytest.mark.parametrize(
    "condition",
    [
        "self.last is not None",
        "not (self.last is None)",
        "self.last != None",
        "self.last",
        "not not self.last",
        "self.last is not None and self.last is not self",
    ],
)
def test_that_it_is_there(tmp_path: Path, condition: str) -> None:
    said = _said(tmp_path, "self.last = None", "self.last = msg", condition)
    assert said.control == frozenset()
    assert "topic:/in" in said.trigger


@pytest.mark.parametrize(
    ("does", "condition"),
    [
        ("self.last = msg if msg.data > 1.0 else None", "self.last is not None"),
        ("self.last = [1.0] * int(msg.data)", "not self.last"),
        ("self.last = Row([1.0] * int(msg.data))", "not self.last"),
        ("self.last = Level(msg.data)", "not self.last"),
        ("self.last = np.array([msg.data])", "not self.last"),
        ("self.last = {1.0: 2.0}.get(msg.data)", "self.last is None"),
        ("self.last = acme.found(msg)", "self.last is None"),
        ("self.last = acme.found(msg)", "self.last == None"),
    ],
)
def test_what_it_is_decides(tmp_path: Path, does: str, condition: str) -> None:
    said = _said(tmp_path, "self.last = None", does, condition, CLASSES)
    assert "topic:/in" in said.control
