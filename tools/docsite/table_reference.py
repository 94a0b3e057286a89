# SPDX-License-Identifier: Apache-2.0
"""Which columns have the tables of a survey? A page of Markdown, written from their declaration."""

from __future__ import annotations

from typing import Final

from rosward.surveying.columns import COSTS, REPOSITORY, TABLES, Column

__all__ = ["table_reference"]

_HEAD: Final = """\
<!-- SPDX-License-Identifier: Apache-2.0 -->
# Tables of a survey

[`rosward survey`](survey.md) writes these files. A column is never null unless its row says so.
Rows are sorted by repository, and then as in `network.json`. All tables but `costs.parquet` have
the same bytes for the same sources, options, rosward and pyarrow. Texts are UTF-8; a byte of a
name that is not UTF-8 is written as `\\xff`.
"""


def table_reference() -> str:
    """The page."""
    sections = [_HEAD]
    for name, table in {**TABLES, "costs": COSTS}.items():
        rows = [_row(column) for column in (REPOSITORY, *table.columns)]
        sections.append(
            "\n".join([f"## {name}.parquet", "", table.what, "", "| column | type | |", "|---|---|---|", *rows, ""])
        )
    return "\n".join(sections)


def _row(column: Column) -> str:
    kind = f"`{column.kind.value}`" + (" or null" if column.optional else "")
    return f"| `{column.name}` | {kind} | {column.what} |"
