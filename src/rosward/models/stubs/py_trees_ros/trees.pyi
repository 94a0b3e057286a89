# SPDX-License-Identifier: Apache-2.0
"""py_trees_ros.trees: a node with services for those who watch the tree; the tree is set up with it and ticks in its timer.

Streams that a watcher opens are modelled with the name that they get by default, `~/snapshot_streams/_snapshots_N`.

Read from splintered-reality/py_trees_ros, branch devel (2023-04, 2.3).
"""

import py_trees.trees
import rclpy
from _rosward import unknown
from py_trees import common
from py_trees_ros_interfaces.msg import BehaviourTree as BehaviourTreeMsg
from py_trees_ros_interfaces.srv import CloseSnapshotStream, OpenSnapshotStream, ReconfigureSnapshotStream

from py_trees_ros import blackboard, utilities


class BehaviourTree(py_trees.trees.BehaviourTree):
    def __init__(self, root, unicode_tree_debug=False):
        py_trees.trees.BehaviourTree.__init__(self, root)
        self.node = None
        self.timer = None

    def setup(self, node=None, node_name="tree", timeout=common.Duration.INFINITE, visitor=None, **kwargs):
        self.node = node if node else rclpy.create_node(node_name=node_name)
        self.snapshot_stream_services = utilities.Services(
            node=self.node,
            service_details=[
                ("close", "~/snapshot_streams/close", CloseSnapshotStream, self._close_snapshot_stream),
                ("open", "~/snapshot_streams/open", OpenSnapshotStream, self._open_snapshot_stream),
                (
                    "reconfigure",
                    "~/snapshot_streams/reconfigure",
                    ReconfigureSnapshotStream,
                    self._reconfigure_snapshot_stream,
                ),
            ],
            introspection_topic_name="snapshot_streams/services",
        )
        self.blackboard_exchange = blackboard.Exchange()
        self.blackboard_exchange.setup(self.node)
        self.node.add_on_set_parameters_callback(callback=self._set_parameters_callback)
        if self.node.declare_parameter(name="default_snapshot_stream", value=False).value:
            self._stream("~/snapshots")
        self.node.declare_parameter(name="default_snapshot_period", value=2.0)
        self.node.declare_parameter(name="default_snapshot_blackboard_data", value=True)
        self.node.declare_parameter(name="default_snapshot_blackboard_activity", value=False)
        self.node.declare_parameter(name="setup_timeout", value=1.7976931348623157e308)
        py_trees.trees.BehaviourTree.setup(self, timeout=timeout, visitor=visitor, node=self.node, **kwargs)

    def _stream(self, topic):
        self.node.create_publisher(BehaviourTreeMsg, topic, utilities.qos_profile_latched())

    def _set_parameters_callback(self, parameters):
        for parameter in parameters:
            if parameter.name == "default_snapshot_stream" and parameter.value:
                self._stream("~/snapshots")

    def _close_snapshot_stream(self, request, response):
        return response

    def _open_snapshot_stream(self, request, response):
        self._stream("~/snapshot_streams/_snapshots_" + unknown("live", "number of the snapshot stream", "str"))
        return response

    def _reconfigure_snapshot_stream(self, request, response):
        return response

    def tick_tock(
        self,
        period_ms,
        number_of_iterations=py_trees.trees.CONTINUOUS_TICK_TOCK,
        pre_tick_handler=None,
        post_tick_handler=None,
    ):
        self.timer = self.node.create_timer(
            period_ms / 1000.0, lambda: self.tick(pre_tick_handler, post_tick_handler)
        )
