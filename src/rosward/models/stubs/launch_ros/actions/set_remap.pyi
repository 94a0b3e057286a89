# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.set_remap."""

from launch_ros.actions import SetRemap as SetRemap
