# SPDX-License-Identifier: Apache-2.0
"""launch.actions.group_action."""

from launch.actions import GroupAction as GroupAction
