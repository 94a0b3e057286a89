# SPDX-License-Identifier: Apache-2.0
"""Promise: a program in C++ is linked again only where one of its files may be another; what is told of it is the same all the same."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from rosward import Result, extract
from rosward.analysis.compiled import Compiled, Planned
from rosward.cache.results import _written as written
from rosward.cache.store import Store
from rosward.engine.sources.remembered import Memory, remembering
from rosward.frontends.cpp.symbols import CppSymbols
from rosward.source.disk import watching

PACKAGE = "<package format='3'><name>demo</name><version>0.0.0</version><build_type>ament_cmake</build_type></package>"
NODE = '#include "rclcpp/rclcpp.hpp"\n#include "std_msgs/msg/string.hpp"\n'
MAKES = 'n->create_publisher<std_msgs::msg::String>("{}", 1);'
FILES = {
    "demo/package.xml": PACKAGE,
    "demo/CMakeLists.txt": "project(demo)\ninclude_directories(include)\nadd_executable(pump src/pump.cpp)\n"
    "install(TARGETS pump DESTINATION lib/demo)\nadd_library(lamp SHARED src/lamp.cpp)\n"
    'rclcpp_components_register_node(lamp PLUGIN "demo::Lamp" EXECUTABLE lamp_node)\n'
    'rclcpp_components_register_nodes(lamp "demo::Spare")\ninstall(TARGETS lamp DESTINATION lib)\n',
    "demo/include/name.hpp": '#pragma once\n#define NAME "pump"\n',
    "demo/src/pump.cpp": f'{NODE}#include "name.hpp"\nvoid never(rclcpp::Node * n) {{ {MAKES.format("never")} }}\n'
    f"int main(int argc, char ** argv) {{ rclcpp::init(argc, argv); auto n = rclcpp::Node::make_shared(NAME); {MAKES.format('level')} }}\n",
    "demo/src/lamp.cpp": f"{NODE}namespace demo {{\n"
    'class Lamp : public rclcpp::Node {\npublic:\n  explicit Lamp(const rclcpp::NodeOptions & o) : Node("lamp", o) {}\n'
    '  void later() { create_publisher<std_msgs::msg::String>("later", 1); }\n};\n'
    'class Spare : public rclcpp::Node {\npublic:\n  explicit Spare(const rclcpp::NodeOptions & o) : Node("spare", o) {}\n};\n}\n'
    "RCLCPP_COMPONENTS_REGISTER_NODE(demo::Lamp)\nRCLCPP_COMPONENTS_REGISTER_NODE(demo::Missing)\n",
    "talker.py": "import rclpy\nrclpy.create_node('talker')\n",
}
LOADER = (
    '#include "rclcpp/rclcpp.hpp"\n#include "pluginlib/class_loader.hpp"\n'
    'int main(int argc, char ** argv) { rclcpp::init(argc, argv); auto n = rclcpp::Node::make_shared("loader"); }\n'
)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name, content in FILES.items():
        file = tmp_path / "ws" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(content, encoding="utf-8")
    return tmp_path / "ws"


@pytest.fixture
def linked(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The programs that were linked so far."""
    names: list[str] = []
    real = Compiled._link

    def noted(self: Compiled, planned: Planned) -> CppSymbols | None:
        names.append(planned.entry.program)
        return real(self, planned)

    monkeypatch.setattr(Compiled, "_link", noted)
    return names


@pytest.fixture
def warm(folder: Path, linked: list[str], tmp_path: Path) -> Callable[[], Result]:
    """Extracts with a store, after which `linked` has the programs of this extraction alone; it says what one without a store says."""
    store = Store(str(tmp_path / "store"))

    def analysed() -> Result:
        cold = extract(folder)
        linked.clear()
        with watching():
            found = extract(folder, store=store)
        assert written(found) == written(cold)
        return found

    return analysed


