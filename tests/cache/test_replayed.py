# SPDX-License-Identifier: Apache-2.0
"""A run that is said again says what it would say: whatever is edited, printed, written, and whoever has been at the cache."""

from __future__ import annotations

import os
import random
import subprocess
import sys
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

import pytest
from sampling import sample

from cache.test_results import WORKSPACE
from rosward.cli import main
from rosward.source.kept import cache_folder

MORE = {
    "rosward.toml": "exclude = ['nothing']\n",
    "params.yaml": "/**:\n  ros__parameters:\n    topic: given\n",
    "src/other/launch/all.launch.xml": "<launch><include file='$(dirname)/all.launch.py'/>"
    "<node pkg='demo' exec='listener' name='second'><param from='$(dirname)/../../../params.yaml'/></node></launch>\n",
    "src/third/package.xml": "<package format='3'><name>third</name></package>",
    "models/yaml.pyi": "def safe_load(stream: object) -> object: ...\n",
    "baseline.json": "",
}
OPTIONS = {
    "plain": ["--format", "json,policy,html"],
    "launched": ["--launch", "other:all.launch.xml", "--format", "json", "-v"],
    "parameters": ["--params", "params.yaml", "--format", "json"],
    "models": ["--models", "models", "--format", "json,sarif"],
    "flows": ["--flows", "--format", "json,html"],
}


class Said(NamedTuple):
    """What a run said."""

    status: int
    printed: str
    errors: str
    files: dict[str, bytes]


