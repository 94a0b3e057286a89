# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.set_parameter."""

from launch_ros.actions import SetParameter as SetParameter
