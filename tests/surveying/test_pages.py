# SPDX-License-Identifier: Apache-2.0
"""The pages about surveys: the columns are those that are written, and each query that is shown answers something.

python -m pytest tests/surveying/test_pages.py --update-pages     writes the page of columns
"""

from __future__ import annotations

import re

import duckdb
import pytest
from docsite.pages import DOCS
from docsite.table_reference import table_reference

from .checkouts import Surveyed

QUERIES = re.findall(r"^```sql\n(.*?)^```$", (DOCS / "survey.md").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)


def test_the_columns(request: pytest.FixtureRequest) -> None:
    page = DOCS / "survey-tables.md"
    if request.config.getoption("--update-pages"):
        page.write_text(table_reference(), encoding="utf-8")
    assert page.read_text(encoding="utf-8") == table_reference()


@pytest.mark.parametrize("query", QUERIES, ids=range(len(QUERIES)))
def test_a_query_answers(query: str, surveyed: Surveyed, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(surveyed.output)
    relation = duckdb.sql(query)
    assert relation is not None
    assert relation.fetchall()


def test_qualities_that_do_not_fit(surveyed: Surveyed, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(surveyed.output)
    relation = duckdb.sql(next(query for query in QUERIES if "best_effort" in query))
    assert relation is not None
    assert relation.fetchall() == [("both", "/chatter", "/talker", "/listener")]


def test_there_are_queries() -> None:
    assert len(QUERIES) >= 6
