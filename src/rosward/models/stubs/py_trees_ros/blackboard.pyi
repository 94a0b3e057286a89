# SPDX-License-Identifier: Apache-2.0
"""py_trees_ros.blackboard.

Read from splintered-reality/py_trees_ros, branch devel (2023-04, 2.3).
"""

from _rosward import reads_only, unknown
from py_trees_ros_interfaces.srv import CloseBlackboardStream, GetBlackboardVariables, OpenBlackboardStream
from std_msgs.msg import String

from py_trees_ros import utilities

reads_only(__name__)


class Exchange:
    def setup(self, node):
        self.node = node
        node.create_service(GetBlackboardVariables, "~/blackboard_streams/get_variables", self._answer)
        node.create_service(OpenBlackboardStream, "~/blackboard_streams/open", self._open)
        node.create_service(CloseBlackboardStream, "~/blackboard_streams/close", self._answer)

    def _answer(self, request, response):
        return response

    def _open(self, request, response):
        name = "~/blackboard_streams/_watcher_" + unknown("live", "number of the blackboard watcher", "str")
        self.node.create_publisher(String, name, utilities.qos_profile_latched())
        return response

    def post_tick_handler(self, visited_client_ids=None) -> None: ...
    def register_activity_stream_client(self) -> None: ...
    def unregister_activity_stream_client(self) -> None: ...
