# SPDX-License-Identifier: Apache-2.0
"""Promise: what is read of a file of the sources is what is in it; of any other file, nothing is made up."""

from __future__ import annotations

import time

import pytest

from models.fake_std import FakeMachine
from rosward.domain.choice import reasons_of
from rosward.domain.text import concat
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import TRUE, Const, Unknown, Value
from rosward.location import Place
from rosward.models.python.std.paths import basename, dirname, splitext
from rosward.models.python.std.support import to_plain

SHARE = Unknown((Reason(Cause.SHARE, "demo", Place("a.py", 1)),), "str")


FILES = {"config/a.yaml": "x: [1, two]\n", "config/.b": "first\nsecond"}


class OneFolder:
    """`config` in the share folder of demo has two files."""

    def read(self, package: str, relative: str) -> str | None:
        return FILES.get(relative) if package == "demo" else None

    def is_file(self, package: str, relative: str) -> bool:
        return self.read(package, relative) is not None

    def is_folder(self, package: str, relative: str) -> bool:
        return (package, relative) == ("demo", "config")

    def listing(self, package: str, relative: str) -> tuple[str, ...] | None:
        return (".b", "a.yaml") if self.is_folder(package, relative) else None

    def name_of(self, package: str, relative: str) -> str | None:
        del package, relative
        return None

    def modules(self, relative: str) -> tuple[str, ...]:
        del relative
        return ()


@pytest.fixture
def machine() -> FakeMachine:
    found = FakeMachine()
    found.files = OneFolder()
    return found


def below(path: str, start: Value = SHARE) -> Value:
    return concat((start, Const(path)))


def test_read_text(machine: FakeMachine) -> None:
    assert machine.native("pathlib._read_text", below("/config/a.yaml")) == Const("x: [1, two]\n")
    for path in (below("/config/c"), Const("/etc/a"), below("/config/a.yaml", dirname(SHARE))):
        found = machine.native("pathlib._read_text", path)
        assert isinstance(found, Unknown)
        assert {r.cause for r in reasons_of(found)} == {Cause.FILE}


@pytest.mark.parametrize(
    ("name", "path", "expected"),
    [
        ("exists", "/config", True),
        ("exists", "/config/a.yaml", True),
        ("isdir", "/config", True),
        ("isdir", "/config/a.yaml", None),
        ("isfile", "/config/a.yaml", True),
        ("isfile", "/config", None),
        ("exists", "/absent", None),
    ],
)
def test_is_there(machine: FakeMachine, name: str, path: str, expected: bool | None) -> None:
    found = machine.native(f"os.path.{name}", below(path))
    assert (found == TRUE) == bool(expected)
    assert expected or (isinstance(found, Unknown) and found.hint == "bool")


def plain(machine: FakeMachine, value: Value) -> object:
    return to_plain(machine, value)[0]


def test_listing(machine: FakeMachine) -> None:
    assert plain(machine, machine.native("os.listdir", below("/config"))) == [".b", "a.yaml"]
    fitting = machine.native("glob.glob", below("/config/*"))
    assert list(machine.iterate(fitting).known) == [below("/config/a.yaml")]
    for name, path in (("os.listdir", "/absent"), ("glob.glob", "/*/a.yaml"), ("glob.glob", "/config/**")):
        assert machine.iterate(machine.native(name, below(path))).rest is not None


def test_pieces_of_a_path_are_no_path() -> None:
    """What is made of the path of a folder does not lead to its files."""
    assert dirname(dirname(SHARE)) == Unknown((SHARE.reasons[0]._replace(cause=Cause.PREFIX),), "str")
    for value in (dirname(dirname(dirname(SHARE))), basename(SHARE), *splitext(SHARE)):
        assert {r.cause for r in reasons_of(value)} == {Cause.OPERATION}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a: &x [1, 2]\nb: *x\n", {"a": [1, 2], "b": [1, 2]}),
        ("/**:\n  '/*/x': 1\n", {"/**": {"/*/x": 1}}),
        ("base: &b {x: 1}\nmore:\n  <<: *b\n  y: 2\n", {"base": {"x": 1}, "more": {"x": 1, "y": 2}}),
        ("", None),
        ("- yes\n- 010\n- 1e3\n", [True, 8, "1e3"]),
    ],
)
def test_yaml(machine: FakeMachine, text: str, expected: object) -> None:
    assert plain(machine, machine.native("yaml.safe_load", Const(text))) == expected


DOUBLING = "a0: &a0 {x: 1}\n" + "".join(f"a{n}: &a{n} [*a{n - 1}, *a{n - 1}]\n" for n in range(1, 40))
MERGING = "a0: &a0 {x: 1}\n" + "".join(f"a{n}: &a{n}\n  <<: [*a{n - 1}, *a{n - 1}]\n" for n in range(1, 40))


@pytest.mark.parametrize(
    "text",
    [
        DOUBLING,
        MERGING,
        "a: &x [*x]",
        "[" * 5_000 + "]" * 5_000,
        "{a: " * 3_000,
        "!!python/object/apply:os.system [echo]",
        "!mine {a: 1}",
        "a: " + "x" * 900_000,
        "- 1\n" * 200_000,
    ],
    ids=lambda text: text[:20],
)
def test_hostile_yaml(machine: FakeMachine, text: str) -> None:
    """It ends soon, and makes little."""
    start, before = time.process_time(), len(machine.heap)
    machine.native("yaml.safe_load", Const(text))
    assert time.process_time() - start < 5
    assert len(machine.heap) - before < 20_000
