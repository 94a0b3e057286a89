# SPDX-License-Identifier: Apache-2.0
"""qt_gui.plugin: what a plugin of rqt derives from.

Read from qt_gui 2.9 (jazzy, rolling).
"""
from _rosward import plugin_class, reads_only
from python_qt_binding.QtCore import QObject

@plugin_class("rqt_gui.main._open")
@reads_only
class Plugin(QObject):
    def __init__(self, context):
        super().__init__()
    def shutdown_plugin(self) -> None: ...
    def save_settings(self, plugin_settings, instance_settings) -> None: ...
    def restore_settings(self, plugin_settings, instance_settings) -> None: ...
