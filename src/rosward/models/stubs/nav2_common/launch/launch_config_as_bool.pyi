# SPDX-License-Identifier: Apache-2.0
"""nav2_common.launch.launch_config_as_bool."""

from nav2_common.launch import LaunchConfigAsBool as LaunchConfigAsBool
