# SPDX-License-Identifier: Apache-2.0
"""launch_ros.substitutions.executable_in_package."""

from launch_ros.substitutions import ExecutableInPackage as ExecutableInPackage
