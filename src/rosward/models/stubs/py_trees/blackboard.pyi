# SPDX-License-Identifier: Apache-2.0
"""py_trees.blackboard: what is written there, whoever reads it may find. Keys with the same last word are one.

Read from py_trees 2.6.0.
"""

from _rosward import changes, reads_only

_cells = {}


def _word(key):
    return key.split(".")[0].split("/")[-1]


def _cell(key):
    return _cells.setdefault(_word(key), [])


@changes("value")
def _given(value) -> None: ...
@reads_only
def _found(cell): ...
@reads_only
def _is_there(cell) -> bool: ...


def _keep(key, value):
    _given(value)
    _cell(key).append(value)


class Client:
    def __init__(self, *, name=None, namespace=None):
        self.__dict__["name"] = name
        self.__dict__["namespace"] = namespace

    def __setattr__(self, name, value):
        _keep(name, value)

    def __getattr__(self, name):
        return _found(_cell(name))

    def register_key(self, key, access, required=False, remap_to=None):
        if remap_to is not None:
            cell = _cell(remap_to)
            cell.extend(_cell(key))
            _cells[_word(key)] = cell

    def set(self, name, value, overwrite=True):
        _keep(name, value)
        return _is_there(_cell(name))

    def get(self, name):
        return _found(_cell(name))

    def exists(self, name):
        return _is_there(_cell(name))

    def unset(self, key):
        return _is_there(_cell(key))

    @reads_only
    def unregister(self, clear=True) -> None: ...
    @reads_only
    def unregister_key(self, key, clear=True, update_remappings=True) -> None: ...
    @reads_only
    def unregister_all_keys(self, clear=True) -> None: ...
    @reads_only
    def verify_required_keys_exist(self) -> None: ...
    @reads_only
    def is_registered(self, key, access=None) -> bool: ...
    @reads_only
    def absolute_name(self, key) -> str: ...
    @reads_only
    def id(self): ...


class Blackboard:
    @staticmethod
    def set(variable_name, value):
        _keep(variable_name, value)

    @staticmethod
    def get(variable_name):
        return _found(_cell(variable_name))

    @staticmethod
    def unset(key):
        return _is_there(_cell(key))

    @staticmethod
    def exists(name):
        return _is_there(_cell(name))
