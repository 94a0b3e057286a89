# SPDX-License-Identifier: Apache-2.0
"""launch.launch_description_sources.any_launch_description_source."""

from launch.launch_description_sources import AnyLaunchDescriptionSource as AnyLaunchDescriptionSource
