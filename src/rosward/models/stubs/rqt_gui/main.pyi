# SPDX-License-Identifier: Apache-2.0
"""rqt_gui.main: a window with one plugin, or with those that somebody opens.

Read from rqt_gui 1.8, rqt_gui_py 1.8 and qt_gui 2.9 (jazzy, rolling). A plugin is looked for in the package that its name begins with, or
else imported by its name.
"""
import importlib
import os
import sys
from xml.etree import ElementTree

import rclpy
from _rosward import ask, beside, either, reads_only, report, schedule, spin, unknown
from _rosward.launch import is_package, share_folder
from rqt_gui.ros2_plugin_context import Ros2PluginContext

def main():
    sys.exit(Main().main())

class Main:
    @reads_only
    def __init__(self, filename=None, settings_filename='rqt_gui'): ...
    def main(self, argv=None, standalone=None, plugin_argument_provider=None):
        if not standalone:
            report('RW203', 'which plugins are opened in the window of rqt is not known')
            _node()
            return 0
        package = standalone.split('/')[0].split('.')[0]
        here = is_package(package)
        if here is None:
            report('RW203', 'the name of the plugin that is opened in the window of rqt is not known')
            _node()
            return 0
        found = list(_exported(package, standalone.lower()).values()) if here else []
        if not found and '.' in standalone and '/' not in standalone:
            found = [standalone]
        if not found:
            report('RW203', f'no plugin of rqt that is exported by a package that {standalone} begins with has this name')
            _node()
        if len(found) > 1:
            report('RW203', f'rqt opens no plugin where several match {standalone}')
            return 1
        for path in found:
            module, _, name = path.rpartition('.')
            _open(getattr(importlib.import_module(module), name))
        return 0

def _exported(package, wanted):
    """The classes that a package exports as plugins, and that are meant, by the names of the plugins."""
    folder = share_folder(package)
    found = {}
    for export in ElementTree.parse(f'{folder}/package.xml').getroot().iter('rqt_gui'):
        file = export.get('plugin', '').replace('${prefix}/', '')
        for each in ElementTree.parse(f'{folder}/{file}').getroot().iter('class'):
            path, name = each.get('type', ''), f"{package}/{each.get('name', '')}"
            if each.get('base_class_type') == 'rqt_gui_py::Plugin' and (wanted in path.lower() or wanted in name.lower()):
                found[name] = path
    return found

def _node():
    if not rclpy.ok():
        rclpy.init()
    return rclpy.create_node(f'rqt_gui_py_node_{os.getpid()}')
def _open(cls):
    node = _node()
    beside()
    plugin = cls(Ros2PluginContext(None, node))
    ask(plugin, 'restore_settings', _Settings(), _Settings())
    schedule(_asked, plugin, event='window')
    spin()

@reads_only
class _Settings:
    def value(self, key, default_value=None, type=None):
        return either(default_value, unknown('file', 'settings of the plugin'))
    def set_value(self, key, value) -> None: ...
    def contains(self, key) -> bool: ...
    def remove(self, key) -> None: ...
    def all_keys(self) -> list: ...
    def child_keys(self) -> list: ...
    def child_groups(self) -> list: ...
    def get_settings(self, prefix):
        return self
def _asked(plugin):
    ask(plugin, 'trigger_configuration')
    ask(plugin, 'save_settings', _Settings(), _Settings())
    ask(plugin, 'shutdown_plugin')
