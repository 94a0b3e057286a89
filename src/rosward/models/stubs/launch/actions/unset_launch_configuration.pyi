# SPDX-License-Identifier: Apache-2.0
"""launch.actions.unset_launch_configuration."""

from launch.actions import UnsetLaunchConfiguration as UnsetLaunchConfiguration
