# SPDX-License-Identifier: Apache-2.0
"""py_trees_ros.battery.

Read from splintered-reality/py_trees_ros, branch devel (2023-04, 2.3).
"""

from py_trees.blackboard import Blackboard
from py_trees.common import ClearingPolicy
from sensor_msgs.msg import BatteryState

from py_trees_ros import subscribers


class ToBlackboard(subscribers.ToBlackboard):
    def __init__(self, name, topic_name, qos_profile, threshold=30.0):
        subscribers.ToBlackboard.__init__(
            self,
            name,
            topic_name,
            BatteryState,
            qos_profile,
            {"battery": None},
            {"battery_low_warning": False},
            ClearingPolicy.NEVER,
        )
        self.threshold = threshold

    def update(self):
        if self.msg is not None:
            Blackboard.set("battery_low_warning", self.msg.percentage < self.threshold)
        return subscribers.ToBlackboard.update(self)
