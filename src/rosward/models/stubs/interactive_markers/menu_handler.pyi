# SPDX-License-Identifier: Apache-2.0
"""interactive_markers.menu_handler (2024-03)."""

from _rosward import reads_only, unknown
from visualization_msgs.msg import MenuEntry


@reads_only
class MenuHandler:
    NO_CHECKBOX = 0
    CHECKED = 1
    UNCHECKED = 2

    def __init__(self):
        self._callbacks = []

    def insert(self, title, parent=None, command_type=MenuEntry.FEEDBACK, command="", callback=None):
        if callback is not None:
            self._callbacks.append(callback)
        return unknown("live", "handle of a menu entry", "int")

    def setVisible(self, handle, visible) -> bool: ...

    def setCheckState(self, handle, check_state) -> bool: ...

    def getCheckState(self, handle):
        return unknown("live", "state of a menu entry")

    def getTitle(self, handle):
        return unknown("live", "title of a menu entry")

    def apply(self, server, marker_name):
        server.setCallback(marker_name, self.processFeedback)
        return unknown("live", "markers", "bool")

    def reApply(self, server) -> bool: ...

    def processFeedback(self, feedback):
        for callback in self._callbacks:
            callback(feedback)
