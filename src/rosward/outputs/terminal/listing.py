# SPDX-License-Identifier: Apache-2.0
"""What there is of one kind, as a plain table: one line each, for the eyes, for grep and for awk.

node                 package        executable   interface  assumed  enclave              entities
/porter/base_driver  delivery_base  base_driver  analysed   -        /porter/base_driver  4
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from rosward.explanation.listing import Row
from rosward.safe import encodable, printable

_NONE: Final = "-"


def listing_text(rows: Sequence[Row], kind: str) -> str:
    """A head and a line for each, in columns of two spaces; without rows one line that says so."""
    if not rows:
        return f"no {kind}\n"
    head = list(rows[0])
    table = [head, *([_cell(row[column]) for column in head] for row in rows)]
    widths = [max(len(line[at]) for line in table) for at in range(len(head))]
    lines = ("  ".join(f"{text:<{wide}}" for text, wide in zip(line, widths, strict=True)).rstrip() for line in table)
    return "".join(f"{encodable(line)}\n" for line in lines)


def _cell(value: object) -> str:
    if isinstance(value, (list, tuple)):
        return printable(",".join(map(str, value))) or _NONE
    if isinstance(value, bool):
        return "yes" if value else _NONE
    return _NONE if value is None or value == "" else printable(str(value))
