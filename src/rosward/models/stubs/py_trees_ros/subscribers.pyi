# SPDX-License-Identifier: Apache-2.0
"""py_trees_ros.subscribers: subscribe in setup(), on the node of the tree.

Read from splintered-reality/py_trees_ros, branch devel (2023-04, 2.3).
"""

import operator

from py_trees import common
from py_trees.behaviour import Behaviour
from py_trees.blackboard import Blackboard
from py_trees.common import ClearingPolicy
from std_msgs.msg import Empty


class Handler(Behaviour):
    def __init__(self, name, topic_name, topic_type, qos_profile, clearing_policy=ClearingPolicy.ON_INITIALISE):
        Behaviour.__init__(self, name)
        self.topic_name = topic_name
        self.topic_type = topic_type
        self.qos_profile = qos_profile
        self.clearing_policy = clearing_policy
        self.node = None
        self.msg = None

    def setup(self, **kwargs):
        self.node = kwargs["node"]
        self.subscriber = self.node.create_subscription(
            msg_type=self.topic_type, topic=self.topic_name, callback=self._callback, qos_profile=self.qos_profile
        )

    def _callback(self, msg):
        self.msg = msg

    def update(self):
        return common._status(self.msg)


class CheckData(Handler):
    def __init__(
        self,
        name,
        topic_name,
        topic_type,
        qos_profile,
        variable_name,
        expected_value,
        comparison_operator=operator.eq,
        fail_if_no_data=False,
        fail_if_bad_comparison=False,
        clearing_policy=ClearingPolicy.ON_INITIALISE,
    ):
        Handler.__init__(self, name, topic_name, topic_type, qos_profile, clearing_policy)
        self.expected_value = expected_value

    def update(self):
        return common._status(self.msg, self.expected_value)


class WaitForData(Handler):
    def __init__(self, name, topic_name, topic_type, qos_profile, clearing_policy=ClearingPolicy.ON_INITIALISE):
        Handler.__init__(self, name, topic_name, topic_type, qos_profile, clearing_policy)


class ToBlackboard(Handler):
    def __init__(
        self,
        name,
        topic_name,
        topic_type,
        qos_profile,
        blackboard_variables={},
        initialise_variables={},
        clearing_policy=ClearingPolicy.ON_INITIALISE,
    ):
        Handler.__init__(self, name, topic_name, topic_type, qos_profile, clearing_policy)
        self._variables = [blackboard_variables] if isinstance(blackboard_variables, str) else blackboard_variables
        if isinstance(initialise_variables, dict):
            for key, value in initialise_variables.items():
                Blackboard.set(key, value)

    def update(self):
        if self.msg is not None:
            for key in self._variables:
                Blackboard.set(key, self.msg)
        return common._status(self.msg)


class EventToBlackboard(Handler):
    def __init__(self, name, topic_name, qos_profile, variable_name):
        Handler.__init__(self, name, topic_name, Empty, qos_profile, ClearingPolicy.ON_SUCCESS)
        self.variable_name = variable_name

    def update(self):
        Blackboard.set(self.variable_name, self.msg is not None)
        return common._status(self.msg)
