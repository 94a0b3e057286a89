# SPDX-License-Identifier: Apache-2.0
"""A result that is kept is used as long as it would come out again, and no longer: warm and cold are the same, whatever is edited."""

from __future__ import annotations

import random
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from sampling import sample

from cache.running import Running
from rosward import Result, extract
from rosward.cache.codec import loaded, text
from rosward.cache.results import _written as written
from rosward.cache.results import keep_result, kept_result, question_of
from rosward.cache.store import Store
from rosward.cli import main
from rosward.engine.budget import Budget
from rosward.source.disk import watching
from rosward.source.kept import cache_folder

EXAMPLE = Path(__file__).resolve().parent.parent.parent / "examples" / "delivery_robot"

WORKSPACE = {
    "src/demo/package.xml": "<package format='3'><name>demo</name><depend>other</depend></package>",
    "src/demo/setup.py": "from setuptools import setup\nsetup(name='demo', packages=['demo'],\n"
    "    data_files=[('share/demo/config', ['config/names.yaml'])],\n"
    "    entry_points={'console_scripts': ['talker = demo.talker:main', 'listener = demo.listener:main']})\n",
    "src/demo/resource/demo": "",
    "src/demo/config/names.yaml": "topic: chatter\n",
    "src/demo/demo/__init__.py": "",
    "src/demo/demo/names.py": "NAME = 'talker'\n",
    "src/demo/demo/talker.py": "import os\nimport yaml\nimport rclpy\nfrom ament_index_python.packages import get_package_share_directory\n"
    "from rclpy.node import Node\nfrom std_msgs.msg import String\nfrom demo import names\n\n\ndef main():\n"
    "    with open(os.path.join(get_package_share_directory('demo'), 'config', 'names.yaml')) as file:\n"
    "        topic = yaml.safe_load(file)['topic']\n    node = Node(names.NAME)\n    node.create_publisher(String, topic, 10)\n",
    "src/demo/demo/listener.py": "import rclpy\nfrom rclpy.node import Node\nfrom other.msg import Thing\n\n\nclass Listener(Node):\n"
    "    def __init__(self):\n        super().__init__('listener')\n"
    "        self.create_subscription(Thing, self.declare_parameter('topic', 'things').value, print, 10)\n\n\ndef main():\n    Listener()\n",
    "src/other/package.xml": "<package format='3'><name>other</name></package>",
    "src/other/msg/Thing.msg": "string name\n",
    "src/other/CMakeLists.txt": "project(other)\nadd_executable(pump src/pump.cpp)\ninstall(TARGETS pump DESTINATION lib/other)\n",
    "src/other/src/pump.cpp": '#include "rclcpp/rclcpp.hpp"\n#include "name.hpp"\nint main() { auto n = rclcpp::Node::make_shared(NAME); }\n',
    "src/other/src/name.hpp": '#define NAME "pump"\n',
    "src/other/launch/all.launch.py": "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
    "def generate_launch_description():\n    return LaunchDescription([Node(package='demo', executable='talker', name='renamed')])\n",
}


def _write(folder: Path) -> Path:
    for name, content in WORKSPACE.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content, encoding="utf-8")
    return folder


# Edits that somebody may do

CONTENTS = (
    "",
    "NAME = 'other'\n",
    "NAME = 'talker'  # the same\n",
    "import rclpy\nfrom rclpy.node import Node\n\n\ndef main():\n    Node('made')\n\n\nmain()\n",
    "syntax error here(\n",
    "from demo import names\n",
    "topic: other\n",
    "topic: [1, 2]\n",
    '#define NAME "other"\n',
    "string name\nint32 number\n",
    "<package format='3'><name>renamed</name></package>",
)
NEW = (
    "src/demo/rclpy.py",
    "src/demo/yaml/__init__.py",
    "src/demo/demo/names/__init__.py",
    "src/demo/demo/more.py",
    "src/demo/COLCON_IGNORE",
    "src/other/src/rclcpp/rclcpp.hpp",
    "src/third/package.xml",
    "src/third/talker.py",
    "src/demo/launch/more.launch.py",
    "notes.txt",
)


