# SPDX-License-Identifier: Apache-2.0
"""How do the parts become files of Parquet?

    with Tables(output) as tables:
        for repository in repositories:
            tables.add(repository, part, rows)

One repository after the other, so that memory is that of a group of rows and not of the survey. Where groups end depends on the rows alone: the same
rows are the same bytes. A file is at its place when all are whole.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import ExitStack, suppress
from types import TracebackType
from typing import Any, Final, final

import pyarrow as pa
import pyarrow.parquet as pq

from rosward.outputs.whole_files import WholeFile
from rosward.surveying.columns import COSTS, REPOSITORY, TABLES, Column, Kind, Row, Table
from rosward.surveying.part import Part, Rows
from rosward.surveying.repositories import Repository

__all__ = ["Tables", "file_of"]

_GROUP: Final = 50_000
"""Rows after which a group ends."""
_TYPES: Final[Mapping[Kind, pa.DataType]] = {
    Kind.TEXT: pa.string(),
    Kind.NUMBER: pa.int64(),
    Kind.FLAG: pa.bool_(),
    Kind.DECIMAL: pa.float64(),
    Kind.TEXTS: pa.list_(pa.field("item", pa.string(), nullable=False)),
}


def file_of(table: str) -> str:
    """The name of the file of a table."""
    return f"{table}.parquet"


@final
class Tables:
    """The files of a survey while they are written. Raises OSError."""

    def __init__(self, output: str) -> None:
        self._output = output
        self._places = ExitStack()
        self._files: dict[str, _File] = {}

    def __enter__(self) -> Tables:
        with ExitStack() as places:
            for name, table in {**TABLES, "costs": COSTS}.items():
                self._files[name] = _File(places.enter_context(WholeFile(self._output, file_of(name))).target, table)
            self._places = places.pop_all()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        with self._places:  # which puts the files in place, or takes them away if this raises
            try:
                if error is not None:
                    raise error
                for file in self._files.values():
                    file.end()
            except BaseException:
                for file in self._files.values():
                    file.abandon()
                raise

    def add(self, repository: Repository, part: Part, rows: Rows) -> None:
        """Add what is known of a repository."""
        for name in TABLES:
            for row in rows[name]:
                self._files[name].add(
                    [repository.name, _path(repository), *row] if name == "repositories" else [repository.name, *row]
                )
        self._files["costs"].add([repository.name, part.cpu, part.peak])
        for file in self._files.values():
            file.end_of_repository()

    def counts(self) -> dict[str, int]:
        """How many rows each table has."""
        return {name: file.rows for name, file in self._files.items()}


def _path(repository: Repository) -> str:
    return repository.path.encode("utf-8", "surrogateescape").decode("utf-8", "backslashreplace")


@final
class _File:
    """One table while it is written."""

    def __init__(self, target: Any, table: Table) -> None:
        self._columns = (REPOSITORY, *table.columns)
        self._schema = pa.schema([_field(column) for column in self._columns])
        self._rows: list[Row] = []
        self.rows = 0
        self._target = target
        self._writer = pq.ParquetWriter(target, self._schema, compression="zstd")

    def end(self) -> None:
        """Write what is left, to the last byte."""
        self._flush()
        self._writer.close()
        self._target.flush()

    def abandon(self) -> None:
        """Write no more, not even when the writer is taken apart."""
        with suppress(Exception):
            self._writer.close()
        self._writer.is_open = False

    def add(self, row: Row) -> None:
        self._rows.append(row)
        self.rows += 1

    def end_of_repository(self) -> None:
        if len(self._rows) >= _GROUP:
            self._flush()

    def _flush(self) -> None:
        if self._rows:
            cells = zip(*self._rows, strict=True)
            arrays = [pa.array(each, type=field.type) for each, field in zip(cells, self._schema, strict=True)]
            self._writer.write_table(pa.Table.from_arrays(arrays, schema=self._schema))
            self._rows = []


def _field(column: Column) -> pa.Field:
    return pa.field(column.name, _TYPES[column.kind], nullable=column.optional, metadata={"description": column.what})
