# SPDX-License-Identifier: Apache-2.0
"""launch_ros.substitutions.find_package."""

from launch_ros.substitutions import FindPackage as FindPackage
from launch_ros.substitutions import FindPackagePrefix as FindPackagePrefix
from launch_ros.substitutions import FindPackageShare as FindPackageShare
