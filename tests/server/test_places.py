# SPDX-License-Identifier: Apache-2.0
"""Names of files that come from anybody: where they may be written, and which are refused."""

from __future__ import annotations

import pytest

from rosward.server.limits import Limits
from rosward.server.places import Places, UploadRefusedError, why_left_out


@pytest.mark.parametrize(
    ("name", "path"),
    [
        ("talker.py", "talker.py"),
        ("ws/src/demo/talker.py", "ws/src/demo/talker.py"),
        ("./demo//talker.py", "demo/talker.py"),
        ("demo/..hidden/a b.py", "demo/..hidden/a b.py"),
        ("demo/größe.py", "demo/größe.py"),
    ],
)
def test_a_name_below_the_folder_is_taken(name: str, path: str) -> None:
    assert Places(Limits()).add(name) == path


@pytest.mark.parametrize(
    "name",
    [
        "../talker.py",
        "demo/../../talker.py",
        "demo/..",
        "/etc/passwd",
        "//server/share/x.py",
        "C:\\x.py",
        "C:x.py",
        "c:/x.py",
        "..\\talker.py",
        "demo\\talker.py",
        "talker.py\0.png",
        "talk\ner.py",
        "\x1b[2Jtalker.py",
        "\u202eyp.reklat",
        "\udc80.py",
        "",
        ".",
        "./",
        "a" * 256,
        "/".join("a" * 41),
        "/".join(["abcdefghij" * 20] * 6),
    ],
)
def test_a_name_that_could_lead_elsewhere_is_refused(name: str) -> None:
    with pytest.raises(UploadRefusedError):
        Places(Limits()).add(name)


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("talker.py", "talker.py"),
        ("talker.py", "./talker.py"),
        ("talker.py", "Talker.py"),
        ("demo/a.py", "Demo/b.py"),
        ("stra\u00dfe.py", "strasse.py"),
        ("caf\u00e9.py", "cafe\u0301.py"),
        ("demo", "demo/a.py"),
        ("demo/a.py", "demo"),
    ],
)
def test_two_names_for_one_place_are_refused(first: str, second: str) -> None:
    places = Places(Limits())
    places.add(first)
    with pytest.raises(UploadRefusedError):
        places.add(second)


def test_files_of_one_folder_do_not_collide() -> None:
    places = Places(Limits())
    assert [places.add(name) for name in ("demo/a.py", "demo/b.py", "a.py")] == ["demo/a.py", "demo/b.py", "a.py"]


def test_the_number_of_files_is_bounded() -> None:
    places = Places(Limits(files=2))
    places.add("a")
    places.add("b")
    with pytest.raises(UploadRefusedError, match="more than 2 files"):
        places.add("c")


@pytest.mark.parametrize("name", ["a.py", "package.xml", "scripts/talker", "config/a.yaml", "msg/A.msg", "x.launch"])
def test_what_may_be_source_is_kept(name: str) -> None:
    assert why_left_out(name) == ""


@pytest.mark.parametrize("name", [".git/config", "demo/__pycache__/a.pyc", "mesh/arm.STL", "bag/a.db3", "in.zip"])
def test_what_is_no_source_is_left_out(name: str) -> None:
    assert why_left_out(name)
