# SPDX-License-Identifier: Apache-2.0
"""Which classes and functions of the sources does a library know by a name that the program hands it?

gymnasium.register(id='Arm-v0', entry_point='arm.env:ArmEnv')     make('Arm-v0') imports arm.env and makes an ArmEnv
gymnasium.make('arm:Arm-v0')                                      imports arm, which registers it
plugins.load('arm.gripper.Gripper')

The library may import the module at any time, make the class with anything and call the function with anything.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import options
from rosward.domain.values import UNBOUND, Class, Const, Function, ModuleValue, Value
from rosward.engine.running.frame import own_frame
from rosward.engine.running.schedule_book import Naming

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

_DOTTED: Final = r"[A-Za-z_]\w*(?:\.[A-Za-z_]\w*)*"
_WITH_COLON: Final = re.compile(rf"({_DOTTED}):(\S+)")
_WITH_DOT: Final = re.compile(rf"({_DOTTED})\.([A-Za-z_]\w*)")
_LONGEST: Final = 300
"""The longest text that is taken for a name."""


def note(machine: Engine, value: Const) -> None:
    """A text reaches a library: it may be the name of something in the sources."""
    text = value.value
    if not isinstance(text, str) or len(text) > _LONGEST:
        return
    parts = _WITH_COLON.fullmatch(text) or _WITH_DOT.fullmatch(text)
    if parts is None or text in machine.schedule_book.named:
        return
    frame = own_frame(machine.frames)
    found = machine.library.find(parts[1], 0, frame.module if frame is not None else None)
    if found is not None and found.file and not found.model and not found.guess:
        machine.schedule_book.named[text] = Naming(parts[1], parts[2], machine.place, frame)


def called(machine: Engine, naming: Naming) -> list[Value]:
    """What a library gets by a name: classes and functions."""
    found = machine.language.load_module(machine, naming.module, naming.frame, 0)
    for part in naming.name.split("."):
        if isinstance(found, (ModuleValue, Class)):
            found = machine.at(found.address).attrs.get(part, UNBOUND)
    return [option for option in options(found) if isinstance(option, (Class, Function))]
