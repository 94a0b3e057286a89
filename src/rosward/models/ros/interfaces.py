# SPDX-License-Identifier: Apache-2.0
"""What are the classes called that rosidl generates for messages, services and actions?

std_msgs.msg.String            String, of module std_msgs.msg._string
std_srvs.srv.SetBool.Request   SetBool_Request, of module std_srvs.srv._set_bool
"""

from __future__ import annotations

import re
from typing import Final

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
