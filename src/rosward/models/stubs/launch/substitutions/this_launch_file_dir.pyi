# SPDX-License-Identifier: Apache-2.0
"""launch.substitutions.this_launch_file_dir."""

from launch.substitutions import ThisLaunchFileDir as ThisLaunchFileDir
