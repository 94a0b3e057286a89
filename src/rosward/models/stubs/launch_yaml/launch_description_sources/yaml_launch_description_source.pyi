# SPDX-License-Identifier: Apache-2.0
"""launch_yaml.launch_description_sources.yaml_launch_description_source."""

from launch_yaml.launch_description_sources import YAMLLaunchDescriptionSource as YAMLLaunchDescriptionSource
