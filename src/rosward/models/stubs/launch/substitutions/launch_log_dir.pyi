# SPDX-License-Identifier: Apache-2.0
"""launch.substitutions.launch_log_dir."""

from launch.substitutions import LaunchLogDir as LaunchLogDir
