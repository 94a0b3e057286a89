# SPDX-License-Identifier: Apache-2.0
"""sensor_msgs_py.

Read from ros2/common_interfaces, branch rolling (2024-11).
"""

