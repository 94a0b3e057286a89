# SPDX-License-Identifier: Apache-2.0
"""webots_ros2_core.joint_state_publisher.

Read from cyberbotics/webots_ros2, tag 1.2.3.
"""

from _rosward import reads_only

from sensor_msgs.msg import JointState

reads_only(__name__)


class JointStatePublisher:
    def __init__(self, robot, joint_prefix, node, frame_id="joint_states"):
        self._publisher = node.create_publisher(JointState, "joint_states", 1)

    def publish(self) -> None: ...
