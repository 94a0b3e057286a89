# SPDX-License-Identifier: Apache-2.0
"""launch.launch_description_sources.python_launch_file_utilities."""

from launch.launch_description_sources import get_launch_description_from_python_launch_file as get_launch_description_from_python_launch_file
