# SPDX-License-Identifier: Apache-2.0
"""A name is renamed at each literal that makes it, or nowhere; and after the edits the system is what was asked for."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosward.lsp.rename import Edit, RefusedError, rename, renamed_at

from .desk import DEMO, LAUNCH, LISTENER, PARAMETERS, TALKER, Desk

SYSTEM = "launch/demo.launch.xml"
PLAIN = LAUNCH.replace('    <remap from="chatter" to="/news"/>\n', "")
BY_PARAMETER = TALKER.replace('"chatter"', "self.declare_parameter('topic', 'chatter').value")
OF_THE_SHELL = "__import__('os').environ['TOPIC']"
TWO = LISTENER.replace("self.create", "self.create_publisher(String, 'taken', 1); self.create")
IN_NAMESPACES = """<launch>
  <node pkg="demo" exec="talker" namespace="a"/>
  <node pkg="demo" exec="listener" namespace="a"/>
  <node pkg="demo" exec="talker" namespace="b"/>
</launch>
"""


def _desk(root: Path, **files: str) -> Desk:
    names = {"talker": "demo/talker.py", "listener": "demo/listener.py", "launch": SYSTEM, "config": "config/demo.yaml"}
    desk = Desk(root, {**DEMO, **{names[key]: text for key, text in files.items()}})
    desk.renew()
    return desk


def _renamed(desk: Desk, name: str, text: str, new: str) -> set[str]:
    """Carry a renaming out; the names of topics that there are then, in all views."""
    edits = rename(desk.state, *desk.at(name, text), new)
    files = {edit.path for edit in edits}
    for path in files:
        lines = desk.state.lines(path)
        for edit in sorted((e for e in edits if e.path == path), reverse=True):
            line = lines[edit.extent.line]
            lines[edit.extent.line] = line[: edit.extent.column] + edit.text + line[edit.extent.end_column :]
        Path(path).write_text("\n".join(lines))
    desk.renew(*(desk.folder.file(path) for path in files))
    return {e.name for b in desk.folder.based.values() for n in b.marks.view.nodes for e in n.ends}


def _shown(desk: Desk, edits: list[Edit]) -> list[tuple[str, int, str]]:
    return [(desk.folder.file(edit.path), edit.extent.line + 1, edit.text) for edit in edits]


def test_both_ends_in_the_code(tmp_path: Path) -> None:
    desk = _desk(tmp_path, launch=PLAIN)
    edits = rename(desk.state, *desk.at("demo/talker.py", '"chatter"'), "news/all")
    assert _shown(desk, edits) == [("demo/listener.py", 8, "news/all"), ("demo/talker.py", 9, "news/all")]
    assert _renamed(desk, "demo/talker.py", '"chatter"', "news/all") == {"/news/all"}


def test_the_target_of_remappings_in_the_launch_file_alone(tmp_path: Path) -> None:
    desk = _desk(tmp_path)
    edits = rename(desk.state, *desk.at(SYSTEM, "/news"), "/olds")
    assert _shown(desk, edits) == [(SYSTEM, 4, "/olds"), (SYSTEM, 7, "/olds")]
    assert _renamed(desk, SYSTEM, "/news", "/olds") == {"/chatter", "/olds"}


def test_a_name_in_the_code_that_is_remapped_is_renamed_in_the_remapping_too(tmp_path: Path) -> None:
    desk = _desk(tmp_path)
    edits = rename(desk.state, *desk.at("demo/talker.py", '"chatter"'), "talk")
    assert sorted(_shown(desk, edits)) == [
        ("demo/listener.py", 8, "talk"),
        ("demo/talker.py", 9, "talk"),
        (SYSTEM, 4, "talk"),
        (SYSTEM, 7, "talk"),
    ]
    assert _renamed(desk, "demo/talker.py", '"chatter"', "talk") == {"/talk", "/news"}


def test_a_name_from_a_parameter_file_and_its_default(tmp_path: Path) -> None:
    config = PARAMETERS + "    topic: 'news'\n"
    listener = LISTENER.replace('"chatter"', '"/news"')
    desk = _desk(tmp_path, talker=BY_PARAMETER, listener=listener, launch=PLAIN, config=config)
    edits = rename(desk.state, *desk.at("config/demo.yaml", "'news'"), "olds")
    assert _shown(desk, edits) == [("config/demo.yaml", 4, "olds"), ("demo/listener.py", 8, "/olds")]
    assert _renamed(desk, "config/demo.yaml", "'news'", "olds") == {"/chatter", "/olds"}


def test_a_program_that_is_started_twice_takes_all_its_names_along(tmp_path: Path) -> None:
    desk = _desk(tmp_path, launch=IN_NAMESPACES)
    assert _renamed(desk, "demo/talker.py", '"chatter"', "news") == {"/news", "/a/news", "/b/news"}


def test_a_literal_that_only_looks_like_a_name_is_left_alone(tmp_path: Path) -> None:
    talker = TALKER.replace("self.pub =", 'self.text = "chatter"  # chatter\n        self.pub =')
    desk = _desk(tmp_path, talker=talker, launch=PLAIN)
    edits = rename(desk.state, *desk.at("demo/listener.py", '"chatter"'), "news")
    assert _shown(desk, edits) == [("demo/listener.py", 8, "news"), ("demo/talker.py", 10, "news")]
    assert renamed_at(desk.state, *desk.at("demo/talker.py", '= "chatter"')) is None


@pytest.mark.parametrize(
    ("files", "place", "new", "why"),
    [
        ({"listener": LISTENER.replace('"chatter"', '"chat" + "ter"')}, "demo/listener.py:8", "news", "as one literal"),
        ({"listener": LISTENER.replace('"chatter"', "f'{self.get_name()[0]}chatter'[1:]")}, "demo/listener.py:8", "news", "not"),
        ({"listener": LISTENER.replace('"chatter"', OF_THE_SHELL)}, "demo/listener.py:8", "news", "not known"),
        ({"listener": TWO}, "demo/listener.py:8", "taken", "already"),
        ({}, "demo/talker.py", "a b", "no name"),
        ({}, "demo/talker.py", "*", "no name"),
        ({}, "demo/talker.py", "", "no name"),
        ({}, "demo/talker.py", "chatter", "already"),
    ],
)  # fmt: skip
def test_what_stands_in_the_way_is_told_with_its_place(
    tmp_path: Path, files: dict[str, str], place: str, new: str, why: str
) -> None:
    desk = _desk(tmp_path, launch=PLAIN, **files)
    with pytest.raises(RefusedError) as refused:
        rename(desk.state, *desk.at("demo/talker.py", '"chatter"'), new)
    assert why in str(refused.value)
    assert ":" not in place or str(refused.value).startswith(place)


def test_a_new_name_that_would_be_remapped_is_refused(tmp_path: Path) -> None:
    launch = PLAIN.replace('exec="listener">', 'exec="listener"><remap from="news" to="x"/>')
    desk = _desk(tmp_path, launch=launch)
    with pytest.raises(RefusedError, match=r"^launch/demo.launch.xml:5: /news is remapped here"):
        rename(desk.state, *desk.at("demo/talker.py", '"chatter"'), "news")


def test_nothing_is_renamed_where_nothing_is_named(tmp_path: Path) -> None:
    desk = _desk(tmp_path)
    for name, text in (("demo/talker.py", '"talker"'), ("demo/talker.py", "import rclpy"), (SYSTEM, 'exec="talker"')):
        assert renamed_at(desk.state, *desk.at(name, text)) is None
        with pytest.raises(RefusedError):
            rename(desk.state, *desk.at(name, text), "x")
    with pytest.raises(RefusedError):
        rename(desk.state, "/elsewhere/a.py", 0, 0, "x")
