# SPDX-License-Identifier: Apache-2.0
"""A call that a library refuses (RW209) is followed as if the rest had been left out: nothing is declared that nobody asked for."""

from __future__ import annotations

from pathlib import Path

import rosward


def test_a_publisher_without_a_profile_declares_no_overrides(tmp_path: Path) -> None:
    (tmp_path / "main.py").write_text(
        "import rclpy\nfrom rclpy.node import Node\nfrom std_msgs.msg import String\n"
        "rclpy.init()\nnode = Node('n')\nnode.create_publisher(String, 'a', queue_size=10)\n",
        encoding="utf-8",
    )
    result = rosward.extract(tmp_path)
    assert "RW209" in {each.code for each in result.findings}
    assert not [p.name for p in result.network.nodes[0].parameters if "qos_overrides" in str(p.name)]
