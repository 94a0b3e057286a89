# SPDX-License-Identifier: Apache-2.0
"""py_trees_ros.publishers: publish on the node of the tree.

Read from splintered-reality/py_trees_ros, branch devel (2023-04, 2.3).
"""

from py_trees import common
from py_trees.behaviour import Behaviour
from py_trees.blackboard import Blackboard


class FromBlackboard(Behaviour):
    def __init__(self, name, topic_name, topic_type, qos_profile, blackboard_variable):
        Behaviour.__init__(self, name)
        self.topic_name = topic_name
        self.topic_type = topic_type
        self.qos_profile = qos_profile
        self.variable_name = blackboard_variable

    def setup(self, **kwargs):
        self.node = kwargs["node"]
        self.publisher = self.node.create_publisher(
            msg_type=self.topic_type, topic=self.topic_name, qos_profile=self.qos_profile
        )

    def update(self):
        if Blackboard.exists(self.variable_name):
            self.publisher.publish(Blackboard.get(self.variable_name))
        return common._status(Blackboard.exists(self.variable_name))
