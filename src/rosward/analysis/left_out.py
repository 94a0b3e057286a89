# SPDX-License-Identifier: Apache-2.0
"""Does a process that was followed in haste leave out an entity, because what is called has become unknown by that?

for name, make in self.makers.items(): make(name)     where `makers` is not known any more, nothing says what is called

Then it is to be followed anew, without haste: what is missing is told in any case (`unreached.py`), but may be found.
"""

from __future__ import annotations

from collections.abc import Iterable

from rosward.analysis.seen import Seen
from rosward.analysis.summary import creates
from rosward.analysis.unreached import Unseen
from rosward.engine.libraries.library import Library
from rosward.ir.program import Code


def leaves_out(seen: Seen, functions: Iterable[Code], library: Library) -> bool:
    """Whether something unknown may call a function that creates an entity and was not entered."""
    unseen = Unseen((seen,))
    creating = library.facts.creating
    return any(
        code.key not in seen.entered and unseen.may_call(code.file, code.qualname) and creates(code, creating)
        for code in functions
    )
