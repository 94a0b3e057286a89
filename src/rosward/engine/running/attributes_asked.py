# SPDX-License-Identifier: Apache-2.0
"""Which attributes of an object did a call ask for? Where it read nothing else of the record, the others may change.

self.pub.publish(self.count)      asks for `pub` and `count`; what another callback writes to `self.last` is none of its business
self.last = msg                   asks for no attribute, but for what kind of object it is

Such a question is noted among the addresses whose records were read, as a number far below zero that tells the address and the attribute:
who carries addresses on carries these on as well (so are questions for nodes, `nodes_asked.py`). To most it counts as the whole record.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Final, final

from rosward.domain.heap import KIND
from rosward.models.python.attribute_tables import TABLE

if TYPE_CHECKING:
    from rosward.domain.heap import Obj

FIRST: Final = -(1 << 56)
"""Questions for attributes stand at this number and below."""
BITS: Final = 20
_MASK: Final = (1 << BITS) - 1


@final
class AttributeNames:
    """The names of attributes in the order in which they were asked for."""

    __slots__ = ("_names", "numbers")

    def __init__(self) -> None:
        self._names: list[str] = []
        self.numbers: dict[str, int] = {}

    def question(self, address: int, name: str) -> int:
        """What is noted where somebody asks for one attribute of the object at an address.

        The whole record, where it is one of a function, or where there are too many names.
        """
        if address < 0:
            return address
        number = self.numbers.get(name)
        if number is None:
            number = len(self._names)
            if number > _MASK:
                return address
            self.numbers[name] = number
            self._names.append(name)
        return FIRST - (address << BITS | number)

    def asked(self, question: int) -> tuple[int, str]:
        """The address and the name that a question tells."""
        told = FIRST - question
        return told >> BITS, self._names[told & _MASK]


def records_of(asked_for: Iterable[int]) -> Iterator[int]:
    """The addresses of all records that were read, wholly or in part. Questions for nodes are among them: there is no record there.

    Those of functions are below zero (`Library.function_address`), but far above questions for attributes.
    """
    for asked in asked_for:
        yield asked if asked > FIRST else (FIRST - asked) >> BITS


def says_the_same(then: Obj | None, now: Obj | None, name: str) -> bool:
    """Whether who asks for one attribute is told the same by two records."""
    if then is now:
        return True
    if then is None or now is None:
        return False
    return (
        then.cls is now.cls
        and then.many is now.many
        and then.payload is now.payload
        and then.attrs.get(TABLE) is now.attrs.get(TABLE)
        and (
            name == KIND
            or (then.attrs.get(name) == now.attrs.get(name) and (name in then.partial) is (name in now.partial))
        )
    )
