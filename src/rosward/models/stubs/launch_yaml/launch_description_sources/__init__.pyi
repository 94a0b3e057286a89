# SPDX-License-Identifier: Apache-2.0
"""launch_yaml.launch_description_sources.

Read from launch 3.7.0, with what humble had before it.
"""

from launch.launch_description_source import LaunchDescriptionSource


class YAMLLaunchDescriptionSource(LaunchDescriptionSource):
    def __init__(self, launch_file_path):
        super().__init__(location=launch_file_path)
