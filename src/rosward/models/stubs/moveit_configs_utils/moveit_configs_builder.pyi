# SPDX-License-Identifier: Apache-2.0
"""moveit_configs_utils.moveit_configs_builder."""

from moveit_configs_utils import MoveItConfigs as MoveItConfigs
from moveit_configs_utils import MoveItConfigsBuilder as MoveItConfigsBuilder
