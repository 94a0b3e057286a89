# SPDX-License-Identifier: Apache-2.0
"""What does a translation unit hold after preprocessing?

    #include "demo/topics.hpp"                    files: demo/topics.hpp, then the source itself,
    auto pub = node->advertise(STATUS_TOPIC);     with "/robot/status" where the macro stood

Each file keeps its own text and its own lines; a header is prepared once for all units in which the macros that it looks at are the
same. Only what is included within brackets is put in place. No program of the machine has a part in this, and no header that is not of
the sources is read.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import final

from rosward.frontends.cpp.macros import Macro, definition
from rosward.frontends.cpp.prepared import Translation
from rosward.frontends.cpp.store import NO_VERSIONS, Above, FileStore, Find, Read, Versions, nowhere
from rosward.frontends.cpp.unit import Unit


@final
class Preprocessor:
    """Prepares the sources of a workspace; what it has read and prepared is shared by all units.

    `read` gives the text of a file, `named` how places call it, `find` the file of the workspace that an include leads to
    (`above` the one that it leads to all the same, where there is none),
    `versions` which version the macro of a library compares with (`RCLCPP_VERSION_GTE`).
    """

    def __init__(
        self,
        read: Read,
        named: Callable[[str], str],
        find: Find,
        versions: Versions = NO_VERSIONS,
        above: Above = nowhere,
    ) -> None:
        self._store = FileStore(read, named, find, versions, above)

    def translate(
        self, path: str, includes: Sequence[str], definitions: Iterable[tuple[str, str, bool]]
    ) -> Translation:
        """The unit of the source at `path`, with its folders of headers and the macros of its command line (name, value, sure)."""
        macros = dict(self._store.predefined)
        for name, value, sure in definitions:
            macro = definition(f"{name} {value}")
            if macro is None:
                continue
            before = macros.get(macro.name)
            others = before.alternatives if before is not None and before.alternatives else (before,)
            macros[macro.name] = macro if sure else Macro(macro.name, (), None, "", (macro, *others))
        unit = Unit(self._store, tuple(includes), macros)
        unit.visit(path, 0)
        return Translation(path, tuple(unit.order.values()), tuple(dict.fromkeys(unit.findings)))