@pytest.fixture
def used(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Results are kept in a folder of this test, which is also where it runs."""
    monkeypatch.setenv("ROSWARD_CACHE", str(tmp_path / "cache"))
    monkeypatch.setattr("rosward.cli.kept.results_folder", cache_folder)
    folder = tmp_path / "ws"
    for name, content in {**WORKSPACE, **MORE}.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content, encoding="utf-8")
    monkeypatch.chdir(folder)
    return tmp_path


@pytest.fixture
def say(used: Path, capsys: pytest.CaptureFixture[str]) -> Callable[..., Said]:
    """Run `extract`."""

    def said(*options: str) -> Said:
        out = used / "out"
        status = main(["extract", ".", "-j", "1", "-o", str(out), *options])
        text = capsys.readouterr()
        return Said(
            status,
            text.out,
            text.err,
            {p.relative_to(out).as_posix(): p.read_bytes() for p in out.rglob("*") if p.is_file()},
        )

    return said


@pytest.fixture
def runs(monkeypatch: pytest.MonkeyPatch) -> list[object]:
    """The words that were taken apart."""
    from rosward.cli import command_line

    found: list[object] = []
    real = command_line.parsed_and_run

    def counted(words: Sequence[str]) -> int:
        found.append(words)
        return real(words)

    monkeypatch.setattr(command_line, "parsed_and_run", counted)
    return found


@pytest.mark.parametrize("options", sample(OPTIONS.values(), 3), ids=OPTIONS)
def test_it_is_said_again(say: Callable[..., Said], runs: list[object], options: list[str]) -> None:
    first = say(*options)
    assert say(*options) == first
    assert len(runs) == 1
    assert say(*options, "--no-cache") == first
    assert len(runs) == 2


EDITS: dict[str, Callable[[], object]] = {
    "a line": lambda: _add("src/demo/demo/names.py", "NAME = 'changed'\n"),
    "a header": lambda: _add("src/other/src/name.hpp", '#undef NAME\n#define NAME "changed"\n'),
    "a launch file": lambda: Path("src/other/launch/all.launch.xml").write_text("<launch/>\n", encoding="utf-8"),
    "an included launch file": lambda: _add("src/other/launch/all.launch.py", "raise ValueError\n"),
    "a parameter file": lambda: Path("params.yaml").write_text(
        "/**:\n  ros__parameters:\n    topic: changed\n", encoding="utf-8"
    ),
    "a model": lambda: Path("models/yaml.pyi").write_text(
        "def safe_load(stream: object) -> str: ...\n", encoding="utf-8"
    ),
    "a new model": lambda: Path("models/ament_index_python.pyi").write_text("", encoding="utf-8"),
    "the configuration": lambda: Path("rosward.toml").write_text("distro = 'humble'\n", encoding="utf-8"),
    "a configuration that is gone": lambda: Path("rosward.toml").unlink(),
    "a nearer configuration": lambda: Path("src/rosward.toml").write_text("distro = 'humble'\n", encoding="utf-8"),
    "a file that appears": lambda: Path("src/third/talker.py").write_text(
        "import rclpy\nrclpy.create_node('third')\n", encoding="utf-8"
    ),
    "a file that vanishes": lambda: Path("src/demo/demo/listener.py").unlink(),
    "a mark": lambda: Path("src/demo/COLCON_IGNORE").touch(),
}


def _add(name: str, text: str) -> None:
    with Path(name).open("a", encoding="utf-8") as file:
        file.write(text)


@pytest.mark.parametrize("edit", sample(EDITS.values(), 4), ids=EDITS)
def test_after_an_edit_it_is_as_without_a_cache(say: Callable[..., Said], edit: Callable[[], object]) -> None:
    options = ["--launch", "other:all.launch.xml", "--models", "models", "--format", "json", "-v"]
    say(*options)
    edit()
    warm = say(*options)
    assert warm == say(*options, "--no-cache")
    assert warm == say(*options)


@pytest.mark.parametrize("options", sample(OPTIONS.values(), 5), ids=OPTIONS)
def test_after_any_edits_it_is_as_without_a_cache(say: Callable[..., Said], options: list[str]) -> None:
    rng = random.Random(str(options))
    for _ in range(4):
        warm = say(*options)
        assert warm == say(*options, "--no-cache")
        assert warm == say(*options)
        for edit in rng.sample(list(EDITS.values()), 2):
            with suppress(OSError):  # it was there, or is gone, already
                edit()


def test_the_same_sources_anew_are_the_same(say: Callable[..., Said], runs: list[object]) -> None:
    first = say()
    for path in Path().rglob("*"):
        if path.is_file():
            content = path.read_bytes()
            path.unlink()
            path.write_bytes(content)
    assert say() == first
    assert say() == first
    assert len(runs) == 1


def test_a_change_that_keeps_size_and_time_is_seen(say: Callable[..., Said], runs: list[object]) -> None:
    path = Path("src/demo/demo/names.py")
    os.utime(path, (1_000_000_000, 1_000_000_000))
    say()
    path.write_text("NAME = 'walker'\n", encoding="utf-8")
    os.utime(path, (1_000_000_000, 1_000_000_000))
    assert b"/walker" in say().files["network.json"]
    assert len(runs) == 2


@pytest.mark.parametrize("option", ["--env-from-shell", "--env-from", "--env-"])
def test_the_shell_is_asked_each_time(say: Callable[..., Said], monkeypatch: pytest.MonkeyPatch, option: str) -> None:
    Path("src/demo/demo/names.py").write_text("import os\nNAME = os.environ['ROBOT']\n", encoding="utf-8")
    for name in ("left", "right"):
        monkeypatch.setenv("ROBOT", name)
        assert f"/{name}".encode() in say(option, "ROBOT").files["network.json"]


def test_the_underlays_of_the_shell_are_asked_each_time(
    used: Path, say: Callable[..., Said], monkeypatch: pytest.MonkeyPatch
) -> None:
    Path("src/demo/demo/names.py").write_text("from far.names import NAME\n", encoding="utf-8")
    for name in ("left", "right"):
        module = used / name / "lib/python3.12/site-packages/far/names.py"
        module.parent.mkdir(parents=True)
        module.with_name("__init__.py").touch()
        module.write_text(f"NAME = '{name}'\n", encoding="utf-8")
        monkeypatch.setenv("AMENT_PREFIX_PATH", str(used / name))
        warm = say("--ament-prefix-path")
        assert warm == say("--ament-prefix-path", "--no-cache")
        assert f"/{name}".encode() in warm.files["network.json"]


def _entries(used: Path) -> list[Path]:
    return [p for p in (used / "cache").rglob("run-*/*") if p.is_file()]


@pytest.mark.parametrize(
    "spoil",
    [lambda _: b"", lambda data: data[:-1], lambda data: data[:40] + b"x" + data[41:], lambda _: b"x" * 5_000],
)
def test_a_spoilt_entry_is_not_said(
    used: Path, say: Callable[..., Said], runs: list[object], spoil: Callable[[bytes], bytes]
) -> None:
    first = say()
    (entry,) = _entries(used)
    entry.write_bytes(spoil(entry.read_bytes()))
    assert say() == first
    assert len(runs) == 2


@pytest.mark.parametrize(
    "forged",
    [
        b"",
        b"\n",
        b"9\n",
        b"-1\n",
        b"3\na\0b",
        b"x\n\0\0\0\0",
        b"cos\nsystem\n(S'true'\ntR.",
        "DIGEST\0000\0001\0000\0000\0x",
        "DIGEST\0000\0004\0000\0000\0a\0b\0c\0d",
    ],
)
def test_a_forged_entry_is_not_said(
    say: Callable[..., Said], runs: list[object], monkeypatch: pytest.MonkeyPatch, forged: bytes | str
) -> None:
    from rosward.cli import replayed

    written = replayed._written

    def other(question: bytes, _: replayed._Said) -> bytes:
        if isinstance(forged, bytes):
            return forged
        head = forged.replace("DIGEST", replayed._digest(question)).encode()
        return b"%d\n" % len(head) + head

    monkeypatch.setattr(replayed, "_written", other)
    first = say()
    monkeypatch.setattr(replayed, "_written", written)
    assert say() == first
    assert len(runs) == 2


def test_an_entry_of_another_run_is_not_said(used: Path, say: Callable[..., Said], runs: list[object]) -> None:
    say()
    (one,) = _entries(used)
    first = say("--tests")
    (other,) = [p for p in _entries(used) if p != one]
    other.write_bytes(one.read_bytes())
    assert say("--tests") == first
    assert len(runs) == 3


def test_a_folder_that_cannot_be_written_is_told_as_ever(used: Path, say: Callable[..., Said]) -> None:
    say()
    for path in sorted((used / "out").rglob("*"), reverse=True):
        path.rmdir() if path.is_dir() else path.unlink()
    (used / "out").rmdir()
    (used / "out").write_text("a file", encoding="utf-8")
    assert main(["extract", ".", "-j", "1", "-o", str(used / "out")]) == 2


@pytest.mark.usefixtures("used")
def test_next_to_nothing_is_loaded() -> None:
    """A process of its own tells what it has loaded."""
    code = (
        "import sys; from rosward.source import same; same._MOMENT = 0; from rosward.cli import main; "
        "main(['extract', '.', '-j', '1', '-q', '-o', '../out']); print(*sys.modules)"
    )
    told = [
        subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
        for _ in range(2)
    ]
    assert "rosward.pipeline" in told[0]
    assert sum(name.startswith("rosward") for name in told[1]) < 18
    assert not {"argparse", "json", "pathlib", "re", "typing"} & set(told[1])