def _edit(folder: Path, rng: random.Random) -> None:
    files = sorted(p for p in folder.rglob("*") if p.is_file())
    kind = rng.choice(("change", "change", "line", "line", "new", "new", "gone", "moved", "linked", "same"))
    path = rng.choice(files)
    if kind == "change":
        path.write_text(rng.choice(CONTENTS), encoding="utf-8")
    elif kind == "line":
        with path.open("a", encoding="utf-8") as file:
            file.write(rng.choice(("# more\n", "\n", "x = 1\n")))
    elif kind == "new":
        made = folder / rng.choice(NEW)
        if not any(p.is_file() for p in made.parents):
            made.parent.mkdir(parents=True, exist_ok=True)
            made.write_text(rng.choice(CONTENTS), encoding="utf-8")
    elif kind == "gone":
        path.unlink()
    elif kind == "moved":
        path.rename(path.with_name(f"moved_{path.name}"))
    elif kind == "linked":
        target = folder / f"target_{rng.random()}{path.suffix}"
        path.rename(target)
        path.symlink_to(target)
    else:
        path.touch()


class Asking:
    """Asks a store first, and counts what has to be computed."""

    def __init__(self, folder: Path) -> None:
        self.store = Store(str(folder))
        self.computed = 0

    def __call__(self, **arguments: Any) -> Result:
        question = question_of(**arguments)
        known = kept_result(self.store, question)
        if known is not None:
            return known
        self.computed += 1
        with watching() as trace:
            found = extract(*arguments["paths"], **{k: v for k, v in arguments.items() if k != "paths"})
        return keep_result(self.store, question, found, trace)


@pytest.mark.parametrize(
    "options", [{}, {"launch": "other:all.launch.py"}, {"budget": Budget(flow=True)}], ids=["all", "launched", "flow"]
)
@pytest.mark.parametrize("seed", sample(range(4), 4))
def test_warm_is_cold(tmp_path: Path, seed: int, options: dict[str, Any]) -> None:
    """After any edits, what is kept is what would come out."""
    rng = random.Random(f"{seed} {sorted(options)}")
    folder, ask = _write(tmp_path / "ws"), Asking(tmp_path / "cache")
    for _ in range(12):
        try:
            cold = extract(folder, **options)
        except Exception as error:  # what is asked for is gone
            with pytest.raises(type(error)):
                ask(paths=(folder,), **options)
        else:
            warm = ask(paths=(folder,), **options)
            assert text(written(warm)) == text(written(cold))
            before = ask.computed
            assert text(written(ask(paths=(folder,), **options))) == text(written(cold))
            assert ask.computed == before
        for _ in range(rng.randint(1, 2)):
            _edit(folder, rng)


def test_another_question_has_another_answer(tmp_path: Path) -> None:
    folder, ask = _write(tmp_path / "ws"), Asking(tmp_path / "cache")
    asked: list[dict[str, Any]] = [
        {},
        {"distro": "humble"},
        {"tests": True},
        {"env": {"A": "1"}},
        {"env": {"A": "2"}},
        {"budget": Budget(steps=10)},
        {"exclude": ["x"]},
    ]
    for number, options in enumerate(asked, 1):
        ask(paths=(folder,), **options)
        assert ask.computed == number


def test_the_answer_to_another_question_is_none(tmp_path: Path) -> None:
    """Somebody has put an entry in the place of another."""
    folder, ask = _write(tmp_path / "ws"), Asking(tmp_path / "cache")
    ask(paths=(folder,))
    (entry,) = [p for p in (tmp_path / "cache").rglob("*") if p.is_file()]
    ask(paths=(folder,), tests=True)
    (other,) = [p for p in (tmp_path / "cache").rglob("*") if p.is_file() and p.parent != entry.parent]
    shutil.copy(entry, other)
    ask(paths=(folder,), tests=True)
    assert ask.computed == 3


