# SPDX-License-Identifier: Apache-2.0
"""launch.actions.set_launch_configuration."""

from launch.actions import SetLaunchConfiguration as SetLaunchConfiguration
