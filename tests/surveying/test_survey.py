# SPDX-License-Identifier: Apache-2.0
"""What a survey writes, and that it goes on where it was stopped."""

from __future__ import annotations

import re
import shutil
import signal
import subprocess
import sys
import time
from concurrent.futures import BrokenExecutor, Executor, Future
from pathlib import Path
from typing import Any

import duckdb
import pyarrow.parquet as pq
import pytest

import rosward
from rosward.cli import main
from rosward.surveying.columns import COSTS, REPOSITORY, TABLES
from rosward.surveying.part import packed

from .checkouts import NAMES, RESULTS, TALKER, Surveyed, put, tables


def copied(surveyed: Surveyed, place: Path, *names: str) -> Path:
    """Another folder with some of the same repositories."""
    for name in names:
        shutil.copytree(surveyed.folder / name, place / name)
    return place


def parts(output: Path) -> list[Path]:
    return sorted((output / "parts").glob("*/*.part"))


def asked(query: str) -> list[Any]:
    """What DuckDB answers."""
    relation = duckdb.sql(query)
    assert relation is not None
    return list(relation.fetchall())


def test_each_repository_has_a_row(surveyed: Surveyed) -> None:
    rows = pq.read_table(surveyed.output / "repositories.parquet").to_pylist()
    told = [(row["repository"], row["state"], row["started"]) for row in rows]
    assert told == [
        ("both", "ok", "executables"),
        ("empty", "empty", None),
        ("launched", "ok", "launch files"),
        ("new\nline \\xff<b>", "ok", "executables"),
    ]
    assert [row["complete"] for row in rows] == [False, True, True, True]
    assert surveyed.survey.states == {"ok": 3, "empty": 1}
    assert surveyed.survey.complete
    assert surveyed.survey.analysed == len(NAMES)
    costs = pq.read_table(surveyed.output / "costs.parquet").to_pylist()
    assert [row["repository"] for row in costs] == [row["repository"] for row in rows]
    assert all(row["cpu_seconds"] > 0 for row in costs)


def test_the_tables_have_their_documented_columns(surveyed: Surveyed) -> None:
    for name, table in {**TABLES, "costs": COSTS}.items():
        schema = pq.read_schema(surveyed.output / f"{name}.parquet")
        assert [field.name for field in schema] == [REPOSITORY.name, *(column.name for column in table.columns)]
        for column in table.columns:
            field = schema.field(column.name)
            assert str(field.type).replace("element: string not null", "string") == column.kind.value
            assert field.nullable == column.optional
            assert field.metadata[b"description"].decode() == column.what


def test_the_rows_are_those_of_the_analysis(surveyed: Surveyed) -> None:
    network = rosward.extract(surveyed.folder / "both").network
    expected = [
        (node.fqn, e.kind.value, e.name, e.type, e.resolution.value, e.qos.reliability if e.qos else None)
        for node in network.nodes
        for e in node.entities
    ]
    output = surveyed.output
    columns = "node_name, kind, name, type, resolution, reliability"
    assert asked(f"select {columns} from '{output}/entities.parquet' where repository = 'both'") == expected
    codes = asked(f"select code from '{output}/findings.parquet' where repository = 'both'")
    assert [code for (code,) in codes] == [finding.code for finding in network.findings]


def test_what_launch_files_start(surveyed: Surveyed) -> None:
    rows = pq.read_table(surveyed.output / "systems.parquet").to_pylist()
    assert [(row["system"], row["package"], row["name"], row["remaps"]) for row in rows] == [
        ("start.launch.xml", "demo_nodes_cpp", "other", ["chatter:=/said"])
    ]


def test_the_overview_is_one_page_that_loads_nothing(surveyed: Surveyed) -> None:
    page = (surveyed.output / "overview.html").read_text(encoding="utf-8")
    assert "new\\x0aline \\xff&lt;b&gt;" in page
    assert not re.search(r"https?:|<script|<link|<img|\bsrc=|\bhref=|url\(|@import|<b>", page)
    assert "default-src 'none'; style-src 'sha256-" in page
    assert "there is no Python, C++ or launch file" in page


