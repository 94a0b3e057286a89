# SPDX-License-Identifier: Apache-2.0
"""py_trees.blackboard: what is written there is not followed.

Read from py_trees 2.6.0.
"""

from _rosward import changes, reads_only

class Client:
    @reads_only
    def __init__(self, *, name=None, namespace=None) -> None: ...
    @reads_only
    def register_key(self, key, access, required=False, remap_to=None) -> None: ...
    @changes("value")
    def set(self, name, value, overwrite=True) -> bool: ...
    @reads_only
    def get(self, name): ...
    @reads_only
    def exists(self, name) -> bool: ...
    @reads_only
    def unset(self, key) -> bool: ...


class Blackboard:
    @staticmethod
    @changes("value")
    def set(variable_name, value) -> None: ...
    @staticmethod
    @reads_only
    def get(variable_name): ...
    @staticmethod
    @reads_only
    def exists(name) -> bool: ...
