# SPDX-License-Identifier: Apache-2.0
"""py_trees.trees: setting up and ticking call the methods of all behaviours of the tree.

Read from py_trees 2.6.0.
"""

from _rosward import ask, reads_only, schedule, unknown

from py_trees import common

CONTINUOUS_TICK_TOCK = -1


def setup(root, timeout=common.Duration.INFINITE, visitor=None, **kwargs):
    for behaviour in root.iterate():
        behaviour.setup(**kwargs)


class BehaviourTree:
    def __init__(self, root):
        self.root = root
        self.count = 0
        self.visitors = []

    def add_pre_tick_handler(self, handler):
        schedule(handler, self, event="tick")

    def add_post_tick_handler(self, handler):
        schedule(handler, self, event="tick")

    def add_visitor(self, visitor):
        self.visitors.append(visitor)
        schedule(ask, visitor, "initialise", event="tick")
        schedule(ask, visitor, "run", unknown("call", "behaviour that is visited"), event="tick")
        schedule(ask, visitor, "finalise", event="tick")

    def prune_subtree(self, unique_id):
        for behaviour in self.root.iterate():
            for child in list(behaviour.children):
                if child.id == unique_id:
                    behaviour.children.remove(child)
        return unknown("call", "whether there is such a subtree", "bool")

    def insert_subtree(self, child, unique_id, index):
        self.root.children.append(child)
        return True

    def replace_subtree(self, unique_id, subtree):
        self.root.children.append(subtree)
        return True

    def setup(self, timeout=common.Duration.INFINITE, visitor=None, **kwargs):
        setup(self.root, timeout, visitor, **kwargs)

    def tick(self, pre_tick_handler=None, post_tick_handler=None):
        if pre_tick_handler is not None:
            pre_tick_handler(self)
        self.root.tick_once()
        if post_tick_handler is not None:
            post_tick_handler(self)

    def tick_tock(
        self,
        period_ms,
        number_of_iterations=CONTINUOUS_TICK_TOCK,
        stop_on_terminal_state=False,
        pre_tick_handler=None,
        post_tick_handler=None,
    ):
        self.tick(pre_tick_handler, post_tick_handler)

    @reads_only
    def tip(self): ...
    @reads_only
    def interrupt(self) -> None: ...

    def shutdown(self):
        for behaviour in self.root.iterate():
            behaviour.shutdown()
