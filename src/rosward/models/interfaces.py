# SPDX-License-Identifier: Apache-2.0
"""What are the classes called that rosidl generates for messages, services and actions?

std_msgs.msg.String            String, of module std_msgs.msg._string
std_srvs.srv.SetBool.Request   SetBool_Request, of module std_srvs.srv._set_bool
"""

from __future__ import annotations

import re
from typing import Final

from rosward.domain.compound import External, Native, Tuple
from rosward.domain.values import Class, Const, Function, Text, Value
from rosward.models.native import Machine
from rosward.records import NamedTuple
from rosward.source.definitions import PARTS

NO_INTERFACE: Final = (Class, Const, Function, Native, Text, Tuple)
"""What the class of an interface never is, nor is equal to."""
INTERFACE_NAMES: Final = frozenset({"__name__", "__qualname__", "__module__"})
_WORD: Final = re.compile(r"(.)([A-Z][a-z]+)")
_CAPITAL: Final = re.compile(r"([a-z0-9])([A-Z])")


def interface_name(dotted: str, attribute: str) -> str:
    """`__name__`, `__qualname__` or `__module__` of the class of an interface, by the dotted name under which programs import it."""
    package, kind, *inner = dotted.split(".")
    if attribute != "__module__":
        return "_".join(n for n in inner if n != "Impl")
    return f"{package}.{kind}._{_CAPITAL.sub(_SPLIT, _WORD.sub(_SPLIT, inner[0])).lower()}"


_SPLIT: Final = r"\1_\2"


class MessageName(NamedTuple):
    """Which message a class is: of a package and kind, by its name, and the part of a service or action (`Request`), else ''."""

    package: str
    kind: str
    name: str
    part: str

    @property
    def dotted(self) -> str:
        """The name under which programs import it."""
        inner = f"{self.name}.{self.part}" if self.part else self.name
        return f"{self.package}.{self.kind}.{inner}"


def same_interface(machine: Machine, left: Value, right: Value) -> bool | None:
    """Whether two classes of interfaces are one; None where the fields of one are not known."""
    names = {_interface_of(machine, left), _interface_of(machine, right)}
    return None if "" in names else len(names) == 1


def is_known_interface(machine: Machine, cls: Value) -> bool:
    """Whether a value is the class of an interface whose fields are known: such a class has no base but `object`."""
    return _interface_of(machine, cls) != ""


def _interface_of(machine: Machine, cls: Value) -> str:
    """The name under which programs import the class of an interface whose fields are known; '' for anything else."""
    if not isinstance(cls, External):
        return ""
    if not any(machine.interface_definition(cls.name + part) for part in ("", ".Request", ".Goal")):
        return ""
    return public_name(cls.name)


def public_name(dotted: str) -> str:
    """The name under which programs import the class of an interface, however one has come to it."""
    message = message_name(dotted)
    return message.dotted if message is not None else ".".join(n for n in dotted.split(".") if not n.startswith("_"))


def is_of_interfaces(dotted: str) -> bool:
    """Whether a dotted name is one in a module of interfaces (`package.msg`)."""
    return dotted.partition(".")[2].partition(".")[0] in PARTS


def message_name(dotted: str) -> MessageName | None:
    """The message behind a dotted name, however a program has come to it; None for anything else."""
    package, _, rest = dotted.partition(".")
    kind, *inner = rest.split(".")
    inner = [name for name in inner if not name.startswith("_")]
    if kind not in PARTS or not inner or not inner[0][:1].isupper():
        return None
    if len(inner) == 1:
        name, _, part = inner[0].rpartition("_") if kind != "msg" else (inner[0], "", "")
        inner = [name, part]
    return MessageName(package, kind, inner[0], inner[1]) if len(inner) == 2 and inner[1] in PARTS[kind] else None


def is_interface(dotted: str) -> bool:
    """Whether a dotted name is that of a message, a service or an action, or of a part of one."""
    _, kind, name, *_ = (*dotted.split("."), "", "", "")
    return kind in PARTS and name[:1].isupper()
