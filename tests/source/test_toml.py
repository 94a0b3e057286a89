# SPDX-License-Identifier: Apache-2.0
"""TOML that comes with the sources: as the standard library reads it, and in bounded time."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from rosward.cli.configuration_file import read_configuration
from rosward.cli.shared import WrongUseError
from rosward.network.assigned import AssignmentError, read_assignment
from rosward.source.entry_points import read_pyproject
from rosward.source.toml import read_toml

DEEP = ".".join(["a"] * 100_000)
SLOW = {
    "a dotted key": f"{DEEP} = 1\n",
    "its parts in quotes": '"a" . ' * 100_000 + "b = 1\n",
    "a deep table with many keys": f"[{'.'.join(['a'] * 4_000)}]\n" + "".join(f"k{n} = 1\n" for n in range(60_000)),
    "many long keys": "".join(f"k{n}.{'.'.join(['a'] * 900)} = 1\n" for n in range(1_000)),
    "behind the end of a text of several lines": f'x = {{a = """\n\'""", {DEEP} = 1, b = "\'"}}\n',
}


@pytest.mark.parametrize("text", SLOW.values(), ids=SLOW)
def test_keys_that_take_quadratic_time_are_refused(text: str, tmp_path: Path) -> None:
    file = tmp_path / "rosward.toml"
    file.write_text(text, encoding="utf-8")
    start = time.process_time()
    with pytest.raises(ValueError, match="too many dots"):
        read_toml(text)
    with pytest.raises(AssignmentError):
        read_assignment(file)
    with pytest.raises(WrongUseError):
        read_configuration(tmp_path, [])
    assert [f.code for f in read_pyproject(str(file), "pyproject.toml").findings] == ["RW008"]
    assert time.process_time() - start < 5


def test_honest_files_are_read() -> None:
    names = ", ".join(f'"/robot_{n}/camera.left/image.raw"' for n in range(1_500))
    arrays = "".join(f'["a.b", "c.d{n}"],\n' for n in range(20_000))
    text = f"[tool.rosward]\nnodes = [{names}]\nrows = [\n{arrays}]\n[a.b.c]\nd.e = 1\n"
    document = read_toml(text)
    assert document["a"] == {"b": {"c": {"d": {"e": 1}}}}
    assert set(document) == {"tool", "a"}


@pytest.mark.parametrize(
    "text", ["a", "a = ", "[" * 5_000, "a = " + "[" * 100_000, f"a = {'9' * 5_000}", "a = 2000-13-45"]
)
def test_what_is_no_toml_is_a_value_error(text: str) -> None:
    with pytest.raises(ValueError):  # noqa: PT011  the words are those of the standard library
        read_toml(text)
