# SPDX-License-Identifier: Apache-2.0
"""launch.launch_description_sources.frontend_launch_description_source."""

from launch.launch_description_sources import FrontendLaunchDescriptionSource as FrontendLaunchDescriptionSource
