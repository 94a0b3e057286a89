# SPDX-License-Identifier: Apache-2.0
"""interactive_markers.menu_handler (2024-03)."""

from _rosward import message, reads_only, schedule, unknown
from visualization_msgs.msg import InteractiveMarkerFeedback, MenuEntry


@reads_only
class MenuHandler:
    NO_CHECKBOX = 0
    CHECKED = 1
    UNCHECKED = 2

    def __init__(self): ...

    def insert(self, title, parent=None, command_type=MenuEntry.FEEDBACK, command="", callback=None):
        if callback is not None:
            schedule(callback, message(InteractiveMarkerFeedback), event="message")
        return unknown("live", "handle of a menu entry", "int")

    def setVisible(self, handle, visible) -> bool: ...

    def setCheckState(self, handle, check_state) -> bool: ...

    def getCheckState(self, handle):
        return unknown("live", "state of a menu entry")

    def getTitle(self, handle):
        return unknown("live", "title of a menu entry")

    def apply(self, server, marker_name) -> bool: ...

    def reApply(self, server) -> bool: ...

    def processFeedback(self, feedback) -> None: ...
