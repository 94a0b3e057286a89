# SPDX-License-Identifier: Apache-2.0
"""For which methods does it count where a value stands that they are called on?

text.erase(0, 1)        another text stands in the variable from then on
text.front() = 'x'      what it gives leads into the variable
text.size()             nothing changes: it is enough to know the text
"""

from __future__ import annotations

from typing import Final

from rosward.models.cpp import functional, memory
from rosward.models.cpp.concurrency import threads
from rosward.models.cpp.iteration import iterators
from rosward.models.cpp.strings import string_changes, string_queries

__all__ = ["OF_PLACES"]

OF_PLACES: Final = (
    functional.OF_PLACES
    | iterators.OF_PLACES
    | memory.OF_PLACES
    | string_queries.OF_PLACES
    | string_changes.OF_PLACES
    | threads.OF_PLACES
)
"""Their full names, as natives have them: what they are called on is a value in a slot, not an object."""
