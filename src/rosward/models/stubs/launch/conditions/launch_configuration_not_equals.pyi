# SPDX-License-Identifier: Apache-2.0
"""launch.conditions.launch_configuration_not_equals."""

from launch.conditions import LaunchConfigurationNotEquals as LaunchConfigurationNotEquals
