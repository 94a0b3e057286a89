# SPDX-License-Identifier: Apache-2.0
"""A file that asks ROS for no more than a folder is no program of the system, unless it may run something that is."""

from __future__ import annotations

from pathlib import Path

import pytest

import rosward

_ASKS = "from ament_index_python.packages import get_package_share_directory\n"
_MAIN = "if __name__ == '__main__':\n    {}\n"
_NODE = "import rclpy\nfrom std_msgs.msg import String\nrclpy.init()\nrclpy.create_node('n').create_publisher(String, 'chatter', 1)\n"


def _codes(folder: Path, **texts: str) -> set[str]:
    for name, text in texts.items():
        file = folder / f"{name.replace('__', '/')}.py"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    found = rosward.extract(folder)
    return {finding.code for finding in found.network.findings} | {node.name for node in found.network.nodes}


def test_what_only_asks_is_not_followed(tmp_path: Path) -> None:
    raises = _ASKS + _MAIN.format("raise ValueError(get_package_share_directory('demo'))")
    assert _codes(tmp_path, convert=raises) == {"RW007"}


@pytest.mark.parametrize(
    "does",
    [
        "import subprocess; subprocess.run(['ros2', 'run', 'demo', 'talker'])",
        "import os; os.system('ros2 run demo talker')",
        "import os; os.execvp('ros2', ['ros2', 'run', 'demo', 'talker'])",
        "import os; getattr(os, 'sys' + 'tem')('ros2 run demo talker')",
        "import os; find = getattr; find(os, 'sys' + 'tem')('ros2 run demo talker')",
        "import os, operator; operator.attrgetter('sys' + 'tem')(os)('ros2 run demo talker')",
        "import os, operator; operator.methodcaller('sys' + 'tem', 'ros2 run demo talker')(os)",
    ],
)
def test_what_starts_a_program_is_followed(tmp_path: Path, does: str) -> None:
    assert "RW210" in _codes(tmp_path, start=_ASKS + _MAIN.format(does))


def test_an_attribute_whose_name_stands_there_is_that_one(tmp_path: Path) -> None:
    raises = _ASKS + "import sys\n" + _MAIN.format("raise ValueError(getattr(sys, 'version', None))")
    assert _codes(tmp_path, convert=raises) == {"RW007"}


def test_what_is_imported_may_start_one(tmp_path: Path) -> None:
    starts = "import os\ndef start():\n    os.system('ros2 run demo talker')\n"
    asks = _ASKS + "import helper\n" + _MAIN.format("helper.start()")
    assert "RW210" in _codes(tmp_path, helper=starts, main=asks)


def test_a_path_that_is_changed_leads_to_any_file_of_a_name(tmp_path: Path) -> None:
    """One of them makes a node: which one is imported is not known, and told."""
    path = "import sys\nsys.path.append(sys.argv[1])\n"
    asks = _ASKS + path + _MAIN.format("import talking")
    assert "RW203" in _codes(tmp_path, main=asks, one__lib__talking=_NODE, two__lib__talking="")
