# SPDX-License-Identifier: Apache-2.0
"""launch_ros.substitutions.parameter."""

from launch_ros.substitutions import Parameter as Parameter
