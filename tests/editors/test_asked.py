# SPDX-License-Identifier: Apache-2.0
"""What an editor asks of a workspace: hover, links, symbols, lenses, completion."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosward.lsp.completion import completions
from rosward.lsp.hover import hover
from rosward.lsp.links import aims, everywhere
from rosward.lsp.state import Shift, State
from rosward.lsp.symbols import lenses, symbols_in, symbols_named

from .desk import DEMO, LAUNCH, TALKER, Desk

CPP = """#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("ear");
  auto sub = node->create_subscription<std_msgs::msg::String>(
    "chatter", 10, [](const std_msgs::msg::String &) {});
  rclcpp::spin(node);
}
"""
CMAKE = """cmake_minimum_required(VERSION 3.8)
project(ears)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
find_package(std_msgs REQUIRED)
add_executable(ear src/ear.cpp)
ament_target_dependencies(ear rclcpp std_msgs)
install(TARGETS ear DESTINATION lib/ears)
ament_package()
"""
SERVICE = """import rclpy
from rclpy.action import ActionClient
from rclpy.node import Node
from std_srvs.srv import Trigger
from example_interfaces.action import Fibonacci

class {name}(Node):
    def __init__(self):
        super().__init__("{node}")
        {makes}

    def on(self, request, response):
        return response

def main():
    rclpy.init()
    rclpy.spin({name}())
"""
POLICY = """<policy version="0.2.0"><enclaves><enclave path="/"><profiles>
  <profile ns="/" node="talker">
    <topics publish="ALLOW">
      <topic>news</topic>
    </topics>
  </profile>
