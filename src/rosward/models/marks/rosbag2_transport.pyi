# SPDX-License-Identifier: Apache-2.0
"""rosbag2_transport: the parts of rosbag2_py by another name."""
from rosbag2_py import Player as Player
from rosbag2_py import Recorder as Recorder
