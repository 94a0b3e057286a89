# SPDX-License-Identifier: Apache-2.0
"""launch_ros.substitutions.find_package."""

from ament_index_python.packages import get_package_prefix as get_package_prefix
from ament_index_python.packages import get_package_share_directory as get_package_share_directory
from launch_ros.substitutions import FindPackage as FindPackage
from launch_ros.substitutions import FindPackagePrefix as FindPackagePrefix
from launch_ros.substitutions import FindPackageShare as FindPackageShare
