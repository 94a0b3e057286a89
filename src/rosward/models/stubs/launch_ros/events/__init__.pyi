# SPDX-License-Identifier: Apache-2.0
"""launch_ros.events.

Read from launch_ros 0.28.0, with what humble had before it.
"""

from _rosward import reads_only

from launch_ros.events import lifecycle as lifecycle

reads_only(__name__)


def matches_node_name(node_name): ...
