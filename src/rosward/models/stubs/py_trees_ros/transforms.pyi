# SPDX-License-Identifier: Apache-2.0
"""py_trees_ros.transforms: tf on the node of the tree.

Read from splintered-reality/py_trees_ros, branch devel (2023-04, 2.3).
"""

from py_trees import common
from py_trees.behaviour import Behaviour
from py_trees.blackboard import Blackboard
from py_trees.common import ClearingPolicy
from rclpy.time import Time
from tf2_ros import Buffer, StaticTransformBroadcaster, TransformBroadcaster, TransformException, TransformListener


class FromBlackboard(Behaviour):
    def __init__(
        self, name, variable_name, target_frame, source_frame, static, qos_profile, static_qos_profile=None
    ):
        Behaviour.__init__(self, name)
        self.variable_name = variable_name
        self.static = static
        self.qos_profile = qos_profile
        self.static_qos_profile = static_qos_profile

    def setup(self, **kwargs):
        self.node = kwargs["node"]
        if self.static:
            self.broadcaster = StaticTransformBroadcaster(node=self.node, qos=self.static_qos_profile)
        else:
            self.broadcaster = TransformBroadcaster(node=self.node, qos=self.qos_profile)

    def update(self):
        if Blackboard.exists(self.variable_name):
            self.broadcaster.sendTransform(Blackboard.get(self.variable_name))
        return common._status(Blackboard.exists(self.variable_name))


class ToBlackboard(Behaviour):
    def __init__(
        self,
        name,
        variable_name,
        target_frame,
        source_frame,
        qos_profile,
        static_qos_profile=None,
        clearing_policy=ClearingPolicy.ON_INITIALISE,
    ):
        Behaviour.__init__(self, name)
        self.variable_name = variable_name
        self.target_frame, self.source_frame = target_frame, source_frame
        self.qos_profile = qos_profile
        self.static_qos_profile = static_qos_profile
        self.buffer = Buffer()

    def update(self):
        try:
            found = self.buffer.lookup_transform(self.target_frame, self.source_frame, Time())
        except TransformException:
            return common.Status.RUNNING
        Blackboard.set(self.variable_name, found)
        return common.Status.SUCCESS

    def setup(self, **kwargs):
        self.node = kwargs["node"]
        self.listener = TransformListener(
            buffer=self.buffer, node=self.node, qos=self.qos_profile, static_qos=self.static_qos_profile
        )
