# SPDX-License-Identifier: Apache-2.0
"""Runs the program of a node under the real rclpy up to the point where it would spin, and keeps it there.

    python host.py program.py [--ros-args …]

In place of spinning, the node gets a publisher and a subscription of one more topic, `MARK`, and a line is written.
Discovery tells of writers, and of readers, in the order in which they were made: who begins to watch after that line
and has seen both marks has seen everything. The end of standard input ends it.
"""

from __future__ import annotations

import importlib
import runpy
import sys
from typing import Any, Final

MARK: Final = "/everything_is_made"


def _stay(node: Any, *_: Any, **__: Any) -> None:
    message = importlib.import_module("std_msgs.msg").String
    ends = node.create_publisher(message, MARK, 1), node.create_subscription(message, MARK, print, 1)
    print(MARK, flush=True)
    sys.stdin.read()
    del ends


if __name__ == "__main__":
    vars(importlib.import_module("rclpy"))["spin"] = _stay
    sys.argv = sys.argv[1:]
    runpy.run_path(sys.argv[0], run_name="__main__")
