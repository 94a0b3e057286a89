# SPDX-License-Identifier: Apache-2.0
"""Files that have not changed are lowered only where a process runs that reads them; what is told of them is the same."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest

from rosward import Result, extract
from rosward.analysis import source_tree
from rosward.analysis.summaries import SUMMARY
from rosward.analysis.summary import Creation, Summary
from rosward.cache.codec import loaded, text
from rosward.cache.results import _written as written
from rosward.cache.store import Store
from rosward.frontends.front_end import FrontEnd, FrontendError
from rosward.frontends.registry import PYTHON
from rosward.ir.program import Module
from rosward.source.disk import digest, watching

FILES = {
    "talker.py": "import rclpy\nfrom std_msgs.msg import String\nimport names\n\n\ndef main():\n    node = rclpy.create_node(names.NAME)\n"
    "    node.create_publisher(String, 'a', 10)\n\n\ndef never(node):\n    node.create_publisher(String, 'b', 10)\n\n\n"
    "if __name__ == '__main__':\n    main()\n",
    "names.py": "NAME = 'talker'\n",
    "alone.py": "import rclpy\n\n\nclass Node(rclpy.node.Node):\n    def later(self):\n        self.create_timer(1, print)\n\n\n"
    "rclpy.create_node('alone')\n",
    "broken.py": "import rclpy\nx = (\n",
    "latin.py": "# -*- coding: ascii -*-\nimport rclpy\nrclpy.create_node('é')\n",
    "plain.py": "def f():\n    return 1\n",
}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "ws").mkdir()
    for name, content in FILES.items():
        (tmp_path / "ws" / name).write_text(content, encoding="utf-8")
    return tmp_path / "ws"


class Lowering:
    """Extracts with a store, and tells which files were lowered."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.store = Store(str(folder))
        self.lowered: list[str] = []
        real = PYTHON
        self.failing = False

        def lower(text: str, file: str, origins: Sequence[int] = (), name: str = "") -> Module:
            self.lowered.append(file)
            if self.failing and self.lowered.count(file) == 1:
                raise FrontendError("depth", "too deep", 1, 1)
            return real.lower(text, file, origins, name)

        noted = FrontEnd(real.language, real.suffixes, lower)
        monkeypatch.setattr(source_tree, "PYTHON", noted)
        monkeypatch.setattr(source_tree, "front_end_of", lambda *_: noted)

    def __call__(self, path: Path) -> Result:
        self.lowered.clear()
        with watching():
            return extract(path, store=self.store)


def same(one: Result, other: Result) -> bool:
    return text(written(one)) == text(written(other))


def test_only_what_runs_again_is_lowered(folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    cold = extract(folder)
    assert {"RW001", "RW004", "RW205"} <= {f.code for f in cold.findings}
    warm = Lowering(tmp_path / "cache", monkeypatch)
    assert same(warm(folder), cold)
    assert sorted(warm.lowered) == sorted(FILES)
    assert same(warm(folder), cold)
    assert warm.lowered == ["broken.py", "latin.py"]  # something is to be told of them
    with (folder / "names.py").open("a", encoding="utf-8") as file:
        file.write("# more\n")
    found = warm(folder)
    assert set(warm.lowered) == {"broken.py", "latin.py", "names.py", "talker.py"}
    assert same(found, extract(folder))


def test_what_is_nested_too_deep_where_it_is_needed_is_lowered_elsewhere(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (folder / "broken.py").unlink()
    (folder / "latin.py").unlink()
    warm = Lowering(tmp_path / "cache", monkeypatch)
    warm(folder)
    with (folder / "names.py").open("a", encoding="utf-8") as file:
        file.write("# more\n")
    monkeypatch.setattr(warm, "failing", True)
    (folder / "names.py").rename(folder / "more.py")
    (folder / "more.py").write_text(FILES["names.py"], encoding="utf-8")
    (folder / "plain.py").unlink()
    cold = extract(folder)
    found = warm(folder)
    assert warm.lowered.count("talker.py") == 2
    assert {n.fqn for n in found.network.nodes} == {n.fqn for n in cold.network.nodes}


@pytest.mark.parametrize(
    "forged", [b"", b"[]", b"{}", b'{"talker.py": []}', b'{"talker.py": ["", 1, 1, "", [], [], 1, [], []]}']
)
def test_a_forged_entry_is_none(folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, forged: bytes) -> None:
    kept = Store.keep

    def keep(store: Store, kind: str, question: bytes, answer: bytes) -> None:
        kept(store, kind, question, digest(question).encode() + b"\n" + forged if kind == "files" else answer)

    warm = Lowering(tmp_path / "cache", monkeypatch)
    monkeypatch.setattr(Store, "keep", keep)
    warm(folder)
    assert same(warm(folder), extract(folder))
    assert set(warm.lowered) == set(FILES)


def test_a_summary_is_read_as_it_was_written() -> None:
    made = Creation("a.py#1", "a.py", "A.b", "create_timer", 3, 4, ("a.py#0", 7))
    summary = Summary(
        "0f", 9, 9, "a.py#0", frozenset({"b", ".c"}), frozenset({"b"}), True, frozenset({"main"}), (made,)
    )
    assert SUMMARY.read(loaded(text(SUMMARY.write(summary)))) == summary
