# SPDX-License-Identifier: Apache-2.0
"""Two starts that a program cannot tell from each other are one."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosward.analysis import launched
from rosward.analysis.process import Run, run
from rosward.deployment.alike import renumbered, what_it_sees
from rosward.deployment.request import LaunchRequest, Request
from rosward.domain.choice import join
from rosward.domain.values import Const
from rosward.effects.configuration import Configuration, Given
from rosward.pipeline import extract

RATE = (Given("/**", "rate", Const(10)),)
OTHER = (Given("/**", "rate", Const(20)),)


def started(*numbers: int, content: tuple[Given, ...] | None = RATE) -> Configuration:
    """A program that is given files that launch wrote as its first, second, …"""
    names = [f"/tmp/launch_params_{number}" for number in numbers]
    words = [Const(word) for name in names for word in ("--params-file", name)]
    return Configuration(words=(Const("--ros-args"), *words), files=dict.fromkeys(names, content))


def test_files_that_launch_wrote_are_numbered_by_who_reads_them() -> None:
    """The second and the seventh file of two launches; the order counts, and the content."""
    one, other = renumbered(started(2)), renumbered(started(7))
    assert one.words == other.words == started(1).words
    assert what_it_sees(one, process=True) == what_it_sees(other, process=True)
    assert renumbered(started(9, 4)).words == started(1, 2).words
    changed = renumbered(started(2, content=OTHER))
    assert what_it_sees(one, process=True) != what_it_sees(changed, process=True)


def test_a_file_keeps_a_name_by_which_it_is_told() -> None:
    """One of unknown content, one that is no file of launch, and one of several."""
    unknown = started(3, content=None)
    assert renumbered(unknown) is unknown
    plain = Configuration(words=(Const("--params-file"), Const("/etc/a.yaml")), files={"/etc/a.yaml": RATE})
    assert renumbered(plain) is plain
    either = join(Const("/tmp/launch_params_2"), Const("/tmp/launch_params_3"))
    several = Configuration(
        words=(Const("--params-file"), either, Const("/tmp/launch_params_3")), files=started(2, 3).files
    )
    assert renumbered(several) is several


def test_a_component_sees_the_words_of_its_process_only_where_it_asks() -> None:
    """Two containers of other names load the same component."""

    def inside(name: str) -> Configuration:
        return Configuration(words=(Const("-r"), Const(f"__node:={name}")), component=(Const("a"),))

    assert what_it_sees(inside("x"), process=False) == what_it_sees(inside("y"), process=False)
    assert what_it_sees(inside("x"), process=True) != what_it_sees(inside("y"), process=True)
    empty = Configuration(component=(Const("a"),))
    assert what_it_sees(empty, process=True) != what_it_sees(inside("x"), process=False)


SOURCES = {
    "package.xml": "<package format='3'><name>demo</name><version>1.0.0</version><description>d</description>"
    "<maintainer email='m@demo.org'>m</maintainer><license>MIT</license>"
    "<export><build_type>ament_cmake</build_type></export></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(rclcpp_components REQUIRED)\nadd_library(lamp SHARED lamp.cpp)\n"
    'rclcpp_components_register_node(lamp PLUGIN "demo::Lamp" EXECUTABLE lamp_node)\n'
    "install(DIRECTORY launch DESTINATION share/demo)\n",
    "lamp.cpp": """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
namespace demo
{
class Lamp : public rclcpp::Node
{
public:
  explicit Lamp(const rclcpp::NodeOptions & options) : Node("lamp", options)
  {
    pub_ = create_publisher<std_msgs::msg::String>(declare_parameter("topic", "state"), 10);
    INNER
  }
private:
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_, other_;
};
}
""",
}
LAUNCH = """
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer
from launch_ros.descriptions import ComposableNode

def generate_launch_description():
    return LaunchDescription([ComposableNodeContainer(
        name='NAME', namespace='', package='rclcpp_components', executable='component_container',
        composable_node_descriptions=[
            ComposableNode(package='demo', plugin='demo::Lamp', remappings=[('state', 'light')])])])
"""
INNER = 'auto inner = std::make_shared<rclcpp::Node>("inner"); other_ = inner->create_publisher<std_msgs::msg::String>("~/x", 10);'


@pytest.mark.parametrize(("inner", "times"), [("", 1), (INNER, 2)])
def test_a_component_in_two_containers_is_run_once(
    inner: str, times: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Unless it makes a node that sees the words of the process, as `-r __node:=left`: then it has another name in each."""
    files = dict(SOURCES)
    files["lamp.cpp"] = files["lamp.cpp"].replace("INNER", inner)
    files |= {f"launch/{name}.launch.py": LAUNCH.replace("NAME", name) for name in ("left", "right")}
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    runs: list[str] = []

    def counted(*args: object) -> Run:
        runs.append("")
        return run(*args)  # type: ignore[arg-type]  # what it is given is passed on

    monkeypatch.setattr(launched, "run", counted)
    request = Request(launches=(LaunchRequest("left.launch.py", "demo"), LaunchRequest("right.launch.py", "demo")))
    network = extract(tmp_path, request=request).network
    assert len(runs) == times
    names = {entity.name for node in network.nodes for entity in node.entities if entity.name.endswith(("light", "/x"))}
    assert names == ({"/light"} if not inner else {"/light", "/left/x", "/right/x"})
