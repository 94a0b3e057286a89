# SPDX-License-Identifier: Apache-2.0
"""rqt_gui_py.plugin: what a plugin in Python derives from.

Read from rqt_gui_py 1.8 (jazzy, rolling).
"""
from qt_gui.plugin import Plugin as _Base

class Plugin(_Base): ...
