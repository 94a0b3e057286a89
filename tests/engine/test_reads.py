# SPDX-License-Identifier: Apache-2.0
"""What a process read is recorded: a cache can ask the same questions again, and know whether the result still holds."""

from __future__ import annotations

from pathlib import Path

from rosward.analysis.attempts import run
from rosward.analysis.read import SourcesRead, read_sources
from rosward.engine.sources.reads import Reads
from rosward.ros.distro import Distro

FILES = {
    "package.xml": "<package format='3'><name>demo</name></package>",
    "setup.py": (
        "from setuptools import setup\n"
        "setup(name='demo', packages=['demo'], data_files=[('share/demo/config', ['config/names.yaml'])],\n"
        "    entry_points={'console_scripts': ['talker = demo.talker:main', 'other = demo.other:main']})\n"
    ),
    "resource/demo": "",
    "config/names.yaml": "topic: chatter\n",
    "demo/__init__.py": "",
    "demo/names.py": "PREFIX = 'robot'\n",
    "demo/talker.py": """
import os
import yaml
import rclpy
from ament_index_python.packages import get_package_share_directory
from rclpy.node import Node
from std_msgs.msg import String
from demo import names

def main():
    rclpy.init()
    with open(os.path.join(get_package_share_directory('demo'), 'config', 'names.yaml')) as file:
        topic = yaml.safe_load(file)['topic']
    node = Node('talker')
    node.create_publisher(String, f"{names.PREFIX}/{os.environ.get('ROBOT', 'one')}/{topic}", 10)
""",
    "demo/other.py": """
import rclpy
from rclpy.node import Node
from demo import names

def main():
    rclpy.init()
    Node(names.PREFIX)
""",
}


def read(folder: Path) -> SourcesRead:
    for name, text in FILES.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return read_sources([folder], Distro.JAZZY)


def reads(found: SourcesRead) -> dict[str, Reads]:
    runs = [run(found.library, entry, found.budget) for entry in found.plan.entries]
    return {r.entry.executable or "": r.reads for r in runs if r.reads is not None}


def test_what_a_process_read_is_in_its_result(tmp_path: Path) -> None:
    """The files, the data, the imports and where they were asked, the models and the variables; nothing of what another process read."""
    both = reads(read(tmp_path))
    talker, other = both["talker"], both["other"]
    assert {q[1] for q in talker.questions if q[0] == "module"} == {
        "demo/__init__.py",
        "demo/names.py",
        "demo/talker.py",
    }
    assert {q[1] for q in other.questions if q[0] == "module"} == {"demo/__init__.py", "demo/names.py", "demo/other.py"}
    assert ("read", "demo", "config/names.yaml") in talker.questions
    assert ("find", "std_msgs.msg", 0, "demo/talker.py") in talker.questions
    assert {"rclpy", "rclpy.node", "yaml"} <= set(talker.models)
    assert "yaml" not in other.models
    assert "ROBOT" in talker.variables
    assert "ROBOT" not in other.variables


def test_the_record_does_not_depend_on_what_ran_before(tmp_path: Path) -> None:
    """Models and files that a process before has asked for are read once for all; they are in the record of each all the same."""
    found = read(tmp_path)
    first = reads(found)
    again = reads(found)
    backwards = reads(found._replace(plan=found.plan._replace(entries=found.plan.entries[::-1])))
    alone = {entry.executable: run(read(tmp_path).library, entry, found.budget).reads for entry in found.plan.entries}
    assert first == again == backwards == alone
