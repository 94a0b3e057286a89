# SPDX-License-Identifier: Apache-2.0
"""py_trees.behaviour.

Read from py_trees 2.6.0.
"""

from _rosward import either, pure, reads_only

from py_trees.blackboard import Client
from py_trees.common import Name, Status

reads_only(__name__)


def _runs(found) -> bool: ...


class Behaviour:
    def __init__(self, name=Name.AUTO_GENERATED):
        self.name = name
        self.status = Status.INVALID
        self.children = []
        self.parent = None
        self.feedback_message = ""

    @pure
    def setup(self, **kwargs) -> None: ...
    @pure
    def initialise(self) -> None: ...
    @pure
    def terminate(self, new_status) -> None: ...

    def update(self):
        return Status.INVALID

    @pure
    def shutdown(self) -> None: ...
    def attach_blackboard_client(self, name=None, namespace=None):
        return Client(name=name, namespace=namespace)

    def setup_with_descendants(self):
        for node in self.iterate():
            node.setup()

    def tick_once(self):
        nodes = self.iterate()
        for node in nodes:
            if _runs([each.status for each in nodes]):  # what the others have found decides
                node.initialise()
                node.status = node.update()
                node.terminate(either(Status.INVALID, node.status))

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

    @pure
    def visit(self, visitor) -> None: ...

    def stop(self, new_status):
        self.terminate(new_status)

    @pure
    def has_parent_with_name(self, name) -> bool: ...
    @pure
    def has_parent_with_instance_type(self, instance_type) -> bool: ...
    def tip(self): ...