@pytest.mark.parametrize(
    "forged",
    [
        b"",
        b"\n",
        b"\n\n",
        b"{}\n[]",
        b"{}\n{}",
        b'{}\n["/", null, [], [], [0, 0, 0]]',
        b'{"kind": []}\n[]',
        b"[" * 100_000,
        b"cos\nsystem\n(S'true'\ntR.",
    ],
)
def test_a_forged_answer_is_computed_again(tmp_path: Path, forged: bytes) -> None:
    from rosward.source.disk import digest

    folder, ask = _write(tmp_path / "ws"), Asking(tmp_path / "cache")
    question = question_of(paths=(folder,))
    ask.store.keep("result", question, digest(question).encode() + b"\n" + forged)
    assert text(written(ask(paths=(folder,)))) == text(written(extract(folder)))
    assert ask.computed == 1


def test_what_the_machine_decides_is_not_kept(tmp_path: Path) -> None:
    folder, ask = _write(tmp_path / "ws"), Asking(tmp_path / "cache")
    looping = "".join(f"    x{n} = [i for i in range(300)]\n" for n in range(400))
    (folder / "src/demo/demo/names.py").write_text(f"NAME = 'a'\n\n\ndef f():\n{looping}\n\nf()\n", encoding="utf-8")
    options = {"budget": Budget(seconds=0.0)}
    assert any("s of analysis" in f.message for f in ask(paths=(folder,), **options).findings)
    ask(paths=(folder,), **options)
    assert ask.computed == 2


# Processes alone


@pytest.mark.parametrize("flow", [False, True])
@pytest.mark.parametrize("seed", sample(range(5), 4))
def test_what_is_known_of_processes_is_what_they_would_add(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, seed: int, flow: bool
) -> None:
    rng = random.Random(f"processes {seed} {flow}")
    folder, warm = _write(tmp_path / "ws"), Running(Store(str(tmp_path / "cache")), monkeypatch)
    budget = Budget(flow=flow)
    for _ in range(12):
        cold = extract(folder, budget=budget)
        assert text(written(warm(folder, budget=budget))) == text(written(cold))
        assert text(written(warm(folder, budget=budget))) == text(written(cold))
        assert warm.ran == []
        for _ in range(rng.randint(1, 2)):
            _edit(folder, rng)


def test_only_what_reads_a_changed_file_runs_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder, warm = _write(tmp_path / "ws"), Running(Store(str(tmp_path / "cache")), monkeypatch)
    warm(folder)
    assert warm.ran == ["demo/listener", "demo/talker", "other/pump"]
    for file, more, again in (
        ("src/demo/demo/names.py", "# more\n", ["demo/talker"]),
        ("src/demo/demo/listener.py", "# more\n", ["demo/listener"]),
        ("src/demo/config/names.yaml", "# more\n", ["demo/talker"]),
        ("src/other/msg/Thing.msg", "int32 number\n", ["demo/listener"]),
        ("src/other/src/name.hpp", "// more\n", ["other/pump"]),
        ("src/demo/package.xml", "<!-- more -->\n", []),
    ):
        with (folder / file).open("a", encoding="utf-8") as opened:
            opened.write(more)
        found = warm(folder)
        assert warm.ran == again, file
        assert text(written(found)) == text(written(extract(folder))), file
        warm(folder)
        assert warm.ran == []