def test_a_run_that_found_everything_analyses_nothing(surveyed: Surveyed, tmp_path: Path) -> None:
    """And a file that was written to is another state, as are other options."""
    folder, output = copied(surveyed, tmp_path / "checkouts", "both", "empty"), tmp_path / "out"
    assert rosward.survey(folder, output, jobs=2).analysed == 2
    before = tables(output)
    again = rosward.survey(folder, output, jobs=2)
    assert (again.analysed, again.rows["nodes"], tables(output) == before) == (0, 2, True)
    put(folder / "empty" / "talker.py", TALKER)
    assert rosward.survey(folder, output, jobs=2).analysed == 1
    assert rosward.survey(folder, output, exclude=["*.py"], jobs=2).states == {"empty": 2}


def test_damaged_parts_are_made_anew(surveyed: Surveyed, tmp_path: Path) -> None:
    """Cut off, empty, of another form, a folder: each is as if it were not there."""
    output = tmp_path / "out"
    shutil.copytree(surveyed.output, output)
    first, second, third, _ = parts(output)
    first.write_bytes(first.read_bytes()[:-1])
    part = packed(second.read_bytes())
    assert part is not None
    second.write_bytes(part._replace(body=b"\x1f\x8b nothing").stored())
    third.unlink()
    again = rosward.survey(surveyed.folder, output, jobs=2, all_launch=True)
    assert again.analysed == 3
    assert tables(output) == tables(surveyed.output)


class Stopping(Executor):
    """Runs so many tasks, and then is no more."""

    def __init__(self, tasks: int) -> None:
        self.left = tasks

    def submit(self, fn: Any, /, *args: Any, **kwargs: Any) -> Future[Any]:
        future: Future[Any] = Future()
        self.left -= 1
        if self.left < 0:
            future.set_exception(BrokenExecutor("a process ended abruptly"))
        else:
            future.set_result(fn(*args, **kwargs))
        return future


def test_a_survey_whose_executor_is_gone_goes_on(surveyed: Surveyed, tmp_path: Path) -> None:
    folder, output = copied(surveyed, tmp_path / "checkouts", "both", "empty", "launched"), tmp_path / "out"
    with pytest.raises(rosward.LostExecutorError, match="run the same command again"):
        rosward.survey(folder, output, executor=Stopping(2), all_launch=True)
    done = len(parts(output))
    assert not (output / "nodes.parquet").exists()
    again = rosward.survey(folder, output, jobs=2, all_launch=True)
    assert (done + again.analysed, again.states) == (3, {"ok": 2, "empty": 1})


def test_a_survey_that_is_killed_goes_on(surveyed: Surveyed, tmp_path: Path) -> None:
    """Nothing is lost, nothing is analysed twice, and the tables are those of a survey that nobody killed."""
    output = tmp_path / "out"
    command = [
        sys.executable,
        "-m",
        "rosward",
        "survey",
        str(surveyed.folder),
        "--all-launch",
        "-j",
        "1",
        "-o",
        str(output),
    ]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    while process.poll() is None and len(parts(output)) < 2:
        time.sleep(0.02)
    process.send_signal(signal.SIGKILL)
    process.wait()
    done = len(parts(output))
    assert done >= 2
    again = rosward.survey(surveyed.folder, output, jobs=2, all_launch=True)
    assert done + again.analysed == len(NAMES)
    assert tables(output) == tables(surveyed.output)
    assert {path.name for path in output.iterdir() if not path.name.startswith(".")} == {
        "parts", "overview.html", "costs.parquet", *(f"{name}.parquet" for name in RESULTS)
    }  # fmt: skip


def test_what_the_terminal_says(surveyed: Surveyed, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    listed = tmp_path / "list"
    listed.write_text(f"{surveyed.folder}/empty\n\n{surveyed.folder}/./empty\n{tmp_path}/gone\n", encoding="utf-8")
    assert main(["survey", str(listed), "-o", str(tmp_path / "out")]) == 1
    told = capsys.readouterr().out
    assert "rosward surveyed 2 repositories: 1 empty, 1 failed." in told
    assert "1 path leads to a folder that is in the list already" in told
    assert "  gone: cannot be read: No such file or directory" in told
    assert main(["survey", str(listed), "-o", str(tmp_path / "out"), "-q"]) == 1
    assert not capsys.readouterr().out
