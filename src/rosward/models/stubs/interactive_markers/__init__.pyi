# SPDX-License-Identifier: Apache-2.0
"""interactive_markers: a server of markers publishes their updates, subscribes to what users do with them, and gives all of them.

Read from ros-visualization/interactive_markers, branches ros2 and rolling (2024-03).
"""

from interactive_markers.interactive_marker_server import InteractiveMarkerServer
from interactive_markers.menu_handler import MenuHandler

__all__ = ["InteractiveMarkerServer", "MenuHandler"]
