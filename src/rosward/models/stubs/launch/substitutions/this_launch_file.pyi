# SPDX-License-Identifier: Apache-2.0
"""launch.substitutions.this_launch_file."""

from launch.substitutions import ThisLaunchFile as ThisLaunchFile
