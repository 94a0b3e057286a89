# SPDX-License-Identifier: Apache-2.0
"""Two starts that differ only in the numbers of the files that launch wrote are one."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosward.analysis import outcome
from rosward.analysis.attempts import how_started, run
from rosward.analysis.process import Run
from rosward.deployment.alike import renumbered
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
    assert how_started(one) == how_started(other)
    assert renumbered(started(9, 4)).words == started(1, 2).words
    changed = renumbered(started(2, content=OTHER))
    assert how_started(one) != how_started(changed)


def test_those_of_a_component_are_numbered_with_those_of_its_process() -> None:
    """Its own come first."""
    both = started(5, 3)
    found = renumbered(
        Configuration(
            words=both.words, files=both.files, component=(Const("--params-file"), Const("/tmp/launch_params_3"))
        )
    )
    assert found.component == (Const("--params-file"), Const("/tmp/launch_params_1"))
    assert found.words == started(2, 1).words


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


SOURCES = {
    "package.xml": "<package format='3'><name>demo</name><version>1.0.0</version><description>d</description>"
    "<maintainer email='m@demo.org'>m</maintainer><license>MIT</license>"
    "<export><build_type>ament_cmake</build_type></export></package>",
    "CMakeLists.txt": "project(demo)\ninstall(PROGRAMS lamp.py DESTINATION lib/demo)\n"
    "install(DIRECTORY launch DESTINATION share/demo)\n",
    "lamp.py": """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

def main():
    rclpy.init()
    node = Node('lamp')
    node.create_publisher(String, node.declare_parameter('topic', 'state').value, 10)
    rclpy.spin(node)

if __name__ == '__main__':
    main()
""",
    "launch/lamp.launch.py": """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('topic'),
        Node(package='demo', executable='lamp.py', parameters=[{'topic': LaunchConfiguration('topic')}])])
""",
    "launch/two.launch.xml": """<launch>
  <node pkg="demo" exec="lamp.py" name="first"><param name="topic" value="one"/></node>
  <include file="$(find-pkg-share demo)/launch/lamp.launch.py"><arg name="topic" value="light"/></include>
</launch>
""",
    "launch/one.launch.xml": """<launch>
  <include file="$(find-pkg-share demo)/launch/lamp.launch.py"><arg name="topic" value="TOPIC"/></include>
</launch>
""",
}


@pytest.mark.parametrize(("topic", "times"), [("light", 2), ("dark", 3)])
def test_the_same_start_in_two_launch_files_is_run_once(
    topic: str, times: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In one it reads the second file that is written, in the other the first; with another content it is another start."""
    for name, text in SOURCES.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text.replace("TOPIC", topic), encoding="utf-8")
    runs: list[str] = []

    def counted(*args: object) -> Run:
        runs.append("")
        return run(*args)  # type: ignore[arg-type]  # what it is given is passed on

    monkeypatch.setattr(outcome, "run", counted)
    request = Request(launches=(LaunchRequest("two.launch.xml", "demo"), LaunchRequest("one.launch.xml", "demo")))
    network = extract(tmp_path, request=request).network
    assert len(runs) == times
    names = {entity.name for node in network.nodes for entity in node.entities}
    assert {"/one", "/light", f"/{topic}"} <= names
