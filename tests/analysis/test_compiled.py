# SPDX-License-Identifier: Apache-2.0
"""Promise: each program in C++ that a package builds is a process, launch files find it, and what nobody builds is not run."""

from __future__ import annotations

import importlib.util
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import pytest

import rosward
from rosward.analysis.attempts import run
from rosward.analysis.read import read_sources
from rosward.engine.budget import Budget
from rosward.network.graph import Network
from rosward.ros.distro import Distro

MANIFEST = "<package format='3'><name>demo</name><version>0.0.0</version><build_type>ament_cmake</build_type></package>"
HEADER = '#include "rclcpp/rclcpp.hpp"\n#include "std_msgs/msg/string.hpp"\n'
MAIN = (
    HEADER
    + """\
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("NAME");
  auto publisher = node->create_publisher<std_msgs::msg::String>("chatter", 10);
  rclcpp::spin(node);
}
"""
)
COMPONENT = (
    HEADER
    + """\
#include "rclcpp_components/register_node_macro.hpp"
namespace demo
{
class Pump : public rclcpp::Node
{
public:
  explicit Pump(const rclcpp::NodeOptions & options) : Node("pump", options)
  {
    publisher_ = create_publisher<std_msgs::msg::String>("level", 10);
  }
private:
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr publisher_;
};
}  // namespace demo
RCLCPP_COMPONENTS_REGISTER_NODE(demo::Pump)
"""
)
LIBRARY = "add_library(pumps SHARED src/pump.cpp)\n"
CONTAINER = """\
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode


def generate_launch_description():
    return LaunchDescription([
        Node(package='demo', executable='talker', name='speaker'),
        ComposableNodeContainer(
            package='rclcpp_components', executable='component_container', name='box', namespace='',
            composable_node_descriptions=[
                ComposableNode(package='demo', plugin='demo::Pump', remappings=[('level', 'water')])]),
    ])
"""


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """An empty package."""
    folder = tmp_path / "demo"
    folder.mkdir()
    (folder / "package.xml").write_text(MANIFEST)
    return folder


def write(folder: Path, cmake: str, sources: Mapping[str, str]) -> Path:
    if cmake:
        (folder / "CMakeLists.txt").write_text(f"project(demo)\nfind_package(rclcpp REQUIRED)\n{cmake}")
    for name, text in sources.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(text)
    return folder


def publishers(network: Network) -> list[str]:
    return sorted(
        f"{node.process}{' (assumed)' * node.assumed}: {entity.name} of {node.fqn}"
        for node in network.nodes
        for entity in node.entities
        if entity.kind.value == "publisher" and not entity.system
    )


def codes(result: rosward.Result) -> list[str]:
    return [f"{f.code} {f.place.file}:{f.place.line}" for f in result.findings if f.code in ("RW009", "RW018", "RW314")]


def test_an_executable(package: Path) -> None:
    sources = {"src/talker.cpp": MAIN, "src/forgotten.cpp": MAIN.replace("NAME", "forgotten")}
    write(package, "add_executable(talker src/talker.cpp)\ninstall(TARGETS talker)\n", sources)
    assert publishers(rosward.extract(package).network) == ["demo/talker: /chatter of /NAME"]


def test_a_component_that_no_executable_makes(package: Path) -> None:
    registered = 'rclcpp_components_register_nodes(pumps "demo::Pump")\n'
    found = rosward.extract(write(package, LIBRARY + registered, {"src/pump.cpp": COMPONENT}))
    assert publishers(found.network) == ["demo/demo::Pump (assumed): /level of /pump"]
    assert rosward.extract(package, assumed=False).network.nodes == ()


def test_a_component_with_its_executable(package: Path) -> None:
    registered = 'rclcpp_components_register_node(pumps PLUGIN "demo::Pump" EXECUTABLE pump_node)\n'
    found = rosward.extract(write(package, LIBRARY + registered, {"src/pump.cpp": COMPONENT}))
    assert publishers(found.network) == ["demo/pump_node: /level of /pump"]


def test_a_component_that_cmake_does_not_know(package: Path) -> None:
    found = rosward.extract(write(package, LIBRARY, {"src/pump.cpp": COMPONENT}))
    assert found.network.nodes == ()
    assert codes(found) == ["RW009 src/pump.cpp:17"]


def test_launch_files_find_programs(package: Path) -> None:
    cmake = LIBRARY + (
        'rclcpp_components_register_nodes(pumps "demo::Pump")\nadd_executable(talker src/talker.cpp)\n'
        "install(TARGETS talker DESTINATION lib/demo)\ninstall(DIRECTORY launch DESTINATION share/demo)\n"
    )
    sources = {"src/pump.cpp": COMPONENT, "src/talker.cpp": MAIN, "launch/all.launch.py": CONTAINER}
    write(package, cmake, sources)
    found = rosward.extract(package, launch="demo:all.launch.py")
    assert publishers(found.network) == [
        "demo/talker: /chatter of /speaker",
        "rclcpp_components/component_container: /water of /pump",
    ]
    assert codes(found) == []


def test_a_source_that_nothing_builds(tmp_path: Path) -> None:
    (tmp_path / "talker.cpp").write_text(MAIN)
    (tmp_path / "no_ros.cpp").write_text("int main() {}")
    expected = ["talker.cpp: /chatter of /NAME"]
    assert publishers(rosward.extract(tmp_path).network) == expected
    assert publishers(rosward.extract(tmp_path / "talker.cpp").network) == expected


