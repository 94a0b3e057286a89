# SPDX-License-Identifier: Apache-2.0
"""launch.substitutions.launch_configuration."""

from launch.substitutions import LaunchConfiguration as LaunchConfiguration
