# SPDX-License-Identifier: Apache-2.0
"""Which classes have no objects, because a method of them is abstract?

class Driver(ABC):
    @abstractmethod
    def setup(self): …        Driver() is a TypeError; so is each class below that does not define setup
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.compound import Descriptor
from rosward.domain.values import TRUE, UNBOUND, Class, Const, Function, Value
from rosward.engine.python.metaclass_of import metaclass_of

if TYPE_CHECKING:
    from rosward.engine.machine import Engine


_NAMES: Final = "__abstractmethods__"


def mark(machine: Engine, cls: Class) -> None:
    """A class that was just made notes which of its methods are abstract; what it is given later changes nothing of that."""
    if not cls.stub and _is_marked(machine, cls):
        names = machine.new_set(Const(name) for name in _abstract_names(machine, cls))
        machine.put(cls.address, machine.at(cls.address).with_attr(_NAMES, names))


def refused(machine: Engine, cls: Class) -> bool:
    """Whether making an object of a class raises TypeError here. Where nothing waits for that, one is made: the path goes on."""
    if cls.stub:
        return False
    if any(isinstance(b, Class) and b.stub and b.name == "Protocol" for b in cls.bases):
        told = "Protocols cannot be instantiated"
    else:
        noted = machine.at(cls.address).attrs.get(_NAMES)
        names = (
            [str(n.value) for n in machine.iterate(noted).known if isinstance(n, Const)] if noted is not None else []
        )
        if not names:
            return False
        several = "s" * (len(names) > 1)
        told = f"Can't instantiate abstract class {cls.name} with abstract method{several} {', '.join(sorted(names))}"
    return machine.die("TypeError", told, (Const(told),), sure=True, plain=True) is UNBOUND


def _is_marked(machine: Engine, cls: Class) -> bool:
    """Whether its metaclass is that of abstract classes."""
    meta = metaclass_of(machine, cls)
    return isinstance(meta, Class) and any(isinstance(b, Class) and b.stub and b.name == "ABCMeta" for b in meta.mro)


def _abstract_names(machine: Engine, cls: Class) -> list[str]:
    """The methods that are abstract and that no class before theirs defines."""
    defined: set[str] = set()
    found: list[str] = []
    for base in cls.mro:
        if not isinstance(base, Class):
            return []  # what it defines is not known
        for name, value in machine.at(base.address).attrs.items():
            if value is UNBOUND or name in defined:
                continue
            defined.add(name)
            if not base.stub and _is_abstract(machine, value):
                found.append(name)
    return sorted(found)


def _is_abstract(machine: Engine, value: Value) -> bool:
    if isinstance(value, Descriptor):
        return any(
            part is not None and _is_abstract(machine, part) for part in (value.getter, value.setter, value.deleter)
        )
    if not isinstance(value, Function):
        return False
    kept = machine.function_record(value)
    return kept is not None and kept.attrs.get("__isabstractmethod__") == TRUE