def test_only_another_program_is_linked(folder: Path, linked: list[str], warm: Callable[[], Result]) -> None:
    found = warm()
    assert {f.code for f in found.findings} >= {"RW205", "RW009"}
    assert set(linked) >= {"demo/pump", "demo/demo::Lamp"}
    warm()
    assert linked == []
    (folder / "talker.py").write_text("import rclpy\nrclpy.create_node('other')\n")
    assert "/other" in {node.fqn for node in warm().network.nodes}
    assert linked == []
    (folder / "demo/include/name.hpp").write_text('#define NAME "well"\n')
    assert "/well" in {node.fqn for node in warm().network.nodes}
    assert "demo/pump" in linked
    warm()
    assert linked == []


@pytest.mark.parametrize(
    ("file", "text"),
    [
        ("demo/src/name.hpp", '#define NAME "nearer"\n'),
        ("demo/CMakeLists.txt", FILES["demo/CMakeLists.txt"] + 'target_compile_definitions(pump PRIVATE MORE="1")\n'),
        ("demo/src/lamp.cpp", FILES["demo/src/lamp.cpp"].replace("void later()", "void afterwards()")),
    ],
)
def test_what_makes_it_another_is_seen(
    folder: Path, linked: list[str], warm: Callable[[], Result], file: str, text: str
) -> None:
    warm()
    (folder / file).write_text(text)
    warm()
    assert linked
    warm()
    assert linked == []


def test_which_plugins_there_are_is_asked_again(folder: Path, linked: list[str], warm: Callable[[], Result]) -> None:
    (folder / "demo/src/pump.cpp").write_text(LOADER)
    (folder / "demo/plugins.xml").write_text(
        "<library path='lamp'><class type='demo::Lamp' base_class_type='x::Y'/></library>"
    )
    cmake = folder / "demo/CMakeLists.txt"
    cmake.write_text(cmake.read_text() + "pluginlib_export_plugin_description_file(x plugins.xml)\n")
    warm()
    warm()
    assert linked == []
    (folder / "demo/plugins.xml").write_text("<library path='lamp'><class")
    warm()


@pytest.mark.parametrize(
    "forged",
    [
        lambda _: b"",
        lambda _: b"nonsense",
        lambda answer: answer.partition(b"\n")[0] + b"\n[]",
        lambda answer: answer.partition(b"\n")[0] + b"\n[[1,{},{}],{}]",
        lambda answer: b"0" * 40 + b"\n" + answer.partition(b"\n")[2],
        lambda answer: answer.replace(b'"demo/pump":[', b'"demo/pump":[0,'),
    ],
)
def test_a_forged_entry_says_nothing(
    folder: Path,
    linked: list[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    forged: Callable[[bytes], bytes],
) -> None:
    store = Store(str(tmp_path / "store"))
    real = store.keep

    def keep(kind: str, question: bytes, answer: bytes) -> None:
        real(kind, question, forged(answer) if kind == "programs" else answer)

    monkeypatch.setattr(store, "keep", keep)
    with watching():
        extract(folder, store=store)
    linked.clear()
    with watching():
        found = extract(folder, store=store)
    assert "demo/pump" in linked
    assert written(found) == written(extract(folder))


def test_nothing_is_kept_of_two_states(folder: Path, linked: list[str], tmp_path: Path) -> None:
    store = Store(str(tmp_path / "store"))
    extract(folder, store=store)  # nobody watches: it may be two
    linked.clear()
    with watching():
        extract(folder, store=store)
    assert "demo/pump" in linked


def test_an_editor_links_what_has_changed(folder: Path, linked: list[str]) -> None:
    memory = Memory()

    def again() -> Result:
        linked.clear()
        memory.sources_changed()
        with remembering(memory):
            return extract(folder)

    again()
    assert linked
    (folder / "talker.py").write_text("import rclpy\nrclpy.create_node('other')\n")
    found = again()
    assert linked == []
    assert written(found) == written(extract(folder))
    pump = folder / "demo/src/pump.cpp"
    for number in range(5):
        pump.write_text(f'{FILES["demo/src/pump.cpp"]}#include "more{number}.hpp"\n')
        again()
    kept = memory.programs
    again()
    assert linked == []
    assert memory.programs is kept
    assert not any("more0" in path for path in kept.asked.files)  # type: ignore[attr-defined]
