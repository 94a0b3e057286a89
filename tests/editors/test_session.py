# SPDX-License-Identifier: Apache-2.0
"""What is analysed again after a change: no more than what reads it, and with the same result as if everything were."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from rosward.engine.sources.remembered import Lowered, Memory
from rosward.lsp.records import MalformedError, View, read, written
from rosward.lsp.session import Session, Settings

from .desk import DEMO, LAUNCH, LISTENER, TALKER, Desk

OTHER = """<launch><node pkg="demo" exec="listener"/></launch>
"""
HELPER = "NAME = 'said'\n"
USES = TALKER.replace("from rclpy.node", "from demo.names import NAME\nfrom rclpy.node").replace('"chatter"', "NAME")


@pytest.fixture
def desk(tmp_path: Path) -> Desk:
    return Desk(tmp_path, {**DEMO, "launch/other.launch.xml": OTHER})


def test_at_first_everything_then_what_reads_the_file(desk: Desk) -> None:
    assert desk.renew() == ["", "launch/demo.launch.xml", "launch/other.launch.xml"]
    before = desk.session.memory.ran
    desk.open("demo/talker.py", TALKER.replace("chatter", "chat"))
    assert desk.renew("demo/talker.py") == ["", "launch/demo.launch.xml"]
    assert desk.session.memory.ran - before == 2  # the talker as `ros2 run` starts it, and as the launch file does


def test_nothing_runs_again_where_nothing_has_changed(desk: Desk) -> None:
    desk.renew()
    before = desk.session.memory.ran
    desk.renew(everything=True)
    assert desk.session.memory.ran == before


def test_a_module_is_read_by_those_who_import_it(tmp_path: Path) -> None:
    desk = Desk(tmp_path, {**DEMO, "demo/talker.py": USES, "demo/names.py": HELPER, "launch/other.launch.xml": OTHER})
    desk.renew()
    desk.open("demo/names.py", "NAME = 'shouted'\n")
    assert desk.renew("demo/names.py") == ["", "launch/demo.launch.xml"]
    assert "/shouted" in {end.name for node in _view(desk, "").nodes for end in node.ends}


def test_a_launch_file_and_a_parameter_file_belong_to_what_reads_them(desk: Desk) -> None:
    desk.renew()
    desk.open("launch/demo.launch.xml", LAUNCH.replace("/news", "/olds"))
    assert desk.renew("launch/demo.launch.xml") == ["", "launch/demo.launch.xml"]
    desk.open("config/demo.yaml", "/**:\n  ros__parameters:\n    rate: 9\n")
    assert desk.renew("config/demo.yaml") == ["", "launch/demo.launch.xml"]
    settings = [s for node in _view(desk, "launch/demo.launch.xml").nodes for s in node.settings if s.name == "rate"]
    assert [s.value for s in settings] == ["9"]


def test_a_new_file_and_a_description_may_change_anything(desk: Desk) -> None:
    desk.renew()
    (desk.root / "launch/more.launch.xml").write_text(OTHER)
    assert len(desk.renew("launch/more.launch.xml")) == 4
    assert len(desk.renew("setup.py")) == 4


def test_typing_into_a_file_that_nobody_reads_concerns_nobody(desk: Desk) -> None:
    desk.renew()
    desk.open("config/demo.yaml", "a: 1\n")
    (desk.root / "notes.yaml").write_text("b: 1\n")
    desk.open("notes.yaml", "b: 2\n")
    assert len(desk.renew("notes.yaml")) == 3  # it was not there before
    desk.open("notes.yaml", "b: 3\n")
    assert desk.renew("notes.yaml") == [""]


def test_with_models_of_the_user_nothing_is_remembered(tmp_path: Path) -> None:
    models = tmp_path / "models"
    models.mkdir()
    stub = '# SPDX-License-Identifier: Apache-2.0\n"""A library."""\nNAME = \'one\'\n'
    (models / "lib.pyi").write_text(stub)
    desk = Desk(tmp_path / "ws", {"demo/talker.py": USES.replace("demo.names", "lib")})
    desk.session = Session(Settings(str(desk.root), models=(str(models),)))
    desk.renew()
    assert "/one" in _names(desk)
    (models / "lib.pyi").write_text(stub.replace("one", "two"))
    desk.renew(everything=True)
    assert "/two" in _names(desk)


def test_text_of_an_editor_stands_over_the_file_until_it_is_closed(desk: Desk) -> None:
    desk.open("demo/talker.py", TALKER.replace("chatter", "unsaved"))
    desk.renew()
    assert "/unsaved" in _names(desk)
    desk.state.close(desk.path("demo/talker.py"))
    desk.renew("demo/talker.py")
    assert "/unsaved" not in _names(desk)


def test_after_any_edits_the_result_is_that_of_a_new_session(tmp_path: Path) -> None:
    """Typed at random, with halves of statements and removed lines: what is remembered changes nothing."""
    chance = random.Random(5)
    files = {**DEMO, "demo/talker.py": USES, "demo/names.py": HELPER, "launch/other.launch.xml": OTHER}
    desk = Desk(tmp_path, files)
    desk.renew()
    texts = {name: text for name, text in files.items() if "/" in name}
    for _ in range(12):
        name = chance.choice(sorted(texts))
        lines = texts[name].split("\n")
        at = chance.randrange(len(lines))
        kind = chance.randrange(4)
        if kind == 0:
            lines.insert(at, chance.choice(["", "# a comment", "x = (", "    pass"]))
        elif kind == 1:
            del lines[at]
        elif kind == 2:
            lines[at] = lines[at].replace("chatter", f"chatter{chance.randrange(3)}").replace("said", "told")
        else:
            lines = files[name].split("\n")
        texts[name] = "\n".join(lines)
        desk.open(name, texts[name])
        desk.renew(name)
        new = Desk(tmp_path, {})
        new.state = desk.state
        new.folder = desk.folder
        kept = _written(desk)
        new.renew()
        assert kept == _written(new), (name, texts[name])


def test_what_is_kept_does_not_grow_with_edits(desk: Desk) -> None:
    desk.renew()
    sizes = []
    for number in range(40):
        desk.open("demo/talker.py", TALKER.replace("chatter", f"chatter{number}"))
        desk.open("launch/demo.launch.xml", LAUNCH.replace("/news", f"/news{number}"))
        desk.renew("demo/talker.py", "launch/demo.launch.xml")
        sizes.append((len(desk.session.memory), len(desk.folder.based), len(desk.state.documents)))
    assert sizes[-1] == sizes[3]


def test_an_empty_folder_has_no_views(tmp_path: Path) -> None:
    desk = Desk(tmp_path, {})
    assert desk.renew() == []
    (tmp_path / "a.py").write_text(LISTENER)
    assert desk.renew("a.py") == [""]
    (tmp_path / "a.py").unlink()
    assert desk.renew("a.py") == []
    assert not desk.folder.based


def test_work_that_is_ended_halfway_is_done_the_next_time(desk: Desk) -> None:
    class Ended(BaseException):
        pass

    def end(what: str, done: int, _all: int) -> None:
        if what == "analysing" and done:
            raise Ended

    with pytest.raises(Ended):
        desk.session.renew({}, None, lambda _view: None, end)
    assert len(desk.renew()) == 3
    assert "/chatter" in _names(desk)


def test_a_launch_file_that_cannot_be_read_ends_nothing(desk: Desk) -> None:
    desk.open("launch/demo.launch.xml", "<launch><node")
    assert len(desk.renew()) == 3
    assert any(told.place.file == "launch/demo.launch.xml" for told in _view(desk, "launch/demo.launch.xml").findings)


def test_a_memory_forgets_what_is_of_no_use() -> None:
    memory = Memory()
    lowered = Lowered(None, (), 1)
    assert memory.lowered("a.py", "x", lambda: lowered) is lowered
    assert memory.lowered("a.py", "x", lambda: pytest.fail("known")) is lowered
    assert len(memory) == 1
    memory.sources_changed()
    memory.keep_only(())
    assert len(memory) == 0


def test_records_are_read_as_they_were_written_and_nothing_else_is(desk: Desk) -> None:
    import json

    desk.renew()
    for based in desk.folder.based.values():
        view = based.marks.view
        assert read(View, json.loads(written(view))) == view
    odd: list[object] = [
        None,
        [],
        {},
        "x",
        [1] * 7,
        ["", "launch", [[]], [], [], [], []],
        ["", "", [], [], [], ["a", 1], []],
    ]
    for wrong in odd:
        with pytest.raises(MalformedError):
            read(View, wrong)


def _view(desk: Desk, name: str) -> View:
    return desk.folder.based[0, name].marks.view


def _names(desk: Desk) -> set[str]:
    return {end.name for based in desk.folder.based.values() for node in based.marks.view.nodes for end in node.ends}


def _written(desk: Desk) -> list[str]:
    """What was told last of each view, whatever was kept of before for those who ask."""
    found: list[str] = []

    def tell(view: View) -> None:
        found.append(written(view))

    texts = {path: document.text.encode() for path, document in desk.state.documents.items()}
    desk.session.renew(texts, None, tell, lambda *_: None)
    return found