</profiles></enclave></enclaves></policy>
"""
SYSTEM = "launch/demo.launch.xml"


@pytest.fixture(scope="module")
def desk(tmp_path_factory: pytest.TempPathFactory) -> Desk:
    root = tmp_path_factory.mktemp("ws")
    found = Desk(root, {**DEMO, "policy.xml": POLICY})
    found.renew()
    return found


def _files(desk: Desk, at: tuple[str, int, int]) -> list[tuple[str, int]]:
    return [(desk.folder.file(aim.path), aim.extent.line + 1) for aim in aims(desk.state, *at)]


def test_hover_tells_the_name_in_each_system_the_type_and_the_other_end(desk: Desk) -> None:
    text = hover(desk.state.at(*desk.at("demo/talker.py", '"chatter"')))
    assert "**publisher** `/news` · `std_msgs/msg/String`" in text
    assert "depth 10" in text
    assert "subscription of `/listener`" in text
    assert "in `launch/demo.launch.xml`" in text
    assert "/chatter" not in text  # as `ros2 run` starts it: nobody asks for that where a launch file starts it


def test_hover_of_a_parameter_tells_the_value_that_it_is_given(desk: Desk) -> None:
    text = hover(desk.state.at(*desk.at("demo/talker.py", "declare_parameter")))
    assert "`rate` of `/talker` is `7`" in text
    assert "default `5`" in text


def test_hover_of_what_a_launch_file_starts(desk: Desk) -> None:
    text = hover(desk.state.at(*desk.at(SYSTEM, 'exec="talker"')))
    assert "node `/talker`: 1 publisher" in text
    assert "`chatter` is remapped to `/news`" in text


def test_nothing_is_told_where_nothing_is(desk: Desk) -> None:
    assert hover(desk.state.at(*desk.at("demo/talker.py", "import rclpy"))) == ""
    for line, column in ((-1, 0), (10_000, 0), (0, 10_000)):
        assert hover(desk.state.at(desk.path("demo/talker.py"), line, column)) == ""
    assert hover(desk.state.at("/elsewhere/a.py", 0, 0)) == ""


def test_from_one_end_to_the_other_and_back(desk: Desk) -> None:
    assert _files(desk, desk.at("demo/talker.py", '"chatter"')) == [("demo/listener.py", 8)]
    assert _files(desk, desk.at("demo/listener.py", '"chatter"')) == [("demo/talker.py", 9)]
    both = everywhere(desk.state, *desk.at("demo/talker.py", '"chatter"'))
    assert [desk.folder.file(aim.path) for aim in both] == ["demo/listener.py", "demo/talker.py"]


def test_from_a_launch_file_to_the_node_and_back(desk: Desk) -> None:
    assert _files(desk, desk.at(SYSTEM, 'exec="talker"')) == [("demo/talker.py", 7)]
    assert (SYSTEM, 2) in _files(desk, desk.at("demo/talker.py", 'super().__init__("talker")'))


def test_from_a_remapping_to_those_who_have_the_name(desk: Desk) -> None:
    assert _files(desk, desk.at(SYSTEM, "/news")) == [("demo/listener.py", 8), ("demo/talker.py", 9)]


def test_from_a_parameter_to_the_file_that_sets_it_and_back(desk: Desk) -> None:
    assert ("config/demo.yaml", 3) in _files(desk, desk.at("demo/talker.py", "declare_parameter"))
    assert _files(desk, desk.at("config/demo.yaml", "rate")) == [("demo/talker.py", 8)]


def test_from_a_policy_to_those_whom_a_rule_is_about(desk: Desk) -> None:
    assert _files(desk, desk.at("policy.xml", "news")) == [("demo/listener.py", 8), ("demo/talker.py", 9)]


def test_services_and_actions_have_ends_as_well(tmp_path: Path) -> None:
    server = 'self.create_service(Trigger, "go", self.on)'
    client = 'self.create_client(Trigger, "go"); self.act = ActionClient(self, Fibonacci, "count")'
    desk = Desk(
        tmp_path,
        {
            "demo/server.py": SERVICE.format(name="Server", node="server", makes=server),
            "demo/client.py": SERVICE.format(name="Client", node="client", makes=client),
        },
    )
    desk.renew()
    assert _files(desk, desk.at("demo/client.py", '"go"')) == [("demo/server.py", 10)]
    assert _files(desk, desk.at("demo/server.py", '"go"')) == [("demo/client.py", 10)]
    text = hover(desk.state.at(*desk.at("demo/client.py", '"count"')))
    assert "**action client** `/count`" in text
    assert "nobody at the other end of this action" in text
    assert "the sources (`ros2 run`)" in text


def test_cpp_talks_to_python(tmp_path: Path) -> None:
    pytest.importorskip("tree_sitter_cpp")
    desk = Desk(tmp_path, DEMO)
    (tmp_path / "ears/src").mkdir(parents=True)
    (tmp_path / "ears/src/ear.cpp").write_text(CPP)
    (tmp_path / "ears/CMakeLists.txt").write_text(CMAKE)
    (tmp_path / "ears/package.xml").write_text((tmp_path / "package.xml").read_text().replace(">demo<", ">ears<"))
    pkg = tmp_path / "demo_pkg"
    pkg.mkdir()
    for name in ("package.xml", "setup.py", "demo", "launch", "config"):
        (tmp_path / name).rename(pkg / name)
    desk.renew()
    assert ("demo_pkg/demo/talker.py", 9) in _files(desk, desk.at("ears/src/ear.cpp", '"chatter"'))
    assert "**subscription** `/chatter`" in hover(desk.state.at(*desk.at("ears/src/ear.cpp", '"chatter"')))


def test_symbols_of_a_file_and_of_all(desk: Desk) -> None:
    inside = {(s.kind, s.name) for s in symbols_in(desk.state, desk.path("demo/talker.py"))}
    assert inside == {("node", "/talker"), ("parameter", "rate"), ("topic", "/chatter"), ("topic", "/news")}
    started = {(s.kind, s.name) for s in symbols_in(desk.state, desk.path(SYSTEM))}
    assert ("started", "demo/talker") in started
    assert {s.name for _, s in symbols_named(desk.state, "NEW")} == {"/news"}
    assert symbols_named(desk.state, "no such name") == []


def test_lenses_count_the_ends(desk: Desk) -> None:
    titles = [lens.title for lens in lenses(desk.state, desk.path("demo/talker.py"))]
    assert titles == ["/news: 1 publisher, 1 subscription"]
    first = lenses(desk.state, desk.path("demo/talker.py"))[0]
    assert [desk.folder.file(aim.path) for aim in first.aims] == ["demo/listener.py", "demo/talker.py"]
    assert [lens.title for lens in lenses(desk.state, desk.path(SYSTEM))] == [
        "/talker: 1 endpoint",
        "/listener: 1 endpoint",
    ]


def test_names_are_offered_where_a_remapping_is_written(desk: Desk) -> None:
    python = 'Node(package="demo", executable="talker", remappings=[\n    ("cha")\n])\nprint("cha")\n'
    yaml = "launch:\n- node:\n    pkg: demo\n    remap:\n    - from: cha\n      to: x\n    name: cha\n"
    xml = LAUNCH.replace('from="chatter"', 'from=""', 1)
    for name, text, place, where in (
        ("launch/a.launch.py", python, (1, 9), True),
        ("launch/a.launch.py", python, (3, 10), False),
        ("launch/a.launch.yaml", yaml, (4, 14), True),
        ("launch/a.launch.yaml", yaml, (6, 12), False),
        (SYSTEM, xml, (3, 17), True),
        (SYSTEM, xml, (1, 14), False),
        ("demo/talker.py", TALKER, (8, 52), False),
    ):
        desk.open(name, text)
        found = completions(desk.state, desk.path(name), *place)
        assert bool(found) is where, (name, place)
        if found:
            assert {"/news", "/chatter"} <= {offer.name for offer in found}
            assert all(offer.extent.line == place[0] for offer in found)
        desk.state.close(desk.path(name))


def test_places_move_with_what_is_typed_above_them(desk: Desk) -> None:
    desk.open("demo/talker.py", TALKER)
    desk.renew("demo/talker.py")
    desk.open("demo/talker.py", "# one\n# two\n" + TALKER)
    assert "/news" in hover(desk.state.at(*desk.at("demo/talker.py", '"chatter"')))
    assert _files(desk, desk.at("demo/listener.py", '"chatter"')) == [("demo/talker.py", 9)]
    desk.state.close(desk.path("demo/talker.py"))
    desk.renew("demo/talker.py")


def test_while_a_file_is_half_written_what_was_known_is_shown(tmp_path: Path) -> None:
    desk = Desk(tmp_path)
    desk.open("demo/talker.py")
    desk.renew()
    broken = TALKER.replace("def main():", "def main(:")
    desk.open("demo/talker.py", broken)
    desk.renew("demo/talker.py")
    assert [told.code for told in desk.state.findings(desk.path("demo/talker.py"))] == ["RW001"]
    assert "/news" in hover(desk.state.at(*desk.at("demo/talker.py", '"chatter"')))
    desk.open("demo/talker.py", TALKER)
    desk.renew("demo/talker.py")
    assert desk.state.findings(desk.path("demo/talker.py")) == []


def test_lines_before_and_behind_a_change_move_and_the_changed_ones_are_gone() -> None:
    shift = Shift(["a", "b", "c"], ["a", "x", "y", "c"])
    assert [shift.line(n) for n in (1, 2, 3)] == [1, None, 4]
    same = Shift(["a"], ["a"])
    assert same.line(1) == 1
    assert Shift(["a", "a"], ["a"]).line(1) == 1
    assert Shift([""], ["", "", ""]).line(1) == 1


def test_line_ends_of_windows_and_characters_beyond_ascii(tmp_path: Path) -> None:
    text = TALKER.replace("import rclpy\n", "import rclpy  # жук 🐞\n", 1).replace("\n", "\r\n")
    desk = Desk(tmp_path, {**DEMO, "demo/talker.py": text})
    desk.renew()
    assert "/news" in hover(desk.state.at(*desk.at("demo/talker.py", '"chatter"')))
    before = TALKER.replace("        self.pub =", "        self.жук = '🐞'; self.pub =")
    desk.open("demo/talker.py", before)
    desk.renew("demo/talker.py")
    found = desk.state.at(*desk.at("demo/talker.py", '"chatter"'))
    assert before.split("\n")[8][found[0].extent.column :].startswith("self.create_publisher")


def test_text_of_strangers_is_no_markdown(tmp_path: Path) -> None:
    talker = TALKER.replace('"talker"', '"talker"').replace('"rate", 5', '"rate", "`](http://evil) <script>"')
    desk = Desk(tmp_path, {"demo/talker.py": talker})
    desk.renew()
    text = hover(desk.state.at(*desk.at("demo/talker.py", "declare_parameter")))
    assert "`']" in text


def test_the_innermost_folder_has_the_file() -> None:
    state = State()
    state.add_folder("/ws")
    inner = state.add_folder("/ws/inner")
    assert state.folder_of("/ws/inner/a.py") is inner
    assert state.folder_of("/ws2/a.py") is None
