# SPDX-License-Identifier: Apache-2.0
"""Promise: a file is read as Python would read it, and what cannot be read is told with file and line, soon."""

from __future__ import annotations

import codecs
import os
import socket
from pathlib import Path

import pytest

from rosward.findings import Finding
from rosward.source.text import SourceText, place_name, read_source


def text(tmp_path: Path, data: bytes) -> SourceText:
    (tmp_path / "x.py").write_bytes(data)
    result = read_source(tmp_path / "x.py", tmp_path)
    assert isinstance(result, SourceText), result
    return result


def problem(path: Path, limit: int = 1000) -> Finding:
    result = read_source(path, path.parent, limit)
    assert isinstance(result, Finding), result
    return result


def test_utf8_is_the_default(tmp_path: Path) -> None:
    assert text(tmp_path, "x = 'é'\n".encode()) == SourceText("x.py", "x = 'é'\n", "utf-8")


def test_a_byte_order_mark_is_no_text(tmp_path: Path) -> None:
    assert text(tmp_path, codecs.BOM_UTF8 + b"x = 1\n").text == "x = 1\n"


def test_the_declared_encoding_counts(tmp_path: Path) -> None:
    result = text(tmp_path, b"#!/usr/bin/python\n# -*- coding: latin-1 -*-\nx = '\xe9'\n")
    assert result.text.endswith("x = 'é'\n")
    assert result.finding is None


@pytest.mark.parametrize("end", [b"\r\n", b"\r", b"\n"])
def test_line_ends_are_one(tmp_path: Path, end: bytes) -> None:
    assert text(tmp_path, b"a = 1" + end + b"b = 2" + end).text == "a = 1\nb = 2\n"


def test_latin1_without_declaration_is_read_and_told(tmp_path: Path) -> None:
    result = text(tmp_path, b"a = 1\nb = 2\nx = '\xe9'\n")
    assert result.text.endswith("x = 'é'\n")
    assert result.finding is not None
    assert (result.finding.code, str(result.finding.place)) == ("RW004", "x.py:3")


@pytest.mark.parametrize(
    "declaration",
    ["klingon", "rot13", "zlib", "hex", "punycode", "idna", "undefined", "utf-16", "ascii"],
)
def test_a_declaration_that_does_not_work_is_told(tmp_path: Path, declaration: str) -> None:
    result = text(tmp_path, f"# coding: {declaration}\nx = 'é'\n".encode())
    assert result.text.endswith("x = 'é'\n")
    assert result.finding is not None
    assert result.finding.code == "RW004"


def test_a_mark_against_the_declaration_is_told(tmp_path: Path) -> None:
    result = text(tmp_path, codecs.BOM_UTF8 + b"# coding: latin-1\nx = 1\n")
    assert result.text == "# coding: latin-1\nx = 1\n"
    assert result.finding is not None
    assert result.finding.code == "RW004"


def test_declared_utf8_that_is_not(tmp_path: Path) -> None:
    result = text(tmp_path, b"# coding: utf-8\n\nx = '\xe9'\n")
    assert result.finding is not None
    assert str(result.finding.place) == "x.py:3"


def test_nul_bytes_are_an_error_with_a_line(tmp_path: Path) -> None:
    (tmp_path / "x.py").write_bytes(b"a = 1\nb\0 = 2\n")
    finding = problem(tmp_path / "x.py")
    assert (finding.code, finding.place.line, finding.place.column) == ("RW001", 2, 2)


def test_utf16_is_named(tmp_path: Path) -> None:
    (tmp_path / "x.py").write_bytes("x = 1\n".encode("utf-16"))
    assert "UTF-16" in problem(tmp_path / "x.py").message


def test_an_empty_file_is_empty(tmp_path: Path) -> None:
    assert text(tmp_path, b"").text == ""


def test_a_file_at_the_limit_is_read_and_one_above_is_not(tmp_path: Path) -> None:
    (tmp_path / "x.py").write_bytes(b"#" * 1000)
    assert isinstance(read_source(tmp_path / "x.py", tmp_path, 1000), SourceText)
    assert problem(tmp_path / "x.py", 999).code == "RW003"


def test_twenty_megabytes(tmp_path: Path) -> None:
    (tmp_path / "x.py").write_bytes(b"x = 1\n" * (20_000_000 // 6))
    finding = read_source(tmp_path / "x.py", tmp_path)
    assert isinstance(finding, Finding)
    assert finding.code == "RW003"


def test_a_named_pipe_does_not_block(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "x.py")
    assert problem(tmp_path / "x.py") == Finding("RW002", "This is a named pipe, not a text file.", ("x.py", 0, 1))  # type: ignore[arg-type]


def test_a_socket(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)  # the name of a socket must be short
    with socket.socket(socket.AF_UNIX) as end:
        end.bind("x.py")
        assert "socket" in problem(tmp_path / "x.py").message


def test_a_device() -> None:
    assert "device" in problem(Path("/dev/zero")).message


def test_a_folder(tmp_path: Path) -> None:
    (tmp_path / "x.py").mkdir()
    assert "folder" in problem(tmp_path / "x.py").message


def test_a_link_to_itself(tmp_path: Path) -> None:
    (tmp_path / "x.py").symlink_to("x.py")
    assert problem(tmp_path / "x.py").code == "RW002"


def test_a_link_that_leads_nowhere(tmp_path: Path) -> None:
    (tmp_path / "x.py").symlink_to("y.py")
    assert problem(tmp_path / "x.py").code == "RW002"


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read everything")
def test_a_file_without_permission(tmp_path: Path) -> None:
    (tmp_path / "x.py").write_text("x = 1")
    (tmp_path / "x.py").chmod(0)
    assert problem(tmp_path / "x.py").code == "RW002"


@pytest.mark.parametrize("name", ["a\0b.py", "a" * 5000, "missing.py"])
def test_names_that_no_file_can_have(tmp_path: Path, name: str) -> None:
    assert problem(tmp_path / name).code == "RW002"


def test_place_names_are_relative_and_printable(tmp_path: Path) -> None:
    assert place_name(tmp_path / "a" / "b.py", tmp_path) == "a/b.py"
    assert place_name(tmp_path / "b.py", tmp_path / "a") == "../b.py"
    assert place_name("/r/a\nb\udcff.py", "/r") == "a\\nb\\xff.py"
    assert place_name("/r/räder.py", "/r") == "räder.py"
    assert place_name("/a.py", "/") == "a.py"
