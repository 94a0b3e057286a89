# SPDX-License-Identifier: Apache-2.0
"""py_trees.behaviour.

Read from py_trees 2.6.0.
"""

from _rosward import reads_only

from py_trees.blackboard import Client
from py_trees.common import Name, Status

reads_only(__name__)


class Behaviour:
    def __init__(self, name=Name.AUTO_GENERATED):
        self.name = name
        self.status = Status.INVALID
        self.children = []
        self.parent = None
        self.feedback_message = ""

    def setup(self, **kwargs) -> None: ...
    def initialise(self) -> None: ...
    def terminate(self, new_status) -> None: ...

    def update(self):
        return Status.INVALID

    def shutdown(self) -> None: ...
    def attach_blackboard_client(self, name=None, namespace=None) -> Client: ...

    def setup_with_descendants(self):
        for node in self.iterate():
            node.setup()

    def tick_once(self):
        for node in self.iterate():
            node.initialise()
            node.update()
            node.terminate(Status.INVALID)

    def tick(self):
        self.tick_once()
        yield self

    def iterate(self, direct_descendants=False):
        nodes = []
        for child in self.children:
            if direct_descendants:
                nodes.append(child)
            else:
                nodes.extend(child.iterate())
        nodes.append(self)
        return nodes

    def visit(self, visitor) -> None: ...

    def stop(self, new_status):
        self.terminate(new_status)

    def has_parent_with_name(self, name) -> bool: ...
    def has_parent_with_instance_type(self, instance_type) -> bool: ...
    def tip(self): ...
