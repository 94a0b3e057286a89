# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.set_parameters_from_file."""

from launch_ros.actions import SetParametersFromFile as SetParametersFromFile