def test_a_program_of_two_languages(package: Path) -> None:
    """A process in Python is what it is without C++."""
    script = "import rclpy\nfrom rclpy.node import Node\nrclpy.init()\nnode = Node('script')\nrclpy.spin(node)\n"
    write(package, "add_executable(talker src/talker.cpp)\n", {"src/talker.cpp": MAIN, "scripts/run.py": script})
    assert [node.fqn for node in rosward.extract(package).network.nodes] == ["/NAME", "/script"]


def test_without_the_parser(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "talker.cpp").write_text(MAIN)
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None if name == "tree_sitter_cpp" else name)
    found = rosward.extract(tmp_path)
    assert codes(found) == ["RW018 talker.cpp:0"]
    assert not found.complete


def test_what_has_no_cpp_does_not_load_the_parser(tmp_path: Path) -> None:
    (tmp_path / "talker.py").write_text("import rclpy\n")
    code = f"import sys, rosward; rosward.extract({str(tmp_path)!r}); print([m for m in sys.modules if 'tree_sitter' in m or 'cpp' in m])"
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert ran.stdout.strip() == "[]"


def test_what_was_read_and_what_comments_ask_for(tmp_path: Path) -> None:
    (tmp_path / "names.hpp").write_text("#pragma once\nstd::string unknown();\n")
    text = MAIN.replace('"chatter"', "unknown()").replace(
        '#include "std_msgs', '#include "names.hpp"\n#include "std_msgs'
    )
    (tmp_path / "talker.cpp").write_text(text)
    found = rosward.extract(tmp_path)
    assert (found.network.files, found.network.lines) == (2, 12)
    assert [f.relative for f in found.files] == ["talker.cpp", "names.hpp"]
    assert [f.place.line for f in found.findings if f.code == "RW101"] == [8]


def test_what_no_process_reaches(package: Path) -> None:
    """A method that nothing calls, a branch that is not taken, a plugin that somebody may load."""
    source = HEADER + (
        "struct Lamp : rclcpp::Node {\n"
        '  Lamp() : Node("lamp") { if (false) { create_client<std_srvs::srv::Empty>("off"); } }\n'
        '  void never() { create_publisher<std_msgs::msg::String>("never", 1); }\n'
        "};\n"
        "namespace demo { struct Plugin { void configure(rclcpp::Node & node)\n"
        '  { node.create_subscription<std_msgs::msg::String>("in", 1, [](std_msgs::msg::String::SharedPtr) {}); } }; }\n'
        "PLUGINLIB_EXPORT_CLASS(demo::Plugin, base::Plugin)\n"
        "int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Lamp>()); }\n"
    )
    write(package, "add_executable(lamp lamp.cpp)\n", {"lamp.cpp": source})
    found = rosward.extract(package).findings
    assert [
        f"{f.code} {f.place.line} {f.message.partition(':  ')[0][:40]}" for f in found if f.code in ("RW204", "RW205")
    ] == [
        "RW205 4 no execution reaches this create_client,",
        "RW205 5 Lamp::never is never called: its create_",
        "RW204 8 demo::Plugin::configure is of a plugin, ",
    ]


def test_libraries_that_no_program_is_linked_of(package: Path) -> None:
    """Nothing here runs them; what is loaded as a plugin may run all the same, with what else is in its library."""
    configure = '{ node.create_subscription<std_msgs::msg::String>("in", 1, [](std_msgs::msg::String::SharedPtr) {}); }'
    sources = {
        "src/plugin.cpp": HEADER
        + "namespace demo { struct Plugin { void configure(rclcpp::Node & node)\n"
        + configure
        + " }; }\nPLUGINLIB_EXPORT_CLASS(demo::Plugin, base::Plugin)\n",
        "src/helper.cpp": HEADER
        + "struct Helper { void make(rclcpp::Node & node)\n"
        + "{ b_ = std::make_shared<tf2_ros::TransformBroadcaster>(node);\n"
        + 's_ = rclcpp_action::create_server<demo::action::Go>(node, "go"); } };\n',
        "src/tools.cpp": HEADER + "struct Tools { void make(rclcpp::Node & node)\n" + configure + " };\n",
        "src/quiet.cpp": HEADER + "struct Quiet { int make() { return 1; } };\n",
    }
    cmake = "add_library(plugins SHARED src/plugin.cpp src/helper.cpp)\nadd_library(tools src/tools.cpp)\nadd_library(quiet src/quiet.cpp)\n"
    write(package, cmake, sources)
    result = rosward.extract(package)
    assert [
        f"{f.code} {f.place.file}:{f.place.line} {f.message.partition(',')[0]}"
        for f in result.findings
        if f.code in ("RW204", "RW205")
    ] == [
        "RW204 src/helper.cpp:4 Helper::make is in a library of plugins",
        "RW204 src/helper.cpp:5 Helper::make is in a library of plugins",
        "RW204 src/plugin.cpp:4 demo::Plugin::configure is of a plugin",
        "RW205 src/tools.cpp:4 Tools::make is never called: its create_subscription is not in the result",
    ]
    assert not [f for f in result.findings if f.place.file == "src/quiet.cpp"]


def test_a_result_stands_on_all_files_of_its_program(tmp_path: Path) -> None:
    """The questions of a process have a digest of its program: it changes with a header."""

    def asked() -> list[str]:
        read = read_sources([tmp_path], Distro.JAZZY)
        reads = run(read.library, read.plan.entries[0], Budget()).reads
        assert reads is not None
        return [str(question[2]) for question in reads.questions if question[0] == "program"]

    (tmp_path / "names.hpp").write_text("#define TOPIC 1\n")
    (tmp_path / "talker.cpp").write_text('#include "names.hpp"\n' + MAIN)
    first = asked()
    assert len(first) == 1
    assert asked() == first
    (tmp_path / "names.hpp").write_text("const int topic = 1;\n")
    assert asked() != first
