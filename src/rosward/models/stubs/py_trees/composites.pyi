# SPDX-License-Identifier: Apache-2.0
"""py_trees.composites.

Read from py_trees 2.6.0.
"""

from _rosward import reads_only

from py_trees import common
from py_trees.behaviour import Behaviour


class Composite(Behaviour):
    def __init__(self, name, children=None):
        Behaviour.__init__(self, name)
        if children is not None:
            self.add_children(children)

    def add_child(self, child):
        self.children.append(child)

    def add_children(self, children):
        for child in children:
            self.add_child(child)
        return self

    def remove_child(self, child):
        index = self.children.index(child)
        self.children.remove(child)
        return index

    def remove_all_children(self):
        self.children.clear()

    def replace_child(self, child, replacement):
        self.insert_child(replacement, self.remove_child(child))

    def remove_child_by_id(self, child_id):
        for child in list(self.children):
            if child.id == child_id:
                self.children.remove(child)

    def prepend_child(self, child):
        self.children.insert(0, child)

    def insert_child(self, child, index):
        self.children.insert(index, child)

    @reads_only
    def stop(self, new_status=common.Status.INVALID) -> None: ...


class Selector(Composite):
    def __init__(self, name, memory=False, children=None):
        Composite.__init__(self, name, children)


class Sequence(Composite):
    def __init__(self, name, memory=True, children=None):
        Composite.__init__(self, name, children)


class Parallel(Composite):
    def __init__(self, name, policy=None, children=None):
        Composite.__init__(self, name, children)