def test_what_would_now_be_found_runs_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A file that was looked for in vain is there."""
    folder, warm = _write(tmp_path / "ws"), Running(Store(str(tmp_path / "cache")), monkeypatch)
    (folder / "src/demo/demo/talker.py").write_text(
        "import rclpy\n\n\ndef main():\n    try:\n        from demo import special\n        name = special.NAME\n"
        "    except ImportError:\n        name = 'usual'\n    rclpy.create_node(name)\n",
        encoding="utf-8",
    )
    assert "/usual" in {n.fqn for n in warm(folder).network.nodes}
    (folder / "src/demo/demo/special.py").write_text("NAME = 'special'\n", encoding="utf-8")
    assert "/special" in {n.fqn for n in warm(folder).network.nodes}
    assert "demo/talker" in warm.ran
    assert "demo/listener" not in warm.ran
    (folder / "src/demo/demo/special.py").unlink()
    assert "/usual" in {n.fqn for n in warm(folder).network.nodes}
    assert "demo/talker" not in warm.ran  # it was so before


@pytest.mark.parametrize(
    "question",
    [
        ["read"],
        ["module"],
        ["find", 1, 2, 3, 4],
        ["__class__"],
        ["find", 1, "b", 3],
        ["listing", 1, 2],
        ["read", "demo", "../../../../etc/passwd"],
    ],
    ids=str,
)
def test_a_question_that_has_no_meaning_is_not_answered(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, question: list[Any]
) -> None:
    """Somebody has written the questions of an entry: it is no entry."""
    folder, warm = _write(tmp_path / "ws"), Running(Store(str(tmp_path / "cache")), monkeypatch)
    kept = Store.keep

    def forged(store: Store, kind: str, asked: bytes, answer: bytes) -> None:
        head, _, rest = answer.partition(b"\n")
        if kind == "process":
            kept(store, kind, asked, text([*loaded(head)[:2], [question]]) + b"\n" + rest)

    with monkeypatch.context() as patch:
        patch.setattr(Store, "keep", forged)
        whole = warm(folder)
    assert text(written(warm(folder))) == text(written(whole))
    assert len(warm.ran) == 3


# The command line


def _outputs(folder: Path) -> dict[str, bytes]:
    return {p.relative_to(folder).as_posix(): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


def _used(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROSWARD_CACHE", str(folder))
    monkeypatch.setattr("rosward.cli.kept.results_folder", cache_folder)


def _is_run(monkeypatch: pytest.MonkeyPatch) -> Callable[[], int]:
    from rosward import pipeline

    calls: list[object] = []
    real = pipeline.extract

    def counted(*paths: Any, **options: Any) -> Result:
        calls.append(paths)
        return real(*paths, **options)

    monkeypatch.setattr("rosward.pipeline.extract", counted)
    return lambda: len(calls)


@pytest.mark.slow
def test_a_command_says_the_same_again(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    _used(tmp_path / "cache", monkeypatch)
    runs = _is_run(monkeypatch)
    formats = "json,policy,permissions,dot,mermaid,svg,html,sarif,junit"
    said: list[tuple[int, str, dict[str, bytes]]] = []
    for folder in ("cold", "warm"):
        command = ["extract", str(EXAMPLE), "--format", formats, "-o", str(tmp_path / "out"), "-v"]
        status = main(command)
        said.append((status, capsys.readouterr().out, _outputs(tmp_path / "out")))
        (tmp_path / "out").rename(tmp_path / folder)
    assert said[0] == said[1]
    assert runs() == 1
    assert main(["extract", str(EXAMPLE), "--format", "none", "-q", "--no-cache"]) == said[0][0]
    assert runs() == 2


def test_commands_share_what_they_found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    _used(tmp_path / "cache", monkeypatch)
    runs = _is_run(monkeypatch)
    main(["list", "topics", str(EXAMPLE)])
    main(["list", "nodes", str(EXAMPLE)])
    main(["explain", "/rosout", str(EXAMPLE)])
    assert runs() == 1


def test_no_cache_is_written_where_none_is_wanted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    _used(tmp_path / "cache", monkeypatch)
    main(["list", "topics", str(EXAMPLE), "--no-cache"])
    assert not list((tmp_path / "cache").glob("results-*"))
