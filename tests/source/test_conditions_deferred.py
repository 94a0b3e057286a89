# SPDX-License-Identifier: Apache-2.0
"""What evaluates the conditions of a package.xml takes longer to load than all else that reads one: it is loaded where there is a condition."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

_MANIFEST = """<package format="3"><name>demo</name><version>0.0.1</version><description>d</description>
<maintainer email="a@example.com">a</maintainer><license>Apache-2.0</license><depend>rclpy</depend>{}</package>"""
_READS = (
    "import sys\nfrom rosward.source.manifest import read_manifest\n"
    "manifest, problem = read_manifest(sys.argv[1], 'package.xml', 'demo', {'ROS_VERSION': '2'})\n"
    "print(sorted(manifest.depends), problem, 'pyparsing' in sys.modules)"
)


@pytest.mark.parametrize(
    ("more", "expected"),
    [
        ("", "['rclpy'] None False"),
        ("<member_of_group>g</member_of_group><group_depend>h</group_depend>", "['rclpy'] None False"),
        (
            '<depend condition="$ROS_VERSION == 1">rospy</depend><depend condition="$ROS_VERSION == 2">tf2</depend>',
            "['rclpy', 'tf2'] None True",
        ),
        ('<member_of_group condition="$ROS_VERSION == 1">g</member_of_group>', "['rclpy'] None True"),
    ],
)
def test_conditions(tmp_path: Path, more: str, expected: str) -> None:
    file = tmp_path / "package.xml"
    file.write_text(_MANIFEST.format(more))
    done = subprocess.run([sys.executable, "-c", _READS, str(file)], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == expected
