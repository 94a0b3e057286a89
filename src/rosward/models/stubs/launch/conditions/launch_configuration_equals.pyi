# SPDX-License-Identifier: Apache-2.0
"""launch.conditions.launch_configuration_equals."""

from launch.conditions import LaunchConfigurationEquals as LaunchConfigurationEquals
